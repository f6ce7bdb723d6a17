"""What an FMU says that its units mean: its UnitDefinitions."""

from __future__ import annotations

from typing import Any

from ..units import BASE_UNITS, Definition


def definitions_of(root: Any) -> dict[str, Definition]:
    """The units of a mended description by name, and its display units where no unit has their name."""
    found: dict[str, Definition] = {}
    shown: dict[str, Definition] = {}
    for unit in root.findall("UnitDefinitions/Unit"):
        base = unit.find("BaseUnit")
        if base is None:
            continue
        exponents = tuple(int(base.get(symbol, "0")) for symbol in BASE_UNITS)
        meant = Definition(exponents, float(base.get("factor", "1")), float(base.get("offset", "0")))
        found[unit.get("name")] = meant
        for display in unit.findall("DisplayUnit"):
            factor, offset = float(display.get("factor", "1")), float(display.get("offset", "0"))
            reciprocal = display.get("inverse") in ("true", "1")  # FMI 3.0; no linear conversion leads there
            if factor and display.get("name") and not reciprocal:
                shown.setdefault(display.get("name"), _shown(meant, factor, offset))
    return shown | found


def _shown(unit: Definition, factor: float, offset: float) -> Definition:
    """A display unit: `shown = factor * value + offset`, with `value` in the unit."""
    return Definition(unit.exponents, unit.factor / factor, unit.offset - unit.factor * offset / factor)
