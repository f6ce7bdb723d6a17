"""An instance of an FMI 1.0 co-simulation FMU in this process.

FMI 1.0 has no initialization mode: all that is set before `fmiInitializeSlave` is what it begins with, and nothing can
be read until then. So an instance initializes itself when it is read for the first time, or when that mode is left. It
knows no tolerance and cannot save its state.
"""

from __future__ import annotations

import ctypes
import math
from typing import Any

import fmpy
from fmpy import fmi1

from ...errors import FmuError
from ..apart.library import fresh_library
from ..base import CallError
from ..lifecycle import PREFIX, STATE_FUNCTIONS, State, allowed
from .c_messages import format_messages, known_as
from .library import Judged
from .loaded import LoadedInstance
from .message_filter import Row, address_of, filtered
from .refusal import refused

TEXTS = ("fmi1GetVersion", "fmi1GetTypesPlatform", "fmi1GetModelTypesPlatform")  # functions that answer with text
KIND = "application/x-fmu-sharedlibrary"


class Answers:
    """fmpy says of too many functions that they answer with text."""

    _functions: dict[str, Any]

    def _loadFunctions(self) -> None:
        super()._loadFunctions()  # type: ignore[misc]
        for name, function in self._functions.items():
            if function.restype is ctypes.c_char_p and name not in TEXTS:
                function.restype = ctypes.c_int


class FMU1Instance(Answers, Judged, fmi1.FMU1Slave):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class Fmi1Instance(LoadedInstance):
    """Loaded and instantiated by fmpy."""

    prefix = PREFIX[1]
    state_functions = STATE_FUNCTIONS[1]
    kind: type[Any] = FMU1Instance
    span: tuple[float, float | None] | None = None  # s, the start and the stop of the run

    def instantiate(self) -> None:
        self._callbacks = self._make_callbacks()
        try:
            with fresh_library(self.fmu) as library:
                self.slave = self.bound(self.kind, library)
            self.slave.instantiate(KIND, functions=self._callbacks, loggingOn=self.asked_for_all)
            if not self.slave.component:
                raise FmuError("it gave no instance")
        except Exception as error:
            raise refused(self.fmu, self.name, error, self.reasons()) from error
        known_as(self, self.pointer)
        if self._row:
            self._row.known_as(self.pointer)

    def _make_callbacks(self) -> Any:
        callbacks = fmi1.fmi1CallbackFunctions()
        callbacks.allocateMemory = ctypes.cast(fmpy.calloc, fmi1.fmi1CallbackAllocateMemoryTYPE)
        callbacks.freeMemory = ctypes.cast(fmpy.free, fmi1.fmi1CallbackFreeMemoryTYPE)
        format_messages(self, id(self), callbacks)
        if not self.asked_for_all:  # its address, which it logs with, is known behind its first messages only
            self._row = Row(id(self), everything=False)
            callbacks.logger = fmi1.fmi1CallbackLoggerTYPE(filtered(2, address_of(callbacks.logger)))
        return callbacks

    def address(self, function: str) -> int:
        return super().address(f"{self.fmu.interface.modelIdentifier}_{function}")

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        self.require("set up", "set up the experiment")
        self.promised = math.inf if stop is None else stop
        self.span = start, stop

    def enter_initialization(self) -> None:
        if self.span is None:
            raise CallError(f"component {self.name}: cannot be initialized before it is set up")
        self.call("enter", "be initialized", lambda: None)

    def exit_initialization(self) -> None:
        if self.state is State.INITIALIZING:
            assert self.span is not None
            self.call("exit", "initialize", self.slave.initialize, *self.span)

    def take(self, what: str, kind: str, references: Any, count: int) -> list[Any]:
        self.exit_initialization()
        return super().take(what, kind, references, count)

    def step(self, time: float, length: float) -> None:
        self.call("step", f"step from t = {time:.9g} s", self.slave.doStep, time, self.within(time, length))

    def reached(self) -> float:
        if not allowed(1, "ask", self.state):
            return -math.inf
        try:
            return float(self.slave.getRealStatus(fmi1.fmi1LastSuccessfulTime).value)
        except Exception:
            return -math.inf
