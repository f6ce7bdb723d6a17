"""Why a run ended early: who, what and when, from what the loop leaves in its cells."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...fmu.types import decode
from ...loop import cells, versions
from ...loop.operations import SET, SOLVE, STEP, STEP_ON
from ...participant.base import Participant
from ...participant.lifecycle import DISCARD, FATAL, PENDING, status_text
from ...plan.plan import Plan
from ..memory.algorithm_state import AlgorithmState

REPORTED = {
    versions.EARLY: " returned early (earlyReturn), which it was not allowed to,",
    versions.EVENT: " needs event handling (eventHandlingNeeded), which this master does not do,",
}

UNDER_WAY = (
    "; it goes on with the step by itself, which this master does not wait for: it needs an FMU that is done when it "
    "returns (canRunAsynchronuously = false, or a setting of its tool)"
)


def failure_of(
    plan: Plan, instances: Mapping[str, Participant], code: int, control: np.ndarray, z: np.ndarray,
    space: AlgorithmState,
) -> tuple[float, str]:  # fmt: skip
    """The time [s] until which every component is complete, and what happened; arrays as in `loop.run`."""
    clock, operations = plan.clock, plan.operations(int(control[cells.AT_CYCLE]))
    row = operations[control[cells.AT_OPERATION]]
    begin = int(control[cells.AT_CYCLE]) * clock.hyperperiod
    name = "" if row[0] == SOLVE else list(plan.system.components)[row[2]]
    ahead = clock.periods[name] if row[2] >= 0 and name in plan.early else 0
    at = clock.time(min(begin + int(row[1]) + ahead, clock.stop))
    ticks = operations[:, 1]
    end = clock.time(begin + int(np.max(ticks, where=ticks < row[1], initial=0)))
    if plan.adaptive:
        now, step = int(space.clock[cells.NOW]), int(space.clock[cells.STEP_TICKS])
        at, end = clock.time(now + int(space.clock[cells.OFFSET]) + step), clock.time(now)
    if plan.algorithm.repeats_rows:
        end = clock.time(begin)
    if code == cells.INTERRUPTED:
        return end, f"interrupted by the user at t = {end:.9g} s"
    if code == cells.NOT_CONVERGED and row[0] != SOLVE:
        return end, plan.algorithm.failure(plan, space.loop, at)
    if code == cells.LATE:
        late, slowest = int(control[cells.WORST]) / 1e9, int(control[cells.WORST_COMPONENT])
        who = f"; the most time before it was needed by {list(plan.system.components)[slowest]}" if slowest >= 0 else ""
        return at, f"the deadline of t = {at:.9g} s was missed by {1e3 * late:.3g} ms (--realtime-policy stop){who}"
    if code == cells.GAVE_UP:
        return end, f"the compiled loop gave up behind t = {end:.9g} s, which it never should: please report that"
    instant = clock.time(begin + int(row[1])) if row[0] == SOLVE else at
    return end, failed_at(plan, instances, code, control, z, row, f"t = {instant:.9g} s")


def failed_at(
    plan: Plan, instances: Mapping[str, Participant], code: int, control: np.ndarray, z: np.ndarray, row: np.ndarray,
    at: str, event: bool = False,
) -> str:  # fmt: skip
    """What happened in an operation, of a cycle or of an event."""
    if row[0] == SOLVE and code == cells.NOT_CONVERGED:
        loop, loops = plan.layout.loops[int(row[2])], plan.system.loops
        return (
            f"Newton's method finds no solution of the algebraic {loop} at {at} within "
            f"{loops.tolerance:g} in {loops.max_iterations} iterations ([loops]); break it with a state, "
            'or forbid reading again with direct = "off" under [components.NAME]'
        )
    if code == cells.UNFIT:
        return f"{_unfit(plan, row, z, int(control[cells.SLOT]))} at {at}"
    name = instances[list(plan.system.components)[row[2]]].speaker.name
    did, hint = _said(plan, instances[name], code, control, z, "step" if row[0] in (STEP, STEP_ON) else "get")
    return f"component {name}{did} {'at the event at' if event else 'in the step to'} {at}{hint}"


def _unfit(plan: Plan, row: np.ndarray, z: np.ndarray, slot: int) -> str:
    """Which connection has a value that its input does not take, or which input in cell `slot`, of whatever origin."""
    if row[0] == SET:
        name = list(plan.system.components)[row[2]]
        variable = next(v for v, s in plan.layout.exchanged(name)[0].items() if s == slot)
        return f"component {name}: {variable} = {z[slot]:g} is beyond what its type holds"
    target = next(key for key, slot in plan.layout.inputs.items() if slot == row[4])
    c = plan.system.drivers[target]
    found, cell = plan.conversions[c], z[row[3]]
    kind = plan.system.components[c.source[0]].fmu.type_of(c.source[1])
    assert kind is not None
    number = c.gain * float(cell) + c.offset if found.real else decode(kind, z[row[3] : row[3] + 1])[0].item()
    return f"connection {c.label}: {found.unfit(number)}"


def _said(
    plan: Plan, instance: Participant, code: int, control: np.ndarray, z: np.ndarray, action: str
) -> tuple[str, str]:
    """What a component did, and what may help; its life goes where the status leads (`lifecycle.after`)."""
    status, slot = int(control[cells.STATUS]), int(control[cells.SLOT])
    outputs = {s: variable for variable, s in plan.layout.exchanged(instance.name)[1].items()}
    if code == cells.NOT_FINITE:
        return f": output {outputs[slot]} became {z[slot]}", f"; see its inputs and parameters{instance.log_text()}"
    if instance.fault:
        instance.noted(action, FATAL)
        return f": {instance.fault}", instance.log_text()
    if status == versions.NO_ROOM:
        what = f": there is no room for another value of output {outputs[slot]}; do not record or connect it,"
        return what, instance.log_text()
    if status in REPORTED:
        return REPORTED[status], instance.log_text()
    instance.noted(action, status)
    if known := instance.why_failed():
        return f": {known}", instance.reasons()
    why = instance.why_discarded() if status == DISCARD else UNDER_WAY if status == PENDING else ""
    return f" returned {status_text(instance.prefix, status)}", why + instance.reasons()
