"""The instance of a mock (`fmu/mock.py`): the five addresses of the loop as callbacks into a Python object."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from typing import Any

from ..fmu.mock import MockFmu
from ..fmu.types import Value
from .base import CallError, Participant
from .lifecycle import ERROR, OK, allowed, good

POINTER, DOUBLE, SIZE, INT = ctypes.c_void_p, ctypes.c_double, ctypes.c_size_t, ctypes.c_int


class MockInstance(Participant):
    """An instance of a MockFmu."""

    prefix = "fmi2"
    state_functions = ("fmi2GetFMUstate", "fmi2SetFMUstate", "fmi2FreeFMUstate")
    fmu: MockFmu

    def __init__(self, fmu: MockFmu, name: str, tolerance: float | None = None) -> None:
        super().__init__(fmu, name, tolerance=tolerance)
        self.names = {v.valueReference: v.name for v in fmu.description.modelVariables}
        self.model = fmu.model({v: float(fmu.start(v)) for v in fmu.variables})
        fmu.made.append(self.model)
        self.states: dict[int, dict[str, float]] = {}
        self.handles = 0
        self._callbacks: dict[str, Any] = {}

    @property
    def pointer(self) -> int:
        return 1

    def address(self, function: str) -> int:
        pairs: dict[str, tuple[Callable[..., int | None], tuple[Any, ...]]] = {
            "fmi2SetReal": (self._set, (POINTER, POINTER, SIZE, POINTER)),
            "fmi2GetReal": (self._get, (POINTER, POINTER, SIZE, POINTER)),
            "fmi2DoStep": (self._step, (POINTER, DOUBLE, DOUBLE, INT)),
            "fmi2GetFMUstate": (self._save, (POINTER, POINTER)),
            "fmi2SetFMUstate": (self._restore, (POINTER, POINTER)),
            "fmi2FreeFMUstate": (self._forget, (POINTER, POINTER)),
        }
        if function not in pairs:
            raise CallError(f"component {self.name}: a mock has no function {function}")
        if function not in self._callbacks:
            answer, arguments = pairs[function]
            self._callbacks[function] = ctypes.CFUNCTYPE(INT, *arguments)(self._answering(answer))
        return ctypes.cast(self._callbacks[function], POINTER).value or 0

    def _answering(self, function: Callable[..., int | None]) -> Callable[..., int]:
        def answer(*arguments: Any) -> int:
            try:
                return function(*arguments) or OK
            except Exception as error:
                self.log.add(ERROR, "", str(error))
                return ERROR

        return answer

    def _set(self, _instance: int, references: int, count: int, values: int) -> int | None:
        found = dict(zip(self._named(references, count), (DOUBLE * count).from_address(values), strict=True))
        self.model.calls.append(("set", found))
        return self.model.set(found)

    def _get(self, _instance: int, references: int, count: int, values: int) -> int | None:
        ctypes.memmove(values, (DOUBLE * count)(*self.model.get(self._named(references, count))), 8 * count)
        return None

    def _named(self, references: int, count: int) -> list[str]:
        return [self.names[r] for r in (ctypes.c_uint32 * count).from_address(references)]

    def _step(self, _instance: int, time: float, length: float, _final: int) -> int | None:
        self.model.calls.append(("step", time, length))
        return self.model.step(time, length)

    def _save(self, _instance: int, cell: int) -> None:
        self.handles += 1
        self.states[self.handles] = self.model.save()
        self.model.calls.append(("save",))
        POINTER.from_address(cell).value = self.handles

    def _restore(self, _instance: int, state: int) -> None:
        self.model.calls.append(("restore",))
        self.model.restore(self.states[state])

    def _forget(self, _instance: int, cell: int) -> None:
        self.states.pop(POINTER.from_address(cell).value or 0)
        POINTER.from_address(cell).value = None

    # --- by name ---

    def _do(self, action: str, what: str, function: Callable[[], int | None], *told: Any) -> None:
        def must() -> None:
            status = function() or OK
            if not good(status):
                raise CallError(what, status)

        self.require(action, what)
        self.model.calls.append((action, *told))
        try:
            must()
        except CallError as error:
            self.noted(action, ERROR if error.status is None else error.status)
            raise
        self.noted(action, OK)

    def set_up(self, stop: float | None, start: float = 0.0) -> None:
        self._do("set up", "set up", lambda: None, self.tolerance, start, stop)

    def set_own(self, values: Mapping[str, Value]) -> None:
        for name in values:
            self.require_settable(name)
        numbers = {name: float(value) for name, value in values.items()}
        self._do("set", f"set {', '.join(values)}", lambda: self.model.set(numbers), numbers)

    def get_own(self, name: str) -> float:
        found: list[float] = self.call("get", f"get {name}", self.model.get, [name])
        return found[0]

    def enter_initialization(self) -> None:
        self._do("enter", "enter initialization", lambda: None)

    def exit_initialization(self) -> None:
        self._do("exit", "leave initialization", lambda: None)

    def step(self, time: float, length: float) -> None:
        self._do("step", f"step from {time:g} s", lambda: self.model.step(time, length), time, length)

    def save(self) -> int:
        self.require("save", "save its state")
        self.handles += 1
        self.states[self.handles] = self.model.save()
        return self.handles

    def restore(self, state: int) -> None:
        self.require("restore", "restore its state")
        self.model.restore(self.states[state])

    def forget(self, state: int) -> None:
        self.states.pop(state)

    def serialize(self, state: int) -> bytes:
        raise CallError(f"component {self.name}: a mock has no states for the disk")

    def deserialize(self, content: bytes) -> int:
        raise CallError(f"component {self.name}: a mock has no states for the disk")

    def close(self) -> str:
        for action in ("terminate", "free"):
            if not self.dead and allowed(2, action, self.state):
                self._do(action, action, lambda: None)
        return ""
