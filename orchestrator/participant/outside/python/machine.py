"""A function that Numba has compiled as a component: set, get and step are machine code, and no Python is called.

All values lie in one array of doubles, that of a variable at its value reference, and behind them the states and the
time and step of the last call. Its address is the instance that the functions of FMI take first.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ....errors import InputError
from ....extras import needed
from ....fmu.outside.declared import DeclaredFmu
from ....fmu.outside.model import Model
from ....fmu.outside.python_file import PythonCode, arguments_of, line_of, named, plain, where
from ...lifecycle import ERROR, OK

WORDS = {"Real": "", "Integer": "int", "Boolean": "bool"}
TO_CELL, FROM_CELL = "cells[references[k]] = values[k]", "values[k] = cells[references[k]]"
SET_OR_GET = """
def {do}(cells, references, count, values):
    for k in range(count):
        {body}
    return {ok}
"""
STEP = """
def step(cells, t, h, final):
    cells[{time}] = t
    cells[{time} + 1] = h
    try:
        found = function({arguments})
    except Exception:
        return {error}
    {taken}
    return {ok}
"""


class CompiledFunction(Model):
    """A function of `njit` or `cfunc`. Values that are not finite are found by the loop."""

    def __init__(self, fmu: DeclaredFmu, found: Any) -> None:
        code: PythonCode = fmu.settings
        super().__init__({})
        self.code, self.line, self.plain = code, line_of(found), plain(found)
        self.types = {name: v.type for name, v in fmu.variables.items()}
        self.cell = {name: fmu.places[name].reference for name in fmu.variables}
        self.cell |= {name: len(self.cell) + k for k, (name, _) in enumerate(code.states)}
        self.outputs = [*fmu.names("output"), *dict(code.states)]
        self.arguments = [a.name for a in arguments_of(found, code.name)]
        self.cells = np.zeros(len(self.cell) + 2)
        self.set({**fmu.starts(), **dict(code.states)})
        self.functions = self._compiled(found)

    def set(self, values: Mapping[str, Any]) -> int | None:
        for name, value in values.items():
            self.cells[self.cell[name]] = value
        return None

    def get(self, names: Iterable[str]) -> list[Any]:
        known: dict[str, Any] = {"Integer": int, "Boolean": bool}
        return [known.get(self.types[name], float)(self.cells[self.cell[name]]) for name in names]

    def step(self, time: float, length: float) -> int | None:
        """By hand; the loop calls the address."""
        return int(self.functions["fmi2DoStep"].ctypes(self.cells.ctypes.data, time, length, 0))

    def save(self) -> Any:
        return self.cells.copy()

    def restore(self, state: Any) -> None:
        self.cells[:] = state

    def written(self, state: Any) -> bytes:
        return bytes(state.tobytes())

    def read(self, content: bytes) -> Any:
        if len(content) != self.cells.nbytes:
            raise ValueError(f"it has {len(content)} bytes, and {self.cells.nbytes} are wanted")
        return np.frombuffer(content).copy()

    def machine_code(self) -> Mapping[str, int]:
        found = {name: int(function.address) for name, function in self.functions.items()}
        return {**found, "pointer": int(self.cells.ctypes.data)}

    def why_failed(self) -> str:
        """The exception of the last step, found by calling the Python function with the same values."""
        time = len(self.cells) - 2
        known = {"t": float(self.cells[time]), "h": float(self.cells[time + 1])}
        words: dict[str, Any] = {"Integer": int, "Boolean": bool}
        for name, cell in self.cell.items():
            known[name] = words.get(self.types.get(name, "Real"), float)(self.cells[cell])
        try:
            self.plain(*[known[name] for name in self.arguments])
        except Exception as error:
            return f"{where(error, self.code.path)}: {named(error)}"
        return f"{self.code.path.name}, line {self.line}: {self.code.name} raised an exception"

    def _compiled(self, found: Any) -> dict[str, Any]:
        numba = needed("numba", "a compiled function as a component")
        types = numba.types
        doubles, whole = types.CPointer(types.float64), types.int32
        several = whole(doubles, types.CPointer(types.uint32), types.uintp, doubles)
        wholes = whole(doubles, types.CPointer(types.uint32), types.uintp, types.CPointer(whole))
        once = whole(doubles, types.float64, types.float64, whole)
        try:
            texts = {
                "fmi2SetReal": (_made("set_", SET_OR_GET, TO_CELL), several),
                "fmi2GetReal": (_made("get", SET_OR_GET, FROM_CELL), several),
                **{f"fmi2Set{kind}": (_made("set_", SET_OR_GET, TO_CELL), wholes) for kind in ("Integer", "Boolean")},
                **{f"fmi2Get{kind}": (_made("get", SET_OR_GET, FROM_CELL), wholes) for kind in ("Integer", "Boolean")},
                "fmi2DoStep": (self._step_text(found), once),
            }
            return {name: numba.cfunc(signature)(function) for name, (function, signature) in texts.items()}
        except numba.core.errors.NumbaError as error:
            first = next((line.strip() for line in str(error).splitlines() if line.strip()), "")
            raise InputError(
                f"{self.code.path.name}, line {self.line}: Numba cannot compile {self.code.name} for numbers as "
                f"declared, returning {', '.join(self.outputs)}: {first}"
            ) from error

    def _step_text(self, found: Any) -> Any:
        """The call of the function with its cells, as a function that is compiled; no word of the user's is in it."""
        time = len(self.cells) - 2
        known = {"t": "t", "h": "h"}
        for name, cell in self.cell.items():
            known[name] = f"{WORDS[self.types.get(name, 'Real')]}(cells[{cell}])"
        arguments = ", ".join(known[name] for name in self.arguments)
        several = len(self.outputs) > 1
        names = [f"v{k}" for k in range(len(self.outputs))]
        taken = f"{', '.join(names)} = found" if several else "v0 = found"
        taken += "".join(f"\n    cells[{self.cell[name]}] = v{k}" for k, name in enumerate(self.outputs))
        text = STEP.format(time=time, arguments=arguments, error=ERROR, ok=OK, taken=taken)
        return _function("step", text, function=found)


def _made(name: str, template: str, body: str) -> Any:
    return _function(name, template.format(do=name, body=body, ok=OK))


def _function(name: str, text: str, **known: Any) -> Any:
    space: dict[str, Any] = dict(known)
    exec(text, space)
    return space[name]
