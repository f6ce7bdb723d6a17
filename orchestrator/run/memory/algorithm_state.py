"""Arrays that the loop needs for steps that are repeated or that vary; empty ones where they are neither."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...participant.base import Participant
from ...plan.algorithms.base import LoopArrays
from ...plan.plan import Plan
from .moments import Moments


@dataclass
class AlgorithmState:
    """See `loop.run`."""

    loop: LoopArrays
    solver: np.ndarray
    states: np.ndarray
    state_calls: np.ndarray
    moments: Moments | None = None  # cells of the solver's memory, where there are events

    @property
    def clock(self) -> np.ndarray:
        return self.loop.clock

    @property
    def arrays(self) -> tuple[np.ndarray, ...]:
        return *self.loop, self.solver, self.states, self.state_calls


def make_state(plan: Plan, instances: dict[str, Participant]) -> AlgorithmState:
    """What the plan's algorithm needs."""
    count = len(instances)
    state = AlgorithmState(
        plan.algorithm.arrays(plan), plan.layout.loop_memory(), np.zeros(count, dtype=np.int64),
        np.zeros((count, 3), dtype=np.int64),
    )  # fmt: skip
    if plan.events:
        loops = len(state.solver)
        state.solver = np.concatenate([state.solver, np.zeros(Moments.size(count))])
        state.moments = Moments(state.solver[loops:], count)
        state.moments.begin(plan.clock.time(0))
    if plan.algorithm.saves_states:
        for k, instance in enumerate(instances.values()):
            if instance.fmu.can_save_state:
                state.state_calls[k] = [instance.address(function) for function in instance.state_functions]
    return state


def free_states(state: AlgorithmState, instances: dict[str, Participant]) -> None:
    """Give saved states back to the FMUs that are alive."""
    from ...loop.calls import call_state

    for k, instance in enumerate(instances.values()):
        if state.states[k] and not instance.dead:
            call_state(int(state.state_calls[k, 2]), instance.pointer, state.states.ctypes.data + 8 * k)
