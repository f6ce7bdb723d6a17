"""The Jacobian of a group by directional derivatives of its members, along their connections.

A seed is a change of the states. It goes through the connections in the order in which they are solved: what an output
changes by follows from the states and inputs of its FMU, what an input changes by from its source, and a loop of direct
dependences is a system of linear equations. Dense: a seed for each state; a band: states whose rows do not meet, at
once. An FMU that a seed does not reach is not called.
"""

from __future__ import annotations

from numba.extending import register_jitable

from ..cells import (
    CELL,
    COUNT,
    CV_BAND,
    CV_COLUMN,
    CV_LOWER,
    CV_UPPER,
    DERIVATIVE_COUNT,
    DERIVATIVES,
    FAILED,
    FIRST_STATE,
    GIVE,
    KIND,
    LOOP,
    MEMBER,
    MEMBER_COUNT,
    MEMBERS,
    OK,
    ROW,
    ROW_COUNT,
    ROWS,
    SEED_OUT,
    SEEDS,
    STATE_COUNT,
    STATES,
    TAKE,
)
from ..members import place
from ..memory import call_whole, number, put, whole
from .cvode import values_of
from .seed_loops import prepare_loops, solve_loop
from .seeds import change_inputs, change_output, derive


def jacobian(time: float, states: int, now: int, matrix: int, g: int, a: int, b: int, c: int) -> int:
    """CVLsJacFn."""
    status = place(g, time, values_of(g, states))
    if status == OK:
        status = prepare_loops(g)
    if status == OK:
        status = fill(g, matrix)
    return status if status < FAILED else -1


@register_jitable
def fill(g: int, matrix: int) -> int:
    """All columns of the matrix; a status of the group."""
    n, lower, upper = whole(g + STATES), whole(g + CV_LOWER), whole(g + CV_UPPER)
    seeds, out, band = whole(g + SEEDS), whole(g + SEED_OUT), whole(g + CV_BAND) != 0
    apart = min(lower + upper + 1, n) if band else n
    for turn in range(apart):
        for j in range(n):
            put(seeds + CELL * j, 1.0 if j % apart == turn else 0.0)
        status = along(g)
        if status != OK:
            return status
        for j in range(turn, n, apart):
            column = call_whole(whole(g + CV_COLUMN), matrix, j)
            if band:  # the address of the element on the diagonal
                for i in range(max(j - upper, 0), min(j + lower + 1, n)):
                    put(column + CELL * (i - j), number(out + CELL * i))
            else:
                for i in range(n):
                    put(column + CELL * i, number(out + CELL * i))
    return OK


@register_jitable
def along(g: int) -> int:
    """By what the derivatives change, in SEED_OUT, where the states change by SEEDS; a status of the group."""
    first, k, count = whole(g + ROWS), 0, whole(g + ROW_COUNT)
    while k < count:
        row = first + ROW * k
        kind, status = whole(row + KIND), OK
        if kind == LOOP:
            status = solve_loop(g, row)
            k += whole(row + COUNT)
        elif kind == TAKE:
            status = change_output(g, row)
        elif kind == GIVE:
            change_inputs(g, row)
        if status != OK:
            return status
        k += 1
    for m in range(whole(g + MEMBER_COUNT)):
        member = whole(g + MEMBERS) + MEMBER * m
        n, out = whole(member + STATE_COUNT), whole(g + SEED_OUT) + whole(member + FIRST_STATE)
        if n > 0:
            status = derive(g, m, whole(member + DERIVATIVES), whole(member + DERIVATIVE_COUNT), out, n)
            if status != OK:
                return status
    return OK
