"""Units of values that meet: what each means, and the linear conversion between them, or an error.

A unit means what the file says that it comes from; names that no file defines mean what pint says. pint takes a tenth
of a second to import, so it waits for the first two units that are written differently and not defined.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import cache
from typing import Any

from .errors import InputError

BASE_UNITS = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")
DIMENSIONS = (
    "[mass]",
    "[length]",
    "[time]",
    "[current]",
    "[temperature]",
    "[substance]",
    "[luminosity]",
)  # pint's, in the order of BASE_UNITS; the radian is a pure number there
TIME, ANGLE = BASE_UNITS.index("s"), BASE_UNITS.index("rad")
# pint takes both Hz and rad/s for 1/s and would convert one into the other by 1.
TURNS, ANGLES = re.compile(r"Hz"), re.compile(r"rad|deg|rpm|rev|turn")
TURNED = re.compile(r"(?<![^\W\d_])U(?![^\W\d_])")  # U/min; an enzyme unit to pint
# What may reach pint, which would compute any arithmetic: symbols with one short exponent each, no numbers but 1.
EXPONENT = r"-?\d{1,2}(?:\.\d{1,3})?"
POWER = rf"(?:(?:\*\*|\^)?(?:\({EXPONENT}\)|{EXPONENT}))?+"
GRAMMAR = re.compile(rf"(?:(?:[^\W\d]|[%°)]){POWER}|1(?!\w)|[( ./]|\*(?!\*))++")
LONGEST = 64  # characters
ROUNDING = 1e-6  # relative: by so much a factor in a file may differ from the exact one
STATE = 'where an FMU leaves it open, the system file can say it: units = { NAME = "rpm" } under [components.NAME]'
OURS = ("newton_meter = newton * meter = Nm", "@alias ohm = Ohm", "@alias turn = rev")  # as FMI and Modelica write them


@dataclass(frozen=True)
class Definition:
    """What a unit means: `factor * value + offset` in the product of BASE_UNITS with these exponents."""

    exponents: tuple[float, ...]
    factor: float = 1.0
    offset: float = 0.0

    @property
    def frequency(self) -> bool:
        """Whether it counts something per time, or per time squared, be it angles, turns or events."""
        others = [x for k, x in enumerate(self.exponents) if k not in (TIME, ANGLE)]
        return not any(others) and self.exponents[TIME] != 0


@dataclass(frozen=True)
class Unit:
    """A unit by its name, with what the file says of it where it stands."""

    name: str
    definition: Definition | None = None
    relative: bool = False  # of a difference, which has no zero point: it converts by the factor alone

    def __str__(self) -> str:
        return self.name


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
    `kilogram * meter / second ** 2` is read too.
    """
    text = re.sub(r"\s*(\*\*|\*|/)\s*", r"\1", unit.strip())  # pint's own spelling too
    if text in ("", "-", "1"):
        return _registry().Unit("dimensionless")
    if len(text) > LONGEST or not GRAMMAR.fullmatch(text):
        raise InputError(f"unit {text[:LONGEST]!r} is not understood (write it as N.m, kg.m2 or 1/s)")
    if TURNED.search(text):
        raise InputError(
            f"unit '{unit}' is not understood: U can be turns, or of enzymes; turns are written rpm, rev/s"
        )
    text = re.sub(r"(?<=[^\W\d])(-?\d+(\.\d+)?)|(?<=\))(-?\d+(\.\d+)?)", r"**(\1\3)", text).replace(".", "*")
    text = re.sub(r"\((-?\d+)\*(\d+)\)", r"(\1.\2)", text)
    text = "/".join(f"({part})" for part in re.split(r"/(?![^(]*\))", text))
    try:
        return _registry().parse_units(text)
    except Exception as error:
        raise InputError(f"unit '{unit}' is not understood ({error})") from error


@cache
def meaning(name: str) -> Definition:
    """What pint says that a unit means. Raises InputError for one that is unknown or not linear."""
    meant = parse_unit(name)
    quantity = _registry().Quantity
    dimensions = dict(meant.dimensionality)
    zero, one, two = (quantity(x, meant).to_base_units() for x in (0.0, 1.0, 2.0))
    a, b, c = (float(x.magnitude) for x in (zero, one, two))
    if not abs(c - 2.0 * b + a) <= 1e-9 * max(abs(b), abs(a)):
        raise InputError(f"unit {name} is not proportional to any other")
    angle = {str(unit): power for unit, power in one.unit_items()}.get("radian", 0)
    return Definition((*(float(dimensions.get(d, 0)) for d in DIMENSIONS), float(angle)), b - a, a)


