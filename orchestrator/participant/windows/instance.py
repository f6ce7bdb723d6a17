"""Instances of FMUs for Windows: what fmpy does for each version of FMI, with functions that are called under wine."""

from __future__ import annotations

import re
from functools import cache
from pathlib import PureWindowsPath
from typing import Any

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ..base import CallError, State
from ..here.fmi1 import KIND, Fmi1Instance, FMU1Instance
from ..here.fmi2 import Fmi2Instance, FMU2Instance
from ..here.fmi3 import Fmi3Instance, FMU3Instance
from ..here.loaded import FREE, LoadedInstance
from ..here.message_filter import AT_A_TIME, AT_FIRST
from ..here.refusal import NotLoadedError, refused
from ..isolated.callbacks import Callbacks
from ..isolated.child_process import ProcessLostError
from ..lifecycle import FATAL
from ..messages import Logging
from .library import WindowsLibrary
from .memory import DO
from .process import ServerProcess, windows_path

TIMEOUT = 60.0  # s of a call, where nobody says
ALL = (1 << 31) - 1  # messages that pass


class WindowsInstance(LoadedInstance):
    """What is the same for all versions. `timeout` [s] for each call; `process`: one that was started before.

    Raises FmuError if the FMU refuses.
    """

    def __init__(
        self, fmu: Fmu, name: str, logging: Logging = "all", tolerance: float | None = None, timeout: float = TIMEOUT,
        process: ServerProcess | None = None,
    ) -> None:  # fmt: skip
        self.timeout = timeout
        self.process = process or ServerProcess(fmu.own)
        self.page = self.process.memory.page
        super().__init__(fmu, name, logging, tolerance)

    instantiates = ""  # the function that makes an instance
    choice = 0  # what that is told: see `library.WindowsLibrary.instantiate`
    slave_kind: Any  # fmpy's class, which binds the functions

    def instantiate(self) -> None:
        fmu, everything = self.fmu.own, self.log.logging == "all"
        self.page.lowest, self.page.allowance = (0, ALL) if everything else (1, AT_FIRST)
        callbacks = Callbacks(fmu.version, self.process.memory, self._of_the_loop, self._refuse, self._broken_off)
        identifier = str(fmu.interface.modelIdentifier)
        self.remote = WindowsLibrary(fmu.version, identifier, self.process, self._ask, callbacks)
        try:
            self.remote.load(fmu.library, _names(self.slave_kind), self.timeout)
            self.slave = self._slave(identifier)
            self.slave.component = self.remote.instantiate(
                self.instantiates, self._texts(), self.asked_for_all, self.choice
            )
            if not self.slave.component:
                raise FmuError(self.fault or "it gave no instance")
        except NotLoadedError as error:
            self.process.close()
            said = f"component {self.name}: {fmu.path.name} cannot be instantiated: {error}"
            raise NotLoadedError(f"{said}{error.mend and f'; {error.mend}'}", error.mend) from error
        except Exception as error:
            self.process.close()
            raise refused(self.fmu, self.name, error, self.reasons()) from error
        except BaseException:
            self.process.close()
            raise

    def _slave(self, identifier: str) -> Any:
        """fmpy's, which would load a library of this process."""
        slave = self.slave_kind.__new__(self.slave_kind)
        slave.guid, slave.modelIdentifier = self.fmu.description.guid, identifier
        slave.unzipDirectory, slave.instanceName = str(self.fmu.folder), self.name
        slave.fmiCallLogger, slave.requireFunctions, slave.callbacks = None, True, None
        slave._functions, slave.dll = {}, self.remote
        slave._loadFunctions()
        return slave

    def _texts(self) -> list[str]:
        """What it is told when it is instantiated: its name, its token, where its resources are, and what it is."""
        d, folder = self.fmu.description, str(self.fmu.folder)
        if self.fmu.version == 3:
            return [self.name, d.instantiationToken, windows_path(f"{folder}/resources/"), ""]
        place = folder if self.fmu.version == 1 else f"{folder}/resources"
        return [self.name, d.guid, PureWindowsPath(windows_path(place)).as_uri(), KIND]

    # --- calls ---

    def _ask(self, operation: int) -> int:
        """Have a request done: the FMU's status; Fatal, with `fault` set, where the process is lost."""
        if self.dead:
            return FATAL
        try:
            self.process.ask(operation, self.timeout)
        except ProcessLostError as error:
            self._lost(str(error))
        if self.page.written:
            for message in self.process.memory.take_messages():
                self.log.add(*message)
        return FATAL if self.fault else self.page.status

    def _of_the_loop(self, _kind: str, packed: bytes) -> int:
        self.process.memory.put_call(packed)
        return self._ask(DO)

    def _lost(self, fault: str) -> None:
        """What befell the process; the first counts."""
        self.fault = self.fault or fault
        self.state = State.DEAD

    def _refuse(self, fault: str) -> int:
        """Something that cannot be passed on."""
        self.fault = fault
        return FATAL

    def _broken_off(self, error: type[BaseException]) -> None:
        """An exception came while a call was waited for: nobody knows what became of that."""
        what = "a second Ctrl-C" if issubclass(error, KeyboardInterrupt) else error.__name__
        self._lost(f"its call was broken off by {what}")
        self.process.kill()

    def call(self, action: str, what: str, function: Any, *arguments: Any) -> Any:
        before = self.fault
        try:
            found = super().call(action, what, function, *arguments)
        except CallError as error:
            if self.fault == before:
                raise
            raise self._fell(what) from error
        if self.fault != before:
            raise self._fell(what)
        return found

    def _fell(self, what: str) -> CallError:
        self.state = State.DEAD
        return CallError(f"component {self.name}: {self.fault} in the call `{what}`{self.log_text()}")

    # --- messages, and the end ---

    def look(self) -> None:
        if self.process.memory.base:
            self.page.allowance = max(self.page.allowance, AT_A_TIME)
            self.process.pass_on()

    @property
    def unread(self) -> int:
        return int(self.page.kept_back) if self.process.memory.base else self._unread

    def free(self) -> None:
        self.call("free", "free it", getattr(self.slave, FREE[self.fmu.version]), self.slave.component)

    def close(self) -> str:
        said = super().close()
        self._unread = self.unread
        self.process.close()
        return said


class Windows1Instance(WindowsInstance, Fmi1Instance):
    """Of FMI 1.0."""

    instantiates, slave_kind = "fmiInstantiateSlave", FMU1Instance


class Windows2Instance(WindowsInstance, Fmi2Instance):
    """Of FMI 2.0."""

    instantiates, choice, slave_kind = "fmi2Instantiate", 1, FMU2Instance


class Windows3Instance(WindowsInstance, Fmi3Instance):
    """Of FMI 3.0."""

    instantiates, slave_kind = "fmi3InstantiateCoSimulation", FMU3Instance


@cache
def _names(kind: Any) -> list[str]:
    """The functions that fmpy looks for, as the standard calls them."""
    found = [name for name in dir(kind) if re.match(r"fmi\d", name)]
    return [name.replace("fmi1", "fmi", 1) for name in found]
