"""What the loop calls in place of the functions of an FMU that lives in another process.

An exception in a callback of ctypes comes back as 0, which is fmi2OK: a Ctrl-C at the wrong moment would make a step
that was never done a good one. Callbacks of cffi state what an exception is worth: Fatal.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from cffi import FFI

from ..lifecycle import FATAL, good
from .channel import CALL
from .functions import Function, functions
from .memory import AT_REFERENCES, AT_VALUES, REFERENCES, VALUES, Shared, bytes_at, put_pointers, texts_at

Ask = Callable[[str, bytes], int]  # the kind of a function, a packed CALL; the status
Refuse = Callable[[str], int]  # what cannot be passed on; Fatal


class Callbacks:
    """One per function, made when its address is asked for."""

    def __init__(
        self, version: int, shared: Shared, ask: Ask, refuse: Refuse, broken_off: Callable[[type[BaseException]], None]
    ) -> None:
        self.shared, self.ask, self.refuse, self.broken_off = shared, ask, refuse, broken_off
        self.known = {function.name: (number, function) for number, function in enumerate(functions(version))}
        self.made: dict[str, tuple[int, Any]] = {}
        self.ffi = FFI()

    def address(self, name: str) -> int:
        """Of the callback for a function; 0 if it is not one that the loop can call."""
        if name not in self.known:
            return 0
        if name not in self.made:
            number, function = self.known[name]
            kind = {"set": self._exchange, "get": self._exchange, "step": self._step}.get(function.kind, self._state)
            kind = self._exchange_bytes if function.binary else kind
            callback = self.ffi.callback(
                function.signature, kind(number, function), error=FATAL, onerror=lambda e, *_: self.broken_off(e)
            )
            self.made[name] = int(self.ffi.cast("intptr_t", callback)), callback
        return self.made[name][0]

    def _exchange(self, number: int, function: Function) -> Callable[..., int]:
        shared, sets = self.shared, function.kind == "set"

        def exchange(_instance: int, references: int, count: int, values: int, size: int | None = None) -> int:
            number_of_values = count if size is None else size
            room = function.size * number_of_values
            if 4 * count > REFERENCES or room > VALUES:
                return self.refuse("it has more values than the memory shared with it can hold")
            ctypes.memmove(shared.base + AT_REFERENCES, references, 4 * count)
            if sets and function.text:
                if not shared.put_texts(texts_at(values, number_of_values)):
                    return self.refuse("its texts are longer than the memory shared with it")
            elif not function.text:  # of a get, too: what an FMU does not write stays as it was
                ctypes.memmove(shared.base + AT_VALUES, values, room)
            status = self.ask(function.kind, CALL.pack(number, count, number_of_values, 0.0, 0.0, False))
            if not sets and good(status):
                if function.text:
                    put_pointers(values, shared.text_addresses(number_of_values))
                else:
                    ctypes.memmove(values, shared.base + AT_VALUES, room)
            return status

        return exchange

    def _exchange_bytes(self, number: int, function: Function) -> Callable[..., int]:
        shared = self.shared

        def exchange(_instance: int, references: int, count: int, sizes: int, values: int, size: int) -> int:
            if 4 * count > REFERENCES or 16 * size > VALUES:
                return self.refuse("it has more values than the memory shared with it can hold")
            ctypes.memmove(shared.base + AT_REFERENCES, references, 4 * count)
            if function.kind == "set" and not shared.put_bytes(bytes_at(sizes, values, size)):
                return self.refuse("its bytes are more than the memory shared with it can hold")
            status = self.ask(function.kind, CALL.pack(number, count, size, 0.0, 0.0, False))
            if function.kind == "get" and good(status):
                found, addresses = shared.byte_addresses(size)
                put_pointers(sizes, found)  # whole numbers as long as a pointer
                put_pointers(values, addresses)
            return status

        return exchange

    def _step(self, number: int, function: Function) -> Callable[..., int]:
        def step(_instance: int, time: float, length: float, final: int, *ends: int) -> int:
            status = self.ask("step", CALL.pack(number, 0, 0, time, length, bool(final)))
            for to, at, size in zip(ends, (0, 1, 2, 8), (1, 1, 1, 8), strict=False):
                ctypes.memmove(to, self.shared.base + AT_VALUES + at, size)
            return status

        return step

    def _state(self, number: int, function: Function) -> Callable[..., int]:
        def state(_instance: int, value: int) -> int:
            cell = ctypes.c_void_p.from_address(self.shared.base + AT_VALUES)
            packed = CALL.pack(number, 0, 0, 0.0, 0.0, False)
            if function.kind == "restore":
                cell.value = value
                return self.ask(function.kind, packed)
            outside = ctypes.c_void_p.from_address(value)
            cell.value = outside.value
            status = self.ask(function.kind, packed)
            outside.value = cell.value
            return status

        return state
