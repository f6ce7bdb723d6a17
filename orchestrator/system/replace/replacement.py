"""Somebody else's FMU in the place of a component: presented under our names, with our units and directions.

What the rest of the system sees does not change: connections, bonds, summary, figures and results speak of our
variables. What the other FMU does not have must be said to be missing in the mapping file, never guessed.
"""

from __future__ import annotations

import copy
import difflib
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.attributes import parse_value
from ...fmu.binary import as_text
from ...fmu.conversions import conversion_of
from ...fmu.fmu import Fmu
from ...fmu.types import REALS, TYPES, Value
from ...units import Unit, left_open
from ..model import Component, System
from ..values import start_as_toml
from .crossing import Crossing, crossing
from .mapping import VariableMapping
from .missing import Missing, leave_out
from .view import OWN, View

ROLES = ("input", "output", "parameter", "calculatedParameter")
CALLED = ("parameter", "calculatedParameter")  # of ours that a system may do without


def replace_component(system: System, name: str, fmu: Fmu, mapping: VariableMapping) -> System:
    """A copy of the system with `fmu` in place of the component `name`, at the same period.

    Raises InputError that names all at once: what the FMU lacks of what the system needs, units that do not fit, other
    causalities or types, and inputs of theirs that nothing drives and that have no start value.
    """
    before, label = system.components[name], fmu.path.name
    ours = [v for v in before.fmu.variables.values() if v.causality in ROLES]
    mapping.check([v.name for v in ours], fmu.variables, name, label)
    presented, crossings, lacking = [], {}, []
    problems: list[str] = []
    for variable in ours:
        theirs = fmu.variables.get(mapping.entry(variable.name).name)
        if theirs is None or _not_used(variable, theirs, mapping):
            lacking.append(variable)
            continue
        try:
            units = before.fmu.unit(variable.name), fmu.unit(theirs.name)
            crossings[variable.name] = crossing_between(name, variable, theirs, mapping, label, units)
        except InputError as error:
            problems.append(str(error))
            continue
        presented.append(_presented(variable, theirs, crossings[variable.name]))
    unmapped = [v.name for v in lacking if v.causality == "input" and not mapping.states(v.name)]
    taken = {mapping.entry(v.name).name for v in ours}
    own: dict[str, Value] = {}
    try:
        own = own_values(fmu.variables, mapping, taken, label, unmapped)
    except InputError as error:
        problems.append(str(error))
    for key in own:
        theirs = fmu.variables[key]
        crossings[OWN + key] = Crossing(key, theirs.unit)
        presented.append(_renamed(theirs, OWN + key))
    missing = Missing(name, label, mapping, [v.name for v in lacking], fmu)
    component = replace(  # all that is said of the component itself stays: period, isolation, logging ...
        before, fmu=View.of(fmu, tuple(presented), crossings, before.fmu), parameters={}, inputs={}, series={},
        notes=(f"{label} in place of {before.fmu.path.name}, mapped by {mapping.file}", *_tool(fmu),
               *_crossing_notes(name, crossings, mapping), *_differing(before, presented, crossings),
               *_kept(name, fmu, {*taken, *own})),
    )  # fmt: skip
    left = leave_out(system, before, missing)
    problems += missing.problems.values()
    if problems:
        raise InputError("\n".join(dict.fromkeys(problems)))
    component = replace(component, notes=(*component.notes, *left.notes))
    origin = f"--replace {name}={label}"
    for variable_name, value in {**left.parameters, **left.inputs, **{OWN + k: v for k, v in own.items()}}.items():
        target = component.fmu.variables[variable_name]
        component = component.with_value(variable_name, parse_value(target, value, f"{origin}: {name}.{variable_name}"))
    for variable_name, series in left.series.items():
        component = component.with_series(variable_name, series)
    return replace(left.system, components={**system.components, name: component})


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


def _not_used(ours: ModelVariable, theirs: ModelVariable, mapping: VariableMapping) -> bool:
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


