"""The beginning of a step: what was set since the last one, and the event that may follow from it."""

from __future__ import annotations

from numba.extending import register_jitable

from ..advance import note_event
from ..cells import (
    CELL,
    CHANGED,
    CURRENT,
    ENDS_EARLY,
    IN_EVENTS,
    IN_WINDOW,
    LOST,
    NEXT_STEP,
    OK,
    PENDING,
    RESTART,
    RESTARTS,
    SEEN,
    STOPPED,
    TIME,
    WATCHED,
    WATCHED_COUNT,
    WINDOW,
    Z_NEW,
)  # fmt: skip
from ..connections import exchange
from ..members import indicate
from ..memory import into_caller, number, put, put_whole, whole
from .roots import first_changed
from .rounds import settle

BACK = 1e-9  # of a step, by which its beginning may differ from where the group is


@into_caller
def begin(g: int, time: float, length: float) -> int:
    """Take in what was set since the last step; of a step that another member has begun, what is left is done."""
    at = number(g + TIME)
    if whole(g + PENDING) != 0:  # nothing is done but to come to its instant
        return OK if at >= time + length else STOPPED
    if at < time - BACK * length or at > time + length * (1.0 + BACK):
        put_whole(g + CURRENT, 0)
        put_whole(g + CHANGED, 1)
        put(g + TIME, time)
    if number(g + NEXT_STEP) <= 0.0:
        put(g + NEXT_STEP, length)
    if watched_changed(g):
        put_whole(g + CHANGED, 1)
    if whole(g + RESTARTS) != 0:
        put_whole(g + RESTART, 1)
    if whole(g + ENDS_EARLY) == 0 or time + length > number(g + WINDOW):
        put(g + WINDOW, time + length)
        put_whole(g + IN_WINDOW, 0)
    if whole(g + IN_EVENTS) != 0:
        return happens(g)
    if whole(g + CHANGED) == 0:
        return OK
    put_whole(g + CHANGED, 0)
    put_whole(g + CURRENT, 0)
    put_whole(g + RESTART, 1)
    put_whole(g + LOST, 0)
    status = exchange(g)
    if status == OK:
        status = indicate(g, whole(g + Z_NEW))
    if status != OK:
        return status
    crossed = first_changed(g)
    if crossed >= 0:
        note_event(g, crossed)
        return happens(g)
    return OK


@register_jitable
def happens(g: int) -> int:
    """An event at TIME: it is handled, or the step ends there."""
    if whole(g + ENDS_EARLY) == 0:
        return settle(g)
    put_whole(g + PENDING, 1)
    return STOPPED


@into_caller
def watched_changed(g: int) -> bool:
    """Whether an input from outside is not what it was at the last step."""
    changed, watched, seen = False, whole(g + WATCHED), whole(g + SEEN)
    for j in range(0, CELL * whole(g + WATCHED_COUNT), CELL):
        now = whole(whole(watched + j))
        if now != whole(seen + j):
            changed = True
            put_whole(seen + j, now)
    return changed
