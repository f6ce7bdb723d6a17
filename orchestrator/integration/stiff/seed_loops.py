"""By what the inputs in a loop of direct dependences change: linear equations, whose matrix serves all seeds."""

from __future__ import annotations

from numba.extending import register_jitable

from ..cells import (
    AT,
    CELL,
    COUNT,
    FAILED,
    KIND,
    LOOP,
    LOOP_FAILS,
    OK,
    REFERENCES,
    ROW,
    ROW_COUNT,
    ROWS,
    SEEDS,
    SIZE,
    STATES,
    TAKE,
    V_SEEDS,
    VALUES,
    WHO,
)
from ..members import fault
from ..memory import number, put, whole
from .linear import factorize_and_solve
from .seeds import change_output, received, seed_of


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
