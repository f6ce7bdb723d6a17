"""What the loop needs to exchange typed values: between the run's vector and the FMI functions.

A component has one block per type and direction: its value references, and its values where the FMU wants them. Doubles
lie in the run's vector itself; other types in `raw`, packed as in C, and are converted here. Like `run.run` this is
one source with two lives.
"""

from __future__ import annotations

import numpy as np
from numba.extending import register_jitable

from ..fmu.types import BOOLEAN, FLOAT, TEXT
from .calls import do_step3
from .cells import AT, BYTES, CODE, DO_STEP, FINAL, FIRST_SLOT, FLAGS, FLAGS_AT, INSTANCE, SIGNED, SIZE
from .texts import ADDRESS, OFFSETS, number_of

REPORTS = 1 << 40  # from here on, where no status of an FMU can be: a C int
EVENT, TERMINATE, EARLY = REPORTS, REPORTS + 1, REPORTS + 2  # what fmi3DoStep reports beside its status
NO_ROOM = REPORTS + 3  # for another text


@register_jitable
def good(status: int) -> bool:
    """Whether a status is OK (0) or Warning (1): anything else is none, the unknown too."""
    return (status | 1) == 1


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
def pack(
    blocks: np.ndarray, m: int, z: np.ndarray, whole: np.ndarray, raw: np.ndarray, raw32: np.ndarray, index: np.ndarray
) -> None:
    """The cells of block m as the FMU wants them; arrays as in `run.run`."""
    at, first, size, code = blocks[m, AT], blocks[m, FIRST_SLOT], blocks[m, BYTES], blocks[m, CODE]
    for j in range(blocks[m, SIZE]):
        if code == FLOAT:
            raw32[at // 4 + j] = z[first + j]
        elif code == TEXT:
            put_whole(raw, at + size * j, size, index[ADDRESS] + index[OFFSETS + whole[first + j]])
        else:
            put_whole(raw, at + size * j, size, whole[first + j])


@register_jitable
def unpack(
    blocks: np.ndarray, m: int, z: np.ndarray, whole: np.ndarray, raw: np.ndarray, raw32: np.ndarray,
    pool: np.ndarray, index: np.ndarray,
) -> int:  # fmt: skip
    """What the FMU gave for block m into its cells; -1, or the cell of a text for which there is no room."""
    at, first, size, code = blocks[m, AT], blocks[m, FIRST_SLOT], blocks[m, BYTES], blocks[m, CODE]
    for j in range(blocks[m, SIZE]):
        if code == FLOAT:
            z[first + j] = raw32[at // 4 + j]
        elif code == TEXT:
            number = number_of(whole_at(raw, at + size * j, size, 0), pool, index)
            if number < 0:
                return int(first + j)
            whole[first + j] = number
        elif code == BOOLEAN:
            whole[first + j] = whole_at(raw, at + size * j, size, 0) != 0
        else:
            whole[first + j] = whole_at(raw, at + size * j, size, blocks[m, SIGNED])
    return -1


@register_jitable
def step3(components: np.ndarray, c: int, raw: np.ndarray, time: float, length: float) -> int:
    """Step component c of FMI 3; the status, or EVENT, TERMINATE, EARLY."""
    at = components[c, FLAGS_AT]
    for k in range(3):
        raw[at + k] = 0
    final = components[c, FINAL]
    status = do_step3(components[c, DO_STEP], components[c, INSTANCE], time, length, final, components[c, FLAGS])
    if good(status):
        if raw[at + 1] != 0:
            return TERMINATE
        if raw[at + 2] != 0:
            return EARLY
        if raw[at] != 0:
            return EVENT
    return status
