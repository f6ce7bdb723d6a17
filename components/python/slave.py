"""The Fmi2Slave base of every component: variables, argument binding, complete state, errors that reach the user.

A component declares its interface and its kernel; this class owns all numbers in one float64 vector `values` (one
element per FMI scalar, index = value reference) and the declared arrays, and calls the kernel with arguments bound
by name. It holds no equations.
"""

from __future__ import annotations

import ctypes
import traceback
from collections.abc import Callable, Iterator
from math import inf, isfinite
from types import ModuleType
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np
from pythonfmu import Fmi2Slave
from pythonfmu.enums import Fmi2Status

from ..declare.interface import Array, Variable, parameter_variables, tunable_places
from ..declare.model_description import model_description
from ..lowering.lowered import lowered
from .memory import Memory
from .options import ROWS
from .stages import Bound, bound
from .state import State, from_bytes, to_bytes

PHASES = ("instantiated", "initializing", "running", "terminated")
NEW, INITIALIZING, RUNNING, TERMINATED = range(4)  # the life of an instance; reset makes a new one


def keep_alive(*objects: object) -> None:
    """Hold one more reference to each object, for good: pythonfmu 0.7.0 drops references that it does not own."""
    for item in objects:
        ctypes.pythonapi.Py_IncRef(ctypes.py_object(item))


