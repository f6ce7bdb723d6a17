"""Events: all members go to event mode, are asked until none needs another round, and go on."""

from __future__ import annotations

from numba.extending import register_jitable

from ..loop.calls import byte_at
from ..loop.versions import good
from .cells import (
    ABSOLUTE,
    CELL,
    CHANGED,
    CURRENT,
    ENDING,
    ENTER_CONTINUOUS,
    ENTER_EVENTS,
    ENTRY,
    FAILED,
    FAULT_MEMBER,
    FIRST_STATE,
    GET_NOMINALS,
    GET_STATES,
    IN_CONTINUOUS,
    IN_EVENT_MODE,
    IN_EVENTS,
    IN_GET_STATES,
    IN_NOMINALS,
    IN_UPDATE,
    INFO,
    INSTANCE,
    LOG,
    LOG_COUNT,
    LOG_SIZE,
    LOST,
    MEMBER,
    MEMBER_COUNT,
    MEMBERS,
    NEXT_EVENT,
    NEXT_WHO,
    NOMINAL,
    OK,
    RELATIVE,
    RESTART,
    SETTLE,
    STATE_COUNT,
    TIME,
    UNSETTLED,
    UPDATE,
    V_OLD,
    VALUES,
    VERSION,
    V,
    X,
    Z,
)  # fmt: skip
from .connections import exchange
from .discrete import send
from .members import fault, indicate, refused
from .memory import call, half, number, put, put_whole, whole

MOST = 100  # rounds of an event
NEVER = 1e300  # s
SAME = 1e-13  # of a value, by which it may change without another round
AGAIN, ENDS, NOMINALS_MOVED, STATES_MOVED, TIMED = range(5)  # what a member answers, in the order of both versions
STATE_SHARE = 0.01  # of relative tolerance and nominal: the absolute tolerance, as FMI advises


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
    """All members into event mode."""
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        status = call(whole(row + ENTER_EVENTS), whole(row + INSTANCE))
        if not good(status):
            return refused(g, IN_EVENT_MODE, m, status)
    put_whole(g + IN_EVENTS, 1)
    return OK


@register_jitable
def told(row: int, info: int, what: int) -> bool:
    """One of the answers of the last update: FMI 2.0 writes ints, FMI 3.0 bytes."""
    if whole(row + VERSION) == 2:
        return half(info + 4 * what) != 0
    return byte_at(info + what) != 0


@register_jitable
def update(row: int, info: int) -> int:
    """One round of a member's event; its status."""
    for j in range(4):
        put_whole(info + CELL * j, 0)
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
def settle(g: int) -> int:
    """The event at TIME, over all members, until none asks for another round and nothing sent changes any more."""
    return call(whole(g + SETTLE), g)


def settle_all(g: int) -> int:
    """What SETTLE is the address of."""
    if whole(g + IN_EVENTS) == 0:
        status = enter_events(g)
        if status != OK:
            return status
    info, again, states_moved, nominals_moved, last = whole(g + INFO), True, False, False, 0
    next_event = NEVER
    moved(g)
    for turn in range(MOST + 1):
        sent = send(g)
        if sent < 0:
            return -1 - sent
        status = exchange(g)
        if status != OK:
            return status
        changed = moved(g)
        if turn > 0 and not again and not changed and sent == 0:
            break
        if turn == MOST:
            fault(g, UNSETTLED, last, 0, -1)
            return FAILED
        again, next_event = False, NEVER
        for m in range(whole(g + MEMBER_COUNT)):
            row = whole(g + MEMBERS) + MEMBER * m
            status = update(row, info)
            if not good(status):
                return refused(g, IN_UPDATE, m, status)
            if told(row, info, ENDS):
                put_whole(g + FAULT_MEMBER, m)
                return ENDING
            if told(row, info, AGAIN):
                again, last = True, m
            states_moved = states_moved or told(row, info, STATES_MOVED)
            nominals_moved = nominals_moved or told(row, info, NOMINALS_MOVED)
            if told(row, info, TIMED) and number(info + 3 * CELL) < next_event:
                next_event = number(info + 3 * CELL)
                put_whole(g + NEXT_WHO, m)
    put(g + NEXT_EVENT, next_event)
    status = go_on(g)
    if status == OK and states_moved:
        status = read_states(g)
    if status == OK and nominals_moved:
        status = read_nominals(g)
    if status == OK:
        status = indicate(g, whole(g + Z))
    return status


@register_jitable
def go_on(g: int) -> int:
    """All members into continuous-time mode; the solver begins anew."""
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        status = call(whole(row + ENTER_CONTINUOUS), whole(row + INSTANCE))
        if not good(status):
            return refused(g, IN_CONTINUOUS, m, status)
    put_whole(g + IN_EVENTS, 0)
    put_whole(g + CURRENT, 0)
    put_whole(g + CHANGED, 0)
    put_whole(g + RESTART, 1)
    put_whole(g + LOST, 0)
    return OK


@register_jitable
def read_states(g: int) -> int:
    """The states as the members have them."""
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        n = whole(row + STATE_COUNT)
        if n > 0:
            status = call(whole(row + GET_STATES), whole(row + INSTANCE), whole(g + X) + whole(row + FIRST_STATE), n)
            if not good(status):
                return refused(g, IN_GET_STATES, m, status)
    return OK


@register_jitable
def read_nominals(g: int) -> int:
    """The nominal values of the states, and the absolute tolerances that follow."""
    nominal, absolute = whole(g + NOMINAL), whole(g + ABSOLUTE)
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        n, first = whole(row + STATE_COUNT), whole(row + FIRST_STATE)
        if n > 0:
            status = call(whole(row + GET_NOMINALS), whole(row + INSTANCE), nominal + first, n)
            if not good(status):
                return refused(g, IN_NOMINALS, m, status)
            for j in range(first, first + CELL * n, CELL):
                size = abs(number(nominal + j))
                put(absolute + j, STATE_SHARE * number(g + RELATIVE) * (size if size > 0.0 else 1.0))
    return OK
