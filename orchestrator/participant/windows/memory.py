"""The memory that the master shares with a server under wine; the other side is `server/protocol.h`."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

from ..isolated.channel import CALL
from ..isolated.memory import SIZE, Shared

MESSAGES = 1 << 18
PAGE = 4096
CALL_AT, WORDS_AT = 48, 96  # bytes into the page
WHOLE = SIZE + PAGE + MESSAGES
FUNCTIONS = 256

DO, LOAD, FROM_SERVER, TO_SERVER, RESUME = range(5)  # `enum Operation` of the server

U32, I32, U64 = ctypes.c_uint32, ctypes.c_int32, ctypes.c_uint64


class Page(ctypes.Structure):
    """The numbers of `struct Shared`, in its order."""

    asked: int
    answered: int
    server_sleeps: int
    master_sleeps: int
    operation: int
    status: int
    written: int
    kept_back: int
    allowance: int
    lowest: int
    crash: int
    refused: int
    words: ctypes.Array[ctypes.c_uint64]
    result: int
    inside: int
    _fields_ = (
        ("asked", U32), ("answered", U32), ("server_sleeps", U32), ("master_sleeps", U32), ("operation", U32),
        ("status", I32), ("written", U32), ("kept_back", U32), ("allowance", I32), ("lowest", I32), ("crash", U32),
        ("refused", U32), ("call", ctypes.c_char * 48), ("words", U64 * 8), ("result", U64), ("inside", U64),
    )  # fmt: skip


class ServerMemory(Shared):
    """References, values and texts as for any isolated FMU; behind them the page, then messages."""

    def __init__(self, file: int) -> None:
        super().__init__(file, WHOLE)
        self.page = Page.from_address(self.base + SIZE)
        self._call = memoryview((ctypes.c_ubyte * CALL.size).from_address(self.base + SIZE + CALL_AT)).cast("B")
        # The two numbers that both sides look at, and whether the server sleeps: nothing is quicker in Python.
        self.numbers = memoryview((U32 * 4).from_address(self.base + SIZE)).cast("B").cast("I")

    def put_call(self, packed: bytes) -> None:
        """The function of a request, as `CALL`."""
        self._call[:] = packed

    def put_words(self, *values: int | float) -> None:
        """Other arguments."""
        for k, value in enumerate(values):
            word = ctypes.c_double(value) if isinstance(value, float) else U64(value)
            ctypes.memmove(self.base + SIZE + WORDS_AT + 8 * k, ctypes.byref(word), 8)

    def put_value(self, content: bytes) -> None:
        """Bytes at the beginning of the values."""
        ctypes.memmove(self.values, content, len(content))

    def value(self, size: int) -> bytes:
        """Bytes from the beginning of the values."""
        return ctypes.string_at(self.values, size)

    def texts(self, count: int) -> list[bytes]:
        """The texts of an answer."""
        return [ctypes.string_at(at) for at in self.text_addresses(count)]

    def take_messages(self) -> list[tuple[int, str, str]]:
        """Status, category and text of what the FMU has logged since."""
        size, self.page.written = min(self.page.written, MESSAGES), 0
        content, at, found = ctypes.string_at(self.base + SIZE + PAGE, size), 0, []
        while at + 6 <= size:
            status = int.from_bytes(content[at : at + 4], "little", signed=True)
            first = content.index(b"\0", at + 4)
            second = content.index(b"\0", first + 1)
            category, text = content[at + 4 : first], content[first + 1 : second]
            found.append((status, _text(category), _text(text)))
            at = second + 1
        return found

    def require_texts(self, texts: Sequence[bytes]) -> None:
        """Lay texts down. Raises ValueError where there is no room."""
        if not self.put_texts(texts):
            raise ValueError("its texts are longer than the memory shared with it")


def _text(content: bytes) -> str:
    return content.decode("utf-8", "replace").strip()
