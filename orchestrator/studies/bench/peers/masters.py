"""What a macro step costs in this master, in others and as bare calls, and what a start costs, all in one run.

A macro step is one period of the fastest component. Ratios of rows from one run count; the machine does not.
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from ....errors import RunError
from ....plan.plan import Plan, make_plan
from ....results.tables import require_complete
from ....run.simulation import simulate
from ....run.stepping.stepping import Stepping
from ....system.model import System
from ..fmus.systems import Case
from .floor import floor_loop
from .hosts import run_host

REPEATS = 5
ELSEWHERE = 3  # repetitions in another master, each in a process of its own


def measured(case: Case, hosts: list[str], quick: bool = False) -> list[dict[str, Any]]:
    """The rows of one system, recording off and on; with `quick` one run of each."""
    repeats, elsewhere = (1, 1) if quick else (REPEATS, ELSEWHERE)
    rows: list[dict[str, Any]] = []
    for recording in (False, True):
        system = replace(case.system, record=("*",) if recording else (), bonds=())
        label: dict[str, Any] = {"system": case.name, "recording": recording, "runs": repeats}
        rows.append({**label, "master": "rovbrush", "us_per_macro_step": per_step(system, rovbrush_loop, repeats)})
        if case.steps_elsewhere:
            steps = min(c.period for c in system.components.values()) * case.steps_elsewhere
            by_hand = per_step(replace(system, stop=steps), hand_loop, repeats)
            rows.append({**label, "master": "rovbrush by hand", "us_per_macro_step": by_hand})
            if not recording:
                least = per_step(system, floor_loop, repeats)
                rows.append({**label, "master": "calls alone", "us_per_macro_step": least})
            for host in hosts:
                rows.append({**label, "master": host, **_elsewhere(host, system, case.steps_elsewhere, elsewhere)})
        else:
            wall = 1e-6 * rows[-1]["us_per_macro_step"] / float(min(c.period for c in system.components.values()))
            rows[-1]["real_time_factor"] = 1.0 / wall
    return rows


def _elsewhere(host: str, system: System, steps: int, runs: int) -> dict[str, Any]:
    """What a macro step takes in another master [us]; None, and why, where that one fails."""
    recording = bool(system.record)
    try:
        seconds = statistics.median(run_host(host, system, steps, recording).seconds_per_step for _ in range(runs))
    except RunError as error:
        return {"us_per_macro_step": None, "failed": str(error)}
    return {"us_per_macro_step": 1e6 * seconds}


def per_step(system: System, loop: Callable[[Plan], float], repeats: int = REPEATS) -> float:
    """Median over `repeats` runs of a loop's wall time, in microseconds per macro step."""
    plan = make_plan(system)
    steps = plan.clock.stop // min(plan.clock.periods.values())
    return 1e6 * statistics.median(loop(plan) for _ in range(repeats)) / steps


def rovbrush_loop(plan: Plan) -> float:
    """Seconds that the compiled master takes."""
    return require_complete(simulate(plan)).wall


def hand_loop(plan: Plan) -> float:
    """Seconds that the same steps take if Python asks for each."""
    with Stepping(plan) as session:
        begin = time.perf_counter()
        while session.tick < plan.clock.stop:
            session.step()
        return time.perf_counter() - begin


def process_figures(fmus: Path | None) -> dict[str, float]:
    """Start to first step [s] and peak memory [MB] of a `rovbrush run nominal` in its own process, caches warm."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "rovbrush.orchestrator", "run", "nominal", "--out", folder]
        done = subprocess.run(
            [*command, *(["--fmus", str(fmus)] if fmus else [])], capture_output=True, text=True, check=False
        )
        if done.returncode:
            raise RunError(f"the nominal run in a process of its own failed: {done.stderr.strip()}")
        summary = json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))
    return {key: summary[key] for key in ("start_s", "peak_memory_MB")}


def rerun_figures(fmus: Path | None) -> dict[str, float]:
    """Wall time [s] of 20 ms of the nominal run from Python, in a process of its own: loading, first and later runs."""
    code = (
        "import json, sys, time\nfrom rovbrush.orchestrator import load\ntimes = [time.perf_counter()]\n"
        "system = load('nominal', stop='20 ms', fmus=sys.argv[1] or None)\ntimes.append(time.perf_counter())\n"
        "for k in range(6):\n    system.set('motor.R', 0.1 + 0.001 * k).run()\n    times.append(time.perf_counter())\n"
        "print(json.dumps([b - a for a, b in zip(times, times[1:])]))"
    )
    done = subprocess.run([sys.executable, "-c", code, str(fmus or "")], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RunError(f"the nominal run from Python failed: {done.stderr.strip()}")
    loading, first, *later = json.loads(done.stdout)
    return {"load_s": loading, "first_run_s": first, "next_run_s": statistics.median(later)}
