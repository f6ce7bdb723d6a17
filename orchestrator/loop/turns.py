"""What is done in one go: turns of components whose values lie where their FMUs take them, and transfers in a row.

A turn is set, step and get of one component with the transfers before it, in one row of `turns`: what three operations
would look up in `components` and `blocks`. Transfers are the rows of `moves`. Both give the bits of the operations
that they stand for. One source with two lives, like `run.run`.
"""

from __future__ import annotations

from math import isfinite

import numpy as np

from .cells import BAD_STATUS, DONE, FLAGS, NOT_FINITE, PART, SLOT, STATUS
from .last_step import length_to
from .lives import compilable
from .versions import exchange, good, step

# `moves`: from and to which cell, and the first coefficient; -1 for a value that is moved as it is.
FROM, TO, COEFFICIENT, MOVE_COLUMNS = range(4)
# `turns`: where its transfers end in `moves`, they begin where those of the turn before end; address of the function
# that sets (0: nothing is set), value references and their number, address of the values, their number; the same for
# what is got, there with the first cell; address of the step function, instance, start and length [ticks], whose
# signatures the functions have, whether a step is final, the component.
(
    MOVED, SET, SET_REFERENCES, SET_COUNT, SET_VALUES, SET_SIZE, GET, GET_REFERENCES, GET_COUNT, GET_VALUES, GET_SIZE,
    GET_SLOT, DO_STEP, INSTANCE, START, LENGTH, FMI, FINAL, COMPONENT, TURN_COLUMNS,
) = range(20)  # fmt: skip
AT_SET, AT_STEP, AT_GET, PARTS = range(4)  # where a turn ended: PARTS times its number and one of them


@compilable
def move(moves: np.ndarray, first: int, last: int, z: np.ndarray, coefficients: np.ndarray) -> None:
    """Some transfers, one after the other."""
    for n in range(first, last):
        k = moves[n, COEFFICIENT]
        if k < 0:
            z[moves[n, TO]] = z[moves[n, FROM]]
        else:
            z[moves[n, TO]] = coefficients[k] * z[moves[n, FROM]] + coefficients[k + 1]


@compilable
def take_turns(
    turns: np.ndarray, first: int, last: int, moves: np.ndarray, moved: int, z: np.ndarray, coefficients: np.ndarray,
    components: np.ndarray, control: np.ndarray,
    base: int, varying: int, numerator: int, denominator: int, stop: float,
) -> int:  # fmt: skip
    """Some turns, one after the other: DONE, BAD_STATUS or NOT_FINITE, with control[PART] where that was.

    `moved`: where the transfers of the first begin; `varying`: what is added to the length of steps that vary [ticks];
    `base` [ticks from time 0] and the others as in `run.run`.
    """
    start, ticks, time, length = -1, -1, 0.0, 0.0
    for n in range(first, last):
        while moved < turns[n, MOVED]:
            k = moves[moved, COEFFICIENT]
            if k < 0:
                z[moves[moved, TO]] = z[moves[moved, FROM]]
            else:
                z[moves[moved, TO]] = coefficients[k] * z[moves[moved, FROM]] + coefficients[k + 1]
            moved += 1
        fmi, instance = turns[n, FMI], turns[n, INSTANCE]
        if turns[n, SET] != 0:
            status = exchange(
                fmi, turns[n, SET], instance, turns[n, SET_REFERENCES], turns[n, SET_COUNT], turns[n, SET_VALUES],
                turns[n, SET_SIZE],
            )  # fmt: skip
            if not good(status):
                control[PART], control[STATUS] = PARTS * n + AT_SET, status
                return BAD_STATUS
        if turns[n, START] != start or turns[n, LENGTH] != ticks:  # a division takes longer than a call
            start, ticks = turns[n, START], turns[n, LENGTH]
            time = ((base + start) * numerator) / denominator
            length = ((ticks + varying) * numerator) / denominator
            if time + length > stop:
                length = length_to(time, stop)
        flags = 0
        if fmi != 2:
            flags = components[turns[n, COMPONENT], FLAGS]
        status = step(fmi, turns[n, DO_STEP], instance, time, length, turns[n, FINAL], flags)
        if not good(status):
            control[PART], control[STATUS] = PARTS * n + AT_STEP, status
            return BAD_STATUS
        if turns[n, GET] != 0:
            status = exchange(
                fmi, turns[n, GET], instance, turns[n, GET_REFERENCES], turns[n, GET_COUNT], turns[n, GET_VALUES],
                turns[n, GET_SIZE],
            )  # fmt: skip
            if not good(status):
                control[PART], control[STATUS] = PARTS * n + AT_GET, status
                return BAD_STATUS
            for j in range(turns[n, GET_SLOT], turns[n, GET_SLOT] + turns[n, GET_SIZE]):
                if not isfinite(z[j]):
                    control[PART], control[SLOT] = PARTS * n + AT_GET, j
                    return NOT_FINITE
    return DONE
