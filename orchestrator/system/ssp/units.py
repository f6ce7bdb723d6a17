"""Units of an SSP: by the base units that the file defines them with; and the transformations that a file states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...units import BASE_UNITS, Definition
from .document import Document, find


def definitions(document: Document) -> dict[str, Definition]:
    """The units that a file defines, by name."""
    found = {}
    path = "ssd:Units/ssc:Unit" if find(document.root, "ssd:Units") else "ssv:Units/ssc:Unit"
    for unit in find(document.root, path):
        base = find(unit, "ssc:BaseUnit")[0]
        try:
            exponents = tuple(int(base.get(name, "0")) for name in BASE_UNITS)
        except ValueError:
            raise document.fail(f"unit '{unit.get('name')}': exponents must be whole numbers", base) from None
        found[unit.get("name")] = Definition(exponents, float(base.get("factor", "1")), float(base.get("offset", "0")))
    return found


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
