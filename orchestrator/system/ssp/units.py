"""Units of an SSP: by their names, as FMI writes them, or by the base units that the file defines them with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...errors import InputError
from ...units import conversion
from .document import Document, find

BASE_UNITS = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")


@dataclass(frozen=True)
class Definition:
    """A unit by its definition: `factor * value + offset` in `base` units."""

    base: str
    factor: float
    offset: float


def definitions(document: Document) -> dict[str, Definition]:
    """The units that a file defines, by name."""
    found = {}
    path = "ssd:Units/ssc:Unit" if find(document.root, "ssd:Units") else "ssv:Units/ssc:Unit"
    for unit in find(document.root, path):
        base = find(unit, "ssc:BaseUnit")[0]
        try:
            exponents = {name: int(base.get(name, "0")) for name in BASE_UNITS}
        except ValueError:
            raise document.fail(f"unit '{unit.get('name')}': exponents must be whole numbers", base) from None
        text = ".".join(f"{name}{exponent}" for name, exponent in exponents.items() if exponent) or "1"
        found[unit.get("name")] = Definition(text, float(base.get("factor", "1")), float(base.get("offset", "0")))
    return found


def convert(source: str | None, target: str | None, known: Mapping[str, Definition], label: str) -> tuple[float, float]:
    """Gain and offset from one unit to another. A name that is no unit of its own is taken by its definition.

    Raises InputError if the units do not fit, or one is neither known nor defined.
    """
    try:
        return conversion(source, target, label)
    except InputError:
        if source not in known and target not in known:
            raise
    a, b = (known.get(str(name), Definition(str(name), 1.0, 0.0)) for name in (source, target))
    gain, offset = conversion(a.base, b.base, label)
    return gain * a.factor / b.factor, (gain * a.offset + offset - b.offset) / b.factor


@dataclass(frozen=True)
class Linear:
    """`factor * value + offset`."""

    factor: float = 1.0
    offset: float = 0.0

    def then(self, other: Linear) -> Linear:
        """This one first, the other one after it."""
        return Linear(other.factor * self.factor, other.factor * self.offset + other.offset)


IDENTITY = Linear()


def stated_linear(element: Any) -> Linear:
    """The LinearTransformation in an element; the identity where there is none."""
    for entry in find(element, "ssc:LinearTransformation"):
        return Linear(float(entry.get("factor", "1")), float(entry.get("offset", "0")))
    return IDENTITY
