"""Are the units declared, understood, and written in base units that agree with their names?"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any

import pint
from fmpy.model_description import Unit

from ....errors import InputError
from ....fmu.types import REALS
from ....units import parse_unit
from ..rows import Row, judged
from ..subject import Subject

STAGE = "units"
DIMENSIONS = {
    "kg": "[mass]", "m": "[length]", "s": "[time]", "A": "[current]", "K": "[temperature]", "mol": "[substance]",
    "cd": "[luminosity]",
}  # fmt: skip


def unit_rows(subject: Subject) -> Iterator[Row]:
    """One row per rule; the radian counts as a pure number, as pint has it."""
    units = {unit.name: unit for unit in subject.description.unitDefinitions}
    reals = [v for v in subject.variables if v.type in REALS]
    used = {v.name: v.unit for v in reals}
    yield judged(
        STAGE, "every number has a unit", [name for name, unit in used.items() if not unit],
        f"{len(used)} variables, {len(units)} units", "without a unit",
        'give each a unit, "1" for pure numbers', "finding",
    )  # fmt: skip
    if subject.version == 1:  # where only display units are defined
        units = {unit: Unit(name=unit) for unit in used.values() if unit}
    yield from _understood(units) if subject.version == 1 else _defined(units, used)


def _defined(units: dict[str, Unit], used: dict[str, str | None]) -> Iterator[Row]:
    yield judged(
        STAGE, "units are defined", sorted({u for u in used.values() if u and u not in units}),
        "all in UnitDefinitions", "not in UnitDefinitions", "add a Unit element for each", "finding",
    )  # fmt: skip
    yield from _understood(units)
    known = {name: (unit, meant) for name, unit in units.items() if (meant := _meaning(name)) is not None}
    missing = [name for name, (unit, meant) in known.items() if unit.baseUnit is None and _whole(meant)]
    yield judged(
        STAGE, "BaseUnit is given", missing, "wherever its exponents are whole", "without BaseUnit",
        "add BaseUnit with the SI exponents, so that others can convert", "finding",
    )  # fmt: skip
    wrong = [name for name, (unit, meant) in known.items() if unit.baseUnit is not None and not _agrees(unit, meant)]
    yield judged(
        STAGE, "BaseUnit fits the name", wrong, "exponents and factors are those of pint", "not the unit of that name",
        "correct exponents, factor or offset of BaseUnit, or the name", "finding",
    )  # fmt: skip


def _understood(units: Iterable[str]) -> Iterator[Row]:
    yield judged(
        STAGE, "units are understood", [name for name in units if _meaning(name) is None], "pint reads every name",
        "pint cannot read", "write them as in N.m, kg.m2, rad/s", "finding",
    )  # fmt: skip


def _meaning(name: str) -> Any:
    """A unit as pint has it; None for one that it does not know."""
    try:
        return parse_unit(name)
    except InputError:
        return None


def _whole(meant: pint.Unit) -> bool:
    dimensions: Any = meant.dimensionality
    return all(exponent == int(exponent) for exponent in dimensions.values())


def _agrees(unit: Unit, meant: pint.Unit) -> bool:
    base = unit.baseUnit
    assert base is not None
    written = {dimension: getattr(base, symbol) for symbol, dimension in DIMENSIONS.items() if getattr(base, symbol)}
    if written != dict(meant.dimensionality):
        return False
    quantity: Any = meant._REGISTRY.Quantity
    zero, one = (quantity(value, meant).to_base_units().magnitude for value in (0.0, 1.0))
    return math.isclose(base.factor, one - zero, rel_tol=1e-9) and math.isclose(base.offset, zero, rel_tol=1e-9)
