"""Ctrl-C ends a run between two instants: complete rows are kept, the process lives and ends as it means to."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from helpers import Part, plan_of, system_text
from rovbrush.orchestrator.run.simulation import simulate

CODE = """
import json, signal, sys
from pathlib import Path
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.reader import load_system
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


def pressing(mode: int) -> dict[str, Part]:
    """A system in which somebody presses Ctrl-C: mode 4 at the end of initialization, mode 5 in the step to 6 ms."""
    parts: dict[str, Part] = {"fast": ("wave", "0.5 ms", {"c1": 1.0})}
    return parts | {"p": ("plain", "1 ms", {"mode": mode, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0})}


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
