"""Exact time: periods are rational numbers of seconds, instants are integer multiples of one tick.

The tick is the greatest common divisor of all periods and the stop time, so 1/60 s and 1 ms live in one system and
no time is ever the sum of rounded steps.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

from .errors import InputError, shown

SCALES = {"s": Fraction(1), "ms": Fraction(1, 1000), "us": Fraction(1, 10**6), "ns": Fraction(1, 10**9)}
NUMBER = r"[0-9.]{1,64}(?:[eE][+-]?[0-9]{1,3})?(?:/[0-9]{1,64})?"  # bounded: a power of ten is computed exactly
SHORTEST, LONGEST = Fraction(1, 10**15), Fraction(10**15)  # s


def duration(value: object, what: str) -> Fraction:
    """A positive time in seconds, exactly: 0.005, "5 ms", "1/60 s", "250 us". Raises InputError."""
    text = "" if isinstance(value, bool) or (isinstance(value, int) and value > LONGEST) else str(value).strip()
    match = re.fullmatch(rf"([+-]?{NUMBER})\s*([a-z]*)", text)
    scale = SCALES.get(match[2] or "s") if match else None
    try:
        if match is None or scale is None:
            raise ValueError
        seconds = Fraction(match[1]) * scale
    except (ValueError, ZeroDivisionError):
        raise InputError(
            f'{what} = {shown(value)!r} is not a time; write a number of seconds, "5 ms", "250 us" or "1/60 s"'
        ) from None
    if seconds <= 0:
        raise InputError(f"{what} = {text} is not a positive time")
    if not SHORTEST <= seconds <= LONGEST:
        raise InputError(f"{what} = {text} is no time that can be counted; from 1e-15 s to 1e15 s are")
    return seconds


def seconds_text(value: Fraction) -> str:
    """A time as a person writes it, exactly: `1.5 ms`, `10 s`, `1/60 s`."""
    for unit in ("s", "ms", "us", "ns"):
        text = f"{float(value / SCALES[unit]):.9g}"
        if value >= SCALES[unit] and "e" not in text and Fraction(text) * SCALES[unit] == value:
            return f"{text} {unit}"
    return f"{value} s"


@dataclass(frozen=True)
class Clock:
    """One tick of `numerator / denominator` seconds; periods and stop time as whole numbers of ticks."""

    numerator: int
    denominator: int
    periods: dict[str, int]
    stop: int
    hyperperiod: int

    def time(self, tick: int) -> float:
        """The instant in seconds: the double nearest to the exact rational."""
        return (tick * self.numerator) / self.denominator

    def seconds(self, ticks: int) -> Fraction:
        """A number of ticks in seconds, exactly."""
        return Fraction(ticks * self.numerator, self.denominator)


def make_clock(periods: dict[str, Fraction], stop: Fraction) -> Clock:
    """The clock of a system. Raises InputError where the stop time is no whole number of some period."""
    for name, period in periods.items():
        if (stop / period).denominator != 1:
            numerators, denominators = zip(*(p.as_integer_ratio() for p in periods.values()), strict=True)
            common = Fraction(lcm(*numerators), gcd(*denominators))  # all periods divide it
            below = stop // common * common
            text = " or ".join(seconds_text(t) for t in (below, below + common) if t > 0)
            raise InputError(
                f"component {name}: period {seconds_text(period)} does not divide the stop time {seconds_text(stop)}; "
                f"stop at {text}, or take a period that divides it"
            )
    all_times = [*periods.values(), stop]
    denominator = lcm(*(t.denominator for t in all_times))
    numerator = gcd(*(int(t * denominator) for t in all_times))
    tick = Fraction(numerator, denominator)
    ticks = {name: int(period / tick) for name, period in periods.items()}
    if max(int(stop / tick) * numerator, denominator) >= 2**53:  # the loop divides them as doubles
        raise InputError(
            f"the periods have no common tick above {float(tick):.1e} s "
            f"that counts exactly to {seconds_text(stop)}; round them to microseconds"
        )
    return Clock(tick.numerator, tick.denominator, ticks, int(stop / tick), lcm(*ticks.values()))
