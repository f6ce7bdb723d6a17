"""The functions of the members of a group, called by address: FMI 2.0 and 3.0 alike."""

from __future__ import annotations

from math import isfinite

from numba.extending import register_jitable

from ..loop.calls import byte_at
from ..loop.versions import exchange as set_or_get
from ..loop.versions import good
from .cells import (
    CELL,
    COMPLETED,
    CROSS_GET,
    CROSS_LIMIT,
    CROSS_REFERENCE,
    CROSS_RISES,
    CROSS_ROOM,
    CROSS_WHO,
    CROSSING,
    CROSSING_COUNT,
    CROSSINGS,
    ENDING,
    EVALUATE,
    EVALUATIONS,
    FAILED,
    FAULT,
    FAULT_INDEX,
    FAULT_MEMBER,
    FAULT_STATUS,
    FAULT_TIME,
    FIRST_FMI,
    FIRST_INDICATOR,
    FIRST_STATE,
    GET_DERIVATIVES,
    GET_INDICATORS,
    IN_COMPLETED,
    IN_DERIVATIVES,
    IN_GET,
    IN_INDICATORS,
    IN_STATES,
    IN_TIME,
    INDICATE,
    INDICATOR_COUNT,
    INDICATORS,
    INFO,
    INSTANCE,
    MEMBER,
    MEMBER_COUNT,
    MEMBERS,
    NO_INDICATOR,
    NO_STATE_BEFORE,
    NOT_FINITE,
    OK,
    RETRY,
    SET_STATES,
    SET_TIME,
    STATE_COUNT,
    STATES,
    TIME,
    VERSION,
)  # fmt: skip
from .connections import exchange
from .memory import call, half, into_caller, number, put, put_whole, whole

DISCARD = 2


@register_jitable
def fault(g: int, what: int, member: int, status: int, index: int) -> None:
    """Note what is wrong: in which call, whose, its status, which derivative or indicator."""
    put_whole(g + FAULT, what)
    put_whole(g + FAULT_MEMBER, member)
    put_whole(g + FAULT_STATUS, status)
    put_whole(g + FAULT_INDEX, index)
    put(g + FAULT_TIME, number(g + TIME))


@register_jitable
def refused(g: int, what: int, member: int, status: int) -> int:
    """What a bad status of a member means: Discard may go with a smaller step."""
    fault(g, what, member, status, -1)
    return RETRY if status == DISCARD else FAILED


@into_caller
def place(g: int, time: float, states: int) -> int:
    """Put all members at a time [s] and to states, and solve their connections."""
    count = whole(g + MEMBER_COUNT)
    for m in range(count):
        row = whole(g + MEMBERS) + MEMBER * m
        status = call(whole(row + SET_TIME), whole(row + INSTANCE), time)
        if not good(status):
            return refused(g, IN_TIME, m, status)
        n = whole(row + STATE_COUNT)
        if n > 0:
            status = call(whole(row + SET_STATES), whole(row + INSTANCE), states + whole(row + FIRST_STATE), n)
            if not good(status):
                return refused(g, IN_STATES, m, status)
    return exchange(g)


@into_caller
def evaluate(g: int, time: float, states: int, derivatives: int) -> int:
    """The right-hand side: all members placed, their derivatives to an address; RETRY where one is not finite."""
    return call(whole(g + EVALUATE), g, time, states, derivatives)


def evaluate_all(g: int, time: float, states: int, derivatives: int) -> int:
    """What EVALUATE is the address of."""
    return evaluate_here(g, time, states, derivatives)


