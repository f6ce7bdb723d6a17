"""Which output may drive which input, and how its values become those of another type.

What can lose nothing is converted by itself. What could is refused, unless the connection says `round`: the nearest
value of the input's type is taken then, and one that the type does not hold ends the run.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

from fmpy.model_description import ModelVariable

from ..errors import InputError
from .attributes import items_of
from .types import BINARY, BOOLEAN, TEXT, FmiType, Value

EXACT = {4: 2.0**24, 8: 2.0**53}  # so far every whole number is a floating-point number of 4 or 8 bytes


class LossyError(InputError):
    """A conversion that could lose something, and is made only where the connection says `round`."""


class How(Enum):
    """What the loop does to a cell of the run's vector."""

    REAL = 1  # both are doubles there
    SAME = 2  # both are whole numbers there, or texts
    NUMBER = 3  # a whole number becomes a double
    FIT = 4  # becomes, or is, a whole number that the input's type must hold


@dataclass(frozen=True)
class Conversion:
    """What happens to the values of an output on their way into an input.

    `least` and `most` are what the input's type holds, `items` those of an Enumeration, where they must be checked.
    """

    how: How
    words: str = ""  # for the plan; empty where the types are alike
    real: bool = False  # the output is floating point
    unsigned: bool = False  # a UInt64, of which a cell holds the bits
    least: int = 0
    most: int = 0
    items: tuple[int, ...] = ()
    largest: float = math.inf  # of a real input, in either direction

    @property
    def bounds(self) -> tuple[float, float]:
        """The smallest number that fits, and the first beyond; of cells that are whole numbers of 64 bits."""
        if self.real or self.most < 2**63 - 1:
            return float(max(self.least, 0) if self.unsigned else self.least), self.most + 1.0
        return (0.0 if self.unsigned else float(self.least)), math.inf

    def convert(self, value: Value, gain: float, offset: float) -> Value:
        """One value, as the loop converts it. Raises ValueError, with the words, for one that does not fit."""
        if self.how is How.SAME:
            return value
        if self.how in (How.REAL, How.NUMBER):
            real = gain * float(value) + offset
            if abs(real) > self.largest:
                raise ValueError(self.unfit(real))
            return real
        number = gain * float(value) + offset if self.real else int(value)
        if self.real and math.isfinite(number):
            number = round(number)
        if not self.least <= number <= self.most or (self.items and number not in self.items):
            raise ValueError(self.unfit(number))
        return int(number)

    def unfit(self, number: float | int) -> str:
        """Why a number cannot be given to the input."""
        if self.least <= number <= self.most:
            return f"{number:g} is none of its items, {', '.join(map(str, self.items))}"
        return f"{number:g} is beyond what its type holds"


def conversion_of(
    source: ModelVariable, a: FmiType | None, target: ModelVariable, b: FmiType | None, rounded: bool = False
) -> Conversion:
    """From an output of one type to an input of another.

    Raises LossyError where only `rounded` ones are possible, InputError where none is: why, and what to do instead.
    """
    for variable, known in ((source, a), (target, b)):
        if known is None:
            raise InputError(f"signals of type {variable.type} cannot be connected")
    assert a is not None and b is not None
    words = "" if a.name == b.name else f"{a.name} to {b.name}"
    if {TEXT, BINARY} & {a.code, b.code}:
        if a.code == b.code:
            return Conversion(How.SAME)
        raise InputError("there is no conversion between them; put an FMU between that makes one of the other")
    if b.code == BOOLEAN and a.code != BOOLEAN:
        raise InputError("a Boolean is true or false only; put an FMU between that compares the value")
    if b.real:
        return _into_real(source, a, b, rounded, words)
    if a.real:
        if not rounded:
            raise LossyError(f"a {a.name} can lie between whole numbers")
        return Conversion(How.FIT, f"{words}, rounded", True, False, *_range(b), _items(target))
    return _between_whole(source, a, target, b, rounded, words)


def _into_real(source: ModelVariable, a: FmiType, b: FmiType, rounded: bool, words: str) -> Conversion:
    if a.real:
        loses, how = b.size < a.size, How.REAL
    else:
        low, high = _values(source, a)
        loses, how = not -EXACT[b.size] <= low <= high <= EXACT[b.size], How.NUMBER
    if loses and not rounded:
        raise LossyError(f"a {b.name} does not hold every {a.name}")
    return Conversion(how, f"{words}, rounded" if loses else words, a.real, _unsigned(a), largest=b.largest)


def _between_whole(
    source: ModelVariable, a: FmiType, target: ModelVariable, b: FmiType, rounded: bool, words: str
) -> Conversion:
    items = _items(target)
    if a.name == b.name == "Enumeration" and source.declaredType and target.declaredType:
        if items_of(source) != items_of(target):
            raise InputError(
                f"the items of the two enumerations differ: {_differing(source, target)}; put an FMU between that "
                "makes one of the other"
            )
        return Conversion(How.SAME)
    (low, high), (least, most) = _values(source, a), _range(b)
    if not least <= low <= high <= most and not rounded:
        raise LossyError(f"{b.name} holds {least} to {most} only")
    if high - low < len(items) and set(range(low, high + 1)) <= set(items):
        items = ()  # each value is one: there is nothing to check
    own = _range(a)
    if not items and least <= own[0] and own[1] <= most:
        return Conversion(How.SAME, words)
    checked = ", its items checked" if items else ", its range checked"
    return Conversion(How.FIT, (words or a.name) + checked, False, _unsigned(a), least, most, items)


def _differing(source: ModelVariable, target: ModelVariable) -> str:
    """`only the output has big = 7`: what two enumerations do not have in common."""
    ours, theirs = items_of(source), items_of(target)
    found = []
    for end, own, other in (("output", ours, theirs), ("input", theirs, ours)):
        alone = [f"{name} = {value}" for name, value in own.items() if other.get(name) != value]
        found += [f"only the {end} has {', '.join(alone)}"] if alone else []
    return ", ".join(found)


def _items(variable: ModelVariable) -> tuple[int, ...]:
    return tuple(sorted(set(items_of(variable).values())))


def _range(kind: FmiType) -> tuple[int, int]:
    """What the type holds."""
    return (0, 1) if kind.code == BOOLEAN else kind.range


def _unsigned(kind: FmiType) -> bool:
    return kind.name == "UInt64"


def _values(variable: ModelVariable, kind: FmiType) -> tuple[int, int]:
    """The smallest and the largest value that a variable has: of an Enumeration with items, those."""
    items = _items(variable)
    return (items[0], items[-1]) if items else _range(kind)
