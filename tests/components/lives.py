"""The lives of a kernel: plain Python, machine code of its own, Numba, and C by Pyccel, driven with the same numbers.

Arguments are bound by name, as the FMU base class does it, from the component's declared interface.
"""

from __future__ import annotations

import atexit
import dataclasses
import inspect
import shutil
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from machine_life import machine
from pyccel import epyccel
from rovbrush.components.declare.interface import Variable, parameter_variables
from rovbrush.components.declare.layout import cells_name, over
from rovbrush.components.declare.record import fields_of
from rovbrush.components.lowering.source import is_record
from rovbrush.components.python.component import component_class as component
from rovbrush.components.python.kernels import argument_names, compiled, joined_source
from rovbrush.components.python.slave import ComponentSlave

Range = tuple[float, float]  # an input's mean and amplitude


@dataclass(frozen=True)
class Case:
    """A component, how it is excited and which parameters differ from the defaults.

    `inputs` gives mean and amplitude of an input (all elements of an array input alike); others stay at their start.
    """

    name: str
    h: float
    steps: int
    inputs: Mapping[str, Range] = field(default_factory=dict)
    parameters: Mapping[str, Any] = field(default_factory=dict)
    variant: str = "default"

    def __str__(self) -> str:
        return f"{self.name}-{self.variant}"


@cache
def lives(name: str) -> dict[str, Any]:
    """The kernel as plain Python, as FMUs run it, under Numba and as C: namespaces with the same functions, made once.

    In C no contraction to fused multiply-add: it rounds once where Python rounds twice. Symbols are bound inside the
    library: the C library has an old function `step` of its own, which would be called instead of the kernel's.
    """
    kernel = component(name).kernel
    flags = {"flags": "-ffp-contract=off", "wrapper_flags": "-Wl,-Bsymbolic"}
    folder = tempfile.mkdtemp(prefix=f"{Path(name).name}_")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    in_c = epyccel(joined_source(kernel), language="c", folder=folder, **flags)
    return {"python": kernel, "machine": machine(kernel), "numba": compiled(kernel), "c": in_c}


class Instance:
    """One instance of a component without FMI: parameters, inputs, state arrays and y, by name."""

    def __init__(
        self, declared: type[ComponentSlave], functions: Any, spoiled: bool = False, **parameters: Any
    ) -> None:
        self.declared = declared
        self.spoiled = spoiled  # what is scratch has no number in it when a function is called
        self.functions = functions
        chosen = declared.parameters(**parameters)
        self.values: dict[str, Any] = {
            v.name: _typed(v, getattr(chosen, v.name)) for v in parameter_variables(declared.parameters)
        }
        self.values |= {v.name: _typed(v, v.start if v.size else v.start[0]) for v in declared.inputs}
        self.arrays = {a.name: np.zeros(a.shape_for(chosen)) for a in declared.arrays}
        self.values |= self.arrays
        self.parameters = chosen
        self.values["y"] = np.zeros(sum(len(v.start) for v in declared.outputs))
        self.values |= {"t": 0.0, "h": 0.0}
        self.at: dict[str, slice] = {}
        first = 0
        for v in declared.outputs:
            self.at[v.name] = slice(first, first + len(v.start))
            first += len(v.start)
        self.signatures = {
            f: argument_names(declared.kernel, f)
            for f in ("setup", "initialize", "outputs", "step", "table")
            if hasattr(declared.kernel, f)
        }

    def set(self, **inputs: Any) -> None:
        """Set inputs; scalars by a number, arrays by a sequence."""
        declared = {v.name: v for v in self.declared.inputs}
        for name, value in inputs.items():
            self.values[name] = _typed(declared[name], value)

    def call(self, function: str) -> None:
        """Call an entry point with its arguments bound by name; plain Python gets records over the same arrays."""
        called = getattr(self.functions, function)
        for array in self.declared.arrays if self.spoiled else ():
            if array.scratch:
                self.arrays[array.name].fill(np.nan)
        if self.functions is self.declared.kernel:
            called(*[self.of_record(p) for p in inspect.signature(called).parameters.values()])
        else:
            called(*[self.values[argument] for argument in self.signatures[function]])

    def of_record(self, parameter: inspect.Parameter) -> Any:
        """What plain Python takes as an argument."""
        record = parameter.annotation
        if not is_record(record):
            return self.values[parameter.name]
        if dataclasses.is_dataclass(record):
            return self.parameters
        fields = fields_of(record)
        if all(f.role == "input" for f in fields.values()):
            return record(*[self.values[name] for name in fields])
        return self.record(record)

    def record(self, kind: type[Any]) -> Any:
        """State, scratch or outputs as plain Python sees them."""
        return over(kind, self.values.get(cells_name(kind)), self.arrays)

    def start(self) -> None:
        """setup, initialize and outputs, as far as the kernel has them."""
        for function in ("setup", "initialize", "outputs"):
            if function in self.signatures:
                self.call(function)

    def step(self, h: float) -> None:
        """One communication step; a table of single rows is filled too, where a kernel has one."""
        self.values["h"] = h
        self.call("step")
        if "table" in self.signatures:
            self.call("table")
        self.values["t"] += h

    def __getitem__(self, output: str) -> Any:
        """An output: a float, or an array of floats."""
        value = self.values["y"][self.at[output]]
        size = next(v.size for v in self.declared.outputs if v.name == output)
        return value.copy() if size else float(value[0])

    def snapshot(self) -> dict[str, np.ndarray]:
        """Copies of y and of every array, scratch included."""
        return {name: array.copy() for name, array in (*self.arrays.items(), ("y", self.values["y"]))}


def excitation(case: Case, k: int) -> dict[str, Any]:
    """Inputs of step k: mean plus amplitude times a sine whose frequency differs from element to element."""
    result: dict[str, Any] = {}
    for number, v in enumerate(component(case.name).inputs):
        if v.name in case.inputs:
            mean, amplitude = case.inputs[v.name]
            phases = [0.7 * k + 1.3 * number + 2.1 * j for j in range(max(v.size, 1))]
            elements = [mean + amplitude * float(np.sin(phase)) for phase in phases]
            result[v.name] = elements if v.size else elements[0]
    return result


def history(case: Case, functions: Any, spoiled: bool = False) -> list[dict[str, np.ndarray]]:
    """Everything a kernel computes, after the start and after every step."""
    instance = Instance(component(case.name), functions, spoiled, **case.parameters)
    instance.set(**excitation(case, 0))
    instance.start()
    snapshots = [instance.snapshot()]
    for k in range(case.steps):
        instance.set(**excitation(case, k))
        instance.step(case.h)
        snapshots.append(instance.snapshot())
    return snapshots


def _typed(variable: Variable, value: Any) -> Any:
    if variable.size:
        return np.array(value, dtype=float)
    return bool(value) if variable.kind == "Boolean" else int(value) if variable.kind == "Integer" else float(value)
