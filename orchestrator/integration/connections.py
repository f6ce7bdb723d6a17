"""The connections between the members of a group, solved in each evaluation: in the order of direct dependence."""

from __future__ import annotations

from numba.extending import register_jitable

from ..loop.versions import exchange as set_or_get
from ..loop.versions import good
from .cells import (
    AT,
    CELL,
    COUNT,
    EXCHANGE,
    FAILED,
    FAULT,
    FAULT_INDEX,
    FAULT_MEMBER,
    FAULT_STATUS,
    FAULT_TIME,
    FUNCTION,
    GAINS,
    GIVE,
    IN_GET,
    IN_SET,
    INSTANCE,
    KIND,
    LOOP,
    LOOP_FAILS,
    MEMBER,
    MEMBERS,
    OFFSETS,
    OK,
    REFERENCES,
    RETRY,
    ROW,
    ROW_COUNT,
    ROWS,
    SIZE,
    SOURCES,
    TAKE,
    TIME,
    VERSION,
    WHO,
    V,
)  # fmt: skip
from .memory import call, into_caller, number, put, put_whole, whole
from .stiff.linear import factorize_and_solve

MOST = 25  # iterations of Newton's method
SMALL, NEARLY = 1e-13, 1e-9  # of the largest unknown: what is solved; what still is where rounding stops Newton
NUDGE = 1.5e-8  # of an unknown, by which it is moved for a column of the Jacobian


@register_jitable
def received(g: int, at: int) -> float:
    """What the connection into an input, a cell of V, makes of its source; its own value where nothing drives it."""
    k = at - whole(g + V)
    source = whole(whole(g + SOURCES) + k)
    if source == 0:
        return number(at)
    return number(whole(g + GAINS) + k) * number(source) + number(whole(g + OFFSETS) + k)


@register_jitable
def do_row(g: int, row: int) -> int:
    """Get the outputs, or form and set the inputs, of one row."""
    kind, size, at = whole(row + KIND), whole(row + SIZE), whole(row + AT)
    if kind == GIVE:
        for j in range(size):
            put(at + CELL * j, received(g, at + CELL * j))
    member = whole(g + MEMBERS) + MEMBER * whole(row + WHO)
    status = set_or_get(
        whole(member + VERSION), whole(row + FUNCTION), whole(member + INSTANCE), whole(row + REFERENCES),
        whole(row + COUNT), at, size,
    )  # fmt: skip
    if good(status):
        return OK
    put_whole(g + FAULT, IN_GET if kind == TAKE else IN_SET)
    put_whole(g + FAULT_MEMBER, whole(row + WHO))
    put_whole(g + FAULT_STATUS, status)
    put_whole(g + FAULT_INDEX, -1)
    put(g + FAULT_TIME, number(g + TIME))
    return RETRY if status == 2 else FAILED


@into_caller
def exchange(g: int) -> int:
    """All outputs that are sent between members, and the inputs that they go to, each behind what it needs."""
    return call(whole(g + EXCHANGE), g) if whole(g + ROW_COUNT) > 0 else OK


def exchange_all(g: int) -> int:
    """What EXCHANGE is the address of."""
    first, k, count = whole(g + ROWS), 0, whole(g + ROW_COUNT)
    while k < count:
        row = first + ROW * k
        if whole(row + KIND) == LOOP:
            status = solve(g, row)
            k += whole(row + COUNT)
        else:
            status = do_row(g, row)
        if status != OK:
            return status
        k += 1
    return OK


@register_jitable
def residuals(g: int, row: int, to: int) -> int:
    """With the inputs of a loop as they stand: what the connections make of them, less themselves."""
    for k in range(1, whole(row + COUNT) + 1):
        status = do_row(g, row + ROW * k)
        if status != OK:
            return status
    unknowns, n = whole(row + REFERENCES), whole(row + SIZE)
    for j in range(n):
        at = whole(unknowns + CELL * j)
        put(to + CELL * j, received(g, at) - number(at))
    return OK


@register_jitable
def solve(g: int, row: int) -> int:
    """Newton's method for a loop of direct dependences, from its last solution."""
    unknowns, n, memory = whole(row + REFERENCES), whole(row + SIZE), whole(row + AT)
    now, moved, jacobian = memory, memory + CELL * n, memory + 2 * CELL * n
    for _ in range(MOST):
        status = residuals(g, row, now)
        if status != OK:
            return status
        size, off = 0.0, 0.0
        for j in range(n):
            size = max(size, abs(number(whole(unknowns + CELL * j))))
            off = max(off, abs(number(now + CELL * j)))
        if off <= SMALL * size + 1e-300:
            return OK
        for j in range(n):
            at = whole(unknowns + CELL * j)
            value = number(at)
            nudge = NUDGE * max(abs(value), size, 1e-6)
            put(at, value + nudge)
            nudge = number(at) - value
            status = residuals(g, row, moved)
            put(at, value)
            if status != OK:
                return status
            for i in range(n):
                put(jacobian + CELL * (n * i + j), (number(moved + CELL * i) - number(now + CELL * i)) / nudge)
        for j in range(n):
            put(moved + CELL * j, number(now + CELL * j))
        if not factorize_and_solve(jacobian, moved, n):
            break
        step = 0.0
        for j in range(n):
            at = whole(unknowns + CELL * j)
            put(at, number(at) - number(moved + CELL * j))
            step = max(step, abs(number(moved + CELL * j)))
        if step <= SMALL * size and off <= NEARLY * size:
            return residuals(g, row, now)
    put_whole(g + FAULT, LOOP_FAILS)
    put_whole(g + FAULT_MEMBER, whole(row + WHO))
    put_whole(g + FAULT_STATUS, 0)
    put_whole(g + FAULT_INDEX, -1)
    put(g + FAULT_TIME, number(g + TIME))
    return RETRY