class ComponentSlave(Fmi2Slave):  # type: ignore[misc]
    """Base class of the Python FMUs; subclasses are declarations only."""

    parameters: type[Any]
    kernel: ModuleType
    inputs: tuple[Variable, ...]
    outputs: tuple[Variable, ...]
    arrays: tuple[Array, ...]
    default_step: float = 1e-3

    @classmethod
    def variables(cls) -> tuple[Variable, ...]:
        """The whole interface, in value-reference order: parameters, inputs, outputs, rows of arrays."""
        return (*parameter_variables(cls.parameters), *cls.inputs, *cls.outputs, *cls.row_outputs())

    @classmethod
    def row_outputs(cls) -> tuple[Variable, ...]:
        """Outputs that show the first elements of vectors, as many as this FMU was built with."""
        return tuple(v for a in cls.arrays for v in a.row_output(ROWS))

    @classmethod
    def started_by(cls) -> set[str]:
        """The inputs from which the initial state follows, and with it every output at time 0."""
        stages = [stage for stage in ("setup", "initialize") if hasattr(cls.kernel, stage)]
        arguments = lowered(cls.kernel).arguments
        return {a for stage in stages for a in arguments[stage]} & {v.name for v in cls.inputs}

    @classmethod
    def component_name(cls) -> str:
        """The component's folder name, which is the FMU's model name."""
        return cls.kernel.__name__.split(".")[-2]

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.stages: dict[str, Bound] = {}
        self.memory = Memory(self.variables(), self.outputs, self.arrays)
        self.cells: Any = memoryview(self.memory.values)  # type: ignore[arg-type]  # shares it; plain floats
        self.settable = range(sum(len(v.start) for v in parameter_variables(self.parameters)), self.memory.first_output)
        self.tunable = tunable_places(self.parameters)
        self.modelName = self.component_name()
        self.windows: dict[tuple[int, int], tuple[list[int], Any]] = {}  # what has been asked for, and where it lies
        self.given: list[int] = []  # inputs, as a master sets them at every step
        self.ready = False
        self.stale = False  # inputs were set since the outputs were computed
        self.phase = NEW

    def to_xml(self, model_options: dict[str, str] | None = None) -> Element:
        """The model description; the whole of FMI 2.0 that pythonfmu's own leaves out."""
        return model_description(type(self))

    # --- variable access: one vector, whatever the FMI type ---

    def get_real(self, vrs: list[int]) -> list[float]:
        if not self.ready:
            self.guarded(self.refresh)
        elif self.stale:
            self.guarded(self.answer)
        if not vrs:
            return []
        key = vrs[0], len(vrs)
        if key in self.windows:
            asked, window = self.windows[key]
            if vrs == asked:
                return window.tolist()  # type: ignore[no-any-return]
        cells = self.cells
        if vrs == list(range(vrs[0], vrs[0] + len(vrs))):
            self.windows[key] = vrs, cells[vrs[0] : vrs[0] + len(vrs)]
        return [cells[vr] for vr in vrs]

    def set_real(self, vrs: list[int], values: list[float]) -> None:
        cells = self.cells
        if self.phase < RUNNING:
            self.ready = False
        elif self.phase == RUNNING and vrs == self.given:
            self.stale = True
        elif all(vr in self.settable for vr in vrs):
            self.given, self.stale = vrs, True
        elif self.phase == RUNNING and all(vr in self.settable or vr in self.tunable for vr in vrs):
            self.guarded(self.tune, vrs, values)
            return
        else:
            self.guarded(self.out_of_turn, "set what is not an input")
        for vr, value in zip(vrs, values):  # noqa: B905  pythonfmu gives as many of both
            cells[vr] = value

    def tune(self, vrs: list[int], values: list[float]) -> None:
        """Tunable parameters between two steps. Raises ValueError where one is out of its range."""
        for vr, value in zip(vrs, values, strict=True):
            v = self.tunable.get(vr)
            if v is not None and not v.minimum <= value <= v.maximum:
                raise ValueError(f"{self.instance_name}.{v.name} = {value:g} is out of range")
            self.cells[vr] = value
        self.stale = True

    def get_integer(self, vrs: list[int]) -> list[int]:
        return [int(value) for value in self.get_real(vrs)]

    def get_boolean(self, vrs: list[int]) -> list[bool]:
        return [bool(value) for value in self.get_real(vrs)]

    def set_integer(self, vrs: list[int], values: list[int]) -> None:
        self.set_real(vrs, [float(value) for value in values])

    def set_boolean(self, vrs: list[int], values: list[bool]) -> None:
        self.set_real(vrs, [float(value) for value in values])

    # --- life cycle ---

    def refresh(self) -> None:
        """Derived tables, initial state and outputs from the present parameters and inputs."""
        chosen = {v.name: self.memory.value(v) for v in self.checked_parameters()}
        self.memory.allocate(self.parameters(**chosen))
        self.stages = bound(self.kernel, self.memory)
        for stage in ("setup", "initialize", "outputs"):
            if stage in self.stages:
                self.stages[stage]()
        self.show_rows()
        self.step_stage = self.stages["step"]
        self.ready = True

    def show_rows(self) -> None:
        """Elements of vectors as outputs, where this FMU has such; a kernel's `table` fills the vectors."""
        if "table" in self.stages:
            self.stages["table"]()
        self.memory.show_rows()

    def checked_parameters(self) -> Iterator[Variable]:
        """The parameters one by one. Raises ValueError where one is out of its range."""
        for v in parameter_variables(self.parameters):
            values = self.memory.views[v.name]
            if not np.all((values >= v.minimum) & (values <= v.maximum)):
                shown, unit = values.tolist() if v.size else values[0], "" if v.unit == "1" else f" {v.unit}"
                raise ValueError(
                    f"{self.instance_name}.{v.name} = {shown}{unit} is out of range: "
                    f"{v.minimum:g} to {v.maximum:g}{unit} are allowed"
                )
            yield v

    def answer(self) -> None:
        """Outputs for inputs that were set between two steps: direct feedthrough."""
        if "outputs" in self.stages:
            self.stages["outputs"]()
        self.stale = False

    def setup_experiment(self, start_time: float, stop_time: float | None, tolerance: float | None) -> None:
        self.cells[-2] = start_time  # outputs at the start may depend on it
        self.ready = False

    def enter_initialization_mode(self) -> None:
        if self.phase != NEW:
            self.guarded(self.out_of_turn, "enter initialization")
        self.phase = INITIALIZING

    def exit_initialization_mode(self) -> None:
        if self.phase != INITIALIZING:
            self.guarded(self.out_of_turn, "leave initialization")
        self.guarded(self.refresh)
        self.phase = RUNNING

    def terminate(self) -> None:
        self.phase = TERMINATED

    def out_of_turn(self, what: str) -> None:
        """Raise RuntimeError: the host has called in the wrong order."""
        raise RuntimeError(f"{self.instance_name}: a host cannot {what} while the FMU is {PHASES[self.phase]}")

    def do_step(self, current_time: float, step_size: float) -> bool:
        """Advance by one communication step; False (fmi2Discard) after an exception, whose text goes to the logger."""
        try:
            if self.phase != RUNNING:
                self.out_of_turn("do a step")
            if not (0.0 < step_size < inf and isfinite(current_time)):
                raise ValueError("the step size must be positive, and both it and the time must be finite")
            cells = self.cells
            cells[-2] = current_time
            cells[-1] = step_size
            self.step_stage()
            cells[-2] = current_time + step_size
            self.stale = False
            if ROWS:
                self.show_rows()
            return True
        except Exception:
            self.report(f"do_step at t = {current_time!r} s with h = {step_size!r} s")
            return False

    def guarded(self, action: Callable[..., None], *arguments: Any) -> None:
        """Run a life-cycle action; its exception is logged before pythonfmu turns it into fmi2Fatal."""
        try:
            action(*arguments)
        except Exception:
            self.report("a call")
            keep_alive(type(self), self, self.log_queue)  # pythonfmu drops them once more when the instance is freed
            raise

    def report(self, where: str) -> None:
        """Send the current traceback to the FMI logger (which formats with printf, so % is doubled)."""
        text = f"{self.instance_name}: {where} failed\n{traceback.format_exc()}"
        self.log(text.replace("%", "%%"), Fmi2Status.error)

    # --- complete state: see state.py ---

    def _get_fmu_state(self) -> State:
        if self.stale:
            self.guarded(self.answer)
        kept = {a.name: self.memory.store[a.name].copy() for a in self.arrays if not a.scratch and self.ready}
        return State(self.memory.values.copy(), kept, self.ready, self.phase)

    def _set_fmu_state(self, state: State) -> None:
        parameters = slice(self.settable.start)
        bound = self.ready and np.array_equal(self.memory.values[parameters], state.values[parameters])
        self.memory.values[:] = state.values
        self.ready, self.phase, self.stale = state.ready, state.phase, False
        if self.ready:
            if not bound:
                self.refresh()  # allocates for the saved parameters and binds them
            for name, array in state.arrays.items():
                self.memory.store[name][...] = array.reshape(self.memory.store[name].shape)
            self.memory.values[:] = state.values

    @staticmethod
    def _fmu_state_to_bytes(state: State) -> bytes:
        return to_bytes(state)

    @staticmethod
    def _fmu_state_from_bytes(state: bytes) -> State:
        return from_bytes(state)
