"""States of a group: of its first member, and of what the group keeps beside its members."""

from __future__ import annotations

from numba.extending import register_jitable

from .cells import (
    ARRAYS,
    ARRAYS_SIZE,
    CELL,
    CVODES,
    FREE,
    KEPT,
    LOST,
    MALLOC,
    METHOD,
    OWN_FORGET,
    OWN_INSTANCE,
    OWN_RESTORE,
    OWN_SAVE,
    RESTART,
    RESTARTS,
)  # fmt: skip
from .memory import call, call_whole, put_whole, whole


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
