"""A loaded instance of an FMU under check: FMI 2.0 and 3.0 behind one face, statuses as numbers, outputs as bytes.

fmpy loads the library and makes the calls. Nothing here protects the process: it is made to be lost (`dry_run.py`).
"""

from __future__ import annotations

import ctypes
import math
import struct
from collections.abc import Callable
from typing import Any, ClassVar

import fmpy
from fmpy import fmi2, fmi3
from fmpy.fmi1 import FMICallException
from fmpy.model_description import ModelVariable

from ...participant.base import STATUS
from .subject import REALS, Subject, bounds, numbers, size

REFUSED = 2  # statuses from here on (Discard, Error, Fatal) refuse a call
FATAL = 4


class RefusedError(Exception):
    """A call that should have succeeded did not; the text says which, the status and the FMU's own words."""


class Tried:
    """One instance. Methods that make an FMI call return its status; `must` raises RefusedError unless it is good."""

    doomed: ClassVar[bool] = False  # after Fatal no instance in the process may be called (FMI 2.0.4, 2.1.3)

    def __init__(self, subject: Subject, name: str = "tried") -> None:
        self.subject, self.name = subject, name
        self.messages: list[str] = []
        self.lost = False  # after Fatal nothing may be called, not even the release
        kind = fmi2.FMU2Slave if subject.version == 2 else fmi3.FMU3Slave
        self.slave: Any = kind(
            guid=subject.description.guid, modelIdentifier=subject.interface.modelIdentifier,
            unzipDirectory=str(subject.folder), instanceName=name,
        )  # fmt: skip
        if subject.version == 2:
            self.callbacks = self._callbacks()
            self.slave.instantiate(callbacks=self.callbacks, loggingOn=True)
        else:
            self.slave.instantiate(loggingOn=True, logMessage=self._log3)
        self.outputs = [v for v in subject.of("output") if v.type != "Binary"]

    def _callbacks(self) -> Any:
        callbacks = fmi2.fmi2CallbackFunctions()
        callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(self._log2)
        callbacks.allocateMemory = fmi2.defaultCallbacks.allocateMemory
        callbacks.freeMemory = fmi2.defaultCallbacks.freeMemory
        # The proxy formats printf arguments; pythonfmu passes bare messages as the format (see orchestrator/fmu.py).
        if not (self.subject.folder / "resources" / "slavemodule.txt").is_file():
            fmpy.logging.addLoggerProxy(ctypes.byref(callbacks))
        return callbacks

    def _log2(self, _environment: Any, _instance: bytes, status: int, _category: bytes, message: bytes) -> None:
        if status > 0 and message:
            self.messages.append(message.decode("utf-8", "replace").strip())

    def _log3(self, _environment: Any, status: int, _category: bytes, message: bytes) -> None:
        if status > 0 and message:
            self.messages.append(message.decode("utf-8", "replace").strip())

    def status(self, function: Callable[..., Any], *arguments: Any, **options: Any) -> int:
        """Call and give back the status: 0 OK or Warning, otherwise that of the FMU."""
        try:
            function(*arguments, **options)
        except FMICallException as error:
            if error.status >= FATAL:
                self.lost = Tried.doomed = True
            return int(error.status)
        return 0

    def must(self, what: str, status: int) -> None:
        """Raises RefusedError unless the status is a good one."""
        if status:
            words = f": {self.messages[-1].splitlines()[-1]}" if self.messages else ""
            raise RefusedError(f"{what} returned {STATUS.get(status, status)}{words}")

    # --- variables ---

    def set(self, v: ModelVariable, values: list[Any]) -> int:
        """Set a variable, element by element."""
        kind = v.type
        if self.subject.version == 2:
            kind = "Integer" if kind == "Enumeration" else kind
        elif kind == "Enumeration":
            kind = "Int64"
        if kind not in (*REALS, "String"):
            values = [bool(value) if kind == "Boolean" else int(value) for value in values]
        return self.status(getattr(self.slave, f"set{kind}"), [v.valueReference], values)

    def get(self, v: ModelVariable) -> list[Any]:
        """The elements of a variable. Raises RefusedError."""
        kind = {2: "Integer", 3: "Int64"}[self.subject.version] if v.type == "Enumeration" else v.type
        getter = getattr(self.slave, f"get{kind}")
        many = {} if self.subject.version == 2 else {"nValues": size(v)}
        found: list[Any] = []
        self.must(f"get {v.name}", self.status(lambda: found.extend(getter([v.valueReference], **many))))
        return found

    def start_values(self, v: ModelVariable) -> list[Any]:
        """The declared start, one value per element; empty if there is none."""
        if v.start is None or v.type == "Binary":
            return []
        if v.type == "String":
            return [v.start]
        values = numbers(v.start)
        return values * size(v) if len(values) == 1 else values

    def observed(self) -> bytes:
        """All outputs, bit by bit."""
        parts = []
        for v in self.outputs:
            for value in self.get(v):
                parts.append(struct.pack("<d", value) if isinstance(value, float) else repr(value).encode())
        return b"|".join(parts)

    def not_finite(self) -> list[str]:
        """Names of the Real outputs that are infinite or not a number."""
        return [v.name for v in self.outputs if v.type in REALS and not all(map(math.isfinite, self.get(v)))]

    # --- life cycle ---

    def set_starts(self) -> None:
        """Set every parameter and input to its own start value. Raises RefusedError."""
        for v in self.subject.of("parameter", "input"):
            values = self.start_values(v)
            if values:
                self.must(f"set {v.name} to its start value", self.set(v, values))

    def setup(self) -> int:
        """FMI 2.0's fmi2SetupExperiment; nothing in FMI 3.0."""
        if self.subject.version == 3:
            return 0
        return self.status(self.slave.setupExperiment, startTime=self.subject.start_time)

    def enter(self) -> int:
        """Enter initialization mode."""
        options = {} if self.subject.version == 2 else {"startTime": self.subject.start_time}
        return self.status(self.slave.enterInitializationMode, **options)

    def exit(self) -> int:
        """Leave initialization mode."""
        return self.status(self.slave.exitInitializationMode)

    def begin(self) -> None:
        """From a new instance to time 0 with start values. Raises RefusedError."""
        self.must("setupExperiment", self.setup())
        self.set_starts()
        self.must("enterInitializationMode", self.enter())
        self.must("exitInitializationMode", self.exit())

    def step(self, t: float, h: float) -> int:
        """One communication step."""
        return self.status(self.slave.doStep, t, h)

    def stir(self, first: int, steps: int, phase: float = 0.0) -> list[bytes]:
        """Steps with inputs that change all the time; all outputs after each. Raises RefusedError."""
        h, seen = self.subject.step, []
        inputs = [v for v in self.subject.of("input") if v.type in REALS]
        for k in range(first, first + steps):
            for number, v in enumerate(inputs):
                starts = self.start_values(v) or [0.0] * size(v)
                values = [stirred(v, start, 0.3 * k + number + j + phase) for j, start in enumerate(starts)]
                self.must(f"set {v.name}", self.set(v, values))
            t = self.subject.start_time + k * h
            self.must(f"doStep at t = {t:g} s", self.step(t, h))
            seen.append(self.observed())
        return seen

    def close(self) -> None:
        """Terminate and release, unless the instance is lost. The library stays loaded: some cannot be unloaded."""
        if not self.lost:
            self.must("terminate", self.status(self.slave.terminate))
            self.free()

    def free(self) -> None:
        """Release without terminating."""
        if not self.lost:
            getattr(self.slave, f"fmi{self.subject.version}FreeInstance")(self.slave.component)
            self.lost = True


def stirred(v: ModelVariable, start: float, angle: float) -> float:
    """A value near the start value and inside the range."""
    low, high = bounds(v)
    value = start + 0.01 * (float(v.nominal or 0.0) or abs(start) or 1.0) * math.sin(angle)
    return min(max(value, value if low is None else low), value if high is None else high)
