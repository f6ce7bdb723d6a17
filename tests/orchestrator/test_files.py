"""Files of processes that are no more."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from rovbrush.orchestrator.files import is_alive, sweep_up


@pytest.mark.skipif(sys.platform != "linux", reason="there are no zombies to be seen")
def test_a_process_that_waits_to_be_collected_is_dead_and_its_files_are_swept_up(tmp_path: Path) -> None:
    process = subprocess.Popen([sys.executable, "-c", "pass"])
    os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)  # it has ended and is not collected
    left = tmp_path / f".result.{process.pid}.tmp.nc"
    left.touch()
    assert not is_alive(process.pid)
    assert sweep_up(tmp_path) == [left.name]
    process.wait()


def test_the_files_of_a_living_process_stay(tmp_path: Path) -> None:
    left = tmp_path / f".result.{os.getpid()}.tmp.nc"
    left.touch()
    assert sweep_up(tmp_path) == [] and left.exists()
