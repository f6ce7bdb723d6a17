"""An FMU as a unit under test: the few methods that behaviour tests use, in our names, units and signs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ...errors import FmuError
from ...fmu.attributes import parse_value
from ...fmu.fmu import Fmu
from ...fmu.types import Value, function_type
from ...participant.here.loaded import LoadedInstance
from ...participant.opening import load
from ...system.replace.mapping import VariableMapping
from .binding import Binding
from .suites import NotApplicableError


class FmuUnit:
    """An FMU seen through the bindings of a comparison. `tolerance` is the relative error granted to its solver."""

    def __init__(
        self, fmu: Fmu, bindings: Mapping[str, Binding], mapping: VariableMapping, tolerance: float = 0.0
    ) -> None:
        self.fmu, self.bindings, self.mapping, self.tolerance = fmu, bindings, mapping, tolerance
        self.observed: list[tuple[str, float, float]] = []
        self.instances: list[RunningFmu] = []
        self.described: Any = fmu.interface

    def supports(self, name: str) -> bool:
        """Can this variable of ours be used?"""
        return name in self.bindings

    def binding(self, name: str) -> Binding:
        if name not in self.bindings:
            raise NotApplicableError(f"needs {name}")
        return self.bindings[name]

    def parameter(self, name: str) -> Any:
        """The value that the FMU states for a parameter, in our unit."""
        binding = self.binding(name)
        starts = binding.starts()
        if starts is None:
            raise NotApplicableError(f"needs the value of {name}, which the FMU does not state")
        return binding.back(starts)

    def new(self, inputs: Mapping[str, Any] | None = None, **parameters: Any) -> RunningFmu:
        """An initialized instance with these inputs and parameters; others keep the FMU's own values."""
        if self.described.canBeInstantiatedOnlyOncePerProcess:
            self.release()
        for name, value in parameters.items():
            self._check_range(name, value)
        running = RunningFmu(self, load(self.fmu, f"unit{len(self.instances)}"))
        self.instances.append(running)
        running.begin(inputs or {}, parameters)
        return running

    def _check_range(self, name: str, value: Any) -> None:
        binding = self.binding(name)
        for number, v in zip(binding.there(value), binding.theirs * len(binding.crossings), strict=False):
            low = -np.inf if v.min is None else float(v.min)
            high = np.inf if v.max is None else float(v.max)
            if not low <= number <= high:
                raise NotApplicableError(f"needs {name} = {value:g}, outside of {low:g} to {high:g}")

    def observe(self, what: str, deviation: float, bound: float) -> None:
        """Keep a measured deviation and its bound."""
        self.observed.append((what, deviation, bound))

    def release(self) -> None:
        """Free all instances."""
        for running in self.instances:
            running.close()
        self.instances.clear()


class RunningFmu:
    """One instance, its time at 0 after `begin`."""

    def __init__(self, unit: FmuUnit, instance: LoadedInstance) -> None:
        self.unit, self.instance, self.time = unit, instance, 0.0
        self.step_size = 0.0
        self.states: list[int] = []

    def begin(self, inputs: Mapping[str, Any], parameters: Mapping[str, Any]) -> None:
        mapping, instance = self.unit.mapping, self.instance
        instance.set_up(None)
        self._set_own(mapping.parameters, "parameters")
        for name, value in parameters.items():
            self._write(self.unit.binding(name), value)
        instance.enter_initialization()
        self._set_own(mapping.inputs, "inputs")
        self.set(**inputs)
        instance.exit_initialization()

    def set(self, **inputs: Any) -> None:
        """Set inputs, in our units."""
        for name, value in inputs.items():
            self._write(self.unit.binding(name), value)

    def step(self, h: float) -> None:
        """One communication step of h [s]."""
        self._check_alive()
        self._check_step(h)
        self.instance.step(self.time, h)
        self.time += h

    def __getitem__(self, name: str) -> Any:
        self._check_alive()
        binding = self.unit.binding(name)
        kind, count = function_type(self.unit.fmu.version, binding.type), len(binding.crossings)
        return binding.back(binding.turned(self.instance.take(binding.name, kind, binding.references, count)))

    def save(self) -> Any:
        """The FMU's state and the time."""
        if not self.unit.described.canGetAndSetFMUstate:
            raise NotApplicableError("needs an FMU that can save and restore its state")
        state = self.instance.save()
        self.states.append(state)
        return state, self.time

    def restore(self, state: Any) -> None:
        """Go back to a saved state."""
        kept, self.time = state
        self.instance.restore(kept)

    def close(self) -> None:
        for state in self.states if not self.instance.dead else ():
            self.instance.forget(state)
        self.states.clear()
        self.instance.close()

    def _write(self, binding: Binding, value: Any) -> None:
        self._check_alive()
        kind = function_type(self.unit.fmu.version, binding.type)
        self.instance.put(binding.name, kind, binding.references, binding.turned(binding.there(value)))

    def _set_own(self, values: Mapping[str, Value], table: str) -> None:
        """Values for variables of theirs: scalars, elements `a[2]`, or one value for a whole array `a`."""
        fmu = self.unit.fmu
        own = {scalar: value for name, value in values.items() for scalar in fmu.expand(name)}
        self.instance.set_own(
            {scalar: parse_value(fmu.variables[scalar], v, f"[{table}] {scalar}") for scalar, v in own.items()}
        )

    def _check_alive(self) -> None:
        if self.instance.dead and self not in self.unit.instances:
            raise NotApplicableError("needs several instances at a time, and the FMU allows one per process")

    def _check_step(self, h: float) -> None:
        described = self.unit.described
        if described.canHandleVariableCommunicationStepSize:
            return
        stated = getattr(described, "fixedInternalStepSize", None)
        if stated and abs(h / stated - round(h / stated)) > 1e-9:
            raise NotApplicableError(f"needs a step of {h:g} s; the FMU's own is {stated:g} s")
        if self.step_size and abs(h - self.step_size) > 1e-9 * h:
            raise NotApplicableError("needs steps of several lengths, and the FMU allows one length")
        self.step_size = h


def first_line(error: FmuError) -> str:
    """An FMU's failure as one line: what it could not do, and the first words that it logged."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return lines[0] + (f": {lines[-1]}" if len(lines) > 1 else "")
