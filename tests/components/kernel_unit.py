"""A component's kernel as a unit under test: its functions as FMUs run them, without FMI."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import Any

import numpy as np
from lives import Instance, component
from machine_life import machine
from rovbrush.components.declare.interface import parameter_variables


class RunningKernel(Instance):
    """An instance whose state can be saved; scratch arrays are no state and are spoilt when it is restored.

    As in an FMU, an output that is read after inputs were set follows them.
    """

    stale = False

    def set(self, **inputs: Any) -> None:
        super().set(**inputs)
        self.stale = True

    def start(self) -> None:
        super().start()
        self.stale = False

    def step(self, h: float) -> None:
        super().step(h)
        self.stale = False

    def __getitem__(self, name: str) -> Any:
        if any(v.name == name for v in self.declared.inputs):
            return self.values[name]
        if self.stale and "outputs" in self.signatures:
            self.call("outputs")
        self.stale = False
        return super().__getitem__(name)

    def save(self) -> dict[str, Any]:
        kept = {a.name for a in self.declared.arrays if not a.scratch}
        arrays = {name: array.copy() for name, array in self.arrays.items() if name in kept}
        plain = {name: copy.copy(value) for name, value in self.values.items() if name not in self.arrays}
        return {"arrays": arrays, "plain": plain}

    def restore(self, state: dict[str, Any]) -> None:
        for name, array in self.arrays.items():
            array[...] = state["arrays"].get(name, np.nan)
        self.values |= {name: copy.copy(value) for name, value in state["plain"].items()}


class KernelUnit:
    """The kernel of `rovbrush.components.<name>`."""

    tolerance = 0.0

    def __init__(self, name: str) -> None:
        self.declared = component(name)
        self.variables = {v.name: v for v in self.declared.variables()}
        self.observed: list[tuple[str, float, float]] = []

    def supports(self, name: str) -> bool:
        return name in self.variables

    def parameter(self, name: str) -> Any:
        start = next(v for v in parameter_variables(self.declared.parameters) if v.name == name)
        return np.array(start.start) if start.size else getattr(self.declared.parameters(), name)

    def new(self, inputs: Mapping[str, Any] | None = None, **parameters: Any) -> RunningKernel:
        chosen = {k: tuple(np.asarray(v).tolist()) if np.ndim(v) else v for k, v in parameters.items()}
        running = RunningKernel(self.declared, machine(self.declared.kernel), **chosen)
        running.set(**(inputs or {}))
        running.start()
        return running

    def observe(self, what: str, deviation: float, bound: float) -> None:
        self.observed.append((what, deviation, bound))
