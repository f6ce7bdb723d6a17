"""An instance of an FMI 3.0 FMU in this process: no event mode, no early return, no intermediate update."""

from __future__ import annotations

from typing import Any

from fmpy import fmi3

from ..errors import FmuError
from .base import CallError, refused
from .loaded import Judged, LoadedInstance


class FMU3Instance(Judged, fmi3.FMU3Slave):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class Fmi3Instance(LoadedInstance):
    """Loaded and instantiated by fmpy."""

    prefix = "fmi3"
    state_functions = ("fmi3GetFMUState", "fmi3SetFMUState", "fmi3FreeFMUState")
    span: tuple[float, float | None] | None = None  # s, the start and the stop of the run

    def instantiate(self) -> None:
        try:
            self.slave = FMU3Instance(
                guid=self.fmu.description.instantiationToken,
                modelIdentifier=self.fmu.interface.modelIdentifier,
                unzipDirectory=str(self.fmu.folder),
                instanceName=self.name,
            )
            self.slave.instantiate(loggingOn=True, logMessage=self._log)
        except Exception as error:
            raise refused(self.fmu, self.name, error, self.log_text()) from error

    def _log(self, _environment: Any, status: int, _category: bytes, message: bytes) -> None:
        if status > 0 and message:
            self.messages.append(message.decode("utf-8", "replace").strip())

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        self.require("set up", "set up the experiment")
        self.span = start, stop  # FMI 3.0 is told when it enters initialization mode

    def enter_initialization(self) -> None:
        if self.span is None:
            raise CallError(f"component {self.name}: cannot enter initialization before it is set up")
        enter = self.slave.enterInitializationMode
        self.call("enter", "enter initialization", enter, self.tolerance, *self.span)

    def step(self, time: float, length: float) -> None:
        what = f"step from t = {time:.9g} s"
        _, terminates, early, reached = self.call("step", what, self.slave.doStep, time, length, False)
        if terminates or (early and reached < time + length):
            raise FmuError(f"component {self.name}: it ended the {what} early, at {reached:.9g} s{self.log_text()}")
