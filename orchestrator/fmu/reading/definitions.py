"""What an FMU says that its units mean: its UnitDefinitions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from ...errors import InputError
from ...units import BASE_UNITS, Definition, meaning


class Shown(NamedTuple):
    """A display unit of a unit that is known by its name only: `shown = factor * value + offset`."""

    unit: str
    factor: float
    offset: float


class Definitions(dict[str, Definition]):
    """By name. What rests on what the name of a unit means is found out when it is asked for: that takes its time."""

    def __init__(self, known: dict[str, Definition], by_name: dict[str, Shown]) -> None:
        super().__init__(known)
        self.by_name = by_name

    def get(self, name: str, default: Any = None) -> Any:
        if name in self.by_name and name not in self:
            unit, factor, offset = self.by_name.pop(name)
            try:
                self[name] = _shown(meaning(unit), factor, offset)
            except InputError:  # nobody knows the unit; the name alone may mean something
                return default
        return super().get(name, default)


def definitions_of(root: Any) -> Definitions:
    """The units of a mended description by name, and its display units where no unit has their name.

    FMI 1.0 never says what a unit means, and FMI 2.0 need not: its display units are made of what its name means then.
    """
    found: dict[str, Definition] = {}
    shown: dict[str, Definition] = {}
    by_name: dict[str, Shown] = {}
    for unit in root.findall("UnitDefinitions/Unit"):
        base = unit.find("BaseUnit")
        if base is None:
            for name, factor, offset in _displays(unit):
                by_name.setdefault(name, Shown(unit.get("name"), factor, offset))
            continue
        exponents = tuple(int(base.get(symbol, "0")) for symbol in BASE_UNITS)
        meant = Definition(exponents, float(base.get("factor", "1")), float(base.get("offset", "0")))
        found[unit.get("name")] = meant
        for name, factor, offset in _displays(unit):
            shown.setdefault(name, _shown(meant, factor, offset))
    for unit in root.findall("UnitDefinitions/Unit"):
        by_name.pop(unit.get("name"), None)
    return Definitions(shown | found, by_name)


def _displays(unit: Any) -> Iterator[tuple[str, float, float]]:
    """The display units of a unit: name, factor, offset."""
    for display in unit.findall("DisplayUnit"):
        factor, offset = float(display.get("factor", "1")), float(display.get("offset", "0"))
        reciprocal = display.get("inverse") in ("true", "1")  # FMI 3.0; no linear conversion leads there
        if factor and display.get("name") and not reciprocal:
            yield display.get("name"), factor, offset


def _shown(unit: Definition, factor: float, offset: float) -> Definition:
    """A display unit: `shown = factor * value + offset`, with `value` in the unit."""
    return Definition(unit.exponents, unit.factor / factor, unit.offset - unit.factor * offset / factor)
