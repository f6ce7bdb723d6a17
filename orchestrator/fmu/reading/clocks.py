"""The clocks of an FMI 3.0 FMU, as its description states them: when they tick, with exact intervals (section 2.2.9).

A time-based clock is an input that its importer activates, periodically or when the FMU says; a triggered one ticks by
what happens: an output clock says that it did, an input clock is told so by another FMU's.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation
from fractions import Fraction

from fmpy.model_description import ModelVariable

from ...errors import FmuError
from .details import Details

PERIODIC = ("constant", "fixed", "calculated", "tunable")  # `calculated` was in FMI 3.0.0 and is `fixed` since
APERIODIC = ("changing", "countdown")
TRIGGERED = "triggered"
SHORTEST, LONGEST = Fraction(1, 10**15), Fraction(10**15)  # s, of an interval that can be counted
DIGITS = 60  # of a number that is read: more are no time


@dataclass(frozen=True)
class ClockVariable:
    """A variable of type Clock. Times in seconds, exactly."""

    name: str
    reference: int
    causality: str
    variability: str  # intervalVariability: of PERIODIC, APERIODIC, or TRIGGERED
    interval: Fraction | None = None  # as the description states it
    shift: Fraction = Fraction(0)  # of its first tick behind the start
    fractions: bool = False  # whether intervals are exchanged as fractions, too
    resolution: int | None = None
    deactivates: bool = False  # whether it can be deactivated again at the same instant
    priority: int | None = None  # 0 first
    fault: str = ""  # why it cannot be run as it is stated

    @property
    def periodic(self) -> bool:
        return self.variability in PERIODIC

    @property
    def time_based(self) -> bool:
        """Whether it ticks at times that its description or its FMU tells."""
        return self.variability != TRIGGERED

    @property
    def known(self) -> Fraction | None:
        """The period where it is known before the FMU is loaded."""
        return self.interval if self.periodic else None

    @property
    def settable(self) -> bool:
        """Whether its interval is for the importer to choose; what the description states counts where it does not."""
        return self.variability in ("fixed", "tunable") and self.interval is not None


def read_clocks(variables: Iterable[ModelVariable], details: Details) -> dict[str, ClockVariable]:
    """The clocks among some variables, by name, aliases too. What cannot be run carries its `fault`."""
    return {
        v.name: _clock(v, details.get(v.name if v.alias is None else v.alias.name, {}))
        for v in variables
        if v.type == "Clock"
    }


def _clock(v: ModelVariable, stated: Mapping[str, str]) -> ClockVariable:
    variability = stated.get("intervalVariability", "")
    resolution = _whole(stated.get("resolution"))
    counter, shift_counter = _whole(stated.get("intervalCounter")), _whole(stated.get("shiftCounter"))
    decimal, shift = _decimal(stated.get("intervalDecimal")), _decimal(stated.get("shiftDecimal")) or Fraction(0)
    interval = Fraction(counter, resolution) if resolution and counter is not None else decimal
    if resolution and shift_counter:
        shift = Fraction(shift_counter, resolution)
    priority = _whole(stated.get("priority"))
    clock = ClockVariable(
        v.name, v.valueReference, v.causality, variability, interval, shift,
        stated.get("supportsFraction") in ("true", "1"), resolution, stated.get("canBeDeactivated") in ("true", "1"),
        priority,
    )  # fmt: skip
    faults = [*_faults(clock), *_disagreement(stated, interval, decimal)]
    return ClockVariable(**{**vars(clock), "fault": faults[0]}) if faults else clock


def _faults(clock: ClockVariable) -> Iterator[str]:
    if clock.variability not in (*PERIODIC, *APERIODIC, TRIGGERED):
        yield f"intervalVariability = {clock.variability!r} is none that FMI 3.0 knows"
    elif clock.time_based and clock.causality != "input":
        yield f"it is {clock.variability} and of causality {clock.causality}; only an input clock can be time-based"
    elif clock.variability == "constant" and clock.interval is None:
        yield "it is constant and states no interval (intervalDecimal, or intervalCounter and resolution)"
    elif clock.interval is not None and clock.periodic and not SHORTEST <= clock.interval <= LONGEST:
        yield f"its interval is {float(clock.interval):g} s; from 1e-15 s to 1e15 s can be counted"
    elif clock.shift < 0:
        yield f"its first tick is {float(clock.shift):g} s behind the start, which is before it"


def _disagreement(stated: Mapping[str, str], interval: Fraction | None, decimal: Fraction | None) -> Iterator[str]:
    """Whether the two ways to state an interval contradict each other, by more than the last digit of the decimal."""
    if interval is None or decimal is None or interval == decimal:
        return
    digits = Decimal(stated["intervalDecimal"].strip()).as_tuple()
    last = Fraction(10) ** int(digits.exponent)
    if abs(interval - decimal) > max(last, abs(decimal) * Fraction(1, 10**6)):  # the schema's xs:float has 24 bits
        yield (
            f"intervalDecimal = {stated['intervalDecimal']} and intervalCounter/resolution = {interval} s contradict "
            f"each other"
        )


def _whole(text: str | None) -> int | None:
    try:
        return int(text) if text is not None and len(text) < DIGITS else None
    except ValueError:
        return None


def _decimal(text: str | None) -> Fraction | None:
    """A decimal number exactly as it is written."""
    try:
        number = Decimal((text or "").strip())
    except InvalidOperation:
        return None
    exponent = number.as_tuple().exponent
    sensible = number.is_finite() and isinstance(exponent, int) and abs(exponent) < DIGITS and len(text or "") < DIGITS
    return Fraction(number) if sensible else None


def seconds_of(value: float) -> Fraction:
    """A time that an FMU tells as a double, as the decimal number that it means: the shortest that rounds to it.

    Raises ValueError for one that is no time.
    """
    if not math.isfinite(value):
        raise ValueError(f"{value} s is no time")
    return Fraction(repr(value))


def require_clocks(shown: str, clocks: Mapping[str, ClockVariable]) -> None:
    """Raise FmuError for the first clock that cannot be run as it is stated; `shown`: the FMU in messages."""
    for clock in clocks.values():
        if clock.fault:
            raise FmuError(f"{shown}: clock {clock.name}: {clock.fault}; export it again, or correct its description")
