"""Values that somebody gives to a system, checked against what its FMUs let be set."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ..errors import InputError, nearest
from ..fmu.attributes import parse_value
from ..fmu.reading.structure import STRUCTURAL
from ..fmu.types import Value
from .component import Component
from .values import checked_values

if TYPE_CHECKING:
    from .model import System

Values = Mapping[str, Mapping[str, Value]]  # by component and scalar


def assigned(system: System, assignments: Mapping[str, object], origin: str) -> Values:
    """Values by component and scalar, from those of `component.variable`: parameters, and inputs that nothing
    drives.

    Raises InputError for an unknown name, a driven input, a wrong type or a value out of range.
    """
    components, values = system.components, dict[str, dict[str, Value]]()
    tables = {f"{c.name}.{v}": series for c in components.values() for v, series in c.series.items()}
    named: dict[tuple[str, str], str] = {}
    for given, value in assignments.items():
        key = system.full_name(given)
        name, _, variable = key.partition(".")
        if "." not in key:
            alone = next(iter(components)) if len(components) == 1 else "component"
            raise InputError(f"{origin} {key}: write {alone}.variable=value{nearest(key, _names_to_set(components))}")
        if name not in components:
            raise InputError(f"{origin}: no component '{name}' in '{key}'{nearest(name, components)}")
        if _same_structure(components[name], variable, value, f"{origin}: {key}"):
            continue
        for scalar, scalar_value in checked_values(components[name], variable, value, origin).items():
            system.require_free(name, scalar, origin)
            if (other := named.setdefault((name, scalar), key)) != key and components[name].fmu.aliases:
                raise InputError(f"{origin}: {other} and {key} are one variable; give it one value")
            if f"{name}.{scalar}" in tables:
                followed = tables[f"{name}.{scalar}"].origin
                raise InputError(f"{origin}: {name}.{scalar} follows {followed}; remove that first")
            values.setdefault(name, {})[scalar] = scalar_value
    return values


def _same_structure(component: Component, name: str, value: object, label: str) -> bool:
    """Whether a name is that of a structural parameter; it has its value already. Raises InputError for another."""
    fmu = component.fmu
    own = fmu.main_name(name)
    if own not in fmu.variables or fmu.variables[own].causality != STRUCTURAL:
        return False
    if parse_value(fmu.variables[own], value, label, fmu.type_of(own)) != fmu.start(own):
        raise InputError(
            f"{label} decides sizes of arrays, so it is set where the system is read: under [components."
            f"{component.name}] parameters, with --set, or load(..., values = {{...}})"
        )
    return True


def _names_to_set(components: Mapping[str, Component]) -> list[str]:
    """What can be set, each by its full name."""
    return [f"{c.name}.{v}" for c in components.values() for v in c.fmu.base_names("parameter", "input")]
