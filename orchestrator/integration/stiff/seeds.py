"""By what outputs and inputs of a group change where its states change by SEEDS; V_SEEDS holds it as V does values."""

from __future__ import annotations

from numba.extending import register_jitable

from ...loop.versions import good
from ..cells import (
    AT,
    CELL,
    COUNT,
    DIRECTIONAL,
    DIRECTIONALS,
    FIRST_STATE,
    GAINS,
    IN_DIRECTIONAL,
    INSTANCE,
    KNOWN,
    KNOWN_COUNT,
    KNOWN_INPUTS,
    KNOWN_SEEDS,
    KNOWN_SIZE,
    MEMBER,
    MEMBERS,
    OK,
    REFERENCES,
    SEEDS,
    SIZE,
    SOURCES,
    STATE,
    STATE_COUNT,
    V_SEEDS,
    VERSION,
    WHO,
    V,
)
from ..members import refused
from ..memory import call, number, put, put_whole, whole


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
