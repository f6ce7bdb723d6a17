"""A library under wine that looks like one of this process: functions by name, each of which passes its call on.

Functions of the loop are those of any isolated FMU (`isolated/callbacks.py`); the others are made here.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from pathlib import Path
from typing import Any

from cffi import FFI

from ...errors import FmuError
from ..here.refusal import NotLoadedError
from ..isolated.callbacks import Callbacks
from ..isolated.channel import AT_VALUES, CALL, VALUES, texts_at
from ..lifecycle import ERROR, FATAL, good
from .functions import INSTANTIATE, Called, Shape, called
from .memory import FUNCTIONS
from .process import ServerProcess, windows_path

DO, LOAD, FROM_SERVER, TO_SERVER = range(4)  # `enum Operation` of the server
REASONS = {  # of LoadLibrary, and what helps
    126: "a library that it needs is missing: ask for an FMU that carries it, or install that in wine's folder",
    127: "a library that it needs lacks a function: ask for an FMU that carries its own",
    193: "that file is no library for Windows, or for another processor: its maker must put the right one there",
    1114: "it refused in its own initialization: ask its maker what it needs",
}
Ask = Callable[[int], int]  # an operation; the FMU's status, Fatal where the process is lost


class Left:
    """Stands for a function that is in the library and cannot be called from here; fmpy writes its types to it."""

    restype: Any = None

    def __init__(self, name: str) -> None:
        self.name = name

    def __call__(self, *_: Any) -> Any:
        raise FmuError(f"{self.name} of an FMU for Windows cannot be called from here")


class WindowsLibrary:
    """`ask` has a request done that lies in the memory; attributes are functions of ctypes."""

    def __init__(self, version: int, identifier: str, process: ServerProcess, ask: Ask, callbacks: Callbacks) -> None:
        self.version, self.process, self.memory = version, process, process.memory
        self.prefix = f"{identifier}_" if version == 1 else ""
        self.ask, self.callbacks = ask, callbacks
        self.known: dict[str, tuple[int, Called]] = {c.name: (k, c) for k, c in enumerate(called(version))}
        self.there: set[str] = set()
        self.made: dict[str, Any] = {}
        self.kept: list[Any] = []  # alive as long as somebody may call them, or read them
        self.ffi = FFI()

    def load(self, library: Path, names: list[str], limit: float) -> None:
        """Load it; `names` of all functions of the version, as the standard has them.

        Raises NotLoadedError, ProcessLostError.
        """
        every = [*self.known, *(name for name in names if name not in self.known)][:FUNCTIONS]
        shapes = bytes(c.shape for _, c in self.known.values()).ljust(FUNCTIONS, bytes([Shape.PLAIN]))
        path = windows_path(str(library)).encode()
        self.memory.require_texts([path, *(f"{self.prefix}{name}".encode() for name in every)])
        self.memory.put_value(shapes)
        self.memory.put_words(len(every))
        self.process.ask(LOAD, limit)
        code = self.memory.page.refused
        if code:
            raise NotLoadedError(
                f"its library, {library.name}, cannot be loaded by wine: error {code} of Windows", REASONS.get(code, "")
            )
        self.there = {name for name, found in zip(every, self.memory.value(len(every)), strict=True) if found}

    def instantiate(self, texts: list[str], logging: bool) -> int:
        """The instance; 0 where the FMU refuses. `texts`: its name, token, place of its resources, and kind."""
        self.memory.require_texts([text.encode() for text in texts])
        self.memory.put_words(int(logging))
        self.memory.page.result = 0
        self._call(INSTANTIATE[self.version])
        return int(self.memory.page.result)

    def __getattr__(self, name: str) -> Any:
        """A function of ctypes by its name in the library; AttributeError where it has none."""
        if name.startswith("__") or name.removeprefix(self.prefix) not in self.there:
            raise AttributeError(name)
        return self.function(name.removeprefix(self.prefix))

    def function(self, name: str) -> Any:
        """By its name in the standard."""
        if name not in self.made:
            self.made[name] = self._make(name)
        return self.made[name]

    def _make(self, name: str) -> Any:
        if address := self.callbacks.address(name):
            return ctypes.CFUNCTYPE(ctypes.c_int)(address)
        if name not in self.known or not self.known[name][1].signature:
            return Left(name)
        found = self.known[name][1]
        pass_on = {
            Shape.PLAIN: self._plain, Shape.FREE: self._free, Shape.EXPERIMENT: self._numbers,
            Shape.INITIALIZE1: self._numbers, Shape.LOGGING1: self._numbers, Shape.LOGGING: self._logging,
            Shape.STATUS_NUMBER: self._status_number, Shape.STATUS_TEXT: self._status_text, Shape.TEXT: self._text,
            Shape.STATE_SIZE: self._state_size, Shape.SERIALIZE: self._serialize, Shape.DESERIALIZE: self._deserialize,
        }[found.shape](name)  # fmt: skip
        void = found.signature.startswith("void")
        given = {} if void else {"error": 0 if found.shape is Shape.TEXT else FATAL}
        callback = self.ffi.callback(
            found.signature, pass_on, onerror=lambda error, *_: self.callbacks.broken_off(error), **given
        )
        self.kept.append(callback)
        return ctypes.CFUNCTYPE(None if void else ctypes.c_int)(int(self.ffi.cast("intptr_t", callback)))

    def _call(self, name: str) -> int:
        """Have the server call a function whose arguments lie in the memory."""
        self.memory.put_call(CALL.pack(self.known[name][0], 0, 0, 0.0, 0.0, False))
        return self.ask(DO)

    def _plain(self, name: str) -> Callable[..., Any]:
        return lambda _instance: self._call(name)

    def _free(self, name: str) -> Callable[..., None]:
        def free(_instance: int) -> None:
            self._call(name)

        return free

    def _numbers(self, name: str) -> Callable[..., int]:
        def numbers(_instance: int, *values: int | float) -> int:
            self.memory.put_words(*(v if isinstance(v, float) else int(v) & 0xFF for v in values))
            return self._call(name)

        return numbers

    def _logging(self, name: str) -> Callable[..., int]:
        def logging(_instance: int, on: int, count: int, categories: int) -> int:
            if not self.memory.put_texts(texts_at(categories, count) if count else []):
                return ERROR
            self.memory.put_words(int(on), count)
            return self._call(name)

        return logging

    def _status_number(self, name: str) -> Callable[..., int]:
        size = 8 if "Real" in name else 1 if "Boolean" in name and self.version == 1 else 4

        def status(_instance: int, kind: int, value: int) -> int:
            self.memory.put_words(kind)
            found = self._call(name)
            ctypes.memmove(value, self.memory.values, size)
            return found

        return status

    def _status_text(self, name: str) -> Callable[..., int]:
        def status(_instance: int, kind: int, value: int) -> int:
            self.memory.put_words(kind)
            found = self._call(name)
            ctypes.c_void_p.from_address(value).value = self._keep()
            return found

        return status

    def _text(self, name: str) -> Callable[..., int]:
        def text() -> int:
            return self._keep() if self._call(name) < ERROR else 0

        return text

    def _keep(self) -> int:
        """The address of a copy of the text of an answer."""
        copy = ctypes.create_string_buffer(self.memory.texts(1)[0])
        self.kept.append(copy)
        return ctypes.addressof(copy)

    # --- states, which may be longer than the memory ---

    def _state_size(self, name: str) -> Callable[..., int]:
        def state_size(_instance: int, state: int, size: int) -> int:
            self._put_state(state)
            status = self._call(name)
            ctypes.c_size_t.from_address(size).value = self.memory.page.result
            return status

        return state_size

    def _serialize(self, name: str) -> Callable[..., int]:
        def serialize(_instance: int, state: int, into: int, size: int) -> int:
            self._put_state(state)
            self.memory.put_words(size)
            status = self._call(name)
            for at in range(0, size, VALUES) if good(status) else ():
                length = min(VALUES, size - at)
                self.memory.put_words(at, length, size)
                if self.ask(FROM_SERVER):
                    return FATAL
                ctypes.memmove(into + at, self.memory.values, length)
            return status

        return serialize

    def _deserialize(self, name: str) -> Callable[..., int]:
        def deserialize(_instance: int, content: int, size: int, state: int) -> int:
            for at in range(0, size, VALUES):
                length = min(VALUES, size - at)
                ctypes.memmove(self.memory.values, content + at, length)
                self.memory.put_words(at, length, size)
                if self.ask(TO_SERVER):
                    return FATAL
            self.memory.put_words(size)
            status = self._call(name)
            cell = ctypes.c_void_p.from_address(self.memory.base + AT_VALUES)
            ctypes.c_void_p.from_address(state).value = cell.value
            return status

        return deserialize

    def _put_state(self, state: int) -> None:
        ctypes.c_void_p.from_address(self.memory.base + AT_VALUES).value = state
