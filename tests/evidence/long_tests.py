"""Tests marked as evidence, and the cases of sampled ones that `make test` leaves out: file by file, by pytest."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from warm_starts import COLD

TESTS = Path(__file__).parent.parent
MARKED = ("pytest.mark.evidence", "pytest.mark.sampled(")
FILES = sorted(path for path in TESTS.rglob("test_*.py") if any(mark in path.read_text("utf-8") for mark in MARKED))

NAME = "long_tests"
CLAIM = "every test and every case that `make test` leaves out holds"
COUNT = len(FILES)
UNIT = "files of tests"
LIMIT = 3600.0  # s
SAMPLE = 0  # `make test` has the other cases of these tests
FINITE = True


def one(index: int, folder: Path) -> str:
    command = [sys.executable, "-m", "pytest", "-m", "evidence", f"--basetemp={folder / 'tests'}", str(FILES[index])]
    environment = os.environ | {COLD: "1"}
    done = subprocess.run(command, cwd=TESTS.parent, env=environment, capture_output=True, text=True, check=False)
    if done.returncode == pytest.ExitCode.NO_TESTS_COLLECTED:
        return "none of its tests is left out by `make test`: take its mark away"
    return "" if done.returncode == 0 else "\n".join(done.stdout.splitlines()[-20:])
