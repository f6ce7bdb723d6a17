"""Somebody else's FMU in the place of a component: presented under our names, with our units and directions.

What the rest of the system sees does not change: connections, bonds, summary, figures and results speak of our
variables. What the other FMU does not have must be said to be missing in the mapping file, never guessed.
"""

from __future__ import annotations

import copy
from dataclasses import replace

from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.attributes import parse_value
from ...fmu.fmu import Fmu
from ...fmu.types import Value
from ..model import System
from .crossing import Crossing
from .fit import crossing_between, not_used
from .mapping import VariableMapping
from .missing import Missing, leave_out
from .own import own_values
from .remarks import crossing_notes, differing, kept_inputs, needed_tool
from .view import OWN, View

ROLES = ("input", "output", "parameter", "calculatedParameter")


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
        if theirs is None or not_used(variable, theirs, mapping):
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
        notes=(f"{label} in place of {before.fmu.path.name}, mapped by {mapping.file}", *needed_tool(fmu),
               *crossing_notes(name, crossings, mapping), *differing(before, presented, crossings),
               *kept_inputs(name, fmu, {*taken, *own})),
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
