"""The end of a run in doubles: no step goes beyond the stop that the FMUs were promised."""

from __future__ import annotations

from .lives import compilable

SMALLER = 1.0 - 2.0**-52  # takes at least one unit in the last place away


@compilable
def length_to(time: float, stop: float) -> float:
    """How long a step from `time` is [s] that ends at `stop` in doubles, where the exact length would end behind it."""
    length = stop - time
    while time + length > stop:
        length *= SMALLER
    return length
