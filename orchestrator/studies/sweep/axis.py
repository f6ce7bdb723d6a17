"""A varied parameter: its values, checked as a run would check them, and how ranges and lists are written.

`low:high:count` (`low:high:count:log` for equal ratios) along a grid, `low:high` or `low:high:log` to draw from, or a
list `8,10,12`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ...errors import InputError
from ...fmu.types import Value
from ...system.model import System, checked_values


@dataclass(frozen=True)
class Axis:
    """A varied parameter: its values along a grid, or one value for each point of another design."""

    name: str  # component.variable
    unit: str
    description: str
    values: tuple[Value, ...]


def checked_axis(system: System, name: str, values: Sequence[object]) -> Axis:
    """Every value checked as a run would check it, and in the type of the variable."""
    origin = "--vary"
    system.with_values({name: values[0]}, origin)  # unknown names, driven inputs
    component, _, variable = name.partition(".")
    owner = system.components[component]
    checked = tuple(next(iter(checked_values(owner, variable, value, origin).values())) for value in values)
    described = owner.fmu.variables[owner.fmu.expand(variable)[0]]
    return Axis(name, described.unit or "1", described.description or "", checked)


def listed(name: str, text: object) -> list[object] | None:
    """The entries of a list; None for a range."""
    if not isinstance(text, list) and ":" in str(text):
        return None
    items: list[object] = text if isinstance(text, list) else [part.strip() for part in str(text).split(",")]
    if not items or "" in items or any(str(item).startswith("[") for item in items):
        raise InputError(
            f"--vary {name}={text}: an empty value; write low:high:count or a,b,c (an array takes one value for all of "
            "its elements, or vary a single element such as {name}[1])"
        )
    return items


def range_of(name: str, text: object, form: str) -> tuple[float, float, list[str]]:
    """Ends of a range and what follows them."""
    low_text, high_text, *more = str(text).split(":")
    try:
        low, high = float(low_text), float(high_text)
    except ValueError:
        raise InputError(f"--vary {name}={text}: not a range of numbers; write {form}") from None
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise InputError(f"--vary {name}={text}: an empty range; {form} needs a finite low below high")
    if more and more[-1] == "log" and low <= 0:
        raise InputError(f"--vary {name}={text}: equal ratios need a range above 0")
    return low, high, more