def conversion(source: Unit | str | None, target: Unit | str | None, label: str) -> tuple[float, float]:
    """Gain and offset that turn a value in `source` units into `target` units. Raises InputError if incompatible.

    A side without a unit is taken as it is. A name alone means what pint says, and a difference where the other does.
    """
    if source is None or target is None:
        return 1.0, 0.0
    relative = source.relative if isinstance(source, Unit) else isinstance(target, Unit) and target.relative
    a = source if isinstance(source, Unit) else Unit(source, None, relative)
    b = target if isinstance(target, Unit) else Unit(target, None, relative)
    if a.name == b.name and (a.definition is None or b.definition is None or _same(a.definition, b.definition)):
        return 1.0, 0.0
    try:
        gain, offset = _by_names(a.name, b.name) if a.definition is b.definition is None else _by_definitions(a, b)
    except InputError as error:
        raise InputError(f"{label}: {error}") from None
    if offset and a.relative != b.relative:
        difference, value = (a, b) if a.relative else (b, a)
        raise InputError(
            f"{label}: the units do not fit: one is a difference in {difference} (relativeQuantity), the other a value "
            f"in {value}, and their zero points differ; correct relativeQuantity of one of them"
        )
    return gain, 0.0 if a.relative else offset


def integral_gain(counter: Unit | None, value: Unit | None, label: str) -> float:
    """What a value is, in its unit, whose time integral rises by 1 of the counter's unit in a second.

    A side without a unit is taken to fit. Raises InputError where the counter's unit is not that of the value times s.
    """
    if counter is None or value is None:
        return 1.0
    try:
        x, y = _meant(counter), _meant(value)
    except InputError as error:
        raise InputError(f"{label}: {error}") from None
    per_second = [exponent - (k == TIME) for k, exponent in enumerate(x.exponents)]
    turns = y.frequency and _angle(counter, x) != _angle(value, y)
    if per_second[:ANGLE] != list(y.exponents[:ANGLE]) or turns:
        raise InputError(f"{label}: the units do not fit: {counter} is not that of {value} integrated over s")
    if y.offset and not value.relative:
        raise InputError(f"{label}: {value} has a zero point of its own, so its time integral has no unit")
    return x.factor / y.factor


def left_open(unit: Unit, said: Unit) -> bool:
    """Whether `said` may say what `unit` means: nobody knows that, or it is per time and says not what it counts."""
    try:
        own, other = unit.definition or meaning(unit.name), said.definition or meaning(said.name)
    except InputError:
        return True
    if not own.frequency or own.exponents[:ANGLE] != other.exponents[:ANGLE]:
        return False
    ratio = other.factor / own.factor
    known = any(math.isclose(ratio, x, rel_tol=ROUNDING) for x in (1.0, math.tau))
    return known and not _angle(unit, own) and bool(_angle(said, other))


def _same(a: Definition, b: Definition) -> bool:
    """Two definitions of one name: many leave out the exponent of rad."""
    return (a.exponents[:ANGLE], a.factor, a.offset) == (b.exponents[:ANGLE], b.factor, b.offset)


def _by_definitions(a: Unit, b: Unit) -> tuple[float, float]:
    """Where one of the two is defined by a file at least."""
    x, y = (_meant(unit) for unit in (a, b))
    if x.exponents[:ANGLE] != y.exponents[:ANGLE]:
        raise InputError(f"the units do not fit: {a} cannot become {b}")
    if x.frequency and _angle(a, x) != _angle(b, y):
        raise InputError(_apart(a.name, b.name))
    return x.factor / y.factor, (x.offset - y.offset) / y.factor


def _meant(unit: Unit) -> Definition:
    if unit.definition is not None:
        return unit.definition
    try:
        return meaning(unit.name)
    except InputError as error:
        raise InputError(f"{error}; {STATE}") from None


def _angle(unit: Unit, meant: Definition) -> float:
    """The exponent of rad of something per time; by its name where the file may have left it out (rpm, 0.1047/s)."""
    if meant.exponents[ANGLE] or not ANGLES.search(unit.name):
        return meant.exponents[ANGLE]
    try:
        named = meaning(unit.name)
    except InputError:
        return 0.0
    alike = named.frequency and math.isclose(named.factor, meant.factor, rel_tol=ROUNDING)
    return named.exponents[ANGLE] if alike else 0.0


def _apart(a: str, b: str) -> str:
    return (
        f"the units do not fit: of {a} and {b} one counts turns or says not what it counts, and one angle, 2 pi apart; "
        f"write rpm or rev/s where turns are meant, rad/s for an angle; {STATE}"
    )


def _by_names(source: str, target: str) -> tuple[float, float]:
    if any(TURNS.search(x) and ANGLES.search(y) for x, y in ((source, target), (target, source))):
        raise InputError(_apart(source, target))
    try:
        converted = _converted(source, target)
    except InputError as error:
        raise InputError(f"{error}; {STATE}") from None
    if converted is None:
        raise InputError(f"the units do not fit: {source} cannot become {target}")
    offset, one, two = converted
    if not abs(two - 2.0 * one + offset) <= 1e-9 * max(abs(one), abs(offset)):
        raise InputError(f"the units do not fit: {source} and {target} are not proportional")
    a, b = meaning(source), meaning(target)
    if a.frequency and a.exponents[ANGLE] != b.exponents[ANGLE]:
        raise InputError(_apart(source, target))
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
