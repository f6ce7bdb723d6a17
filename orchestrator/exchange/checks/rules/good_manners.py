"""What an FMU must do when it is used as the standard says: each function is one row, run in the child process."""

from __future__ import annotations

from ....errors import FmuError
from ....fmu.kinds import MODEL_EXCHANGE, usual_kind
from ....participant.apart.meeting import meeting
from ....participant.here.refusal import NotLoadedError
from ..rows import Row
from ..subject import Subject
from ..tried import Tried

STAGE = "dry run"
STEPS = 50
AHEAD = 12  # steps of the comparisons, behind BEFORE others
BEFORE = 7


def runs(subject: Subject) -> Row:
    """Load, instantiate, initialize with the start values, steps with the inputs at rest, finite outputs."""
    rule = "runs with its start values"
    try:
        instance = Tried(subject)
    except FmuError as error:
        reason, mend = (
            str(error).partition("cannot be instantiated: ")[2] or str(error),
            "is the GUID that of its binary?",
        )
        if isinstance(error, NotLoadedError):
            reason, mend = reason.removesuffix(f"; {error.mend}"), error.mend
        return Row(STAGE, rule, "error", f"it cannot be instantiated: {reason}", mend)
    instance.begin()
    infinite = instance.not_finite()
    for k in range(STEPS):
        if infinite:
            mend = "start values or equations give inf or nan; correct them"
            return Row(STAGE, rule, "error", f"{', '.join(infinite)} not finite after {k} steps", mend)
        t = subject.start_time + k * subject.step
        instance.must(f"doStep at t = {t:g} s", instance.step(t, subject.step))
        infinite = instance.not_finite()
    instance.close()
    return Row(STAGE, rule, "pass", f"{STEPS} steps of {subject.step:g} s, all outputs finite")


def repeats(subject: Subject) -> Row:
    """The same calls in a second instance give the same bits."""
    rule = "same calls, same results"
    seen = []
    for _ in range(2):
        instance = Tried(subject)
        instance.begin()
        seen.append(instance.stir(0, AHEAD))
        instance.close()
    return _equal(rule, seen[0], seen[1], "look for randomness, the clock, globals, uninitialized memory")


def restores(subject: Subject) -> Row:
    """Save, run on, restore, run again."""
    rule = "a saved state restores"
    if not subject.interface.canGetAndSetFMUstate:
        return Row(STAGE, rule, "not applicable", "canGetAndSetFMUstate is false")
    instance = Tried(subject)
    instance.begin()
    instance.stir(0, BEFORE)
    state = instance.save()
    onward = instance.stir(BEFORE, AHEAD)
    instance.restore(state)
    again = instance.stir(BEFORE, AHEAD)
    instance.forget(state)
    instance.close()
    return _equal(rule, onward, again, "save everything that a step reads, arrays and counters too")


def serializes(subject: Subject) -> Row:
    """A serialized state continues in another instance."""
    rule = "a serialized state continues"
    if not subject.interface.canSerializeFMUstate:
        return Row(STAGE, rule, "not applicable", "canSerializeFMUstate is false")
    first = Tried(subject, "first")
    first.begin()
    first.stir(0, BEFORE)
    state = first.save()
    content = first.serialize(state)
    first.forget(state)
    onward = first.stir(BEFORE, AHEAD)
    first.close()
    second = Tried(subject, "second")
    second.begin()
    state = second.deserialize(content)
    second.restore(state)
    second.forget(state)
    again = second.stir(BEFORE, AHEAD)
    second.close()
    return _equal(rule, onward, again, "write and read back all of the state", f"{len(content)} bytes, bitwise equal")


def independent(subject: Subject) -> Row:
    """Two instances in turn give what each gives alone."""
    rule = "two instances do not meet"
    if subject.interface.canBeInstantiatedOnlyOncePerProcess:
        return Row(STAGE, rule, "not applicable", "canBeInstantiatedOnlyOncePerProcess is true")
    alone = []
    with meeting():
        for phase in (0.0, 1.0):
            instance = Tried(subject)
            instance.begin()
            alone.append(instance.stir(0, AHEAD, phase))
            instance.close()
        pair = [Tried(subject, name) for name in ("left", "right")]
    for instance in pair:
        instance.begin()
    together: list[list[bytes]] = [[], []]
    for k in range(AHEAD):
        for seen, instance, phase in zip(together, pair, (0.0, 1.0), strict=True):
            seen += instance.stir(k, 1, phase)
    for instance in pair:
        instance.close()
    return _equal(rule, alone[0] + alone[1], together[0] + together[1], "keep no state in globals or statics")


def resets(subject: Subject) -> Row:
    """After reset everything is as in a new instance."""
    rule = "reset starts afresh"
    if subject.version == 1 and usual_kind(subject.description) == MODEL_EXCHANGE:
        return Row(STAGE, rule, "not applicable", "FMI 1.0 has no reset for model exchange")
    instance = Tried(subject)
    instance.begin()
    fresh = instance.stir(0, AHEAD)
    instance.must("reset", instance.status(instance.instance.reset))
    instance.begin()
    again = instance.stir(0, AHEAD)
    instance.close()
    return _equal(rule, fresh, again, "let reset do what instantiate does")


def varies(subject: Subject) -> Row:
    """Steps of half, double and odd size, finite outputs."""
    rule = "runs with varying steps"
    if not getattr(subject.interface, "canHandleVariableCommunicationStepSize", True):
        return Row(STAGE, rule, "not applicable", "canHandleVariableCommunicationStepSize is false")
    instance = Tried(subject)
    instance.begin()
    t = subject.start_time
    for factor in (1.0, 0.5, 2.0, 0.1, 1.3) * 2:
        instance.must(f"doStep at t = {t:g} s", instance.step(t, factor * subject.step))
        t += factor * subject.step
    infinite = instance.not_finite()
    instance.close()
    if infinite:
        return Row(
            STAGE, rule, "error", f"{', '.join(infinite)} not finite", "set the flag to false, or correct the step"
        )
    return Row(STAGE, rule, "pass", f"0.1 to 2 times {subject.step:g} s")


def _equal(rule: str, expected: list[bytes], found: list[bytes], mend: str, good: str = "bitwise equal") -> Row:
    if not any(expected):
        return Row(STAGE, rule, "not applicable", "no outputs to compare")
    differing = [k + 1 for k, (a, b) in enumerate(zip(expected, found, strict=True)) if a != b]
    if differing:
        return Row(STAGE, rule, "error", f"outputs differ from step {differing[0]} of {len(expected)} on", mend)
    return Row(STAGE, rule, "pass", f"{len(expected)} steps, {good}" if good == "bitwise equal" else good)


RULES = {f.__name__: f for f in (runs, repeats, restores, serializes, independent, resets, varies)}
