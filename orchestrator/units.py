"""Unit checks of connections, by pint: equal, convertible (with gain and offset), or an error."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import pint

from .errors import InputError

# pint takes both Hz and rad/s for 1/s and would convert one into the other by 1.
TURNS, ANGLES = re.compile(r"Hz"), re.compile(r"rad|deg|rpm|rev")


@cache
def _registry() -> Any:
    registry: Any = pint.UnitRegistry()
    registry.define("@alias ohm = Ohm")  # as FMI and Modelica write it
    return registry


@cache
def parse_unit(unit: str) -> Any:
    """An FMI unit string (`N.m`, `kg.m2`, `rad/s`, `1`) as a pint unit. Raises InputError if it is unknown."""
    text = (
        re.sub(r"(?<=[A-Za-z)])(-?\d+(\.\d+)?)", r"**(\1)", unit.strip() or "1").replace(".", "*")
        if unit != "1"
        else "1"
    )
    text = re.sub(r"\((-?\d+)\*(\d+)\)", r"(\1.\2)", text)
    numerator, _, denominator = text.partition("/")
    text = f"({numerator})/({denominator})" if denominator else numerator
    try:
        return _registry().Unit("dimensionless") if text == "1" else _registry().parse_units(text)
    except Exception as error:
        raise InputError(f"unit '{unit}' is not understood ({error})") from error


def conversion(source: str | None, target: str | None, label: str) -> tuple[float, float]:
    """Gain and offset that turn a value in `source` units into `target` units. Raises InputError if incompatible.

    A side without a unit is taken as it is.
    """
    if source == target or source is None or target is None:
        return 1.0, 0.0
    if any(TURNS.search(x) and ANGLES.search(y) for x, y in ((source, target), (target, source))):
        raise InputError(
            f"{label}: the units do not fit: of {source} and {target} one counts turns "
            f"and one angle, 2 pi apart; use one kind"
        )
    try:
        a, b = parse_unit(source), parse_unit(target)
        quantity = _registry().Quantity
        offset = float(quantity(0.0, a).to(b).magnitude)
        return float(quantity(1.0, a).to(b).magnitude) - offset, offset
    except pint.DimensionalityError:
        raise InputError(f"{label}: the units do not fit: {source} cannot become {target}") from None
    except InputError as error:
        raise InputError(f"{label}: {error}") from None
