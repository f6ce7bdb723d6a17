"""An instance of an FMI 3.0 FMU in this process: no event mode, no early return, no intermediate update."""

from __future__ import annotations

from typing import Any

from fmpy import fmi3

from ..fmu.fmu import Fmu
from .base import refused
from .loaded import LoadedInstance


class Fmi3Instance(LoadedInstance):
    """Loaded and instantiated by fmpy. Raises FmuError if the FMU refuses."""

    prefix = "fmi3"
    state_functions = ("fmi3GetFMUState", "fmi3SetFMUState", "fmi3FreeFMUState")

    def __init__(self, fmu: Fmu, name: str) -> None:
        super().__init__(fmu, name)
        try:
            self.slave = fmi3.FMU3Slave(
                guid=fmu.description.instantiationToken,
                modelIdentifier=fmu.interface.modelIdentifier,
                unzipDirectory=str(fmu.folder),
                instanceName=name,
            )
            self.slave.instantiate(loggingOn=True, logMessage=self._log)
        except Exception as error:
            raise refused(fmu, name, error, self.log_text()) from error

    def _log(self, _environment: Any, status: int, _category: bytes, message: bytes) -> None:
        if status > 0 and message:
            self.messages.append(message.decode("utf-8", "replace").strip())

    def enter_initialization(self, stop: float) -> None:
        self.call("enter initialization", self.slave.enterInitializationMode, None, 0.0, stop)

    def exit_initialization(self) -> None:
        self.call("leave initialization", self.slave.exitInitializationMode)

    def deserialize(self, content: bytes) -> int:
        return int(self.call("read a state", self.slave.deserializeFMUState, content).value)

    def free(self) -> None:
        self.slave.fmi3FreeInstance(self.slave.component)
