"""An FMU that asks to end: who, when, and how far its last step went. That ends a run well.

FMI 2.0: it discards a step, and fmi2Terminated is true; FMI 3.0: terminateSimulation. The step counts where it was
done to its end: everybody else comes to that instant then, and its row is the last one.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...loop import cells, versions
from ...loop.calls import EARLY_RETURN, LAST_TIME
from ...loop.operations import STEP, STEP_ON
from ...participant.base import Participant
from ...participant.lifecycle import DISCARD
from ...plan.plan import Plan
from ..memory.algorithm_state import AlgorithmState

NEARLY = 1e-9  # of a step, by which what an FMU says that it reached may miss the step's end


@dataclass(frozen=True)
class Asked:
    """`component`: its number; `tick`: the end of the step; `whole`: whether it was done until then. `text` says who,
    and when it ended."""

    component: int
    tick: int
    whole: bool
    text: str


def asked_to_end(
    plan: Plan, instances: Mapping[str, Participant], control: np.ndarray, space: AlgorithmState, components: np.ndarray
) -> Asked | None:
    """What the component that stopped the loop asks for; None if it does not ask to end. Arrays as in `loop.run`."""
    operation = plan.operations(int(control[cells.AT_CYCLE]))[control[cells.AT_OPERATION]]
    status = int(control[cells.STATUS])
    if operation[0] not in (STEP, STEP_ON) or status not in (versions.TERMINATE, DISCARD):
        return None
    k = int(operation[2])
    instance = list(instances.values())[k]
    end = _end(plan, operation, control, space.clock)
    time, length = plan.clock.time(end[0]), float(plan.clock.seconds(end[1]))
    reached = time
    if status == versions.TERMINATE:
        flags = int(components[k, cells.FLAGS])
        if ctypes.c_ubyte.from_address(flags + EARLY_RETURN).value:
            reached = ctypes.c_double.from_address(flags + LAST_TIME).value
    else:
        instance.noted("step", status)
        if instance.dead or not instance.terminated():
            return None
        reached = instance.reached()
    whole = reached >= time - NEARLY * length
    reached = reached if math.isfinite(reached) and not whole else time if whole else plan.clock.time(end[0] - end[1])
    words = ": ".join(["", *instance.speaker.messages[-1:]])
    return Asked(
        k, end[0], whole, f"component {instance.speaker.name} asked to end the simulation at t = {reached:.9g} s{words}"
    )


def _end(plan: Plan, operation: np.ndarray, control: np.ndarray, varying: np.ndarray) -> tuple[int, int]:
    """The end of a step and its length [ticks]; `varying`: the loop's own clock."""
    length = int(operation[3] + varying[cells.STEP_TICKS])
    base = int(control[cells.AT_CYCLE]) * plan.cycle_ticks + int(varying[cells.NOW] + varying[cells.OFFSET])
    return base + int(operation[4]) + length, length