def _presented(ours: ModelVariable, theirs: ModelVariable, cross: Crossing) -> ModelVariable:
    """Their variable as the system sees it: our name, unit and role, their reference, type, start and range."""
    seen = _renamed(theirs, ours.name)
    seen.description, seen.causality, seen.unit = ours.description, ours.causality, ours.unit
    seen.relativeQuantity = ours.relativeQuantity
    if ours.variability == "discrete":  # the component keeps its role: what samples goes on sampling
        seen.variability = "discrete"
    if cross.exact:
        return seen
    if theirs.start is not None:
        seen.start = repr(cross.back(float(theirs.start)))
    bounds = [None if b is None else repr(cross.back(float(b))) for b in (theirs.min, theirs.max)]
    seen.min, seen.max = reversed(bounds) if cross.back_gain < 0 else bounds
    return seen


def _renamed(variable: ModelVariable, name: str) -> ModelVariable:
    seen = copy.copy(variable)
    seen.name = name
    return seen


def own_values(
    variables: Mapping[str, ModelVariable],
    mapping: VariableMapping,
    mapped: set[str],
    label: str,
    unmapped: Sequence[str] = (),
) -> dict[str, Value]:
    """Values for variables of theirs that stand for none of ours.

    An input of theirs without one keeps its start value, unless it has none, or there are `unmapped` inputs of ours
    that it could stand for. Raises InputError for all that is wrong.
    """
    problems = []
    for name, variable in variables.items():
        free = variable.causality == "input" and name not in mapped and name not in mapping.inputs
        if free and (unmapped or variable.start is None):
            close = difflib.get_close_matches(name, unmapped, 1, 0.0)
            offer = f' ({close[0]} = "{name}")' if close else ""
            problems.append(
                f"{label} has an input '{name}' that nothing drives; map one of ours to it{offer} under [variables] in "
                f'a mapping file, or give it a value there: [inputs] "{name}" = {start_as_toml(variable)}'
            )
    for table, causality in (("inputs", "input"), ("parameters", "parameter")):
        for name in getattr(mapping, table):
            if name not in variables:
                problems.append(f"[{table}]: name each element of '{name}', or give a list ({mapping.file})")
            elif not can_be(causality, variables[name]):
                problems.append(
                    f"[{table}]: '{name}' of {label} is of causality {variables[name].causality}, "
                    f"no {causality} ({mapping.file})"
                )
            elif name in mapped:
                problems.append(f"[{table}]: '{name}' stands for one of our variables; remove it ({mapping.file})")
    if problems:
        raise InputError("\n".join(problems))
    return {**mapping.inputs, **mapping.parameters}


def _kept(name: str, fmu: Fmu, known: Collection[str]) -> Iterable[str]:
    """Inputs of theirs that keep their start values."""
    left = [v for v in fmu.names("input") if v not in known and fmu.type_of(v) is not None]
    if left:
        values = ", ".join(f"{v} = {start_as_toml(fmu.variables[v])}" for v in left)
        yield f"{name}: nothing drives {values} of {fmu.path.name}: the start values are kept"


def _tool(fmu: Fmu) -> Iterable[str]:
    if fmu.interface.needsExecutionTool:
        maker = fmu.description.generationTool or "the tool that made it"
        yield f"{fmu.path.name} says that it needs {maker} on this machine to run (needsExecutionTool)"


def _crossing_notes(name: str, crossings: dict[str, Crossing], mapping: VariableMapping) -> Iterable[str]:
    for ours, cross in crossings.items():
        if mapping.states(ours) or not cross.exact:
            yield f"{name}.{ours} is {cross}"


def _differing(before: Component, presented: Iterable[ModelVariable], crossings: dict[str, Crossing]) -> Iterable[str]:
    """Parameters that the system does not set and that their FMU starts with another value."""
    for theirs in presented:
        ours = before.fmu.variables.get(theirs.name)
        if ours is None or ours.causality != "parameter" or theirs.name in before.parameters:
            continue
        values = [parse_value(theirs, v.start, theirs.name) for v in (theirs, ours) if v.start is not None]
        if len(values) == 2 and not _alike(*values):
            unit = f" {ours.unit}" if ours.unit and ours.unit != "1" else ""
            there, here = map(as_text, values)
            yield f"{before.name}.{theirs.name} is {there}{unit} there, {here}{unit} here; theirs is kept"


def _alike(a: Value, b: Value) -> bool:
    if isinstance(a, float) and isinstance(b, float):
        return abs(a - b) <= 1e-9 * max(abs(a), abs(b))
    return a == b