@into_caller
def evaluate_here(g: int, time: float, states: int, derivatives: int) -> int:
    """The same as a part of its caller."""
    status = place(g, time, states)
    if status != OK:
        return status
    put_whole(g + EVALUATIONS, whole(g + EVALUATIONS) + 1)
    count = whole(g + MEMBER_COUNT)
    for m in range(count):
        row = whole(g + MEMBERS) + MEMBER * m
        n = whole(row + STATE_COUNT)
        if n > 0:
            first = derivatives + whole(row + FIRST_STATE)
            status = call(whole(row + GET_DERIVATIVES), whole(row + INSTANCE), first, n)
            if not good(status):
                return refused(g, IN_DERIVATIVES, m, status)
            for j in range(n):
                if not isfinite(number(first + CELL * j)):
                    fault(g, NOT_FINITE, m, 0, j)
                    return RETRY
    if whole(g + STATES) == 0:
        put(derivatives, 0.0)  # of the one that stands for none
    return OK


@into_caller
def indicate(g: int, indicators: int) -> int:
    """The event indicators of all members where they are placed, to an address."""
    return call(whole(g + INDICATE), g, indicators) if whole(g + INDICATORS) > 0 else OK


def indicate_all(g: int, indicators: int) -> int:
    """What INDICATE is the address of."""
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        n = whole(row + INDICATOR_COUNT)
        if n > 0:
            status = call(
                whole(row + GET_INDICATORS), whole(row + INSTANCE), indicators + whole(row + FIRST_INDICATOR), n
            )
            if not good(status):
                return refused(g, IN_INDICATORS, m, status)
            for j in range(n):
                z = number(indicators + whole(row + FIRST_INDICATOR) + CELL * j)
                if z != z:
                    fault(g, NO_INDICATOR, m, 0, j)
                    return RETRY
    return crossings(g, indicators) if whole(g + CROSSING_COUNT) > 0 else OK


@register_jitable
def crossings(g: int, indicators: int) -> int:
    """How far watched signals are beyond their values, behind the indicators of all members."""
    count = whole(g + CROSSING_COUNT)
    at = indicators + CELL * (whole(g + INDICATORS) - count)
    for k in range(count):
        row = whole(g + CROSSINGS) + CROSSING * k
        member = whole(g + MEMBERS) + MEMBER * whole(row + CROSS_WHO)
        status = set_or_get(
            whole(member + VERSION), whole(row + CROSS_GET), whole(member + INSTANCE), row + CROSS_REFERENCE, 1,
            row + CROSS_ROOM, 1,
        )  # fmt: skip
        if not good(status):
            return refused(g, IN_GET, whole(row + CROSS_WHO), status)
        beyond = number(row + CROSS_ROOM) - number(whole(row + CROSS_LIMIT))
        if whole(row + CROSS_RISES) == 0:
            beyond = -beyond
        put(at + CELL * k, beyond if isfinite(beyond) else -1.0)  # infinite: it is not watched any more
    return OK


@into_caller
def completed(g: int) -> int:
    """Tell the members that want it that a step of the solver is accepted: a status, -1 - m where member m is the
    first to ask for an event, ENDING where one asks to end, whom FAULT_MEMBER names."""
    info, said = whole(g + INFO), OK
    for m in range(whole(g + MEMBER_COUNT)):
        row = whole(g + MEMBERS) + MEMBER * m
        if whole(row + COMPLETED) != 0:
            put_whole(info, 0)
            if whole(row + FIRST_FMI) != 0:
                status = call(whole(row + COMPLETED), whole(row + INSTANCE), info)
            else:
                status = call(
                    whole(row + COMPLETED), whole(row + INSTANCE), whole(g + NO_STATE_BEFORE), info, info + CELL // 2
                )
            if not good(status):
                return refused(g, IN_COMPLETED, m, status)
            wide = whole(row + VERSION) == 2 and whole(row + FIRST_FMI) == 0  # an int, in FMI 2.0 alone
            event = half(info) if wide else byte_at(info)
            ends = half(info + CELL // 2) if wide else byte_at(info + CELL // 2)
            if ends != 0 and said != ENDING:
                put_whole(g + FAULT_MEMBER, m)
                said = ENDING
            if event != 0 and said == OK:
                said = -1 - m
    return said
