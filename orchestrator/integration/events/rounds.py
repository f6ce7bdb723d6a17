"""Events: all members go to event mode, are asked until none needs another round, and go on."""

from __future__ import annotations

from numba.extending import register_jitable

from ...loop.calls import byte_at
from ...loop.versions import good
from ..cells import (
    ASKED,
    CELL,
    ENDING,
    ENTER_EVENTS,
    ENTRY,
    FAILED,
    FAULT_MEMBER,
    FIRST_FMI,
    IN_EVENT_MODE,
    IN_EVENTS,
    IN_UPDATE,
    INFO,
    INSTANCE,
    LOG,
    LOG_COUNT,
    LOG_SIZE,
    MEMBER,
    MEMBER_COUNT,
    MEMBERS,
    MOVED,
    NEXT_EVENT,
    NEXT_WHO,
    OK,
    SETTLE,
    TIME,
    UNSETTLED,
    UPDATE,
    V_OLD,
    VALUES,
    VERSION,
    V,
)  # fmt: skip
from ..connections import exchange
from ..members import fault, refused
from ..memory import call, half, number, put, put_whole, whole
from .discrete import send
from .leaving import NEW_NOMINALS, NEW_STATES, leave_events
from .roots import EPSILON

MOST = 100  # rounds of an event
NEVER = 1e300  # s
SAME = 1e-13  # of a value, by which it may change without another round
CLOSE = 4.0 * EPSILON  # of a time, by which another one is the same
AGAIN, ENDS, NOMINALS_MOVED, STATES_MOVED, TIMED = range(5)  # what a member answers, in the order of both versions


@register_jitable
def log(g: int, member: int, indicator: int) -> None:
    """Note an event at TIME: whose, and because of what; the last ones are kept."""
    entry = whole(g + LOG) + ENTRY * (whole(g + LOG_COUNT) % whole(g + LOG_SIZE))
    put(entry, number(g + TIME))
    put_whole(entry + CELL, member)
    put_whole(entry + 2 * CELL, indicator)
    put_whole(g + LOG_COUNT, whole(g + LOG_COUNT) + 1)


@register_jitable
def enter_events(g: int) -> int:
    """All members into event mode, if they are not there."""
    if whole(g + IN_EVENTS) != 0:
        return OK
    put_whole(g + MOVED, 0)
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        if whole(row + FIRST_FMI) != 0:  # which has no modes
            continue
        status = call(whole(row + ENTER_EVENTS), whole(row + INSTANCE))
        if not good(status):
            return refused(g, IN_EVENT_MODE, m, status)
    put_whole(g + IN_EVENTS, 1)
    return OK


@register_jitable
def told(row: int, info: int, what: int) -> bool:
    """One of the answers of the last update: FMI 2.0 writes ints, FMI 1.0 and 3.0 bytes, in FMI 1.0 whether it is done,
    which states are others, their values, whether it ends, and whether a time event is to come."""
    if whole(row + FIRST_FMI) != 0:
        if what == AGAIN:
            return byte_at(info) == 0
        if what == STATES_MOVED and byte_at(info + 2) != 0:
            return True
        return byte_at(info + (4 if what == TIMED else 3 if what == ENDS else 1)) != 0
    if whole(row + VERSION) == 2:
        return half(info + 4 * what) != 0
    return byte_at(info + what) != 0


@register_jitable
def update(row: int, info: int) -> int:
    """One round of a member's event; its status."""
    for j in range(4):
        put_whole(info + CELL * j, 0)
    if whole(row + FIRST_FMI) != 0:
        return call(whole(row + UPDATE), whole(row + INSTANCE), 0, info)
    if whole(row + VERSION) == 2:
        return call(whole(row + UPDATE), whole(row + INSTANCE), info)
    return call(
        whole(row + UPDATE), whole(row + INSTANCE), info, info + 1, info + 2, info + 3, info + 4, info + 3 * CELL
    )


@register_jitable
def moved(g: int) -> bool:
    """Whether what is sent between members is not what it was at the last look."""
    now, old, found = whole(g + V), whole(g + V_OLD), False
    for j in range(0, CELL * whole(g + VALUES), CELL):
        a, b = number(now + j), number(old + j)
        if abs(a - b) > SAME * max(abs(a), abs(b)):
            found = True
        put(old + j, a)
    return found


@register_jitable
def pass_on(g: int) -> int:
    """What is sent between members, once: 1 if any of it is new, 0 if not; below 0: a status, negative and less one."""
    sent = send(g)
    if sent < 0:
        return sent
    status = exchange(g)
    if status != OK:
        return -1 - status
    return 1 if moved(g) or sent > 0 else 0


@register_jitable
def update_all(g: int) -> int:
    """One update of all members: 1 if one asks for another round, 0 if none does; below 0 as of `pass_on`."""
    info, again, next_event = whole(g + INFO), 0, NEVER
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        status = update(row, info)
        if not good(status):
            return -1 - refused(g, IN_UPDATE, m, status)
        if told(row, info, ENDS):
            put_whole(g + FAULT_MEMBER, m)
            return -1 - ENDING
        if told(row, info, AGAIN):
            again = 1
            put_whole(g + ASKED, m)
        if told(row, info, STATES_MOVED):
            put_whole(g + MOVED, whole(g + MOVED) | NEW_STATES)
        if told(row, info, NOMINALS_MOVED):
            put_whole(g + MOVED, whole(g + MOVED) | NEW_NOMINALS)
        due = number(info + (CELL if whole(row + FIRST_FMI) != 0 else 3 * CELL))
        if told(row, info, TIMED) and due < next_event:
            next_event = due
            put_whole(g + NEXT_WHO, m)
    put(g + NEXT_EVENT, next_event)
    return again


@register_jitable
def settle(g: int) -> int:
    """The event at TIME, over all members, until none asks for another round and nothing sent changes any more."""
    return call(whole(g + SETTLE), g)


def settle_all(g: int) -> int:
    """What SETTLE is the address of."""
    status = settle_here(g)
    return leave_events(g) if status == OK else status


@register_jitable
def settle_here(g: int) -> int:
    """All rounds of an event, which goes on."""
    status = enter_events(g)
    if status != OK:
        return status
    again = 1
    moved(g)
    for turn in range(MOST + 1):
        new = pass_on(g)
        if new < 0:
            return -1 - new
        if turn > 0 and again == 0 and new == 0:
            return OK
        if turn == MOST:
            break
        again = update_all(g)
        if again < 0:
            return -1 - again
    fault(g, UNSETTLED, whole(g + ASKED), 0, -1)
    return FAILED
