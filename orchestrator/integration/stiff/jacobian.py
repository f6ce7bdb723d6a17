"""The Jacobian of a group by directional derivatives of its members, along their connections.

A seed is a change of the states. It goes through the connections in the order in which they are solved: what an output
changes by follows from the states and inputs of its FMU, what an input changes by from its source, and a loop of direct
dependences is a system of linear equations. Dense: a seed for each state; a band: states whose rows do not meet, at
once. An FMU that a seed does not reach is not called.
"""

from __future__ import annotations

from numba.extending import register_jitable

from ...loop.versions import good
from ..cells import (
    AT,
    CELL,
    COUNT,
    CV_BAND,
    CV_COLUMN,
    CV_LOWER,
    CV_POINTER,
    CV_UPPER,
    DERIVATIVE_COUNT,
    DERIVATIVES,
    DIRECTIONAL,
    DIRECTIONALS,
    FAILED,
    FIRST_STATE,
    GAINS,
    GIVE,
    IN_DIRECTIONAL,
    INSTANCE,
    KIND,
    KNOWN,
    KNOWN_COUNT,
    KNOWN_INPUTS,
    KNOWN_SEEDS,
    KNOWN_SIZE,
    LOOP,
    LOOP_FAILS,
    MEMBER,
    MEMBER_COUNT,
    MEMBERS,
    OK,
    REFERENCES,
    ROW,
    ROW_COUNT,
    ROWS,
    SEED_OUT,
    SEEDS,
    SIZE,
    SOURCES,
    STATE,
    STATE_COUNT,
    STATES,
    TAKE,
    V_SEEDS,
    VALUES,
    VERSION,
    WHO,
    V,
)
from ..members import fault, place, refused
from ..memory import call, call_whole, number, put, put_whole, whole
from .linear import factorize_and_solve


def jacobian(time: float, states: int, now: int, matrix: int, g: int, a: int, b: int, c: int) -> int:
    """CVLsJacFn."""
    status = place(g, time, call_whole(whole(g + CV_POINTER), states))
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


@register_jitable
def seed_of(g: int, at: int) -> int:
    """Where the change of a cell of V is."""
    return whole(g + V_SEEDS) + at - whole(g + V)


@register_jitable
def received(g: int, at: int) -> float:
    """By what an input changes, a cell of V, as its source does; 0 where nothing drives it."""
    k = at - whole(g + V)
    source = whole(whole(g + SOURCES) + k)
    return number(whole(g + GAINS) + k) * number(seed_of(g, source)) if source != 0 else 0.0


@register_jitable
def change_inputs(g: int, row: int) -> None:
    """By what the inputs of a row change."""
    at = whole(row + AT)
    for j in range(0, CELL * whole(row + SIZE), CELL):
        put(seed_of(g, at + j), received(g, at + j))


@register_jitable
def change_output(g: int, row: int) -> int:
    """By what the outputs of a row change; a status of the group."""
    out, size, state = seed_of(g, whole(row + AT)), whole(row + SIZE), whole(row + STATE)
    if state >= 0:
        for j in range(0, CELL * size, CELL):
            put(out + j, number(whole(g + SEEDS) + state + j))
        return OK
    return derive(g, whole(row + WHO), whole(row + REFERENCES), whole(row + COUNT), out, size)


@register_jitable
def derive(g: int, m: int, unknown: int, count: int, out: int, size: int) -> int:
    """By what so many variables of a member change, of so many values; a status of the group."""
    member = whole(g + MEMBERS) + MEMBER * m
    states, given, moves = whole(g + SEEDS) + whole(member + FIRST_STATE), whole(member + KNOWN_SEEDS), False
    n, known = whole(member + STATE_COUNT), whole(member + KNOWN_SIZE)
    for j in range(known):
        change = number(states + CELL * j) if j < n else number(whole(whole(member + KNOWN_INPUTS) + CELL * (j - n)))
        put(given + CELL * j, change)
        moves = moves or change != 0.0
    if not moves:
        for j in range(size):
            put(out + CELL * j, 0.0)
        return OK
    put_whole(g + DIRECTIONALS, whole(g + DIRECTIONALS) + 1)
    function, instance = whole(member + DIRECTIONAL), whole(member + INSTANCE)
    references, variables = whole(member + KNOWN), whole(member + KNOWN_COUNT)
    if whole(member + VERSION) == 2:
        status = call(function, instance, unknown, count, references, variables, given, out)
    else:
        status = call(function, instance, unknown, count, references, variables, given, known, out, size)
    return OK if good(status) else refused(g, IN_DIRECTIONAL, m, status)


@register_jitable
def inside(g: int, row: int) -> int:
    """By what the outputs in a loop change, with its inputs changed as they are; a status of the group."""
    for k in range(1, whole(row + COUNT) + 1):
        if whole(row + ROW * k + KIND) == TAKE:
            status = change_output(g, row + ROW * k)
            if status != OK:
                return status
    return OK


@register_jitable
def matrix_of(row: int) -> int:
    """Where the matrix of a loop is: behind the memory of Newton's method."""
    n = whole(row + SIZE)
    return whole(row + AT) + CELL * n * (n + 2)


@register_jitable
def prepare_loops(g: int) -> int:
    """The matrices of all loops: of each input less what the loop makes of it; a status of the group."""
    for j in range(0, CELL * whole(g + STATES), CELL):
        put(whole(g + SEEDS) + j, 0.0)
    k, count = 0, whole(g + ROW_COUNT)
    while k < count:
        row = whole(g + ROWS) + ROW * k
        if whole(row + KIND) == LOOP:
            for j in range(0, CELL * whole(g + VALUES), CELL):
                put(whole(g + V_SEEDS) + j, 0.0)
            unknowns, n, matrix = whole(row + REFERENCES), whole(row + SIZE), matrix_of(row)
            for j in range(n):
                seed = seed_of(g, whole(unknowns + CELL * j))
                put(seed, 1.0)
                status = inside(g, row)
                put(seed, 0.0)
                if status != OK:
                    return status
                for i in range(n):
                    own = 1.0 if i == j else 0.0
                    put(matrix + CELL * (n * i + j), own - received(g, whole(unknowns + CELL * i)))
            k += whole(row + COUNT)
        k += 1
    return OK


@register_jitable
def solve_loop(g: int, row: int) -> int:
    """By what the inputs and outputs of a loop change; a status of the group."""
    unknowns, n, right, matrix = whole(row + REFERENCES), whole(row + SIZE), whole(row + AT), matrix_of(row)
    work = right + 2 * CELL * n
    for j in range(n):
        put(seed_of(g, whole(unknowns + CELL * j)), 0.0)
    status = inside(g, row)
    if status != OK:
        return status
    for j in range(n):
        put(right + CELL * j, received(g, whole(unknowns + CELL * j)))
    for j in range(0, CELL * n * n, CELL):
        put(work + j, number(matrix + j))
    if not factorize_and_solve(work, right, n):
        fault(g, LOOP_FAILS, whole(row + WHO), 0, -1)
        return FAILED
    for j in range(n):
        put(seed_of(g, whole(unknowns + CELL * j)), number(right + CELL * j))
    return inside(g, row)
