"""What a good model description says, beyond what the standard's schema demands."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ....fmu.tolerant.rules import RANGE, STARTS
from ..rows import Row, judged
from ..subject import STEP, Subject, bounds, numbers

STAGE = "description"
UNBOUNDED = ("String", "Binary", "Boolean")  # types without min and max
TOKEN = r"\{[0-9a-fA-F-]{32,}\}|[0-9a-fA-F-]{32,}"


def description_rows(subject: Subject) -> Iterator[Row]:
    """One row per rule on variables, model structure, token and default experiment."""
    yield _described(subject)
    yield from _ranges(subject)
    yield from _structure(subject)
    guid = subject.description.guid or ""
    what = "instantiationToken" if subject.version == 3 else "guid"
    bad = [] if re.fullmatch(TOKEN, guid) else [guid or "empty"]
    mend = "use a UUID or a hash of the content, in braces"
    yield judged(STAGE, f"{what} identifies the content", bad, f"{len(guid)} characters", "neither", mend, "finding")
    if subject.version == 1:  # which has no word for it
        return
    experiment = subject.description.defaultExperiment
    yield judged(
        STAGE, "a step size is suggested", [] if experiment and experiment.stepSize else ["no stepSize"],
        f"{subject.step:g} s", "", f"add DefaultExperiment stepSize; {STEP:g} s is tried here", "finding",
    )  # fmt: skip


def _described(subject: Subject) -> Row:
    bare = [v.name for v in subject.variables if not (v.description or "").strip()]
    good = f"all {len(subject.variables)} variables"
    mend = "say in a few words what each is; that is all its user sees"
    return judged(STAGE, "variables are described", bare, good, "without description", mend, "finding")


def _ranges(subject: Subject) -> Iterator[Row]:
    noted = {note.rule: note.places for note in subject.notes}  # what was mended when it was read
    outside = []
    for v in subject.variables:
        if v.type in UNBOUNDED:
            continue
        low, high = bounds(v)
        starts = numbers(v.start)
        outside += [
            f"{v.name} = {start:g}"
            for start in starts
            if (low is not None and start < low) or (high is not None and start > high)
        ]
    mend = "correct min, max or start"
    yield judged(STAGE, "min is not above max", noted.get(RANGE, ()), "everywhere", "min above max", mend, "finding")
    yield judged(STAGE, "start is within min and max", outside, "everywhere", "outside", mend, "finding")
    if subject.version == 3:
        mend = "give one start value, or one per element"
        yield judged(
            STAGE, "arrays have enough starts", noted.get(STARTS, ()), "everywhere", "wrong number", mend, "finding"
        )


def _structure(subject: Subject) -> Iterator[Row]:
    described = subject.description
    if subject.version == 1:
        silent = [u.variable.name for u in described.outputs if u.dependencies is None and u.variable]
        yield judged(
            STAGE, "dependencies are declared", silent, "for every output", "without DirectDependency",
            "add DirectDependency, an empty one where there are none; without it a host must assume algebraic loops",
            "finding",
        )  # fmt: skip
        return
    outputs = [v for v in subject.of("output") if v.alias is None]
    listed_outputs = {u.variable.name for u in described.outputs if u.variable}
    yield judged(
        STAGE, "Outputs is complete", sorted({v.name for v in outputs} ^ listed_outputs), f"{len(outputs)} outputs",
        "missing or surplus", "list every output once in ModelStructure", "finding",
    )  # fmt: skip
    start = [v for v in outputs if v.initial in ("approx", "calculated") and not v.clocks]
    expected = {v.name for v in (*start, *subject.of("calculatedParameter"))}
    states = [v for u in described.derivatives if u.variable for v in (u.variable, u.variable.derivative)]
    expected |= {v.name for v in states if getattr(v, "initial", None) in ("approx", "calculated")}
    unknowns = {u.variable.name for u in described.initialUnknowns if u.variable}
    yield judged(
        STAGE, "InitialUnknowns is complete", sorted(expected ^ unknowns), f"{len(unknowns)} unknowns",
        "missing or surplus", "list what is calculated at the start, in the order of the variables", "finding",
    )  # fmt: skip
    silent = [
        f"{u.variable.name} ({part})"
        for part, entries in (("Outputs", described.outputs), ("InitialUnknowns", described.initialUnknowns))
        for u in entries
        if u.dependencies is None and u.variable
    ]
    yield judged(
        STAGE, "dependencies are declared", silent, "for every entry", "without dependencies",
        "add dependencies, an empty list where there are none; without them a host must assume algebraic loops",
        "finding",
    )  # fmt: skip


def capability_rows(subject: Subject) -> Iterator[Row]:
    """One row per capability flag that a host of several FMUs needs."""
    flags = subject.interface
    states = (
        ("states can be saved", flags.canGetAndSetFMUstate, "canGetAndSetFMUstate is false",
         "without it no step can be repeated: no iteration, no adaptive steps"),
        ("states can be serialized", flags.canSerializeFMUstate, "canSerializeFMUstate is false",
         "without it no run can be continued in another process"),
    )  # fmt: skip
    rules = (
        *(states if subject.version > 1 else ()),  # FMI 1.0 has none
        ("steps may vary", getattr(flags, "canHandleVariableCommunicationStepSize", True),
         "canHandleVariableCommunicationStepSize is false", "the host must step at the FMU's own step size"),
        ("several instances per process", not flags.canBeInstantiatedOnlyOncePerProcess,
         "canBeInstantiatedOnlyOncePerProcess is true", "each further instance needs a process of its own"),
        ("no other tool is needed", not flags.needsExecutionTool, "needsExecutionTool is true",
         f"export it with all it needs, or install the tool that made it: {subject.description.generationTool}"),
    )  # fmt: skip
    for rule, good, found, mend in rules:
        yield judged("capabilities", rule, [] if good else [found], "yes", "", mend, "finding")
