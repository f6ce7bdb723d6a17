"""What is sent between members at events only: numbers that are no doubles, truth values, texts, sampled inputs."""

from __future__ import annotations

import numpy as np
from numba.extending import register_jitable

from ...loop.calls import byte_at
from ...loop.versions import exchange as set_or_get
from ...loop.versions import good
from ..cells import (
    CELL,
    DISCRETE,
    DISCRETE_COUNT,
    DOUBLE,
    FLOAT,
    GAIN,
    GET,
    GET_REFERENCE,
    GET_TYPE,
    GET_WHO,
    I8,
    I16,
    I32,
    I64,
    IN_GET,
    IN_SET,
    INSTANCE,
    LINK,
    MEMBER,
    MEMBERS,
    OFFSET,
    POINTER,
    PUT,
    PUT_REFERENCE,
    PUT_TYPE,
    PUT_WHO,
    ROOM,
    SENT,
    TRUTH8,
    TRUTH32,
    U8,
    U16,
    U32,
    VERSION,
)  # fmt: skip
from ..members import refused
from ..memory import half, number, put, put_byte, put_whole, whole


@register_jitable
def bits(at: int, size: int) -> int:
    """A whole number of `size` bytes at an address, without sign."""
    value = np.int64(0)
    for k in range(size):
        value |= np.int64(byte_at(at + k)) << np.int64(8 * k)
    return value  # type: ignore[return-value]


@register_jitable
def size_of(kind: int) -> int:
    """The bytes of a value."""
    if kind in (I8, U8, TRUTH8):
        return 1
    if kind in (I16, U16):
        return 2
    return 4 if kind in (FLOAT, I32, U32, TRUTH32) else 8


@register_jitable
def read_as(kind: int, at: int) -> float:
    """The value of a type at an address, as a double."""
    if kind == DOUBLE:
        return number(at)
    if kind == I64:
        return float(whole(at))
    if kind in (I32, TRUTH32):
        return float(half(at))
    size = size_of(kind)
    value = bits(at, size)
    if kind in (I8, I16) and value >= (1 << (8 * size - 1)):
        value -= 1 << (8 * size)
    return float(value)


@register_jitable
def write_as(kind: int, at: int, value: float) -> None:
    """A double as a value of a type, to an address; whole numbers are the nearest."""
    if kind == DOUBLE:
        put(at, value)
        return
    cell = np.int64(value != 0.0) if kind in (TRUTH8, TRUTH32) else np.int64(np.rint(value))
    for k in range(size_of(kind)):
        put_byte(at + k, int((cell >> np.int64(8 * k)) & 255))


@register_jitable
def send(g: int) -> int:
    """Everything once; how many have changed since the last time, or below 0: a status, negative and less one."""
    changed = 0
    for k in range(whole(g + DISCRETE_COUNT)):
        link = whole(g + DISCRETE) + LINK * k
        given, last = link + ROOM, whole(g + SENT) + CELL * k
        source, target = whole(link + GET_TYPE), whole(link + PUT_TYPE)
        member = whole(g + MEMBERS) + MEMBER * whole(link + GET_WHO)
        status = set_or_get(
            whole(member + VERSION), whole(link + GET), whole(member + INSTANCE), link + GET_REFERENCE, 1, given, 1
        )
        if not good(status):
            return -1 - refused(g, IN_GET, whole(link + GET_WHO), status)
        if source != target or source == DOUBLE:
            write_as(target, given, number(link + GAIN) * read_as(source, given) + number(link + OFFSET))
        if source == POINTER or bits(given, size_of(target)) != bits(last, size_of(target)):
            changed += source != POINTER
            put_whole(last, whole(given))
            member = whole(g + MEMBERS) + MEMBER * whole(link + PUT_WHO)
            status = set_or_get(
                whole(member + VERSION), whole(link + PUT), whole(member + INSTANCE), link + PUT_REFERENCE, 1, given, 1
            )
            if not good(status):
                return -1 - refused(g, IN_SET, whole(link + PUT_WHO), status)
    return changed
