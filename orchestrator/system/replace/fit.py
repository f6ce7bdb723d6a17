"""Whether a variable of another FMU can stand for one of ours, and how its values come across."""

from __future__ import annotations

from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.conversions import conversion_of
from ...fmu.types import REALS, TYPES
from ...units import Unit, left_open
from .crossing import Crossing, crossing
from .mapping import VariableMapping

CALLED = ("parameter", "calculatedParameter")  # of ours that a system may do without


def crossing_between(
    name: str,
    ours: ModelVariable,
    theirs: ModelVariable,
    mapping: VariableMapping,
    fmu: str,
    units: tuple[Unit | str | None, Unit | None],
) -> Crossing:
    """Between one of our variables and theirs, in `units`; causality, type and unit must fit."""
    entry = mapping.entry(ours.name)
    label = f"{name}.{ours.name} as '{theirs.name}' of {fmu}"
    if not can_be(ours.causality, theirs):
        raise InputError(
            f"{label}: theirs is of causality {theirs.causality}, {ours.causality} is needed; name another variable of "
            f"theirs in a mapping file, have it exported as {ours.causality}"
            f"{'' if ours.causality == 'input' else f', or say that there is none: {ours.name} = {chr(34) * 2}'} "
            f"{entry.where}".rstrip()
        )
    kinds = ["Real" if v.type in REALS else v.type for v in (ours, theirs)]
    loose = ours.causality == "parameter" and "String" not in kinds  # a whole number may be given as a real one
    if kinds[0] != kinds[1] and not loose and not _converted(ours, theirs):
        raise InputError(f"{label}: theirs is of type {theirs.type}, {ours.type} is needed {entry.where}".rstrip())
    own, said = units[1], Unit(entry.unit, None, bool(theirs.relativeQuantity)) if entry.unit else None
    if said and own and said.name != own.name and not left_open(own, said):
        raise InputError(
            f"{label}: the mapping says that it is in {entry.unit}, their FMU that it is in {theirs.unit}; "
            f"leave the unit out of the mapping {entry.where}"
        )
    if theirs.type not in REALS:
        if entry.sign != 1.0:
            raise InputError(f"{label}: a {theirs.type} has no sign {entry.where}")
        return Crossing(theirs.name)
    meant = own if said is None or (own and own.name == said.name) else said
    return crossing(theirs.name, units[0], meant, entry.sign, label)


def _converted(ours: ModelVariable, theirs: ModelVariable) -> bool:
    """Whether a connection converts between the two types, in the direction in which values go, and loses nothing."""
    ends = (ours, theirs) if ours.causality == "input" else (theirs, ours)
    (source, a), (target, b) = ((v, TYPES[2].get(v.type) or TYPES[3].get(v.type)) for v in ends)
    try:
        conversion_of(source, a, target, b)
    except InputError:
        return False
    return True


def not_used(ours: ModelVariable, theirs: ModelVariable, mapping: VariableMapping) -> bool:
    """Whether theirs only happens to be called like a parameter of ours that it cannot be."""
    return ours.causality in CALLED and not mapping.states(ours.name) and not can_be(ours.causality, theirs)


def can_be(ours: str, theirs: ModelVariable) -> bool:
    """A value may be read wherever it stands, but must be set where FMI allows it."""
    if ours == "parameter":
        start = theirs.initial in ("exact", "approx") and theirs.causality in ("local", "output")
        return theirs.variability != "constant" and (theirs.causality == "parameter" or start)
    if ours == "input":
        return bool(theirs.causality == "input")
    return theirs.causality in ("output", "local", "calculatedParameter")
