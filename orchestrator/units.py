"""Unit checks of connections, by pint: equal, convertible (with gain and offset), or an error.

pint takes a tenth of a second to import, so it waits for the first two units that are written differently.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from .errors import InputError

# pint takes both Hz and rad/s for 1/s and would convert one into the other by 1.
TURNS, ANGLES = re.compile(r"Hz"), re.compile(r"rad|deg|rpm|rev")
# What may reach pint, which would compute any arithmetic: symbols with one short exponent each, no numbers but 1.
EXPONENT = r"-?\d{1,2}(?:\.\d{1,3})?"
POWER = rf"(?:(?:\*\*|\^)?(?:\({EXPONENT}\)|{EXPONENT}))?+"
GRAMMAR = re.compile(rf"(?:(?:[^\W\d]|[%°)]){POWER}|1(?!\w)|[( ./]|\*(?!\*))++")
LONGEST = 64  # characters
OURS = ("newton_meter = newton * meter = Nm", "@alias ohm = Ohm", "@alias turn = rev")  # as FMI and Modelica write them


@cache
def _registry() -> Any:
    import pint

    registry: Any = pint.UnitRegistry(on_redefinition="ignore")  # Nm is a number of textile there
    for definition in OURS:
        registry.define(definition)
    return registry


@cache
def parse_unit(unit: str) -> Any:
    """An FMI unit string (`N.m`, `kg.m2`, `rad/s`, `1`) as a pint unit. Raises InputError if it is unknown.

    What follows a `/` up to the next is below it: `J/kg.K` is J/(kg.K), `m/s/s` is m/s2; `-` and nothing are 1.
    """
    text = unit.strip()
    if text in ("", "-", "1"):
        return _registry().Unit("dimensionless")
    if len(text) > LONGEST or not GRAMMAR.fullmatch(text):
        raise InputError(f"unit {text[:LONGEST]!r} is not understood (write it as N.m, kg.m2 or 1/s)")
    text = re.sub(r"(?<=[^\W\d])(-?\d+(\.\d+)?)|(?<=\))(-?\d+(\.\d+)?)", r"**(\1\3)", text).replace(".", "*")
    text = re.sub(r"\((-?\d+)\*(\d+)\)", r"(\1.\2)", text)
    text = "/".join(f"({part})" for part in re.split(r"/(?![^(]*\))", text))
    try:
        return _registry().parse_units(text)
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
        converted = _converted(source, target)
    except InputError as error:
        raise InputError(f"{label}: {error}") from None
    if converted is None:
        raise InputError(f"{label}: the units do not fit: {source} cannot become {target}")
    offset, one, two = converted
    if not abs(two - 2.0 * one + offset) <= 1e-9 * max(abs(one), abs(offset)):
        raise InputError(f"{label}: the units do not fit: {source} and {target} are not proportional")
    return one - offset, offset


@cache
def _converted(source: str, target: str) -> tuple[float, float, float] | None:
    """0, 1 and 2 in other units; None where their dimensions differ."""
    a, b = parse_unit(source), parse_unit(target)
    if a.dimensionality != b.dimensionality:
        return None
    quantity = _registry().Quantity
    offset, one, two = (float(quantity(x, a).to(b).magnitude) for x in (0.0, 1.0, 2.0))
    return offset, one, two
