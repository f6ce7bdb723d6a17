"""A step of a group of FMUs for Model Exchange, as the loop asks for it: with the signature of fmi3DoStep."""

from __future__ import annotations

from numba.extending import register_jitable

from .advance import EVENT, REACHED, SWITCH, advance, note_event
from .cells import (
    ARRAYS,
    ARRAYS_SIZE,
    CELL,
    CHANGED,
    CHATTERS,
    CURRENT,
    CVODES,
    ENDED,
    ENDING,
    ENTRY,
    EVENTS,
    FAILED,
    FAULT,
    FREE,
    IN_EVENTS,
    INFO,
    KEPT,
    LOG,
    LOG_COUNT,
    LOG_SIZE,
    LOST,
    MALLOC,
    METHOD,
    NEXT_EVENT,
    NEXT_STEP,
    NEXT_WHO,
    NO_STATE_BEFORE,
    NOTHING,
    OK,
    OWN_FORGET,
    OWN_INSTANCE,
    OWN_RESTORE,
    OWN_SAVE,
    RESTART,
    RESTARTS,
    RESTS_IN_EVENTS,
    RETRY,
    SEEN,
    TIME,
    TIME_EVENT,
    WATCHED,
    WATCHED_COUNT,
    Z_NEW,
    X,
)  # fmt: skip
from .connections import exchange
from .events import enter_events, log, read_nominals, read_states, settle
from .members import fault, indicate, place
from .memory import call, call_whole, into_caller, number, put, put_byte, put_whole, whole
from .roots import EPSILON, first_changed
from .stiff.cvode import advance_by_cvode

MOST_EVENTS = 1000  # in one step
BACK = 1e-9  # of a step, by which its beginning may differ from where the group is


@into_caller
def take_step(g: int, time: float, length: float, final: int, event: int, ends: int, early: int, last: int) -> int:
    """From `time` over `length` [s]: a status of FMI, and through addresses whether a member asks to end, and when."""
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
    if status == ENDING:
        put_byte(ends, 1)
        put_whole(g + ENDED, 1)
        put_byte(early, 1 if number(g + TIME) < end else 0)
        return 0
    return 0 if status == OK else 3


@into_caller
def begin(g: int, time: float, length: float) -> int:
    """Take in what was set since the last step; of a step that another member has begun, what is left is done."""
    at = number(g + TIME)
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
    if whole(g + IN_EVENTS) != 0:
        return settle(g)
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
        return settle(g)
    return OK


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


@into_caller
def to_the_end(g: int, end: float) -> int:
    """From event to event until an instant; a time event on it is done."""
    events = 0
    while True:
        time = number(g + TIME)
        due = number(g + NEXT_EVENT)
        close = 4.0 * EPSILON * abs(end)
        target = min(end, due) if due < end - close else end
        how = REACHED
        if target > time:
            how = advance_by_cvode(g, target) if whole(g + METHOD) == CVODES else advance(g, target)
        if how < REACHED:
            return FAILED if how == RETRY else how
        if how == SWITCH:
            continue
        time = number(g + TIME)
        if how == REACHED and due <= time + close:
            if due > time and place(g, due, whole(g + X)) != OK:  # by rounding
                return FAILED
            log(g, whole(g + NEXT_WHO), TIME_EVENT)
            how = EVENT
        if how == EVENT:
            events += 1
            put_whole(g + EVENTS, whole(g + EVENTS) + 1)
            if events > MOST_EVENTS:
                entry = whole(g + LOG) + ENTRY * ((whole(g + LOG_COUNT) - 1) % whole(g + LOG_SIZE))
                fault(g, CHATTERS, whole(entry + CELL), 0, whole(entry + 2 * CELL))
                return FAILED
            status = settle(g)
            if status != OK:
                return status
        if number(g + TIME) >= end:
            return OK


def step(g: int, time: float, length: float, final: int, event: int, ends: int, early: int, last: int) -> int:
    """fmi3DoStep of the group."""
    return take_step(g, time, length, final, event, ends, early, last)


def step2(g: int, time: float, length: float, final: int) -> int:
    """fmi2DoStep of the group: it discards the step in which a member asks to end, and ENDED says so."""
    flags = whole(g + INFO)
    status = take_step(g, time, length, final, flags, flags + 1, flags + 2, flags + CELL)
    return 2 if status == 0 and whole(g + ENDED) != 0 else status


def save(g: int, state: int) -> int:
    """fmi2GetFMUstate of the first member, and what the group keeps beside its members: in memory of its own."""
    at = whole(state)
    if at == 0:
        at = call_whole(whole(g + MALLOC), CELL + CELL * KEPT + whole(g + ARRAYS_SIZE))
        if at == 0:
            return 3
        put_whole(at, 0)
        put_whole(state, at)
    status = call(whole(g + OWN_SAVE), whole(g + OWN_INSTANCE), at)
    if whole(g + METHOD) == CVODES and whole(g + RESTART) == 0 and whole(g + RESTARTS) == 0:
        put_whole(g + LOST, 1)
    put_whole(g + RESTART, 1)  # whoever goes on from here later has no history of the solver
    copy(g, at + CELL, CELL * KEPT)
    copy(whole(g + ARRAYS), at + CELL + CELL * KEPT, whole(g + ARRAYS_SIZE))
    return status


def restore(g: int, state: int) -> int:
    """fmi2SetFMUstate of the first member and of the group."""
    copy(state + CELL, g, CELL * KEPT)
    copy(state + CELL + CELL * KEPT, whole(g + ARRAYS), whole(g + ARRAYS_SIZE))
    return call(whole(g + OWN_RESTORE), whole(g + OWN_INSTANCE), whole(state))


def forget(g: int, state: int) -> int:
    """fmi2FreeFMUstate of both."""
    at = whole(state)
    if at == 0:
        return 0
    status = 0
    if whole(at) != 0:
        status = call(whole(g + OWN_FORGET), whole(g + OWN_INSTANCE), at)
    call(whole(g + FREE), at)
    put_whole(state, 0)
    return status


@register_jitable
def copy(source: int, target: int, size: int) -> None:
    for j in range(0, size, CELL):
        put_whole(target + j, whole(source + j))


def start(g: int) -> int:
    """Behind initialization mode: the first event of all members, and their states, as a status of FMI."""
    put_whole(g + FAULT, NOTHING)
    put_whole(g + IN_EVENTS, 1)
    status = read_nominals(g)
    if status == OK:
        status = settle(g)
    if status == OK:
        status = read_states(g)
    if status == OK and whole(g + RESTS_IN_EVENTS) != 0:
        status = enter_events(g)
    if status == ENDING:
        return 2
    return 0 if status == OK else 3
