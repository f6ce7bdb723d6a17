"""A kernel by `components/python/machine`, its functions called with values in order as those of its other lives."""

from __future__ import annotations

import ctypes
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
from rovbrush.components.lowering.lowered import lowered
from rovbrush.components.python.machine.module import machine_text
from rovbrush.components.python.machine.objects import Loaded, object_of

CALL = ctypes.PYFUNCTYPE(ctypes.c_int64, ctypes.c_int64)


class Machine:
    """A namespace of a kernel's functions: those that return nothing."""

    def __init__(self, kernel: ModuleType) -> None:
        self.text = lowered(kernel).text

    def __getattr__(self, function: str) -> Any:
        return lambda *given: self.call(function, given)

    def call(self, function: str, given: tuple[Any, ...]) -> None:
        """Scalars go in as cells of one array; the others are arrays."""
        kinds = tuple(one.ndim if isinstance(one, np.ndarray) else type(one) for one in given)
        scalars = np.array([float(one) for one in given if not isinstance(one, np.ndarray)])
        arrays = [scalars, *(one for one in given if isinstance(one, np.ndarray))]
        table = np.zeros((len(arrays), 3), dtype=np.int64)
        for row, array in zip(table, arrays, strict=True):
            assert array.dtype == np.float64 and array.flags.c_contiguous
            row[0], row[1 : 1 + array.ndim] = array.ctypes.data, array.shape
        CALL(code(self.text, function, kinds).address(function))(table.ctypes.data)


@cache
def code(text: str, function: str, kinds: tuple[Any, ...]) -> Loaded:
    """A function's machine code for arguments of these kinds: a type, or the number of dimensions."""
    arrays, given, cells = {"values": 1}, [], 0
    for k, kind in enumerate(kinds):
        if isinstance(kind, int):
            arrays[f"array_{k}"] = kind
            given.append(f"array_{k}")
        else:
            cell = f"values[{cells}]"
            given.append({float: cell, int: f"int({cell})", bool: f"{cell} != 0.0"}[kind])
            cells += 1
    return Loaded(object_of(machine_text(text, {function: given}, arrays)))
