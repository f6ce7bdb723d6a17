"""Between the master and an FMU in a process of its own: a pipe each way for what to do, shared memory for the values.

A message is its length, a letter and a body. `J`: a call by name, as JSON. `F`: an FMI function by its number, with the
value references and values in the shared memory; the answer is the status and what the FMU has logged, as JSON.
"""

from __future__ import annotations

import ctypes
import mmap
import os
import struct
from collections.abc import Sequence

HEADER = struct.Struct("<Ic")
CALL = struct.Struct("<HxxxxxxQQdd")  # function, references, values, and for a step its time and length
REFERENCES, VALUES, TEXT_ROOM = 1 << 20, 1 << 20, 1 << 20  # bytes; offsets follow from them
SIZE = REFERENCES + VALUES + TEXT_ROOM
AT_REFERENCES, AT_VALUES = 0, REFERENCES
AT_TEXT = AT_VALUES + VALUES


class ChannelClosedError(Exception):
    """The other side has gone."""


def send(pipe: int, letter: bytes, body: bytes) -> None:
    """Write a whole message. Raises ChannelClosedError."""
    data = memoryview(HEADER.pack(len(body), letter) + body)
    try:
        while data:
            data = data[os.write(pipe, data) :]
    except OSError as error:
        raise ChannelClosedError from error


def receive(pipe: int) -> tuple[bytes, bytes]:
    """The letter and body of the next message. Raises ChannelClosedError."""
    length, letter = HEADER.unpack(_exactly(pipe, HEADER.size))
    return letter, _exactly(pipe, length)


def _exactly(pipe: int, length: int) -> bytes:
    parts, left = [], length
    while left:
        part = os.read(pipe, left)
        if not part:
            raise ChannelClosedError
        parts.append(part)
        left -= len(part)
    return b"".join(parts)


class Shared:
    """The shared memory, on both sides mapped from one file descriptor."""

    def __init__(self, file: int) -> None:
        self.map = mmap.mmap(file, SIZE)
        self.base = ctypes.addressof(ctypes.c_char.from_buffer(self.map))

    @property
    def references(self) -> int:
        return self.base + AT_REFERENCES

    @property
    def values(self) -> int:
        return self.base + AT_VALUES

    def put_texts(self, texts: Sequence[bytes]) -> bool:
        """Lay texts into the memory one after the other, each ended by a zero; whether there is room."""
        data = b"".join(text + b"\0" for text in texts)
        if len(data) > TEXT_ROOM:
            return False
        self.map[AT_TEXT : AT_TEXT + len(data)] = data
        return True

    def text_addresses(self, count: int) -> list[int]:
        """Where the texts are."""
        found, at = [], AT_TEXT
        for _ in range(count):
            found.append(self.base + at)
            at = self.map.find(b"\0", at) + 1
        return found


def texts_at(values: int, count: int) -> list[bytes]:
    """The zero-terminated texts to which `count` pointers at an address lead."""
    pointers = (ctypes.c_void_p * count).from_address(values)
    return [ctypes.string_at(p) if p else b"" for p in pointers]


def put_pointers(values: int, addresses: Sequence[int]) -> None:
    """Pointers into the memory at an address."""
    (ctypes.c_void_p * len(addresses)).from_address(values)[:] = list(addresses)
