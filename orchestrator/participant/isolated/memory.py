"""The memory that is shared with the process of an isolated FMU: value references, values, and texts or bytes."""

from __future__ import annotations

import ctypes
import mmap
import os
import tempfile
from collections.abc import Sequence
from itertools import accumulate

REFERENCES, VALUES, TEXT_ROOM = 1 << 20, 1 << 20, 1 << 20  # bytes; offsets follow from them
SIZE = REFERENCES + VALUES + TEXT_ROOM
AT_REFERENCES, AT_VALUES = 0, REFERENCES
AT_TEXT = AT_VALUES + VALUES


class Shared:
    """The shared memory, on both sides mapped from one file descriptor, which is not needed any more then."""

    def __init__(self, file: int, size: int = SIZE) -> None:
        self.size = size
        # Python's own mmap keeps a copy of the descriptor, through which an FMU could write into the memory.
        mapping = ctypes.CDLL(None, use_errno=True).mmap
        mapping.restype, mapping.argtypes = ctypes.c_void_p, [
            ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int, ctypes.c_int, ctypes.c_int, ctypes.c_long,
        ]  # fmt: skip
        found = mapping(None, size, mmap.PROT_READ | mmap.PROT_WRITE, mmap.MAP_SHARED, file, 0)
        if found in (None, ctypes.c_void_p(-1).value):
            raise OSError(ctypes.get_errno(), "memory cannot be shared with the process of an FMU")
        self.base = int(found)
        os.close(file)

    @classmethod
    def made(cls) -> tuple[Shared, int]:
        """The memory, and a descriptor of it for the other process, to be closed here when that has begun."""
        file, path = tempfile.mkstemp(dir="/dev/shm" if os.path.isdir("/dev/shm") else None)
        os.unlink(path)
        os.truncate(file, SIZE)
        theirs = os.dup(file)
        return cls(file), theirs

    def close(self) -> None:
        """Give the memory back."""
        ctypes.CDLL(None).munmap(ctypes.c_void_p(self.base), ctypes.c_size_t(self.size))
        self.base = 0

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
        ctypes.memmove(self.base + AT_TEXT, data, len(data))
        return True

    def text_addresses(self, count: int) -> list[int]:
        """Where the texts are."""
        found, at = [], self.base + AT_TEXT
        for _ in range(count):
            found.append(at)
            at += len(ctypes.string_at(at)) + 1
        return found

    def put_bytes(self, contents: Sequence[bytes]) -> bool:
        """Their sizes into the values, and all of them where texts are, one after the other; whether there is room."""
        data = b"".join(contents)
        if len(data) > TEXT_ROOM or 16 * len(contents) > VALUES:
            return False
        (ctypes.c_size_t * len(contents)).from_address(self.values)[:] = list(map(len, contents))
        ctypes.memmove(self.base + AT_TEXT, data, len(data))
        return True

    def byte_addresses(self, count: int) -> tuple[list[int], list[int]]:
        """The sizes of bytes, and where they are."""
        sizes = list((ctypes.c_size_t * count).from_address(self.values))
        at = self.base + AT_TEXT
        return sizes, list(accumulate(sizes[:-1], initial=at)) if sizes else []


class Unshared(Shared):
    """The same places in memory that nobody else has: for an FMU with which messages alone are exchanged."""

    def __init__(self) -> None:
        self.size = SIZE
        self._buffer = ctypes.create_string_buffer(SIZE)
        self.base = ctypes.addressof(self._buffer)

    def close(self) -> None:
        self.base = 0


def bytes_at(sizes: int, values: int, count: int) -> list[bytes]:
    """The bytes to which `count` pointers at an address lead."""
    pointers, lengths = ((kind * count).from_address(at) for kind, at in (
        (ctypes.c_void_p, values), (ctypes.c_size_t, sizes)))  # fmt: skip
    return [ctypes.string_at(p, n) if p and n else b"" for p, n in zip(pointers, lengths, strict=True)]


def texts_at(values: int, count: int) -> list[bytes]:
    """The zero-terminated texts to which `count` pointers at an address lead."""
    pointers = (ctypes.c_void_p * count).from_address(values)
    return [ctypes.string_at(p) if p else b"" for p in pointers]


def put_pointers(values: int, addresses: Sequence[int]) -> None:
    """Pointers into the memory at an address."""
    (ctypes.c_void_p * len(addresses)).from_address(values)[:] = list(addresses)
