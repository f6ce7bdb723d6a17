"""All numbers of an instance: one vector for the variables, the arrays of the state and of scratch, found by name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..declare.interface import Array, Variable
from .options import ROWS


class Memory:
    """`values`: one float64 per FMI scalar, by value reference; behind the last one time and step size.

    `index`: where a variable begins in it, `t` and `h` too. `y`: the outputs. `store`: the arrays, by name; those of
    fixed size lie one behind the other in `block`.
    """

    def __init__(self, variables: Sequence[Variable], outputs: Sequence[Variable], arrays: Sequence[Array]) -> None:
        self.variables = {v.name: v for v in variables}
        self.arrays = arrays
        starts = [start for v in variables for start in v.start]
        self.values = np.array([*starts, 0.0, 0.0])
        self.index: dict[str, int] = {"t": len(starts), "h": len(starts) + 1}
        self.views: dict[str, np.ndarray] = {}
        first = 0
        for v in variables:
            self.index[v.name] = first
            self.views[v.name] = self.values[first : first + len(v.start)]
            first += len(v.start)
        self.first_output = self.index[outputs[0].name]
        self.y = self.values[self.first_output : self.first_output + sum(len(v.start) for v in outputs)]
        self.store: dict[str, np.ndarray] = {}
        self.block = np.zeros(0)

    def value(self, variable: Variable) -> Any:
        """The present value of a variable in its own type: a number, or a tuple of them."""
        values = self.views[variable.name]
        if variable.size:
            return tuple(values.tolist())
        value = float(values[0])
        return bool(value) if variable.kind == "Boolean" else int(value) if variable.kind == "Integer" else value

    def allocate(self, parameters: Any) -> None:
        """Make the arrays anew, all zero, in the shapes that these parameters ask for."""
        self.store = {a.name: np.zeros(a.shape_for(parameters)) for a in self.arrays}
        fixed = [a for a in self.arrays if isinstance(a.shape, int)]
        self.block = np.zeros(sum(self.store[a.name].size for a in fixed))
        first = 0
        for a in fixed:
            size = self.store[a.name].size
            self.store[a.name] = self.block[first : first + size]
            first += size

    def show_rows(self) -> None:
        """Copy the elements of vectors that this FMU shows to its outputs; those that a vector lacks stay 0."""
        for array in self.arrays if ROWS else ():
            if array.shown:
                elements = self.store[array.name][:ROWS]
                self.views[array.shown.name][: len(elements)] = elements


def places_of(memory: Memory, names: Sequence[str]) -> tuple[list[str], list[Any]]:
    """Each argument of a kernel function as an expression over `values`, `block` and the other arrays that it needs;
    the names of these arrays, which do not lie in the block. Raises TypeError for a name that the interface lacks."""
    places, first = {}, 0
    for array in memory.arrays:
        if isinstance(array.shape, int):
            places[array.name] = f"lent(block[{first}:{first + array.shape}])"
            first += array.shape
        else:
            places[array.name] = f"lent({array.name})"
    begin = memory.first_output
    places["y"] = f"lent(values[{begin}:{begin + len(memory.y)}])"
    places |= {name: f"values[{memory.index[name]}]" for name in ("t", "h")}
    texts = [places[name] if name in places else _place(memory, name) for name in names]
    others = [a.name for a in memory.arrays if not isinstance(a.shape, int) and a.name in names]
    return texts, others


def _place(memory: Memory, name: str) -> str:
    if name not in memory.variables:
        raise TypeError(f"argument '{name}' of a kernel function is no variable of the interface")
    variable, at = memory.variables[name], memory.index[name]
    if variable.size:
        return f"lent(values[{at}:{at + variable.size}])"
    cell = f"values[{at}]"
    return f"int({cell})" if variable.kind == "Integer" else f"{cell} != 0.0" if variable.kind == "Boolean" else cell
