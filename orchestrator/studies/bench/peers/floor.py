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


class Floor:
    """The FMUs of a plan of one period, and their functions, to be called as often as one likes."""

    def __init__(self, plan: Plan) -> None:
        self.instances = started(plan)
        self._keep, rows = [], []
        for name, instance in self.instances.items():
            given, taken = plan.layout.exchanged(name)
            references = [
                np.array([instance.fmu.places[v].reference for v in table] or [0], dtype=np.uint32)
                for table in (given, taken)
            ]
            values = np.array([float(instance.fmu.start(v)) for v in given] + [0.0] * (len(taken) + 1))
            self._keep += [*references, values]
            rows.append(
                [*(instance.address(f) for f in ("fmi2SetReal", "fmi2GetReal", "fmi2DoStep")), instance.pointer,
                 references[0].ctypes.data, len(given), references[1].ctypes.data, len(taken), values.ctypes.data]
            )  # fmt: skip
        self._table, self._function = np.array(rows, dtype=np.int64), _compiled()
        self._step = float(plan.clock.seconds(min(plan.clock.periods.values())))
        self._function(self._table, 1, self._step)

    def seconds(self, steps: int) -> float:
        """Wall time of so many macro steps."""
        begin = time.perf_counter()
        self._function(self._table, steps, self._step)
        return time.perf_counter() - begin

    def close(self) -> None:
        """Give the FMUs back."""
        for instance in self.instances.values():
            instance.close()


def floor_loop(plan: Plan) -> float:
    """Seconds that the functions of the FMUs take, called as often as the plan does; a system of one period."""
    floor = Floor(plan)
    wall = floor.seconds(plan.clock.stop // min(plan.clock.periods.values()))
    floor.close()
    return wall
