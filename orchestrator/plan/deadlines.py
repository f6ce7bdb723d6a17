"""At which instants a run that keeps pace waits for the clock on the wall."""

from __future__ import annotations

from fractions import Fraction

from ..clock import Clock, duration, seconds_text
from ..errors import InputError
from ..system.model import System
from .algorithms.base import Algorithm

LONGEST = Fraction(1, 20)  # s between two deadlines that nobody has asked for: what a person takes for at once


def deadlines_of(system: System, clock: Clock, algorithm: Algorithm, every: str | None) -> int:
    """Ticks between two deadlines; 0 for a run that keeps no pace (None).

    An empty text: once in a hyperperiod; if that is longer than 50 ms, as often as the slowest component that is at
    least so fast, or the fastest one. Where macro steps vary, or are repeated, the deadline is the end of each.
    Raises InputError for a time that is no multiple of the instants, or does not divide the hyperperiod.
    """
    if every is None:
        return 0
    whole = clock.hyperperiod
    if algorithm.steps_vary or algorithm.saves_states:
        if every:
            raise InputError(
                f"deadlines every {every}: with algorithm '{algorithm.name}' there is one at the end of each macro "
                f"step; leave it out"
            )
        return whole
    periods = sorted({clock.periods[name] for name in system.components})
    if every:
        ticks = duration(every, "deadlines") / clock.seconds(1)
        if ticks.denominator != 1 or not 0 < ticks <= whole or whole % ticks or ticks % periods[0]:
            raise InputError(
                f"deadlines every {seconds_text(duration(every, 'deadlines'))}: take a multiple of the shortest period "
                f"{seconds_text(clock.seconds(periods[0]))} that divides {seconds_text(clock.seconds(whole))}, in "
                f"which the schedule repeats"
            )
        return int(ticks)
    if clock.seconds(whole) <= LONGEST:
        return whole
    return max((period for period in periods if clock.seconds(period) <= LONGEST), default=periods[0])
