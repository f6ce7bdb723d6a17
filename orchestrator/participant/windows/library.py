"""A library under wine that looks like one of this process: functions by name, each of which passes its call on.

Functions of the loop are those of any isolated FMU (`isolated/callbacks.py`); the others are in `passing/`.
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
from ..isolated.channel import CALL
from ..lifecycle import FATAL
from .functions import Called, Shape, called
from .memory import DO, FUNCTIONS, LOAD
from .passing.arrays import PASSED as ARRAYS
from .passing.numbers import PASSED as NUMBERS
from .passing.states import PASSED as STATES
from .process import ServerProcess, windows_path

PASSED = {**NUMBERS, **STATES, **ARRAYS}  # what is called here in place of a function, by the kind of its arguments
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

    def instantiate(self, function: str, texts: list[str], logging: bool, choice: int) -> int:
        """The instance; 0 where the FMU refuses. `texts`: its name, token, place of its resources, and kind; `choice`:
        of FMI 2.0 the kind as a number, of FMI 3.0 for co-simulation whether events are handled."""
        self.memory.require_texts([text.encode() for text in texts])
        self.memory.put_words(int(logging), choice)
        self.memory.page.result = 0
        self.call(function)
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
        void = found.signature.startswith("void")
        given = {} if void else {"error": 0 if found.shape is Shape.TEXT else FATAL}
        callback = self.ffi.callback(
            found.signature, PASSED[found.shape](self, name),
            onerror=lambda error, *_: self.callbacks.broken_off(error), **given,
        )  # fmt: skip
        self.kept.append(callback)
        return ctypes.CFUNCTYPE(None if void else ctypes.c_int)(int(self.ffi.cast("intptr_t", callback)))

    def call(self, name: str, references: int = 0, values: int = 0) -> int:
        """Have the server call a function whose arguments lie in the memory; its status."""
        self.memory.put_call(CALL.pack(self.known[name][0], references, values, 0.0, 0.0, False))
        return self.ask(DO)

    def refuse(self, what: str) -> int:
        """The status of a call with more than the memory can hold."""
        return self.callbacks.refuse(f"it has more {what} than the memory shared with it can hold")
