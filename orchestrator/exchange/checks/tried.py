"""A participant under check: statuses as numbers, outputs as bytes.

Nothing here protects the process: it is made to be lost (`dry_run.py`).
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from typing import Any, ClassVar

from fmpy.model_description import ModelVariable

from ...fmu.fmu import Fmu
from ...fmu.kinds import usual_kind
from ...fmu.types import REALS, function_type
from ...participant.base import AskedToEndError, CallError
from ...participant.lifecycle import FATAL, STATUS, status_text
from ...participant.opening import load
from .subject import Subject, bounds, numbers, size


class RefusedError(Exception):
    """A call that should have succeeded did not; the text says which, the status and the FMU's own words."""


class EndedError(RefusedError):
    """The FMU asked to end the simulation in that call, which may be its right."""


class Tried:
    """One instance. Methods that make an FMI call return its status; `must` raises RefusedError unless it is good.

    Calls follow the standard's order, but under `unguarded`. Raises FmuError if the FMU cannot be instantiated.
    """

    doomed: ClassVar[bool] = False  # after Fatal no instance in the process may be called (FMI 2.0.4, 2.1.3)

    def __init__(self, subject: Subject, name: str = "tried") -> None:
        self.subject = subject
        fmu = Fmu(
            subject.path, subject.folder, "", subject.description, {}, negated=subject.negated,
            details=subject.details, kind=usual_kind(subject.description),
        )  # fmt: skip
        self.instance = load(fmu, name)
        self.ended = False  # whether it asked to end the simulation in the call that was refused last
        self.unguarded = self.instance.unguarded
        self.outputs = [v for v in subject.of("output") if v.type != "Binary" and not v.clocks]
        self.at_events = bool(fmu.clocks)  # steps go over its events then, and what is discrete is set there only

    @property
    def messages(self) -> list[str]:
        """What the FMU has logged."""
        return list(self.instance.messages)

    def status(self, function: Callable[..., Any], *arguments: Any) -> int:
        """Call and give back the status: 0 for OK and Warning, otherwise that of the FMU."""
        try:
            function(*arguments)
        except CallError as error:
            self.ended = isinstance(error, AskedToEndError)
            if error.status is None:
                raise
            if error.status == FATAL or error.status not in STATUS:
                Tried.doomed = True
            return error.status
        return 0

    def must(self, what: str, status: int) -> None:
        """Raises RefusedError unless the status is a good one."""
        if status:
            words = f": {self.messages[-1].splitlines()[-1]}" if self.messages else ""
            name = STATUS.get(status) or status_text("", status)
            kind = EndedError if self.ended else RefusedError
            raise kind(f"{what} returned {name}{words}")

    # --- variables ---

    def set(self, v: ModelVariable, values: list[Any]) -> int:
        """Set a variable, element by element."""
        if v.type not in (*REALS, "String"):
            values = [bool(value) if v.type == "Boolean" else int(value) for value in values]
        kind = function_type(self.subject.version, v.type)
        return self.status(self.instance.put, v.name, kind, [v.valueReference], values)

    def get(self, v: ModelVariable) -> list[Any]:
        """The elements of a variable. Raises RefusedError."""
        kind, found = function_type(self.subject.version, v.type), []
        status = self.status(lambda: found.extend(self.instance.take(v.name, kind, [v.valueReference], size(v))))
        self.must(f"get {v.name}", status)
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
        """Say when the simulation begins."""
        return self.status(self.instance.set_up, None, self.subject.start_time)

    def enter(self) -> int:
        """Enter initialization mode."""
        return self.status(self.instance.enter_initialization)

    def exit(self) -> int:
        """Leave initialization mode."""
        return self.status(self.instance.exit_initialization)

    def terminate(self) -> int:
        """End the simulation."""
        return self.status(self.instance.terminate)

    def begin(self) -> None:
        """From a new instance to time 0 with start values. Raises RefusedError."""
        self.must("setupExperiment", self.setup())
        self.set_starts()
        self.must("enterInitializationMode", self.enter())
        self.must("exitInitializationMode", self.exit())

    def step(self, t: float, h: float) -> int:
        """One communication step."""
        return self.status(self.instance.step, t, h)

    def stir(self, first: int, steps: int, phase: float = 0.0) -> list[bytes]:
        """Steps with inputs that change all the time; all outputs after each. Raises RefusedError."""
        h, seen = self.subject.step, []
        inputs = [v for v in self.subject.of("input") if v.type in REALS]
        if self.at_events:
            inputs = [v for v in inputs if v.variability == "continuous" and not v.clocks]
        for k in range(first, first + steps):
            for number, v in enumerate(inputs):
                starts = self.start_values(v) or [0.0] * size(v)
                values = [stirred(v, start, 0.3 * k + number + j + phase) for j, start in enumerate(starts)]
                self.must(f"set {v.name}", self.set(v, values))
            t = self.subject.start_time + k * h
            self.must(f"doStep at t = {t:g} s", self.step(t, h))
            seen.append(self.observed())
        return seen

    def save(self) -> int:
        """Keep the state; a handle. Raises RefusedError, as the next four do."""
        kept: list[int] = []
        self.must("getFMUstate", self.status(lambda: kept.append(self.instance.save())))
        return kept[0]

    def restore(self, state: int) -> None:
        self.must("setFMUstate", self.status(self.instance.restore, state))

    def forget(self, state: int) -> None:
        self.must("freeFMUstate", self.status(self.instance.forget, state))

    def serialize(self, state: int) -> bytes:
        content: list[bytes] = []
        self.must("serializeFMUstate", self.status(lambda: content.append(self.instance.serialize(state))))
        return content[0]

    def deserialize(self, content: bytes) -> int:
        kept: list[int] = []
        self.must("deSerializeFMUstate", self.status(lambda: kept.append(self.instance.deserialize(content))))
        return kept[0]

    def close(self) -> None:
        """Terminate and release, unless the instance is lost. The library stays loaded: some cannot be unloaded."""
        if not self.instance.dead:
            self.must("terminate", self.terminate())
            self.free()

    def free(self) -> None:
        """Release without terminating."""
        if not self.instance.dead:
            self.instance.free()


def stirred(v: ModelVariable, start: float, angle: float) -> float:
    """A value near the start value and inside the range."""
    low, high = bounds(v)
    value = start + 0.01 * (float(v.nominal or 0.0) or abs(start) or 1.0) * math.sin(angle)
    return min(max(value, value if low is None else low), value if high is None else high)
