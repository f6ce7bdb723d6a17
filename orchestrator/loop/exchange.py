"""Typed values between the run's vector and what FMI functions take and give.

A component has one block per type and direction: its value references, and its values where the FMU wants them. Doubles
lie in the run's vector itself; other types in `raw`, packed as in C, and are converted here. Like `run.run` this is
one source with two lives.
"""

from __future__ import annotations

import numpy as np

from ..fmu.types import BINARY, BOOLEAN, FLOAT, FLOAT32, NEGATED, TEXT
from .cells import AT, BYTES, CODE, FIRST_SLOT, SIGNED, SIZE
from .lives import compilable
from .texts import ADDRESS, OFFSETS, length_of, number_of, number_of_bytes

SIGN = -(1 << 63)  # the bit that is set in a negative double


@compilable
def whole_at(raw: np.ndarray, at: int, size: int, signed: int) -> int:
    """A whole number of `size` bytes, least significant first."""
    value = np.int64(0)
    for k in range(size):
        value |= np.int64(raw[at + k]) << np.int64(8 * k)
    if signed and size < 8 and raw[at + size - 1] >= 128:
        value -= np.int64(1) << np.int64(8 * size)
    return value  # type: ignore[return-value]


@compilable
def put_whole(raw: np.ndarray, at: int, size: int, value: int) -> None:
    """The lowest `size` bytes of a whole number, least significant first."""
    for k in range(size):
        raw[at + k] = (value >> (8 * k)) & 255


@compilable
def pack(
    blocks: np.ndarray, m: int, z: np.ndarray, whole: np.ndarray, raw: np.ndarray, raw32: np.ndarray, index: np.ndarray
) -> int:
    """The cells of block m as the FMU wants them; -1, or the cell of a number that is beyond Float32.

    Arrays as in `run.run`.
    """
    at, first, size, code = blocks[m, AT], blocks[m, FIRST_SLOT], blocks[m, BYTES], blocks[m, CODE]
    for j in range(blocks[m, SIZE]):
        if code == FLOAT and size == 8:  # doubles that are not in place: those of negated aliases
            put_whole(raw, at + size * j, size, whole[first + j] ^ SIGN)
        elif code == FLOAT:
            if abs(z[first + j]) > FLOAT32:
                return int(first + j)
            raw32[at // 4 + j] = z[first + j]
        elif code == TEXT:
            put_whole(raw, at + size * j, size, index[ADDRESS] + index[OFFSETS + whole[first + j]])
        elif code == NEGATED:
            put_whole(raw, at + size * j, size, -whole[first + j])
        elif code == BINARY:
            put_whole(raw, at + size * j, size, index[ADDRESS] + index[OFFSETS + whole[first + j]])
            put_whole(raw, at + size * (blocks[m, SIZE] + j), size, length_of(whole[first + j], index))
        else:
            put_whole(raw, at + size * j, size, whole[first + j])
    return -1


@compilable
def unpack(
    blocks: np.ndarray, m: int, z: np.ndarray, whole: np.ndarray, raw: np.ndarray, raw32: np.ndarray,
    pool: np.ndarray, index: np.ndarray,
) -> int:  # fmt: skip
    """What the FMU gave for block m into its cells; -1, or the cell of a text, or bytes, for which there is no room."""
    at, first, size, code = blocks[m, AT], blocks[m, FIRST_SLOT], blocks[m, BYTES], blocks[m, CODE]
    for j in range(blocks[m, SIZE]):
        if code == FLOAT and size == 8:
            whole[first + j] = whole_at(raw, at + size * j, size, 0) ^ SIGN
        elif code == FLOAT:
            z[first + j] = raw32[at // 4 + j]
        elif code == TEXT:
            number = number_of(whole_at(raw, at + size * j, size, 0), pool, index)
            if number < 0:
                return int(first + j)
            whole[first + j] = number
        elif code == BOOLEAN:
            whole[first + j] = whole_at(raw, at + size * j, size, 0) != 0
        elif code == NEGATED:
            whole[first + j] = -whole_at(raw, at + size * j, size, 1)
        elif code == BINARY:
            length = whole_at(raw, at + size * (blocks[m, SIZE] + j), size, 0)
            number = number_of_bytes(whole_at(raw, at + size * j, size, 0), length, pool, index)
            if number < 0:
                return int(first + j)
            whole[first + j] = number
        else:
            whole[first + j] = whole_at(raw, at + size * j, size, blocks[m, SIGNED])
    return -1
