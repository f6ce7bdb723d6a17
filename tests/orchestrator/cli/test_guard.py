"""`rovbrush run` survives FMUs that crash, end its process or never return: a message and exit code 1."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from helpers import python, system_text
from native_build import FAULTS2, built, needs_gcc

FREE = {"=u": 1.5, "=n_in": 1, "=mode_in": 2, "=on_in": True, "=s_in": "on"}
pytestmark = [needs_gcc, pytest.mark.skipif(not hasattr(os, "fork"), reason="the guard needs Linux or macOS")]


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def started(folder: Path, fmus: Path, fault: str) -> subprocess.Popen[str]:
    """The command, running a system whose one FMU misbehaves at 4.5 ms."""
    path = folder / "case.toml"
    parts = {"bad": ("feedthrough2", "1 ms", {"fault": FAULTS2[fault], "bad_at": 0.0045, **FREE})}
    path.write_text(system_text(parts, stop="10 ms"), encoding="utf-8")
    command = [sys.executable, "-m", "rovbrush.orchestrator", "run", str(path), "--fmus", str(fmus)]
    return subprocess.Popen(
        [*command, "--out", str(folder / "out")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def child_of(process: subprocess.Popen[str]) -> int:
    """The process that does the work."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    deadline = time.monotonic() + 30.0
    while time.monotonic() < deadline:
        found = children.read_text().split()
        if found:
            return int(found[0])
        time.sleep(0.05)
    raise AssertionError("the command made no process")


def is_alive(pid: int) -> bool:
    status = Path(f"/proc/{pid}/status")
    return status.is_file() and "\nState:\tZ" not in status.read_text()


@pytest.mark.parametrize(("fault", "how"), [("crash", "SIGSEGV"), ("exit", "exit code 3")])
def test_an_fmu_that_ends_the_process_is_an_error_with_a_remedy(
    fault: str, how: str, native: Path, tmp_path: Path
) -> None:
    with started(tmp_path, native, fault) as process:
        _, err = process.communicate(timeout=120)
    assert process.returncode == 1
    assert how in err and 'isolation = "process"' in err and "Traceback" not in err
    assert not (tmp_path / "out" / "result.nc").exists(), "nothing half-written"


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_an_fmu_that_never_returns_is_ended_by_pressing_ctrl_c_three_times(native: Path, tmp_path: Path) -> None:
    with started(tmp_path, native, "hang") as process:
        try:
            child = child_of(process)
            assert process.stderr is not None and process.stderr.readline() == "hanging\n"
            presses, deadline = 0, time.monotonic() + 60.0
            while process.poll() is None and time.monotonic() < deadline:  # those that come too fast are one
                process.send_signal(signal.SIGINT)
                presses += 1
                time.sleep(0.01)
            _, err = process.communicate(timeout=60)
        finally:
            process.kill()
    assert process.returncode == 1 and "SIGKILL" in err and not is_alive(child) and presses >= 3


def test_what_is_registered_for_the_end_is_done() -> None:
    code = (
        "import atexit, ctypes, sys, threading, time; from rovbrush.orchestrator.cli import guard\n"
        "def work():\n"
        "    atexit.register(print, 'handler')\n"
        "    threading.Thread(target=lambda: (time.sleep(0.2), print('thread'))).start()\n"
        "    ctypes.CDLL(None).printf(b'C\\n')\n"
        "    print('work')\n"
        "    sys.exit(3)\n"
        "guard.guarded(work)"
    )
    done = python(code)
    assert done.returncode == 3 and sorted(done.stdout.split()) == ["C", "handler", "thread", "work"], done.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_the_work_does_not_outlive_the_command(native: Path, tmp_path: Path) -> None:
    with started(tmp_path, native, "hang") as process:
        child = child_of(process)
        time.sleep(1.0)
        process.kill()
        process.wait()
        deadline = time.monotonic() + 10.0
        while is_alive(child) and time.monotonic() < deadline:
            time.sleep(0.05)
        assert not is_alive(child)
