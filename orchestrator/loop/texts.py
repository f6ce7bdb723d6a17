"""The texts of a run, numbered: a cell of the run's vector holds the number of a text, so that it is copied, compared
and recorded like any other signal. The same text has the same number throughout a run; number 0 is the empty text.
"""

from __future__ import annotations

import ctypes

import numpy as np
from numba.extending import register_jitable

from .calls import byte_at

BYTES, COUNT = 1 << 24, 1 << 16  # room for all different texts of a run
USED_COUNT, USED_BYTES, ADDRESS, OFFSETS = range(4)  # cells of `index`; offsets of the texts, then a hash table


@register_jitable
def number_of(address: int, pool: np.ndarray, index: np.ndarray) -> int:
    """The number of the zero-terminated text at an address (0: none there); -1 if there is no room for one more.

    `pool` (bytes,) holds the texts; `index` how many there are, where they are, and an open hash table.
    """
    room = (len(index) - OFFSETS) // 3
    if address == 0:
        return 0
    length, hashed = 0, 2166136261  # FNV-1a
    while byte_at(address + length) != 0:
        hashed = ((hashed ^ byte_at(address + length)) * 16777619) & 0xFFFFFFFF
        length += 1
    cell = hashed % (2 * room)
    while index[OFFSETS + room + cell] != 0:
        number = index[OFFSETS + room + cell] - 1
        offset, k = index[OFFSETS + number], 0
        while k < length and pool[offset + k] == byte_at(address + k):
            k += 1
        if k == length and pool[offset + k] == 0:
            return int(number)
        cell = (cell + 1) % (2 * room)
    number, offset = index[USED_COUNT], index[USED_BYTES]
    if number == room or offset + length + 1 > len(pool):
        return -1
    for k in range(length):
        pool[offset + k] = byte_at(address + k)
    pool[offset + length] = 0
    index[OFFSETS + number] = offset
    index[OFFSETS + room + cell] = number + 1
    index[USED_COUNT] = number + 1
    index[USED_BYTES] = offset + length + 1
    return int(number)


class Texts:
    """All texts of a run. The memory is reserved, and used only as far as there are texts."""

    def __init__(self, count: int = COUNT, size: int = BYTES) -> None:
        self.pool = np.zeros(size, dtype=np.uint8)
        self.index = np.zeros(OFFSETS + 3 * count, dtype=np.int64)
        self.index[ADDRESS] = self.pool.ctypes.data
        self.number("")

    def number(self, text: str) -> int:
        """The number of a text, which is new or known."""
        buffer = ctypes.create_string_buffer(text.encode())
        return number_of(ctypes.addressof(buffer), self.pool, self.index)

    def text(self, number: int) -> str:
        """The text of a number; bytes that are no UTF-8 are replaced."""
        address = int(self.index[ADDRESS] + self.index[OFFSETS + number])
        return ctypes.string_at(address).decode("utf-8", "replace")

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
