"""Units of an SSP: by the base units that its files define them with; and the transformations that a file states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...errors import InputError
from ...fmu.tolerant.rules import Notes
from ...units import BASE_UNITS, Definition, Unit, conversion, meaning
from .files.document import Document, find
from .files.rules import UNDEFINED_UNIT
from .files.vocabulary import MAPPINGS

SAID = 'where values are to be passed on as they are, state suppressUnitConversion="true" there'


def definitions(document: Document, element: Any = None) -> dict[str, Definition]:
    """The units that a file defines, by name; with those of an `element` in it, such as an inline parameter set."""
    found: dict[str, Definition] = {}
    for owner in (document.root, element):
        for unit in find(owner, "Units/Unit") if owner is not None else ():
            base = find(unit, "BaseUnit")[0]
            try:
                exponents = tuple(int(float(base.get(name, "0"))) for name in BASE_UNITS)
            except (ValueError, OverflowError):
                raise document.fail(f"unit '{unit.get('name')}': exponents must be whole numbers", base) from None
            factor, offset = float(base.get("factor", "1")), float(base.get("offset", "0"))
            if not factor:
                raise document.fail(f"unit '{unit.get('name')}': its factor is 0", base)
            found[unit.get("name")] = Definition(exponents, factor, offset)
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
    for entry in find(element, "LinearTransformation"):
        return Linear(float(entry.get("factor", "1")), float(entry.get("offset", "0")))
    return IDENTITY


def stated_table(element: Any) -> list[Any]:
    """The entries of a transformation that maps values one by one; none where there is none."""
    return [entry for kind in MAPPINGS for entry in find(element, f"{kind}/MapEntry")]


def converted(
    source: Unit | None, target: Unit | None, notes: Notes, label: str, where: str, mend: str = SAID
) -> Linear:
    """What happens to a value on its way from one unit to another; nothing where one of the two is not defined.

    Raises InputError where they do not fit.
    """
    try:
        return Linear(*conversion(source, target, label))
    except InputError as error:
        unknown = [unit for unit in (source, target) if unit is not None and not _understood(unit)]
        if not unknown:
            raise InputError(f"{error}; {mend} {where}") from None
        for unit in unknown:
            notes.add(UNDEFINED_UNIT, f"{unit} {where}")
        return IDENTITY


def _understood(unit: Unit) -> bool:
    if unit.definition is not None:
        return True
    try:
        meaning(unit.name)
    except InputError:
        return False
    return True
