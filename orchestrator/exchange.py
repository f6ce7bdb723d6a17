"""SET, GET and STEP of one component, inside the loop: typed values between the run's vector and the FMI functions.

A component has one block per type and direction: its value references, and its values where the FMU wants them. Doubles
lie in the run's vector itself; other types in `raw`, packed as in C, and are converted here. Like `execute.run` this is
one source with two lives.
"""

from __future__ import annotations

from math import isfinite
from typing import Any

import numpy as np
from numba.extending import register_jitable

from .calls import do_step, do_step3, exchange, exchange3
from .fmi_types import BOOLEAN, FLOAT, TEXT
from .texts import ADDRESS, OFFSETS, number_of

FMI, INSTANCE, DO_STEP, FLAGS, FLAGS_AT, FIRST_IN, LAST_IN, FIRST_OUT, LAST_OUT = range(9)  # columns of `components`
FUNCTION, REFERENCES, COUNT, VALUES, SIZE, SLOT, AT, CODE, BYTES, SIGNED = range(10)  # columns of `blocks`
IN_PLACE = -1  # AT of a block whose values lie in the run's vector
EVENT, TERMINATE, EARLY = 16, 17, 18  # what fmi3DoStep reports beside its status
NO_ROOM, BAD_VALUE = 32, 33  # no room for another text; a value that is not finite


@register_jitable
def whole_at(raw: np.ndarray, at: int, size: int, signed: int) -> int:
    """A whole number of `size` bytes, least significant first."""
    value = np.int64(0)
    for k in range(size):
        value |= np.int64(raw[at + k]) << np.int64(8 * k)
    if signed and size < 8 and raw[at + size - 1] >= 128:
        value -= np.int64(1) << np.int64(8 * size)
    return value  # type: ignore[return-value]


@register_jitable
def put_whole(raw: np.ndarray, at: int, size: int, value: int) -> None:
    """The lowest `size` bytes of a whole number, least significant first."""
    for k in range(size):
        raw[at + k] = (value >> (8 * k)) & 255


@register_jitable
def call(block: np.ndarray, version: int, instance: int) -> int:
    """The set or get function of a block; the status."""
    if version == 2:
        return exchange(block[FUNCTION], instance, block[REFERENCES], block[COUNT], block[VALUES])
    return exchange3(block[FUNCTION], instance, block[REFERENCES], block[COUNT], block[VALUES], block[SIZE])


@register_jitable
def set_inputs(component: np.ndarray, blocks: np.ndarray, z: np.ndarray, typed: Any) -> int:
    """Hand all connected inputs to the FMU; the worst status. `typed`: the arrays of `memory.Memory.typed`."""
    whole, raw, raw32, _, index = typed
    worst = 0
    for m in range(component[FIRST_IN], component[LAST_IN]):
        block = blocks[m]
        at, first, size = block[AT], block[SLOT], block[BYTES]
        if at != IN_PLACE:
            for j in range(block[SIZE]):
                if block[CODE] == FLOAT:
                    raw32[at // 4 + j] = z[first + j]
                elif block[CODE] == TEXT:
                    put_whole(raw, at + size * j, size, index[ADDRESS] + index[OFFSETS + whole[first + j]])
                else:
                    put_whole(raw, at + size * j, size, whole[first + j])
        worst = max(worst, call(block, component[FMI], component[INSTANCE]))
        if worst > 1:
            return worst
    return worst


@register_jitable
def get_outputs(component: np.ndarray, blocks: np.ndarray, z: np.ndarray, typed: Any, control: np.ndarray) -> int:
    """Fetch all outputs that have a cell; the worst status, NO_ROOM, or BAD_VALUE with its slot in control[4]."""
    whole, raw, raw32, pool, index = typed
    worst = 0
    for m in range(component[FIRST_OUT], component[LAST_OUT]):
        block = blocks[m]
        at, first, size = block[AT], block[SLOT], block[BYTES]
        worst = max(worst, call(block, component[FMI], component[INSTANCE]))
        if worst > 1:
            return worst
        for j in range(block[SIZE]):
            if block[CODE] == FLOAT:
                if at != IN_PLACE:
                    z[first + j] = raw32[at // 4 + j]
                if not isfinite(z[first + j]):
                    control[4] = first + j
                    return BAD_VALUE
            elif block[CODE] == TEXT:
                number = number_of(whole_at(raw, at + size * j, size, 0), pool, index)
                if number < 0:
                    control[4] = first + j
                    return NO_ROOM
                whole[first + j] = number
            elif block[CODE] == BOOLEAN:
                whole[first + j] = whole_at(raw, at + size * j, size, 0) != 0
            else:
                whole[first + j] = whole_at(raw, at + size * j, size, block[SIGNED])
    return worst


@register_jitable
def step(component: np.ndarray, typed: Any, time: float, length: float) -> int:
    """Step a component; the status, or EVENT, TERMINATE, EARLY."""
    if component[FMI] == 2:
        return do_step(component[DO_STEP], component[INSTANCE], time, length)
    raw, at = typed[1], component[FLAGS_AT]
    for k in range(3):
        raw[at + k] = 0
    status = do_step3(component[DO_STEP], component[INSTANCE], time, length, component[FLAGS])
    if status <= 1:
        if raw[at + 1] != 0:
            return TERMINATE
        if raw[at + 2] != 0:
            return EARLY
        if raw[at] != 0:
            return EVENT
    return status
