"""What instances of FMI 1.0, 2.0 and 3.0 in this process have in common: a library loaded by fmpy, and its states."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...errors import FmuError
from ...fmu.binary import as_text
from ...fmu.fmu import Fmu
from ...fmu.sharing import made_by_pythonfmu, made_here
from ...fmu.types import Value, function_type
from ..apart.leftovers import Leftovers
from ..apart.library import unload
from ..base import CallError, Participant, State
from ..lifecycle import allowed
from ..messages import Logging
from ..surroundings import Surroundings
from .message_filter import Row

FREE = {1: "fmi1FreeSlaveInstance", 2: "fmi2FreeInstance", 3: "fmi3FreeInstance"}  # as fmpy calls them
CATEGORIES = tuple(f"logStatus{name}" for name in ("Warning", "Discard", "Error", "Fatal"))


class LoadedInstance(Participant):
    """An instance whose library is in this process; `slave` is fmpy's. Raises FmuError if the FMU refuses."""

    slave: Any
    between = State.STEPPING  # where it is when a state that was kept elsewhere is restored

    def __init__(self, fmu: Fmu, name: str, logging: Logging = "all", tolerance: float | None = None) -> None:
        super().__init__(fmu, name, logging, tolerance)
        self._row: Row | None = None  # of the filter of its messages
        self._unread = 0  # messages that the filter had kept back when its row was given back
        self.arrays: dict[int, list[Value]] = {}  # values of arrays by reference: one element needs all the others
        self.modes: dict[int, State] = {}  # of saved states: restoring one brings its mode back
        self._arrays_then: dict[int, dict[int, list[Value]]] = {}  # `arrays` of saved states
        before, self._leftovers = Surroundings(), Leftovers()
        try:
            self.instantiate()
            self._choose_messages()
            self.missing = self.slave.missing
        finally:
            before.restore()  # fmpy stays in the folder of a library that it cannot load

    def instantiate(self) -> None:
        """Load and instantiate by fmpy. Raises FmuError if the FMU refuses."""
        raise NotImplementedError

    def bound(self, slave: Callable[..., Any], library: Path) -> Any:
        """The functions of a library as fmpy's class of FMI 1.0 or 2.0 binds them."""
        return slave(
            guid=self.fmu.description.guid,
            modelIdentifier=self.fmu.interface.modelIdentifier,
            unzipDirectory=str(self.fmu.folder),
            instanceName=self.name,
            libraryPath=str(library),
        )

    @property
    def asked_for_all(self) -> bool:
        """Whether it is to log all that it can: its maker was asked to, or it is ours or another in Python, which log
        little and give the reason of an error nowhere else."""
        return self.log.logging == "all" or made_by_pythonfmu(self.fmu) or made_here(self.fmu)

    def _choose_messages(self) -> None:
        """Of an FMU that is not to log: warnings and worse, of the categories that it declares."""
        declared = {category.name for category in self.fmu.description.logCategories}
        wanted = [name for name in CATEGORIES if name in declared]
        if wanted and not self.asked_for_all:
            with suppress(Exception):  # many FMUs have no such function, or one that does nothing
                self.slave.setDebugLogging(True, wanted)

    def look(self) -> None:
        if self._row:
            self._row.look()

    def logged(self) -> list[str]:
        return self.log.lines(self.name, self.unread)

    @property
    def unread(self) -> int:
        """Messages that the filter has kept back."""
        return self._row.counted if self._row else self._unread

    @property
    def pointer(self) -> int:
        return int(self.slave.component)

    def address(self, function: str) -> int:
        try:
            return ctypes.cast(getattr(self.slave.dll, function), ctypes.c_void_p).value or 0
        except AttributeError:
            raise FmuError(f"component {self.name}: {self.fmu.path.name} has no function {function}") from None

    def put(self, what: str, kind: str, references: Sequence[int], values: Sequence[Any]) -> None:
        """Set variables of one type (of FMI's functions: Real, Float64 ...) by value reference."""
        self.call("set", f"set {what}", getattr(self.slave, f"set{kind}"), references, values)

    def take(self, what: str, kind: str, references: Sequence[int], count: int) -> list[Any]:
        """The `count` values of variables of one type."""
        sizes = [count] if self.fmu.version == 3 else []
        found: list[Any] = self.call("get", f"get {what}", getattr(self.slave, f"get{kind}"), references, *sizes)
        return found

    def set_own(self, values: Mapping[str, Value]) -> None:
        fmu = self.fmu.own
        for name, value in values.items():
            self.require_settable(name)
            place, v = fmu.places[name], fmu.variables[name]
            sent = [place.turned(value)]
            if place.count > 1:
                known = self.arrays.setdefault(place.reference, [fmu.start(s) for s in fmu.arrays[name]])
                known[place.index] = value
                sent = known
            self.put(f"{name} = {as_text(value)}", function_type(self.fmu.version, v.type), [place.reference], sent)

    def get_own(self, name: str) -> Any:
        place, v = self.fmu.own.places[name], self.fmu.own.variables[name]
        kind = function_type(self.fmu.version, v.type)
        value = self.take(name, kind, [place.reference], place.count)[place.index]
        if v.type == "Boolean":
            return bool(value)
        if v.type == "Binary":
            return bytes(value or b"")
        value = place.turned(value)
        return value.decode("utf-8", "replace") if isinstance(value, bytes) else "" if value is None else value

    def exit_initialization(self) -> None:
        self.call("exit", "leave initialization", self.slave.exitInitializationMode)

    def save(self) -> int:
        self.require_state()
        state = int(self.call("save", "save its state", self.slave.getFMUState).value)
        self._note(state)
        return state

    def _note(self, state: int) -> None:
        """Keep with a saved state what is known here and not by the FMU."""
        self.modes[state] = self.state
        self._arrays_then[state] = {reference: list(values) for reference, values in self.arrays.items()}

    def _recall(self, state: int) -> None:
        """The same, of a state that is restored."""
        self.state = self.modes.get(state, self.between)
        if state in self._arrays_then:
            self.arrays = {reference: list(values) for reference, values in self._arrays_then[state].items()}

    def restore(self, state: int) -> None:
        self.call("restore", "restore its state", self.slave.setFMUState, ctypes.c_void_p(state))
        self._recall(state)

    def forget(self, state: int) -> None:
        self.call("forget", "forget a state", self.slave.freeFMUState, ctypes.c_void_p(state))
        self._unnote(state)

    def _unnote(self, state: int) -> None:
        self.modes.pop(state, None)
        self._arrays_then.pop(state, None)

    def serialize(self, state: int) -> bytes:
        return bytes(self.call("serialize", "write its state", self.slave.serializeFMUState, ctypes.c_void_p(state)))

    def deserialize(self, content: bytes) -> int:
        return int(self.call("deserialize", "read a state", self.slave.deserializeFMUState, content).value)

    def terminate(self) -> None:
        """End the simulation; outputs can still be read."""
        self.call("terminate", "terminate", self.slave.terminate)

    def reset(self) -> None:
        """Back to the state behind `instantiate`."""
        self.call("reset", "reset", self.slave.reset)

    def free(self) -> None:
        """Free the instance. Its library stays loaded where that is not safe: Python inside, threads that go on."""
        free = getattr(self.slave, FREE[self.fmu.version])
        self.call("free", "free it", free, self.slave.component)
        if not self._leftovers.any():
            unload(self.fmu, self.slave.dll)

    def close(self) -> str:
        said = []
        for action, function in (("cancel", self.cancel), ("terminate", self.terminate), ("free", self.free)):
            if not self.dead and allowed(self.fmu.version, action, self.state):
                try:
                    function()
                except CallError as error:
                    said.append(str(error))
        if self._row:
            self._unread = self._row.counted
            self._row.give_back()
            self._row = None
        return "\n".join(said)

    def cancel(self) -> None:
        """Give up a step that goes on (fmi2Pending)."""
        self.call("cancel", "cancel a step", self.slave.cancelStep)
