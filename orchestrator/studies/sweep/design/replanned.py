"""What is varied and needs another plan for each value: structural parameters, and numbers of events."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ....errors import InputError
from ....fmu.attributes import parse_value
from ....fmu.types import Value
from ....system.file.events.numbers import is_of_event, number_of, with_event_numbers
from ....system.file.structure import is_structural as decides_sizes
from ....system.model import System


def needs_plan(system: System, name: str) -> bool:
    """Whether a value of a name changes more than a value of a plan."""
    return is_of_event(system, name) or is_structural(system, name)


def is_structural(system: System, name: str) -> bool:
    """Whether a name is that of a structural parameter."""
    component, _, variable = system.full_name(name).partition(".")
    return component in system.components and decides_sizes(system.components[component].fmu, variable)


def event_value(system: System, name: str, value: object, origin: str) -> float:
    """A number of an event: a time in seconds, or a number in the unit of its signal. Raises InputError."""
    number = number_of(system, name, origin)
    if number.is_time:
        try:
            return number.seconds(value)
        except InputError as error:
            raise InputError(f"{origin} {name}: {error}") from None
    try:
        found = float(str(value))
    except ValueError:
        found = math.nan
    if not math.isfinite(found):
        raise InputError(f"{origin} {name}: '{value}' is no number in the unit of its signal")
    return found


def event_values(system: System, name: str, values: Sequence[object], origin: str) -> tuple[float, ...]:
    """All of an axis, each tried. Raises InputError."""
    found = tuple(event_value(system, name, value, origin) for value in values)
    for value in found:
        with_event_numbers(system, {name: value}, origin)
    return found


def structural_values(system: System, name: str, values: Sequence[object], origin: str) -> tuple[Value, ...]:
    """Sizes, each within the range of the parameter. Raises InputError."""
    component, _, variable = name.partition(".")
    fmu = system.components[component].fmu
    (scalar,) = fmu.expand(variable)
    label = f"{origin}: {name}"
    return tuple(parse_value(fmu.variables[scalar], value, label, fmu.type_of(scalar)) for value in values)
