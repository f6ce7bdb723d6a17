"""The instance of a participant that is no FMU: the addresses of the loop as callbacks into a Python object."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ...fmu.outside.declared import DeclaredFmu
from ...fmu.outside.model import Model, StepFailedError
from ...fmu.types import Value
from ..base import CallError, Participant
from ..lifecycle import ERROR, OK, PREFIX, STATE_FUNCTIONS, allowed, good
from ..messages import Logging
from .opening import model_of

POINTER, DOUBLE, SIZE, INT = ctypes.c_void_p, ctypes.c_double, ctypes.c_size_t, ctypes.c_int
CELLS: dict[str, tuple[Any, Callable[[Any], Any]]] = {  # of the functions of each type: in memory, and in Python
    "Real": (DOUBLE, float), "Integer": (INT, int), "Boolean": (INT, bool),
}  # fmt: skip
FUNCTIONS = {f"{PREFIX[2]}{do}{kind}": (do, kind) for do in ("Set", "Get") for kind in CELLS}


class DeclaredInstance(Participant):
    """An instance of a DeclaredFmu."""

    prefix = PREFIX[2]
    state_functions = STATE_FUNCTIONS[2]
    fmu: DeclaredFmu

    def __init__(self, fmu: DeclaredFmu, name: str, logging: Logging = "all", tolerance: float | None = None) -> None:
        super().__init__(fmu, name, logging, tolerance)
        self.names = {v.valueReference: v.name for v in fmu.description.modelVariables}
        self.model: Model = model_of(fmu, name)
        self.states: dict[int, Any] = {}
        self.handles = 0
        self._why = ""  # the last step failed
        self._callbacks: dict[str, Any] = {}
        self._closed = False
        self._known: dict[bytes, list[str]] = {}

    @property
    def pointer(self) -> int:
        code = self.model.machine_code()
        return 1 if code is None else code["pointer"]

    def address(self, function: str) -> int:
        code = self.model.machine_code() or {}
        if function in code:
            return code[function]
        if function not in self._callbacks:
            answer, arguments = self._answer(function)
            self._callbacks[function] = ctypes.CFUNCTYPE(INT, *arguments)(self._answering(answer))
        return ctypes.cast(self._callbacks[function], POINTER).value or 0

    def _answer(self, function: str) -> tuple[Callable[..., int | None], tuple[Any, ...]]:
        if function in FUNCTIONS:
            do, kind = FUNCTIONS[function]
            return (self._setter if do == "Set" else self._getter)(*CELLS[kind]), (POINTER, POINTER, SIZE, POINTER)
        if function == "fmi2DoStep":
            return self._step, (POINTER, DOUBLE, DOUBLE, INT)
        pairs = dict(zip(self.state_functions, (self._save, self._restore, self._forget), strict=True))
        if function not in pairs:
            raise CallError(f"component {self.name}: a {self.fmu.what} has no function {function}")
        return pairs[function], (POINTER, POINTER)

    def _answering(self, function: Callable[..., int | None]) -> Callable[..., int]:
        def answer(*arguments: Any) -> int:
            try:
                return function(*arguments) or OK
            except KeyboardInterrupt:
                self._why = "interrupted by the user"
                return ERROR
            except StepFailedError as error:
                self._why = str(error)
                return ERROR
            except Exception as error:
                self.log.add(ERROR, "", str(error) or type(error).__name__)
                return ERROR

        return answer

    def _setter(self, cell: Any, read: Callable[[Any], Any]) -> Callable[..., int | None]:
        def set_(_instance: int, references: int, count: int, values: int) -> int | None:
            given = (cell * count).from_address(values)[:]
            found = dict(zip(self._named(references, count), given if read is float else map(read, given), strict=True))
            self.model.told("set", found)
            return self.model.set(found)

        return set_

    def _getter(self, cell: Any, _read: Callable[[Any], Any]) -> Callable[..., int | None]:
        def get(_instance: int, references: int, count: int, values: int) -> int | None:
            (cell * count).from_address(values)[:] = self.model.get(self._named(references, count))
            return None

        return get

    def _named(self, references: int, count: int) -> list[str]:
        """The variables at value references; the loop asks for the same ones again and again."""
        content = ctypes.string_at(references, 4 * count)
        found = self._known.get(content)
        if found is None:
            found = self._known[content] = [self.names[r] for r in (ctypes.c_uint32 * count).from_address(references)]
        return found

    def _step(self, _instance: int, time: float, length: float, _final: int) -> int | None:
        self.model.told("step", time, length)
        return self.model.step(time, length)

    def _save(self, _instance: int, cell: int) -> None:
        self.model.told("save")
        POINTER.from_address(cell).value = self._kept(self.model.save())

    def _restore(self, _instance: int, state: int) -> None:
        self.model.told("restore")
        self.model.restore(self.states[state])

    def _forget(self, _instance: int, cell: int) -> None:
        self.states.pop(POINTER.from_address(cell).value or 0)
        POINTER.from_address(cell).value = None

    def _kept(self, state: Any) -> int:
        self.handles += 1
        self.states[self.handles] = state
        return self.handles

    # --- by name ---

    def _do(self, action: str, what: str, function: Callable[[], int | None], *told: Any) -> None:
        self.require(action, what)
        self.model.told(action, *told)
        try:
            status = function() or OK
        except Exception as error:
            self.noted(action, ERROR)
            raise CallError(f"component {self.name}: cannot {what}: {error}{self.log_text()}", ERROR) from error
        self.noted(action, status)
        if not good(status):
            raise CallError(f"component {self.name}: cannot {what}{self.reasons()}", status)

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        self._do("set up", "be set up", lambda: self.model.set_up(start, stop), self.tolerance, start, stop)
        self.promised = math.inf if stop is None else stop

    def set_own(self, values: Mapping[str, Value]) -> None:
        for name in values:
            self.require_settable(name)
        typed = {name: CELLS[self.fmu.variables[name].type][1](value) for name, value in values.items()}
        self._do("set", f"set {', '.join(values)}", lambda: self.model.set(typed), typed)

    def get_own(self, name: str) -> Any:
        found: Sequence[Any] = self.call("get", f"get {name}", self.model.get, [name])
        return found[0]

    def enter_initialization(self) -> None:
        self._do("enter", "enter initialization", lambda: None)

    def exit_initialization(self) -> None:
        self._do("exit", "leave initialization", self.model.initialized)

    def step(self, time: float, length: float) -> None:
        step = self.within(time, length)
        self._do("step", f"step from {time:g} s", lambda: self.model.step(time, step), time, step)

    def save(self) -> int:
        self.require_state()
        self.require("save", "save its state")
        return self._kept(self.model.save())

    def restore(self, state: int) -> None:
        self.require("restore", "restore its state")
        self.model.restore(self.states[state])

    def forget(self, state: int) -> None:
        self.states.pop(state)

    def serialize(self, state: int) -> bytes:
        self._require_written()
        try:
            return self.model.written(self.states[state])
        except (TypeError, ValueError) as error:
            raise CallError(f"component {self.name}: its state cannot be written to disk: {error}") from error

    def deserialize(self, content: bytes) -> int:
        self._require_written()
        return self._kept(self.model.read(content))

    def _require_written(self) -> None:
        if not self.fmu.can_serialize_state:
            raise CallError(f"component {self.name}: a {self.fmu.what} has no states for the disk")

    def reasons(self) -> str:
        """Its log; there is nothing to be asked to talk more."""
        return self.log_text()

    def notes(self) -> list[str]:
        return self.model.notes()

    def why_failed(self) -> str:
        return self._why or self.model.why_failed()

    def close(self) -> str:
        faults = []
        for action in ("terminate", "free"):
            if not self.dead and allowed(2, action, self.state):
                self._do(action, action, lambda: None)
        if not self._closed:
            self._closed = True
            try:
                self.model.close()
            except Exception as error:
                faults.append(f"component {self.name}: {error} in its end")
        return "\n".join(faults)
