"""An event that others take part in: entered, gone round and left from outside."""

from __future__ import annotations

from ..cells import (
    IN_EVENTS,
    NEXT_EVENT,
    OK,
    PENDING,
    TIME,
    X,
)  # fmt: skip
from ..members import place
from ..memory import number, put_whole, whole
from .leaving import leave_events
from .rounds import CLOSE, enter_events, moved, pass_on, update_all


def enter(g: int) -> int:
    """Put all members into event mode at TIME, or at the time event that is there but for rounding."""
    time, due = number(g + TIME), number(g + NEXT_EVENT)
    if whole(g + IN_EVENTS) == 0 and time < due <= time + CLOSE * abs(time):
        status = place(g, due, whole(g + X))
        if status != OK:
            return status
    status = enter_events(g)
    if status == OK:
        moved(g)
    return status


def go_round(g: int) -> int:
    """One round of an event that others take part in: 1 if another one is needed, 0 if not; below 0 as of `pass_on`."""
    new = pass_on(g)
    if new < 0:
        return new
    again = update_all(g)
    if again < 0:
        return again
    new = pass_on(g)
    return new if new < 0 else max(new, again)


def leave(g: int) -> int:
    """Nothing more happens at this instant."""
    put_whole(g + PENDING, 0)
    return leave_events(g)
