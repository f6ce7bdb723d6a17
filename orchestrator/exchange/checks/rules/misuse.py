"""What an FMU must refuse: calls in the wrong order and values out of range.

What was not refused, or refused with Fatal, ends the process (`child.py`): each rule meets a sound FMU.
"""

from __future__ import annotations

from fmpy.model_description import ModelVariable

from ....fmu.kinds import MODEL_EXCHANGE, SCHEDULED_EXECUTION, usual_kind
from ....fmu.types import REALS
from ....participant.lifecycle import FATAL, STATUS
from ..rows import Row
from ..subject import Subject, bounds
from ..tried import Tried

WIDE = ("Integer", "Int32", "Int64", "Enumeration")
LARGEST_REAL, LARGEST_INTEGER = 1e37, 2.0**31  # Float32 and Int32 can hold them
ORDER, RANGE = "wrong call order", "out of range"
WITHOUT_MODE = "FMI 1.0 has no initialization mode"
NO_STEP = {
    MODEL_EXCHANGE: "a model for Model Exchange has no doStep",
    SCHEDULED_EXECUTION: "what is scheduled has partitions and no doStep",
}
MEND = "return Error and log why; a host with a mistake must not get numbers"


def step_before_initialization(subject: Subject) -> Row:
    """doStep right after instantiate."""
    if why := NO_STEP.get(usual_kind(subject.description)):
        return Row(ORDER, "doStep before initialization", "not applicable", why)
    instance = Tried(subject)
    with instance.unguarded():
        status = instance.step(subject.start_time, subject.step)
    return _judged(ORDER, "doStep before initialization", instance, status)


def exit_before_enter(subject: Subject) -> Row:
    """exitInitializationMode without enterInitializationMode."""
    if subject.version == 1:
        return Row(ORDER, "exitInitializationMode without enter", "not applicable", WITHOUT_MODE)
    instance = Tried(subject)
    instance.must("setupExperiment", instance.setup())
    with instance.unguarded():
        status = instance.exit()
    return _judged(ORDER, "exitInitializationMode without enter", instance, status)


def enter_twice(subject: Subject) -> Row:
    """enterInitializationMode once more after initialization."""
    if subject.version == 1:
        return Row(ORDER, "enterInitializationMode after initialization", "not applicable", WITHOUT_MODE)
    instance = Tried(subject)
    instance.begin()
    with instance.unguarded():
        status = instance.enter()
    return _judged(ORDER, "enterInitializationMode after initialization", instance, status)


def parameter_after_initialization(subject: Subject) -> Row:
    """A fixed parameter set while the simulation runs."""
    rule = "fixed parameter set after initialization"
    instance = Tried(subject)
    fixed = [v for v in subject.of("parameter") if v.variability == "fixed" and instance.start_values(v)]
    if not fixed:
        return Row(ORDER, rule, "not applicable", "no fixed parameters")
    instance.begin()
    with instance.unguarded():
        status = instance.set(fixed[0], instance.start_values(fixed[0]))
    return _judged(ORDER, rule, instance, status)


def step_after_terminate(subject: Subject) -> Row:
    """doStep after terminate."""
    if why := NO_STEP.get(usual_kind(subject.description)):
        return Row(ORDER, "doStep after terminate", "not applicable", why)
    instance = Tried(subject)
    instance.begin()
    instance.must("terminate", instance.terminate())
    with instance.unguarded():
        status = instance.step(subject.start_time, subject.step)
    return _judged(ORDER, "doStep after terminate", instance, status)


def backward_step(subject: Subject) -> Row:
    """doStep with a negative step size."""
    if why := NO_STEP.get(usual_kind(subject.description)):
        return Row(ORDER, "doStep with a negative step", "not applicable", why)
    instance = Tried(subject)
    instance.begin()
    return _judged(ORDER, "doStep with a negative step", instance, instance.step(subject.start_time, -subject.step))


def above_maximum(subject: Subject) -> Row:
    """A parameter above its max must be refused before the simulation begins."""
    return _beyond(subject, "parameter above its max", 1)


def below_minimum(subject: Subject) -> Row:
    """A parameter below its min must be refused before the simulation begins."""
    return _beyond(subject, "parameter below its min", 0)


def _beyond(subject: Subject, rule: str, side: int) -> Row:
    instance = Tried(subject)
    able = [(v, _beyond_bound(v, side)) for v in subject.of("parameter") if instance.start_values(v)]
    v, beyond = next((found for found in able if found[1] is not None), (None, None))
    if v is None or beyond is None:
        return Row(RANGE, rule, "not applicable", "no parameter with such a bound")
    instance.must("setupExperiment", instance.setup())
    instance.set_starts()
    status = instance.set(v, [beyond] * len(instance.start_values(v)))
    for call in (instance.enter, instance.exit):
        status = status or call()
    return _judged(RANGE, rule, instance, status, f"{v.name} = {beyond:g}")


def _beyond_bound(v: ModelVariable, side: int) -> float | None:
    """A value behind the min (side 0) or max (1) that the type can hold; None if there is none."""
    bound = bounds(v)[side]
    if bound is None or v.type not in (*REALS, *WIDE):
        return None
    value = bound + (1 if side else -1) * (1.0 + abs(bound) if v.type in REALS else 1.0)
    return value if abs(value) < (LARGEST_REAL if v.type in REALS else LARGEST_INTEGER) else None


def _judged(stage: str, rule: str, instance: Tried, status: int, what: str = "") -> Row:
    prefix = f"{what}: " if what else ""
    if not status:
        instance.free()
        return Row(stage, rule, "finding", f"{prefix}accepted", MEND)
    if status not in STATUS:
        return Row(stage, rule, "error", f"{prefix}status {status} is none of FMI's", MEND)
    name = STATUS[status]
    if not instance.messages:
        return Row(
            stage, rule, "finding", f"{prefix}refused with {name}, but without a word", "log a message that says why"
        )
    if status < FATAL:
        instance.free()
    return Row(stage, rule, "pass", f"{prefix}refused with {name} and a message")


OUT_OF_RANGE = ("above_maximum", "below_minimum")
RULES = {
    f.__name__: f
    for f in (
        step_before_initialization, exit_before_enter, enter_twice, parameter_after_initialization,
        step_after_terminate, backward_step, above_maximum, below_minimum,
    )
}  # fmt: skip
