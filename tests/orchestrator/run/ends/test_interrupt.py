"""Ctrl-C ends a run between two instants: complete rows are kept, the process lives and ends as it means to."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from helpers import plan_of, system_text
from pressing import pressing
from rovbrush.orchestrator.run.ends.interrupt import ENDING, StopRequests
from rovbrush.orchestrator.run.simulation import simulate

CODE = """
import json, signal, sys
from pathlib import Path
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.run.simulation import simulate

def progress(time):
    print("at", time, flush=True)

plan = make_plan(load_system(sys.argv[1], Path(sys.argv[2])))
run = simulate(plan, progress=progress)
assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
rows = [len(table) for table in run.tables]
last = [table[-1].tolist() for table in run.tables]
print(json.dumps({"failure": run.failure, "end": run.end, "rows": rows, "last": last}), flush=True)
sys.exit(3)
"""


@pytest.mark.parametrize("interpreted", [False, True])
def test_ctrl_c_in_a_step_lets_the_instant_be_completed(interpreted: bool, tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, pressing(5)), interpreted)
    assert (run.end, run.failure) == (0.006, "interrupted by the user at t = 0.006 s")
    assert [len(table) for table in run.tables] == [13, 7]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_ctrl_c_during_initialization_is_no_fault_of_the_fmu(tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, pressing(4)))
    assert (run.end, run.failure) == (0.0, "interrupted by the user at t = 0 s")
    assert [len(table) for table in run.tables] == [1, 1]


def test_an_interrupted_process_keeps_its_complete_rows(tmp_path: Path, fmus: Path) -> None:
    sleeper = {"mode": 3, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0}  # 20 ms of wall time per step
    parts = {"slow": ("plain", "20 ms", sleeper), "fast": ("wave", "10 ms", {"c1": 1.0})}
    path = tmp_path / "case.toml"
    path.write_text(system_text(parts, stop="1000 s"))
    command = [sys.executable, "-c", CODE, str(path), str(fmus)]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=os.environ
    ) as process:
        assert process.stdout is not None and process.stderr is not None
        try:
            while not process.stdout.readline().startswith("at 0.1"):
                assert process.poll() is None, process.stderr.read()
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=20)
        finally:
            process.kill()
    assert process.returncode == 3, err
    seen = json.loads(out.splitlines()[-1])
    end = seen["end"]
    assert seen["failure"] == f"interrupted by the user at t = {end:.9g} s"
    assert 0.1 <= end < 20.0, "soon after the signal"
    fast, slow = seen["rows"]
    assert (fast - 1) * 0.01 == pytest.approx(end) and (slow - 1) == (fast - 1) // 2
    assert seen["last"][0][0] == pytest.approx(end)


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_what_was_ignored_at_the_start_stays_ignored(name: str) -> None:
    """As nohup and background jobs want it."""
    number, before = getattr(signal, name), signal.getsignal(getattr(signal, name))
    try:
        signal.signal(number, signal.SIG_IGN)
        requests = StopRequests(ENDING)
        with requests.heard():
            os.kill(os.getpid(), number)
        assert not requests.asked and signal.getsignal(number) is signal.SIG_IGN
    finally:
        signal.signal(number, before)


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_a_signal_asks_once_and_insists_the_second_time(name: str) -> None:
    number, before = getattr(signal, name), signal.getsignal(getattr(signal, name))
    signal.signal(number, signal.SIG_DFL)
    try:
        requests = StopRequests(ENDING)
        with requests.heard():
            os.kill(os.getpid(), number)
            assert requests.asked and requests.came == number
            with pytest.raises(KeyboardInterrupt):
                os.kill(os.getpid(), number)
        assert signal.getsignal(number) is signal.SIG_DFL
    finally:
        signal.signal(number, before)


def test_a_program_that_is_not_ours_keeps_its_signals_but_ctrl_c() -> None:
    before = signal.getsignal(signal.SIGTERM)
    with StopRequests().heard():
        assert signal.getsignal(signal.SIGTERM) is before
