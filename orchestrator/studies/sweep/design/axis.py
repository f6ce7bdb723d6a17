"""A varied parameter: its values, checked as a run would check them, and how ranges and lists are written.

`low:high:count` (`low:high:count:log` for equal ratios) along a grid, `low:high` or `low:high:log` to draw from, or a
list `8,10,12`. Ends and entries may have a unit (`3 mm:7 mm:5`) or be items of an enumeration by name.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ....errors import InputError, nearest
from ....fmu.attributes import items_of
from ....fmu.fmu import Fmu
from ....fmu.types import Value
from ....system.file.events.numbers import is_of_event, number_of
from ....system.model import System
from ....system.quantities import in_own_unit
from ....system.values import checked_values
from .replanned import event_value, event_values, needs_plan, structural_values

DIGITS = 12  # of grid values: 0.6 and not 0.6000000000000001, so that it can be selected
LARGEST = 1_000_000  # points; a larger design is a typing error


@dataclass(frozen=True)
class Axis:
    """A varied parameter: its values along a grid, or one value for each point of another design."""

    name: str  # component.variable
    unit: str
    description: str
    values: tuple[Value, ...]
    items: tuple[tuple[str, int], ...] = ()  # of an enumeration

    def label(self, value: Value) -> str:
        """A value as it is shown: an item of an enumeration by its name."""
        named = (name for name, number in self.items if number == value)
        return next(named, f"{value:g}" if isinstance(value, float) else str(value))

    def array(self) -> np.ndarray:
        """All values, whole ones exact to 64 bits."""
        whole = all(isinstance(value, int) and not isinstance(value, bool) for value in self.values)
        large = whole and max(self.values) >= 2**63  # type: ignore[operator]
        return np.array(self.values, dtype=np.uint64 if large else None)

    def flags(self) -> dict[str, object]:
        """The items of an enumeration as attributes of netCDF (CF conventions, section 3.5)."""
        if not self.items:
            return {}
        names, numbers = zip(*self.items, strict=True)
        return {"flag_values": np.array(numbers), "flag_meanings": " ".join(re.sub(r"\s+", "_", n) for n in names)}


@dataclass(frozen=True)
class Range:
    """From `low` to `high`, both of them allowed; of a variable of whole numbers both are whole."""

    low: float | int
    high: float | int
    log: bool  # in equal ratios
    count: int = 0  # of a grid
    items: tuple[int, ...] = ()  # those of an enumeration between the ends

    @property
    def whole(self) -> bool:
        return isinstance(self.low, int)

    def at(self, shares: np.ndarray) -> list[object]:
        """The values at `shares` from 0 to 1 of the range, (count,)."""
        low, high = self.low, self.high
        if self.items:
            return [self.items[min(int(share * len(self.items)), len(self.items) - 1)] for share in shares]
        if self.whole and not self.log:
            return [min(low + int(share * (high - low + 1)), high) for share in shares.tolist()]
        end = high + 1 if self.whole else high
        values = np.exp(math.log(low) + shares * math.log(end / low)) if self.log else low + shares * (high - low)
        return [min(max(int(v) if self.whole else float(v), low), high) for v in values]


def checked_axis(system: System, name: str, values: Sequence[object]) -> Axis:
    """Every value checked as a run would check it, and in the type of the variable."""
    origin = "--vary"
    if is_of_event(system, name):
        number = number_of(system, name, origin)
        about = f"{number.key} of event {number.event.name}"
        return Axis(name, "s" if number.is_time else "1", about, event_values(system, name, values, origin))
    found = _varied(system, name)
    if found and found[0].variables[found[1]].type == "Binary":
        raise InputError(
            f"{origin} {name}: it is of type Binary, which is not varied; run it with --set for each value"
        )
    component, _, variable = name.partition(".")
    if needs_plan(system, name):
        owner, checked = system.components[component], structural_values(system, name, values, origin)
    else:
        system.with_values({name: values[0]}, origin)  # unknown names, driven inputs
        owner = system.components[component]
        checked = tuple(next(iter(checked_values(owner, variable, value, origin).values())) for value in values)
    described = owner.fmu.variables[owner.fmu.expand(variable)[0]]
    items = tuple(items_of(described).items())
    return Axis(name, described.unit or "1", described.description or "", checked, items)


def listed(system: System, name: str, text: object) -> list[object] | None:
    """The entries of a list; None for a range, which texts have not."""
    found = _varied(system, name)
    is_text = found and found[0].variables[found[1]].type in ("String", "Binary")
    if not isinstance(text, list) and ":" in str(text) and not is_text:
        return None
    items: list[object] = text if isinstance(text, list) else [part.strip() for part in str(text).split(",")]
    if not items or "" in items or any(str(item).startswith("[") for item in items):
        raise InputError(
            f"--vary {name}={text}: an empty value; write low:high:count or a,b,c (an array takes one value for all of "
            f"its elements, or vary a single element such as {name}[1])"
        )
    return items


def range_of(system: System, name: str, text: object, form: str, grid: bool) -> Range:
    """A range as it is written, of a grid with the number of its values. Raises InputError."""
    low_text, high_text, *more = (part.strip() for part in str(text).split(":"))
    low, high = (_end(system, name, part, f"--vary {name}={text}", form) for part in (low_text, high_text))
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise InputError(f"--vary {name}={text}: an empty range; {form} needs a finite low below high")
    log = more[-1:] == ["log"]
    if log and low <= 0:
        raise InputError(f"--vary {name}={text}: equal ratios need a range above 0")
    count = more[: len(more) - log]
    if not grid and count:
        raise InputError(f"--vary {name}={text}: write {form}; the number of points is that of --random")
    if grid and not (len(count) == 1 and count[0].isdecimal()):
        raise InputError(f"--vary {name}={text}: write {form}, for instance {name}={low_text}:{high_text}:5")
    found = Range(
        low, high, log, int(count[0]) if grid else 0, tuple(v for v in _items(system, name) if low <= v <= high)
    )
    if grid and found.count < 2:
        raise InputError(f"--vary {name}={text}: an empty range; it needs at least 2 values, or write one value")
    if found.count > LARGEST:
        raise InputError(f"--vary {name}={text}: more than {LARGEST} values")
    return found


def spaced(name: str, text: object, ends: Range) -> list[object]:
    """The values of a grid in a range; whole numbers stay whole. Raises InputError where they cannot."""
    low, high, count = ends.low, ends.high, ends.count
    if not ends.whole:
        values = (np.geomspace if ends.log else np.linspace)(low, high, count)[1:-1]
        return [float(low), *(float(f"{value:.{DIGITS}g}") for value in values), float(high)]
    if ends.log:
        return sorted({round(value) for value in np.geomspace(low, high, count).tolist()})
    assert isinstance(low, int) and isinstance(high, int)
    step, left = divmod(high - low, count - 1)
    if left:
        parts = [k for k in range(1, min(high - low, 2 * count) + 1) if (high - low) % k == 0]
        near = 1 + min(parts, key=lambda k: abs(k + 1 - count))
        raise InputError(
            f"--vary {name}={text}: {count} values from {low} to {high} are no whole numbers; {near} values are, or "
            f"write a list a,b,c"
        )
    return [low + k * step for k in range(count)]


def _varied(system: System, name: str) -> tuple[Fmu, str] | None:
    """The FMU of a variable and its first scalar; None for an unknown name, which `checked_axis` refuses."""
    component, _, variable = name.partition(".")
    owner = system.components.get(component)
    scalars = owner.fmu.expand(variable) if owner else []
    return (owner.fmu, scalars[0]) if owner and scalars else None


def _items(system: System, name: str) -> list[int]:
    found = _varied(system, name)
    return sorted(items_of(found[0].variables[found[1]]).values()) if found else []


def _end(system: System, name: str, text: str, label: str, form: str) -> float | int:
    """An end of a range in the variable's own unit; whole where the variable is."""
    found = _varied(system, name)
    if is_of_event(system, name):
        return event_value(system, name, text, f"{label}:")
    try:
        if found is None:
            return float(text)
        fmu, scalar = found
        kind = fmu.type_of(scalar)
        if kind is None or kind.real:
            return float(str(in_own_unit(fmu, scalar, text, f"--vary {name}")))
        if kind.name == "Boolean":
            return {"false": 0, "0": 0, "true": 1, "1": 1}[text.lower()]
        items = items_of(fmu.variables[scalar])
        return items[text] if text in items else int(text)
    except (ValueError, KeyError, OverflowError):
        raise InputError(f"{label}: write {form}; {_no_end(found, text)}") from None


def _no_end(found: tuple[Fmu, str] | None, text: str) -> str:
    """Why a text is no end of a range."""
    if found is None or found[0].is_real(found[1]):
        return "not a range of numbers"
    variable = found[0].variables[found[1]]
    items = items_of(variable)
    if items:
        return f"'{text}' is no item of the enumeration{nearest(text, items)}"
    return f"'{text}' is {'not true or false' if variable.type == 'Boolean' else 'no whole number'}"
