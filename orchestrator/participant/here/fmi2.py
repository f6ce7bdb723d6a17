"""An instance of an FMI 2.0 FMU in this process."""

from __future__ import annotations

import math
from typing import Any

from fmpy import fmi2

from ...fmu.sharing import made_by_pythonfmu, made_here
from ..apart.library import fresh_library
from ..apart.modules import own_modules
from ..base import AskedToEndError, CallError
from ..lifecycle import DISCARD, PREFIX, STATE_FUNCTIONS, allowed
from .c_messages import format_messages
from .exit_guard import end_before_library_destructors
from .library import Judged
from .loaded import LoadedInstance
from .message_filter import Row, address_of, filtered
from .refusal import refused


class FMU2Instance(Judged, fmi2.FMU2Slave):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class Fmi2Instance(LoadedInstance):
    """Loaded and instantiated by fmpy."""

    prefix = PREFIX[2]
    state_functions = STATE_FUNCTIONS[2]
    kind: type[Any] = FMU2Instance  # fmpy's, which binds the functions

    def instantiate(self) -> None:
        self.made_by_pythonfmu = made_by_pythonfmu(self.fmu)
        if self.made_by_pythonfmu:
            end_before_library_destructors()
        self._callbacks = self._make_callbacks()
        try:
            with fresh_library(self.fmu) as library:
                self.slave = self.bound(self.kind, library)
            with own_modules(self.fmu):
                self.slave.instantiate(callbacks=self._callbacks, loggingOn=self.asked_for_all)
        except Exception as error:
            raise refused(self.fmu, self.name, error, self.reasons()) from error

    def _make_callbacks(self) -> Any:
        callbacks = fmi2.fmi2CallbackFunctions()
        callbacks.componentEnvironment = id(self)
        callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(self._log)  # of pythonfmu, which passes no arguments of printf
        callbacks.allocateMemory = fmi2.defaultCallbacks.allocateMemory
        callbacks.freeMemory = fmi2.defaultCallbacks.freeMemory
        # The proxy formats the printf arguments of the FMI logger. pythonfmu passes none, but bare messages as the
        # format: an exception whose text holds %s would end the process there.
        if not self.made_by_pythonfmu:
            format_messages(self, id(self), callbacks)
            self._row = Row(id(self), self.log.logging == "all")
            callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(filtered(2, address_of(callbacks.logger)))
        return callbacks

    def _log(self, _environment: Any, _instance: bytes, status: int, category: bytes, message: bytes) -> None:
        text = (message or b"").decode("utf-8", "replace").strip()
        text = text.replace("%%", "%") if self.made_by_pythonfmu else text
        self.log.add(status, (category or b"").decode("utf-8", "replace"), text)

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        self.call("set up", "set up the experiment", self.slave.setupExperiment, self.tolerance, start, stop)
        self.promised = math.inf if stop is None else stop

    def enter_initialization(self) -> None:
        self.call("enter", "enter initialization", self.slave.enterInitializationMode)

    def step(self, time: float, length: float) -> None:
        try:
            self.call("step", f"step from t = {time:.9g} s", self.slave.doStep, time, self.within(time, length), False)
        except CallError as error:
            if error.status == DISCARD and self.terminated():
                raise AskedToEndError(
                    f"component {self.name} asked to end at {self.reached():.9g} s", DISCARD
                ) from error
            raise

    def terminated(self) -> bool:
        if not allowed(2, "ask", self.state) or made_here(self.fmu):  # ours discard a step after an error only
            return False
        try:
            return bool(self.slave.getBooleanStatus(fmi2.fmi2Terminated))
        except Exception:
            return False  # many FMUs do not answer

    def reached(self) -> float:
        if not allowed(2, "ask", self.state):
            return -math.inf
        try:
            return float(self.slave.getRealStatus(fmi2.fmi2LastSuccessfulTime))
        except Exception:
            return -math.inf
