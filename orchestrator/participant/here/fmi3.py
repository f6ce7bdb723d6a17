"""An instance of an FMI 3.0 FMU in this process: no intermediate update; with event mode see `event_mode.py`."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from typing import Any
from weakref import WeakValueDictionary

from fmpy import fmi3

from ...errors import FmuError
from ...fmu.binary import as_text
from ...fmu.types import Value
from ..apart.library import fresh_library
from ..base import AskedToEndError, CallError
from ..lifecycle import DISCARD, PREFIX, STATE_FUNCTIONS
from .library import Judged
from .loaded import LoadedInstance
from .message_filter import Row, address_of, filtered
from .refusal import refused

_LOGGING: WeakValueDictionary[int, Fmi3Instance] = WeakValueDictionary()  # by what the FMU is told of its environment


def _log_of_any(environment: Any, status: int, category: bytes, message: bytes) -> None:
    alone = next(iter(_LOGGING.values())) if len(_LOGGING) == 1 else None  # of an FMU that gives something else back
    instance = _LOGGING.get(environment) or alone
    if instance is not None:
        instance._log(status, category, message)


LOGGER = fmi3.fmi3LogMessageCallback(_log_of_any)


class FMU3Instance(Judged, fmi3.FMU3Slave):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class Fmi3Instance(LoadedInstance):
    """Loaded and instantiated by fmpy."""

    prefix = PREFIX[3]
    state_functions = STATE_FUNCTIONS[3]
    kind: type[Any] = FMU3Instance  # fmpy's, which binds the functions
    event_mode = False  # whether the FMU is told that events are handled, and that its steps may end early
    span: tuple[float, float | None] | None = None  # s, the start and the stop of the run

    def instantiate(self) -> None:
        try:
            with fresh_library(self.fmu) as library:
                self.slave = self.kind(
                    guid=self.fmu.description.instantiationToken,
                    modelIdentifier=str(library.with_suffix("")),  # of which fmpy makes the path of the library
                    unzipDirectory=str(self.fmu.folder),
                    instanceName=self.name,
                )
            _LOGGING[id(self)] = self
            self.slave.component = self._create()
            if not self.slave.component:
                raise FmuError("it gave no instance")
        except Exception as error:
            raise refused(self.fmu, self.name, error, self.reasons()) from error

    def _create(self) -> Any:
        """The instance, as fmpy makes it, with an environment by which its messages are known."""
        self._row = Row(id(self), self.log.logging == "all")
        slave, nothing = self.slave, fmi3.fmi3IntermediateUpdateCallback()
        logger = fmi3.fmi3LogMessageCallback(filtered(3, address_of(LOGGER)))
        self._callbacks: tuple[Any, ...] = logger, nothing  # alive as long as the FMU may call them
        folder = f"{self.fmu.folder / 'resources'}{os.sep}"
        return slave.fmi3InstantiateCoSimulation(
            self.name.encode(), slave.guid.encode(), folder.encode(), False, self.asked_for_all, self.event_mode,
            self.event_mode, (fmi3.fmi3ValueReference * 0)(), 0, id(self), logger, nothing,
        )  # fmt: skip

    def _log(self, status: int, category: bytes, message: bytes) -> None:
        words = ((part or b"").decode("utf-8", "replace").strip() for part in (category, message))
        self.log.add(status, *words)

    def free(self) -> None:
        super().free()
        _LOGGING.pop(id(self), None)  # what is said without saying by whom is said by another one now

    def configure(self, values: Mapping[str, Value]) -> None:
        if not values:
            return
        self.call("configure", "enter configuration mode", self.slave.enterConfigurationMode)
        self.set_own(values)
        shown = ", ".join(f"{name} = {as_text(value)}" for name, value in values.items())
        self.call("configured", f"leave configuration mode with {shown}", self.slave.exitConfigurationMode)
        if self.fmu.structure != values:
            self.fmu = self.fmu.with_structure(values)

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        self.require("set up", "set up the experiment")
        self.promised = math.inf if stop is None else stop
        self.span = start, stop  # FMI 3.0 is told when it enters initialization mode

    def enter_initialization(self) -> None:
        if self.span is None:
            raise CallError(f"component {self.name}: cannot enter initialization before it is set up")
        enter = self.slave.enterInitializationMode
        self.call("enter", "enter initialization", enter, self.tolerance, *self.span)

    def step(self, time: float, length: float) -> None:
        what = f"step from t = {time:.9g} s"
        length = self.within(time, length)
        _, terminates, early, reached = self.call("step", what, self.slave.doStep, time, length, False)
        if terminates:
            end = reached if early else time + length
            raise AskedToEndError(f"component {self.name} asked to end at {end:.9g} s", DISCARD)
        if early and reached < time + length:
            raise FmuError(f"component {self.name}: it ended the {what} early, at {reached:.9g} s{self.log_text()}")
