"""What a point of a sweep costs with its results: two small native FMUs that stay loaded, on all cores."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ....run.simulation import simulate
from ...sweep.options import Options
from ...sweep.sweep import sweep
from ...sweep.workers.point import Job, load
from ...sweep.workers.workers import cores

POINTS, QUICK = 100_000, 5_000
ALONE = 50  # runs with FMUs that are loaded anew
SYSTEM = """
format = 2
description = "a motor on a battery, switched on"
stop_time = "20 ms"
connections = ["battery.V -> motor.V_in", "motor.i -> battery.i"]
[components.battery]
fmu = "battery"
period = "1 ms"
inputs = { i_other = 0.0 }
[components.motor]
fmu = "dc_motor"
period = "1 ms"
[summary]
i_peak = "peak motor.i"
i_last = "last motor.i"
V_mean = "mean battery.V"
"""


def sweep_rows(folder: Path, native: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Wall time of a point of a whole sweep, from the first to the end of sweep.nc and sweep.csv, CPU time of the
    workers for it, and a run whose FMUs are loaded for it alone, in this process.

    With each row comes the share of the work that is done. Raises RunError if a point fails.
    """
    system = folder / "started.toml"
    system.write_text(SYSTEM, encoding="utf-8")
    plan = load(Job(str(system), str(native)))
    simulate(plan)
    begin = time.process_time()
    for _ in range(ALONE):
        simulate(plan)
    alone = (time.process_time() - begin) / ALONE
    points = QUICK if quick else POINTS
    options = Options(["motor.R=0.06:0.12", "battery.soc_start=0.3:1"], random=points, seed=1, fmus=native)
    begin = time.perf_counter()
    swept = sweep(str(system), folder / "swept", options)
    whole = time.perf_counter() - begin
    swept.require_all()
    assert swept.cost is not None
    size = (folder / "swept" / "points.jsonl").stat().st_size + (folder / "swept" / "sweep.nc").stat().st_size
    yield 1.0, {
        "system": "motor on a battery, 20 steps", "points": points, "workers": cores(), "wall_s": whole,
        "ms_per_point": 1e3 * whole / points, "worker_ms_per_point": 1e3 * swept.cost.cpu_s / points,
        "loaded_anew_ms": 1e3 * alone, "bytes_per_point": size / points,
    }  # fmt: skip
