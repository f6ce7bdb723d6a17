"""The least that any master costs: the FMUs' own functions, called one after the other from a compiled loop."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np

from ....loop import operations as op
from ....loop.calls import call_state, do_step, exchange2
from ....participant.here.fmi2 import Fmi2Instance
from ....plan.plan import Plan

SET, GET, STEP, INSTANCE, IN_REFS, IN_COUNT, OUT_REFS, OUT_COUNT, VALUES, STATE = range(10)
STATES = ("fmi2GetFMUstate", "fmi2SetFMUstate", "fmi2FreeFMUstate")
GET_STATE, SET_STATE, FREE_STATE = range(STATE + 1, STATE + 1 + len(STATES))
CALLS = (op.SET, op.STEP, op.GET, op.SAVE, op.RESTORE, op.ITERATE, op.REPEAT)


def call_all(table: np.ndarray, steps: int, step: float) -> int:
    """`steps` times: set, step and get every FMU of `table` (n, 13); the worst status."""
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


def call_in_order(table: np.ndarray, calls: np.ndarray, steps: int, step: float, passes: int) -> int:
    """`steps` times what `calls` (m, 3) say, each by its operation, its FMU, and where it goes on; the worst status.

    A step that is iterated takes so many passes.
    """
    worst = 0
    for k in range(steps):
        left, m = passes, 0
        while m < calls.shape[0]:
            code, c, to = calls[m, 0], calls[m, 1], calls[m, 2]
            m += 1
            status = 0
            if code == op.SET:
                status = exchange2(
                    table[c, SET], table[c, INSTANCE], table[c, IN_REFS], table[c, IN_COUNT], table[c, VALUES]
                )
            elif code == op.GET:
                status = exchange2(
                    table[c, GET], table[c, INSTANCE], table[c, OUT_REFS], table[c, OUT_COUNT], table[c, VALUES]
                )
            elif code == op.STEP:
                status = do_step(table[c, STEP], table[c, INSTANCE], k * step, step, 0)
            elif code == op.SAVE:
                if table[c, STATE] != 0:
                    status = call_state(table[c, FREE_STATE], table[c, INSTANCE], table[c].ctypes.data + 8 * STATE)
                    table[c, STATE] = 0
                worst = max(worst, status)
                status = call_state(table[c, GET_STATE], table[c, INSTANCE], table[c].ctypes.data + 8 * STATE)
            elif code == op.RESTORE:
                status = call_state(table[c, SET_STATE], table[c, INSTANCE], table[c, STATE])
            elif code == op.REPEAT:
                m = to
            else:
                left -= 1
                if left == 0:
                    m = to
            worst = max(worst, status)
    return worst


def _calls(cycle: np.ndarray) -> np.ndarray:
    """Of the operations of a plan those that call FMUs, or decide who is called next."""
    called = np.isin(cycle[:, 0], CALLS) & ~(np.isin(cycle[:, 0], (op.SAVE, op.RESTORE)) & (cycle[:, 2] < 0))
    found: np.ndarray = cycle[called][:, [0, 2, 3]].copy()
    jumps = np.isin(found[:, 0], (op.ITERATE, op.REPEAT))
    found[jumps, 2] = np.concatenate([[0], np.cumsum(called)])[found[jumps, 2]]
    return found


@cache
def _compiled(function: Any) -> Any:
    import numba

    from ....loop.machine import calls as calls

    return numba.njit(function)


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
    """The FMUs of a plan of one period, and their functions, to be called as often as one likes.

    `passes`: of each step, where the plan repeats steps.
    """

    def __init__(self, plan: Plan, passes: int = 1) -> None:
        self.instances = started(plan)
        self._keep, rows = [], []
        repeats = plan.algorithm.saves_states
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
                 references[0].ctypes.data, len(given), references[1].ctypes.data, len(taken), values.ctypes.data, 0,
                 *((instance.address(f) if repeats else 0) for f in STATES)]
            )  # fmt: skip
        self._table = np.array(rows, dtype=np.int64)
        self._step = float(plan.clock.seconds(min(plan.clock.periods.values())))
        self._call: Callable[[int, float], int] = partial(_compiled(call_all), self._table)
        if repeats:
            in_order, calls = _compiled(call_in_order), _calls(plan.cycle)
            self._call = lambda steps, step: in_order(self._table, calls, steps, step, passes)
        self._call(1, self._step)

    def seconds(self, steps: int) -> float:
        """Wall time of so many macro steps."""
        begin = time.perf_counter()
        self._call(steps, self._step)
        return time.perf_counter() - begin

    def close(self) -> None:
        """Give the FMUs back, and their states."""
        for row, instance in zip(self._table, self.instances.values(), strict=True):
            if row[STATE]:
                call_state(int(row[FREE_STATE]), instance.pointer, row.ctypes.data + 8 * STATE)
            instance.close()


def floor_loop(plan: Plan) -> float:
    """Seconds that the functions of the FMUs take, called as often as the plan does; a system of one period."""
    floor = Floor(plan)
    wall = floor.seconds(plan.clock.stop // min(plan.clock.periods.values()))
    floor.close()
    return wall
