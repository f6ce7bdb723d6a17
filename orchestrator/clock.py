"""Exact time: periods are rational numbers of seconds, instants are integer multiples of one tick.

The tick is the greatest common divisor of all periods, the start and the stop, so 1/60 s and 1 ms live in one system
and no time is ever the sum of rounded steps. Ticks are counted from the start of the run; times are not.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

from .errors import InputError, point_wanted, shown

SCALES = {"s": Fraction(1), "ms": Fraction(1, 1000), "us": Fraction(1, 10**6), "ns": Fraction(1, 10**9)}
NUMBER = r"[0-9.]{1,64}(?:[eE][+-]?[0-9]{1,3})?(?:/[0-9]{1,64})?"  # bounded: a power of ten is computed exactly
SHORTEST, LONGEST = Fraction(1, 10**15), Fraction(10**15)  # s


def duration(value: object, what: str) -> Fraction:
    """A positive time in seconds, exactly: 0.005, "5 ms", "1/60 s", "250 us". Raises InputError."""
    seconds = instant(value, what)
    if seconds <= 0:
        raise InputError(f"{what} = {str(value).strip()} is not a positive time")
    return seconds


def instant(value: object, what: str) -> Fraction:
    """A time in seconds that may be 0 or negative, exactly: "2 s", -0.5. Raises InputError."""
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
            f"{point_wanted(value)}"
        ) from None
    if seconds and not SHORTEST <= abs(seconds) <= LONGEST:
        raise InputError(f"{what} = {text} is no time that can be counted; from 1e-15 s to 1e15 s are")
    return seconds


def seconds_text(value: Fraction) -> str:
    """A time as a person writes it, exactly: `1.5 ms`, `10 s`, `1/60 s`, `-2 s`."""
    if value <= 0:
        return f"-{seconds_text(-value)}" if value else "0 s"
    for unit in ("s", "ms", "us", "ns"):
        text = f"{float(value / SCALES[unit]):.9g}"
        if value >= SCALES[unit] and "e" not in text and Fraction(text) * SCALES[unit] == value:
            return f"{text} {unit}"
    return f"{value} s"


@dataclass(frozen=True)
class Clock:
    """One tick of `numerator / denominator` seconds; periods, start and stop as whole numbers of ticks.

    `stop` is counted from the start, as all instants of a run are; `start` from time 0. What a run does repeats in
    every `hyperperiod`; of a shorter run that is all of it.
    """

    numerator: int
    denominator: int
    periods: dict[str, int]
    stop: int
    hyperperiod: int
    start: int = 0

    @property
    def cycles(self) -> int:
        """How often the hyperperiod fits in a run."""
        return self.stop // self.hyperperiod

    @property
    def rest(self) -> int:
        """What is left behind the last of them [ticks]."""
        return self.stop % self.hyperperiod

    def time(self, tick: int) -> float:
        """The instant in seconds: the double nearest to the exact rational."""
        return ((self.start + tick) * self.numerator) / self.denominator

    def seconds(self, ticks: int) -> Fraction:
        """A number of ticks in seconds, exactly."""
        return Fraction(ticks * self.numerator, self.denominator)


def require_span(start: Fraction, stop: Fraction) -> None:
    """Raise InputError for a run that would end where it begins, or before."""
    if stop <= start:
        raise InputError(
            f"the stop at {seconds_text(stop)} is not after the start at {seconds_text(start)}; stop later, or start "
            "earlier"
        )


def make_clock(periods: dict[str, Fraction], stop: Fraction, start: Fraction = Fraction(0)) -> Clock:
    """The clock of a system. Raises InputError where no tick counts it exactly."""
    tick = common_tick([*periods.values(), start, stop])
    ticks = {name: int(period / tick) for name, period in periods.items()}
    if not countable(tick, start, stop):
        fine = tick < Fraction(1, 10**6)
        raise InputError(
            f"the periods have no common tick above {float(tick):.1e} s that counts exactly to "
            f"{seconds_text(max(abs(start), abs(stop)))}; "
            + ("round them, start and stop to microseconds" if fine else "keep start and stop nearer to 0")
        )
    span = int((stop - start) / tick)
    return Clock(tick.numerator, tick.denominator, ticks, span, min(lcm(*ticks.values()), span), int(start / tick))


def whole_stops(periods: Iterable[Fraction], start: Fraction, stop: Fraction) -> str:
    """The stop times around `stop` at which all of these periods have an instant, in words."""
    numerators, denominators = zip(*(p.as_integer_ratio() for p in periods), strict=True)
    common = Fraction(lcm(*numerators), gcd(*denominators))  # all periods divide it
    below = (stop - start) // common * common
    return " or ".join(seconds_text(start + t) for t in (below, below + common) if t > 0)


def common_tick(times: Iterable[Fraction]) -> Fraction:
    """The largest time of which all are whole multiples; not all of them 0."""
    found = list(times)
    denominator = lcm(*(t.denominator for t in found))
    return Fraction(gcd(*(int(t * denominator) for t in found)), denominator)


def countable(tick: Fraction, start: Fraction, stop: Fraction) -> bool:
    """Whether every instant from start to stop is exact in ticks: the loop divides them as doubles."""
    largest = max(abs(start), abs(stop), stop - start)
    return max(int(largest / tick) * tick.numerator, tick.denominator) < 2**53
