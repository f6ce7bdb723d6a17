"""A component's suite: its own tests and those that every component must pass, with the interface they rely on.

The entry points of the group `rovbrush.behaviours` name one suite per component.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import ModuleType
from typing import Any

import numpy as np

from ..declare.interface import Variable
from ..python.slave import ComponentSlave
from .behaviour import Running, Test, Unit, close, holds, read, same, where_known


@dataclass(frozen=True)
class Excitation:
    """Inputs over time for tests that any component must pass: mean and amplitude per input, and parameters."""

    h: float
    steps: int
    inputs: Mapping[str, tuple[float, float]]
    parameters: Mapping[str, Any] = field(default_factory=dict)

    def at(self, unit: Unit, interface: tuple[Variable, ...], k: int) -> dict[str, Any]:
        """Inputs of step k: sines of the step number whose phase differs from element to element."""
        values: dict[str, Any] = {}
        for number, v in enumerate(interface):
            if v.name in self.inputs and unit.supports(v.name):
                mean, amplitude = self.inputs[v.name]
                phases = 0.7 * k + 1.3 * number + 2.1 * np.arange(max(v.size, 1))
                elements = mean + amplitude * np.sin(phases)
                values[v.name] = elements if v.size else float(elements[0])
        return values


@dataclass(frozen=True)
class Suite:
    """A component's interface and its tests; `essential` are the variables that a system cannot do without."""

    name: str
    interface: tuple[Variable, ...]
    essential: tuple[str, ...]
    tests: tuple[Test, ...]


def suite(component: type[ComponentSlave], essential: str, excitation: Excitation, *modules: ModuleType) -> Suite:
    """The tests that the modules hold, and those that every component must pass, in the order of the text."""
    own = [f for module in modules for key, f in vars(module).items() if key.startswith("test_")]
    interface = component.variables()
    chosen = (*own, *CommonTests(interface, excitation).tests())
    return Suite(component.component_name(), interface, tuple(essential.split()), chosen)


@dataclass(frozen=True)
class CommonTests:
    """The tests that every component must pass, for one interface and one way to excite it."""

    interface: tuple[Variable, ...]
    excitation: Excitation

    def seen_by(self, unit: Unit) -> list[str]:
        """The outputs that the unit has."""
        return [v.name for v in self.interface if v.causality == "output" and unit.supports(v.name)]

    def first(self, unit: Unit) -> Running:
        """An instance with the excitation's parameters and its first inputs."""
        inputs = self.excitation.at(unit, self.interface, 0)
        return unit.new(inputs, **where_known(unit, **self.excitation.parameters))

    def advance(self, unit: Unit, running: Running, begin: int, end: int) -> np.ndarray:
        """The outputs after the steps begin .. end-1, a row each."""
        rows = []
        for k in range(begin, end):
            running.set(**self.excitation.at(unit, self.interface, k))
            running.step(self.excitation.h)
            rows.append(read(running, *self.seen_by(unit)))
        return np.array(rows)

    def test_outputs_stay_finite(self, unit: Unit) -> None:
        """Changing inputs give finite outputs."""
        rows = self.advance(unit, self.first(unit), 0, self.excitation.steps)
        broken = [k for k in range(rows.shape[1]) if not np.all(np.isfinite(rows[:, k]))]
        holds(not broken, f"{len(broken)} of {rows.shape[1]} outputs are not finite")

    def test_same_inputs_give_the_same_bits(self, unit: Unit) -> None:
        """Two instances with the same inputs agree to the last bit, although they run in turns."""
        one, other = self.first(unit), self.first(unit)
        half = self.excitation.steps // 2
        for begin in range(0, self.excitation.steps, half):
            same("outputs of the second instance", self.advance(unit, other, begin, begin + half),
                 self.advance(unit, one, begin, begin + half))  # fmt: skip

    def test_restored_state_continues_with_the_same_bits(self, unit: Unit) -> None:
        """An instance whose state is saved, run on and restored repeats its steps to the last bit."""
        running, half = self.first(unit), self.excitation.steps // 2
        self.advance(unit, running, 0, half)
        state = running.save()
        expected = self.advance(unit, running, half, self.excitation.steps)
        running.restore(state)
        seen = self.advance(unit, running, half, self.excitation.steps)
        same("outputs after the state was restored", seen, expected)

    def test_parameters_left_alone_have_their_stated_values(self, unit: Unit) -> None:
        """Setting every parameter to the value that the unit states for it changes no output."""
        known = [v.name for v in self.interface if v.causality == "parameter" and unit.supports(v.name)]
        stated = {name: unit.parameter(name) for name in known}
        inputs = self.excitation.at(unit, self.interface, 0)
        left, set_to = unit.new(inputs), unit.new(inputs, **stated)
        for _ in range(5):
            left.step(self.excitation.h)
            set_to.step(self.excitation.h)
        names = self.seen_by(unit)
        # Written and read as text with all digits, but a unit conversion may round once.
        close(unit, "outputs with the parameters set", read(set_to, *names), read(left, *names), 1e-12)

    def tests(self) -> tuple[Test, ...]:
        """All of them, in the order of the text."""
        return (
            self.test_outputs_stay_finite,
            self.test_same_inputs_give_the_same_bits,
            self.test_restored_state_continues_with_the_same_bits,
            self.test_parameters_left_alone_have_their_stated_values,
        )
