"""`python -m rovbrush` is the command."""

from __future__ import annotations

import subprocess
import sys
from importlib.metadata import version

import pytest


@pytest.mark.parametrize("module", ["rovbrush", "rovbrush.orchestrator"])
def test_the_package_runs_as_the_command(module: str) -> None:
    done = subprocess.run([sys.executable, "-m", module, "--version"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, f"rovbrush {version('rovbrush')}\n")
    wrong = subprocess.run([sys.executable, "-m", module, "fly"], capture_output=True, text=True, check=False)
    assert wrong.returncode == 2 and "fly" in wrong.stderr and "Traceback" not in wrong.stderr
