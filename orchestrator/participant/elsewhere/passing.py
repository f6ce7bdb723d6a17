"""What of the memory that an isolated FMU shares with its master goes with a call, where they share none.

With the call: references and values, also those of a get (what an FMU does not write stays as it was), texts, bytes,
the handle of a state. With its answer: what the FMU wrote. Numbers are as in memory, so that the bits are the same.
"""

from __future__ import annotations

import ctypes
import struct

from ..isolated.channel import ENDS
from ..isolated.functions import Function
from ..isolated.memory import AT_REFERENCES, AT_TEXT, AT_VALUES, REFERENCES, TEXT_ROOM, VALUES, Shared

HANDLE = 8  # bytes of a state's
SIZE = 8  # bytes of a length of bytes, and of a pointer


class NotFittingError(ValueError):
    """What came does not fit the call that it came with."""


def of_call(function: Function, references: int, values: int, shared: Shared) -> bytes:
    """What goes with a call, out of the master's memory."""
    kind = function.kind
    if kind == "step":
        return b""
    if kind not in ("set", "get"):
        return _taken(shared, AT_VALUES, HANDLE)
    named = _taken(shared, AT_REFERENCES, 4 * references)
    if kind == "get" and (function.text or function.binary):
        return named
    return named + _values(function, values, shared)


def put_call(function: Function, references: int, values: int, content: bytes, shared: Shared, version: int) -> None:
    """Lay it into the memory of the FMU's process. Raises NotFittingError."""
    kind = function.kind
    if kind == "step":
        _require(not content)
        return
    if kind not in ("set", "get"):
        _require(len(content) == HANDLE)
        _put(shared, AT_VALUES, content)
        return
    _require(4 * references <= min(REFERENCES, len(content)) and (version == 3 or values == references))
    _put(shared, AT_REFERENCES, content[: 4 * references])
    rest = content[4 * references :]
    if kind == "get" and (function.text or function.binary):
        _require(len(content) == 4 * references and 2 * SIZE * values <= VALUES)
    else:
        _put_values(function, values, rest, shared)


def of_answer(function: Function, values: int, shared: Shared) -> bytes:
    """What goes with a good answer, out of the memory of the FMU's process."""
    kind = function.kind
    if kind == "step":
        return _taken(shared, AT_VALUES, ENDS)
    if kind in ("save", "forget"):
        return _taken(shared, AT_VALUES, HANDLE)
    return _values(function, values, shared) if kind == "get" else b""


def put_answer(function: Function, values: int, content: bytes, shared: Shared) -> None:
    """Lay it into the master's memory. Raises NotFittingError."""
    kind = function.kind
    if kind == "get":
        _put_values(function, values, content, shared)
        return
    _require(len(content) == {"step": ENDS, "save": HANDLE, "forget": HANDLE}.get(kind, 0))
    _put(shared, AT_VALUES, content)


def _values(function: Function, values: int, shared: Shared) -> bytes:
    if function.text:
        last = shared.text_addresses(values)[-1:]
        return _taken(shared, AT_TEXT, sum(at + len(ctypes.string_at(at)) + 1 - shared.base - AT_TEXT for at in last))
    if function.binary:
        return _taken(shared, AT_VALUES, SIZE * values) + _taken(shared, AT_TEXT, sum(shared.byte_addresses(values)[0]))
    return _taken(shared, AT_VALUES, function.size * values)


def _put_values(function: Function, values: int, content: bytes, shared: Shared) -> None:
    if function.text:
        _require(len(content) <= TEXT_ROOM and SIZE * values <= VALUES)
        _require(content.count(0) == values and (content[-1:] in (b"", b"\0")))
        _put(shared, AT_TEXT, content)
    elif function.binary:
        sizes, bytes_ = content[: SIZE * values], content[SIZE * values :]
        _require(2 * SIZE * values <= VALUES and len(sizes) == SIZE * values and len(bytes_) <= TEXT_ROOM)
        _require(sum(struct.unpack(f"<{values}Q", sizes)) == len(bytes_))
        _put(shared, AT_VALUES, sizes)
        _put(shared, AT_TEXT, bytes_)
    else:
        _require(len(content) == function.size * values <= VALUES)
        _put(shared, AT_VALUES, content)


def _require(fits: bool) -> None:
    if not fits:
        raise NotFittingError


def _taken(shared: Shared, at: int, length: int) -> bytes:
    return ctypes.string_at(shared.base + at, length)


def _put(shared: Shared, at: int, content: bytes) -> None:
    ctypes.memmove(shared.base + at, content, len(content))
