"""Functions that serialize states, which may be longer than the memory."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping

from ...isolated.memory import VALUES
from ...lifecycle import FATAL, good
from ..functions import Shape
from ..memory import FROM_SERVER, TO_SERVER
from .remote import Passed, Remote


def _state_size(remote: Remote, name: str) -> Passed:
    def state_size(_instance: int, state: int, size: int) -> int:
        _cell(remote).value = state
        status = remote.call(name)
        ctypes.c_size_t.from_address(size).value = remote.memory.page.result
        return status

    return state_size


def _serialize(remote: Remote, name: str) -> Passed:
    memory = remote.memory

    def serialize(_instance: int, state: int, into: int, size: int) -> int:
        _cell(remote).value = state
        memory.put_words(size)
        status = remote.call(name)
        for at in range(0, size, VALUES) if good(status) else ():
            length = min(VALUES, size - at)
            memory.put_words(at, length, size)
            if remote.ask(FROM_SERVER):
                return FATAL
            ctypes.memmove(into + at, memory.values, length)
        return status

    return serialize


def _deserialize(remote: Remote, name: str) -> Passed:
    memory = remote.memory

    def deserialize(_instance: int, content: int, size: int, state: int) -> int:
        for at in range(0, size, VALUES):
            length = min(VALUES, size - at)
            ctypes.memmove(memory.values, content + at, length)
            memory.put_words(at, length, size)
            if remote.ask(TO_SERVER):
                return FATAL
        memory.put_words(size)
        status = remote.call(name)
        ctypes.c_void_p.from_address(state).value = _cell(remote).value
        return status

    return deserialize


def _cell(remote: Remote) -> ctypes.c_void_p:
    """Where a state goes."""
    return ctypes.c_void_p.from_address(remote.memory.values)


PASSED: Mapping[Shape, Callable[[Remote, str], Passed]] = {
    Shape.STATE_SIZE: _state_size, Shape.SERIALIZE: _serialize, Shape.DESERIALIZE: _deserialize,
}  # fmt: skip
