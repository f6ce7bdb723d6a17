"""What one component costs by itself: as native FMU, as Python FMU, and its compiled kernel without FMI."""

from __future__ import annotations

import statistics
from fractions import Fraction
from importlib.metadata import entry_points
from typing import Any

from ....plan.plan import make_plan
from ....system.model import System
from ..fmus.systems import alone
from ..peers.floor import floor_loop

STEP = Fraction(1, 1000)  # s, of every call
REPEATS = 7
KINDS = {"native": "native FMU", "python": "Python FMU", "kernel": "compiled kernel"}


def component_rows(native: System, python: System, quick: bool = False) -> list[dict[str, Any]]:
    """Microseconds per call for every component of a system of native and one of Python FMUs, measured in turns."""
    timings = [entry.load() for entry in entry_points(group="rovbrush.timings")]
    rows = []
    for name in native.components:
        single = {"native": alone(native, name, STEP), "python": alone(python, name, STEP)}
        plans = {kind: make_plan(system) for kind, system in single.items()}
        component = single["python"].components[name]
        values = {**component.parameters, **component.inputs}
        seconds: dict[str, list[float]] = {}
        for _ in range(1 if quick else REPEATS):
            for kind, plan in plans.items():
                steps = plan.clock.stop // plan.clock.periods[name]
                seconds.setdefault(kind, []).append(floor_loop(plan) / steps)
            for timing in timings:  # of the package that the components come from, where it is installed
                measured = timing(component.fmu.description.modelName, values, float(STEP), steps)
                seconds.setdefault("kernel", []).append(measured)
        rows += [
            {"component": name, "life": kind, "runs": len(found), "us_per_call": 1e6 * statistics.median(found)}
            for kind, found in seconds.items()
        ]
    return rows
