"""How far a step by hand goes: times that are whole numbers of the schedule's own steps."""

from __future__ import annotations

from fractions import Fraction

from ...clock import duration, seconds_text
from ...errors import InputError
from ...plan.plan import Plan

Time = str | float | Fraction


def steps_in(plan: Plan, by: Time, what: str) -> int:
    """How many steps a time has; `what` messages call it. Raises InputError if it is no whole number of them."""
    seconds, period = duration(by, what), plan.clock.seconds(plan.clock.hyperperiod)
    if (seconds / period).denominator == 1:
        return int(seconds / period)
    if plan.adaptive:
        raise InputError(f"{what} = {seconds_text(seconds)} is no multiple of the first step {seconds_text(period)}")
    raise InputError(
        f"{what} = {seconds_text(seconds)} is no multiple of {seconds_text(period)}, in which the schedule "
        f"repeats; take a multiple, or components with other periods"
    )
