"""The end of an event: members go on from the states that they have then."""

from __future__ import annotations

from math import isfinite

from numba.extending import register_jitable

from ...loop.versions import good
from ..cells import (
    ABSOLUTE,
    CELL,
    CHANGED,
    CURRENT,
    ENTER_CONTINUOUS,
    FIRST_FMI,
    FIRST_STATE,
    GET_NOMINALS,
    GET_STATES,
    IN_CONTINUOUS,
    IN_EVENTS,
    IN_GET_STATES,
    IN_NOMINALS,
    INSTANCE,
    LOST,
    MEMBER,
    MEMBER_COUNT,
    MEMBERS,
    MOVED,
    NOMINAL,
    OK,
    RELATIVE,
    RESTART,
    STATE_COUNT,
    X,
    Z,
)  # fmt: skip
from ..members import indicate, refused
from ..memory import call, number, put, put_whole, whole

NEW_STATES, NEW_NOMINALS = 1, 2  # bits of MOVED
STATE_SHARE = 0.01  # of relative tolerance and nominal: the absolute tolerance, as FMI advises


@register_jitable
def leave_events(g: int) -> int:
    """All members into continuous-time mode, with the states that they have now; the solver begins anew."""
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        if whole(row + FIRST_FMI) != 0:  # which has no modes
            continue
        status = call(whole(row + ENTER_CONTINUOUS), whole(row + INSTANCE))
        if not good(status):
            return refused(g, IN_CONTINUOUS, m, status)
    put_whole(g + IN_EVENTS, 0)
    put_whole(g + CURRENT, 0)
    put_whole(g + CHANGED, 0)
    put_whole(g + RESTART, 1)
    put_whole(g + LOST, 0)
    status = OK
    if whole(g + MOVED) & NEW_STATES:
        status = read_states(g)
    if status == OK and whole(g + MOVED) & NEW_NOMINALS:
        status = read_nominals(g)
    if status == OK:
        status = indicate(g, whole(g + Z))
    return status


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
                if not (size > 0.0 and isfinite(size)):
                    size = 1.0
                put(absolute + j, STATE_SHARE * number(g + RELATIVE) * size)
    return OK
