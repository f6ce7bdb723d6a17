"""The least that any master costs: the FMUs' own functions, called one after the other from a compiled loop."""

from __future__ import annotations

import time
from functools import cache
from typing import Any

import numpy as np

from ....loop.calls import do_step, exchange2
from ....participant.here.fmi2 import Fmi2Instance
from ....plan.plan import Plan

SET, GET, STEP, INSTANCE, IN_REFS, IN_COUNT, OUT_REFS, OUT_COUNT, VALUES = range(9)


def call_all(table: np.ndarray, steps: int, step: float) -> int:
    """`steps` times: set, step and get every FMU of `table` (n, 9); the worst status."""
    worst = 0
    for k in range(steps):
        for c in range(table.shape[0]):
            if table[c, IN_COUNT]:
                status = exchange2(
                    table[c, SET], table[c, INSTANCE], table[c, IN_REFS], table[c, IN_COUNT], table[c, VALUES]
                )
                worst = max(worst, status)
            worst = max(worst, do_step(table[c, STEP], table[c, INSTANCE], k * step, step, 1))
            if table[c, OUT_COUNT]:
                status = exchange2(
                    table[c, GET], table[c, INSTANCE], table[c, OUT_REFS], table[c, OUT_COUNT], table[c, VALUES]
                )
                worst = max(worst, status)
    return worst


@cache
def _compiled() -> Any:
    import numba

    from ....loop.machine import calls as calls

    return numba.njit(call_all)


def started(plan: Plan) -> dict[str, Fmi2Instance]:
    """The FMUs of a plan, initialized."""
    instances = {name: Fmi2Instance(component.fmu, name) for name, component in plan.system.components.items()}
    for name, instance in instances.items():
        component = plan.system.components[name]
        instance.set_up(plan.clock.time(plan.clock.stop), plan.clock.time(0))
        instance.set_all({**component.parameters, **component.inputs})
        instance.enter_initialization()
        instance.exit_initialization()
    return instances


def floor_loop(plan: Plan) -> float:
    """Seconds that the functions of the FMUs take, called as often as the plan does; a system of one period."""
    instances = started(plan)
    keep, rows = [], []
    for name, instance in instances.items():
        given, taken = plan.layout.exchanged(name)
        references = [
            np.array([instance.fmu.places[v].reference for v in table] or [0], dtype=np.uint32)
            for table in (given, taken)
        ]
        values = np.array([float(instance.fmu.start(v)) for v in given] + [0.0] * (len(taken) + 1))
        keep += [*references, values]
        rows.append(
            [*(instance.address(f) for f in ("fmi2SetReal", "fmi2GetReal", "fmi2DoStep")), instance.pointer,
             references[0].ctypes.data, len(given), references[1].ctypes.data, len(taken), values.ctypes.data]
        )  # fmt: skip
    table, period = np.array(rows, dtype=np.int64), min(plan.clock.periods.values())
    steps, step = plan.clock.stop // period, float(plan.clock.seconds(period))
    function = _compiled()
    function(table, 1, step)
    begin = time.perf_counter()
    function(table, steps, step)
    wall = time.perf_counter() - begin
    for instance in instances.values():
        instance.close()
    return wall
