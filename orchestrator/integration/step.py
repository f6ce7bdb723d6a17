"""A step of a group of FMUs for Model Exchange, as the loop asks for it: with the signature of fmi3DoStep."""

from __future__ import annotations

from numba.extending import register_jitable

from ..loop.calls import byte_at
from .advance import EVENT, REACHED, SWITCH, advance
from .cells import (
    CELL,
    CHATTERS,
    CVODES,
    ENDED,
    ENDING,
    ENDS_EARLY,
    ENTRY,
    EVENTS,
    FAILED,
    FAULT,
    IN_EVENTS,
    IN_WINDOW,
    INFO,
    LOG,
    LOG_COUNT,
    LOG_SIZE,
    METHOD,
    NEXT_EVENT,
    NEXT_WHO,
    NO_STATE_BEFORE,
    NOTHING,
    OK,
    RESTS_IN_EVENTS,
    RETRY,
    STOPPED,
    TIME,
    TIME_EVENT,
    X,
)  # fmt: skip
from .events.inputs import begin, happens
from .events.leaving import read_nominals, read_states
from .events.rounds import CLOSE, enter_events, log, settle, settle_here
from .members import fault, place
from .memory import into_caller, number, put, put_byte, put_whole, whole
from .stiff.cvode import advance_by_cvode

MOST_EVENTS = 1000  # in one step


@into_caller
def take_step(g: int, time: float, length: float, final: int, event: int, ends: int, early: int, last: int) -> int:
    """From `time` over `length` [s]: a status of FMI, and through addresses whether an event is to be handled,
    whether a member asks to end, whether either is before the end, and when."""
    put_byte(event, 0)
    put_byte(ends, 0)
    put_byte(early, 0)
    put_whole(g + ENDED, 0)
    put_whole(g + NO_STATE_BEFORE, final)
    put_whole(g + FAULT, NOTHING)
    end = time + length
    status = begin(g, time, length)
    if status == OK:
        status = to_the_end(g, end)
    if status == OK and whole(g + RESTS_IN_EVENTS) != 0:
        status = enter_events(g)
    put(last, number(g + TIME))
    if status in (OK, ENDING, STOPPED):
        put_whole(g + FAULT, NOTHING)  # what was wrong in a trial is not, in a smaller step
    if status == STOPPED:
        put_byte(event, 1)
        put_byte(early, 1 if number(g + TIME) < end else 0)
        return 0
    if status == ENDING:
        put_byte(ends, 1)
        put_whole(g + ENDED, 1)
        put_byte(early, 1 if number(g + TIME) < end else 0)
        return 0
    return 0 if status == OK else 3


@into_caller
def to_the_end(g: int, end: float) -> int:
    """From event to event until an instant; a time event on it is done, or left to whoever handles events."""
    close = CLOSE * abs(end)
    while number(g + TIME) < end:
        due = number(g + NEXT_EVENT)
        target = min(end, due) if due < end - close else end
        how = REACHED
        if target > number(g + TIME):
            how = advance_by_cvode(g, target) if whole(g + METHOD) == CVODES else advance(g, target)
        if how < REACHED:
            return FAILED if how == RETRY else how
        if how == SWITCH:
            continue
        if how == REACHED and due <= number(g + TIME) + close and not (target == end and whole(g + ENDS_EARLY) != 0):
            if due > number(g + TIME) and place(g, due, whole(g + X)) != OK:  # by rounding
                return FAILED
            log(g, whole(g + NEXT_WHO), TIME_EVENT)
            how = EVENT
        if how == EVENT:
            status = one_more(g)
            if status == OK:
                status = happens(g)
            if status != OK:
                return status
    return OK


@register_jitable
def one_more(g: int) -> int:
    """Count an event; too many before the end of a step are chattering."""
    put_whole(g + EVENTS, whole(g + EVENTS) + 1)
    put_whole(g + IN_WINDOW, whole(g + IN_WINDOW) + 1)
    if whole(g + IN_WINDOW) <= MOST_EVENTS:
        return OK
    entry = whole(g + LOG) + ENTRY * ((whole(g + LOG_COUNT) - 1) % whole(g + LOG_SIZE))
    fault(g, CHATTERS, whole(entry + CELL), 0, whole(entry + 2 * CELL))
    return FAILED


def step(g: int, time: float, length: float, final: int, event: int, ends: int, early: int, last: int) -> int:
    """fmi3DoStep of the group."""
    return take_step(g, time, length, final, event, ends, early, last)


def step2(g: int, time: float, length: float, final: int) -> int:
    """fmi2DoStep of the group: it discards the step in which a member asks to end, and ENDED says so, or in which an
    event is to be handled, which is PENDING then."""
    flags = whole(g + INFO)
    status = take_step(g, time, length, final, flags, flags + 1, flags + 2, flags + CELL)
    discarded = whole(g + ENDED) != 0 or byte_at(flags) != 0
    return 2 if status == 0 and discarded else status


def start(g: int) -> int:
    """Behind initialization mode: the first event of all members, and their states, as a status of FMI."""
    put_whole(g + FAULT, NOTHING)
    put_whole(g + IN_EVENTS, 1)
    status = read_nominals(g)
    if status == OK and whole(g + ENDS_EARLY) != 0:
        status = settle_here(g)  # and all members stay in event mode
    elif status == OK:
        status = settle(g)
    if status == OK:
        status = read_states(g)
    if status == OK and whole(g + RESTS_IN_EVENTS) != 0:
        status = enter_events(g)
    if status == ENDING:
        return 2
    return 0 if status == OK else 3
