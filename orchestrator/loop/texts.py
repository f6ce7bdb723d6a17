"""The texts and bytes of a run, numbered: a cell of the run's vector holds the number of one, so that it is copied,
compared and recorded like any other signal. The same one has the same number throughout a run; 0 is the empty one. Both
have one store, a text as its bytes, where each is followed by a zero that is none of it.
"""

from __future__ import annotations

import ctypes
from functools import cache

import numpy as np

from .calls import byte_at
from .lives import compilable, compilable_for

BYTES, COUNT = 1 << 24, 1 << 16  # room for all different texts of a run
MANY_BYTES, MANY = 1 << 30, 1 << 19  # of one that has Binary signals
USED_COUNT, USED_BYTES, ADDRESS, OFFSETS = range(4)  # cells of `index`; offsets of the texts, then a hash table
FACTOR, BITS = 16777619, 0xFFFFFFFF  # of the hash: the bytes as digits of a number to this base, its last 32 bits
BLOCK = 1 << 16


@compilable
def number_of(address: int, pool: np.ndarray, index: np.ndarray) -> int:
    """The number of the zero-terminated text at an address (0: none there); -1 if there is no room for one more.

    `pool` (bytes,) holds the texts; `index` how many there are, where they are, and an open hash table.
    """
    if address == 0:
        return 0
    return number_of_bytes(address, length_at(address), pool, index)


@compilable
def number_of_bytes(address: int, length: int, pool: np.ndarray, index: np.ndarray) -> int:
    """The number of so many bytes at an address; -1 if there is no room for them, or if they are nowhere."""
    room = (len(index) - OFFSETS) // 3
    if length == 0:
        return 0
    if address == 0 or length < 0 or length >= len(pool):
        return -1
    cell = hash_at(address, length) % (2 * room)
    while index[OFFSETS + room + cell] != 0:
        number = index[OFFSETS + room + cell] - 1
        if length_of(number, index) == length and is_at(address, length, pool, index[OFFSETS + number]):
            return int(number)
        cell = (cell + 1) % (2 * room)
    number, offset = index[USED_COUNT], index[USED_BYTES]
    if number == room or offset + length + 1 > len(pool):
        return -1
    copy_from(address, length, pool, offset)
    index[OFFSETS + number] = offset
    index[OFFSETS + room + cell] = number + 1
    index[USED_COUNT] = number + 1
    index[USED_BYTES] = offset + length + 1
    return int(number)


@compilable
def length_of(number: int, index: np.ndarray) -> int:
    """How many bytes a text has."""
    end = index[USED_BYTES] if number + 1 == index[USED_COUNT] else index[OFFSETS + number + 1]
    return int(end - index[OFFSETS + number] - 1)


# What is done with the bytes of a text, for Python; the compiled loop has the same below, byte by byte.


def length_at(address: int) -> int:
    return len(ctypes.string_at(int(address)))


def hash_at(address: int, length: int) -> int:
    content, hashed = np.frombuffer(ctypes.string_at(int(address), int(length)), dtype=np.uint8), 0
    for first in range(0, length, BLOCK):
        block = content[first : first + BLOCK]
        digits = int((block * _powers()[-len(block) :]).sum(dtype=np.uint64))
        hashed = (hashed * pow(FACTOR, len(block), BITS + 1) + digits) & BITS
    return hashed


def is_at(address: int, length: int, pool: np.ndarray, offset: int) -> bool:
    """Does the pool hold the text there?"""
    return pool[offset : offset + length + 1].tobytes() == ctypes.string_at(int(address), int(length)) + b"\0"


def copy_from(address: int, length: int, pool: np.ndarray, offset: int) -> None:
    pool[offset : offset + length + 1] = np.frombuffer(
        ctypes.string_at(int(address), int(length)) + b"\0", dtype=np.uint8
    )


@cache
def _powers() -> np.ndarray:
    """FACTOR to the power of BLOCK - 1, ..., 1, 0, the last 32 bits of each."""
    return np.cumprod(np.array([1] + [FACTOR] * (BLOCK - 1), dtype=np.uint32), dtype=np.uint32)[::-1].astype(np.uint64)


@compilable_for(length_at)
def _length_at(address):  # type: ignore[no-untyped-def]
    length = 0
    while byte_at(address + length) != 0:
        length += 1
    return length


@compilable_for(hash_at)
def _hash_at(address, length):  # type: ignore[no-untyped-def]
    hashed = 0
    for k in range(length):
        hashed = (hashed * FACTOR + byte_at(address + k)) & BITS
    return hashed


@compilable_for(is_at)
def _is_at(address, length, pool, offset):  # type: ignore[no-untyped-def]
    k = 0
    while k < length and pool[offset + k] == byte_at(address + k):
        k += 1
    return k == length and pool[offset + k] == 0


@compilable_for(copy_from)
def _copy_from(address, length, pool, offset):  # type: ignore[no-untyped-def]
    for k in range(length):
        pool[offset + k] = byte_at(address + k)
    pool[offset + length] = 0


class Texts:
    """All texts of a run. The memory is reserved, and used only as far as there are texts."""

    def __init__(self, count: int = COUNT, size: int = BYTES) -> None:
        self.pool = np.zeros(size, dtype=np.uint8)
        self.index = np.zeros(OFFSETS + 3 * count, dtype=np.int64)
        self.index[ADDRESS] = self.pool.ctypes.data
        self.index[USED_COUNT] = self.index[USED_BYTES] = 1  # the empty one, and the zero behind it

    def number(self, text: str) -> int:
        """The number of a text, which is new or known."""
        buffer = ctypes.create_string_buffer(text.encode())
        return number_of(ctypes.addressof(buffer), self.pool, self.index)

    def number_of_bytes(self, content: bytes) -> int:
        """The number of bytes, which are new or known."""
        buffer = ctypes.create_string_buffer(content, len(content) + 1)
        return number_of_bytes(ctypes.addressof(buffer), len(content), self.pool, self.index)

    def text(self, number: int) -> str:
        """The text of a number; bytes that are no UTF-8 are replaced."""
        return self.bytes(number).decode("utf-8", "replace")

    def bytes(self, number: int) -> bytes:
        """The bytes of a number."""
        address = int(self.index[ADDRESS] + self.index[OFFSETS + number])
        return ctypes.string_at(address, length_of(number, self.index))

    @property
    def longest(self) -> int:
        """Bytes of the longest text."""
        offsets = self.index[OFFSETS : OFFSETS + int(self.index[USED_COUNT])]
        return int(np.max(np.diff(offsets, append=self.index[USED_BYTES]), initial=0))

    def content(self) -> tuple[np.ndarray, np.ndarray]:
        """The bytes of all texts, and where they are; for `restore`."""
        return self.pool[: self.index[USED_BYTES]].copy(), np.delete(self.index, ADDRESS)

    def restore(self, pool: np.ndarray, index: np.ndarray) -> None:
        """Take texts and their numbers from another run. Raises ValueError if they do not fit."""
        room = (len(self.index) - OFFSETS) // 3
        if len(index) != len(self.index) - 1 or len(pool) > len(self.pool) or not 0 <= index[USED_COUNT] <= room:
            raise ValueError("the texts do not fit")
        self.pool[: len(pool)] = pool
        self.index[:] = np.insert(index, ADDRESS, self.pool.ctypes.data)
