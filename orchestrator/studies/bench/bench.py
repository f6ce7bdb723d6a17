"""What the master costs: microseconds per macro step, beside other masters and the bare calls, all in one run.

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
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ...errors import RunError
from ...files import prepare_folder, write_file, write_json
from ...plan.plan import Plan, make_plan
from ...results.tables import require_complete
from ...run.simulation import simulate
from ...run.stepping import Stepping
from ...system.model import System
from .components import component_rows
from .floor import floor_loop
from .hosts import HOSTS, missing, run_host
from .streaming import long_runs
from .systems import Case, cases

REPEATS = 5
ELSEWHERE = 3  # repetitions in another master, each in a process of its own


@dataclass(frozen=True)
class Measured:
    """The rows of `rovbrush bench`: systems in all masters, components by themselves, long runs, and lines to tell."""

    systems: list[dict[str, Any]]
    components: list[dict[str, Any]]
    long_runs: list[dict[str, Any]]

    @property
    def rows(self) -> list[dict[str, Any]]:
        """All of them."""
        return [*self.systems, *self.components, *self.long_runs]


def bench(json_file: Path | None, fmus: Path | None, tell: Callable[[str], None] = lambda _line: None) -> Measured:
    """Measure all systems in all masters, and write the rows. Raises RunError if a run fails."""
    if json_file:
        prepare_folder(json_file.parent, "--json")
    absent = {host: why for host in HOSTS if (why := missing(host))}
    for host, why in absent.items():
        tell(f"without {host}: {why}")
    rows: list[dict[str, Any]] = []
    with tempfile.TemporaryDirectory() as folder:
        found = cases(Path(folder), fmus)
        for case in found:
            rows += measured(case, [host for host in HOSTS if host not in absent], tell)
        parts = component_rows(native=found[-1].system, python=found[-2].system)
    mark(rows, "nominal", process_figures(fmus) | rerun_figures(fmus))
    result = Measured(rows, parts, long_runs(tell))
    if json_file:
        write_file(json_file, lambda path: write_json(path, result.rows))
    return result


def measured(case: Case, hosts: list[str], tell: Callable[[str], None]) -> list[dict[str, Any]]:
    """The rows of one system, recording off and on."""
    rows: list[dict[str, Any]] = []
    for recording in (False, True):
        system = replace(case.system, record=("*",) if recording else (), bonds=())
        label: dict[str, Any] = {"system": case.name, "recording": recording}
        tell(f"measuring {case.name}, recording {'on' if recording else 'off'}")
        rows.append({**label, "master": "rovbrush", "us_per_macro_step": per_step(system, rovbrush_loop)})
        if case.steps_elsewhere:
            steps = min(c.period for c in system.components.values()) * case.steps_elsewhere
            by_hand = per_step(replace(system, stop=steps), hand_loop)
            rows.append({**label, "master": "rovbrush by hand", "us_per_macro_step": by_hand})
            if not recording:
                rows.append({**label, "master": "calls alone", "us_per_macro_step": per_step(system, floor_loop)})
            for host in hosts:
                seconds = statistics.median(
                    run_host(host, system, case.steps_elsewhere, recording).seconds_per_step for _ in range(ELSEWHERE)
                )
                rows.append({**label, "master": host, "us_per_macro_step": 1e6 * seconds})
        else:
            wall = 1e-6 * rows[-1]["us_per_macro_step"] / float(min(c.period for c in system.components.values()))
            rows[-1]["real_time_factor"] = 1.0 / wall
    return rows


def per_step(system: System, loop: Callable[[Plan], float]) -> float:
    """Median over REPEATS runs of a loop's wall time, in microseconds per macro step."""
    plan = make_plan(system)
    steps = plan.clock.stop // min(plan.clock.periods.values())
    return 1e6 * statistics.median(loop(plan) for _ in range(REPEATS)) / steps


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


def mark(rows: list[dict[str, Any]], system: str, figures: dict[str, float]) -> None:
    """Add figures to the row of a system with recording on."""
    next(r for r in rows if (r["system"], r["master"], r["recording"]) == (system, "rovbrush", True)).update(figures)


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
