"""Arrays that the loop needs for steps that are repeated or that vary; empty ones where they are neither."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from ..loop import cells, iteration
from ..participant.base import Instance
from ..plan.algorithms.ecco import step_limits
from ..plan.plan import Plan


@dataclass
class AlgorithmState:
    """See `loop.run`."""

    clock: np.ndarray
    work: np.ndarray
    saved: np.ndarray
    states: np.ndarray
    state_calls: np.ndarray

    @property
    def arrays(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        return self.clock, self.work, self.saved, self.states, self.state_calls


def make_state(plan: Plan, instances: dict[str, Instance]) -> AlgorithmState:
    """What the plan's algorithm needs."""
    count = len(instances)
    space = AlgorithmState(
        np.zeros(cells.CLOCK_CELLS, dtype=np.int64), np.zeros(3), np.zeros(1), np.zeros(count, dtype=np.int64),
        np.zeros((count, 3), dtype=np.int64),
    )  # fmt: skip
    if plan.system.algorithm == "iterated":
        space.work = iteration.workspace(len(plan.layout.unknowns), plan.system.iteration.method == "newton")
        space.saved = np.zeros(plan.layout.size)
        for k, instance in enumerate(instances.values()):
            space.state_calls[k] = [instance.address(function) for function in instance.state_functions]
    if plan.adaptive:
        tick = plan.clock.seconds(1)
        minimum, maximum = step_limits(plan.system)
        first = min(plan.clock.hyperperiod, plan.clock.stop)
        space.clock[cells.STEP_TICKS], space.clock[cells.STOP] = first, plan.clock.stop
        space.clock[cells.MINIMUM], space.clock[cells.MAXIMUM] = ceil(minimum / tick), int(maximum / tick)
    return space


def free_states(space: AlgorithmState, instances: dict[str, Instance]) -> None:
    """Give saved states back to the FMUs that are alive."""
    from ..loop.calls import call_state

    for k, instance in enumerate(instances.values()):
        if space.states[k] and not instance.dead:
            call_state(int(space.state_calls[k, 2]), instance.pointer, space.states.ctypes.data + 8 * k)
