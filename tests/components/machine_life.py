"""A kernel by `components/python/machine`, its functions called with values in order as those of its other lives.

What is compiled is kept beside what FMUs compile, for the other tests and workers: the brush takes LLVM a quarter of a
minute, and Numba one and a half.
"""

from __future__ import annotations

import ctypes
import hashlib
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from filelock import FileLock
from rovbrush.components.lowering.lowered import lowered
from rovbrush.components.python.kernel_cache import entry_folder
from rovbrush.components.python.machine.module import machine_text
from rovbrush.components.python.machine.objects import Loaded, here, object_of

CALL = ctypes.PYFUNCTYPE(ctypes.c_int64, ctypes.c_int64)
MAKERS = sorted(Path(str(machine_text.__code__.co_filename)).parent.glob("*.py"))  # what makes the objects


class Machine:
    """A namespace of a kernel's functions: those that return nothing."""

    def __init__(self, kernel: ModuleType) -> None:
        self.text = lowered(kernel).text
        self.prepared: dict[tuple[Any, ...], Prepared] = {}

    def __getattr__(self, function: str) -> Any:
        def called(*given: Any) -> None:
            known = (function, *map(type, given))
            if known not in self.prepared:
                self.prepared[known] = Prepared(self.text, function, given)
            self.prepared[known](given)

        setattr(self, function, called)
        return called


class Prepared:
    """A function for arguments of these kinds. Scalars go in as cells of one array; the others are arrays."""

    def __init__(self, text: str, function: str, given: tuple[Any, ...]) -> None:
        kinds = tuple(one.ndim if isinstance(one, np.ndarray) else _kind(one) for one in given)
        self.loaded = code(text, function, kinds)
        self.address = CALL(self.loaded.address(function))
        self.ndims = {k: kind for k, kind in enumerate(kinds) if isinstance(kind, int)}
        self.cells = [k for k in range(len(kinds)) if k not in self.ndims]
        self.scalars = np.zeros(len(self.cells))
        self.arrays: dict[int, Any] = dict.fromkeys(self.ndims)
        self.table = np.zeros((1 + len(self.arrays), 3), dtype=np.int64)
        self.table[0, :2] = self.scalars.ctypes.data, len(self.cells)
        self.begin = self.table.ctypes.data

    def __call__(self, given: tuple[Any, ...]) -> None:
        self.scalars[:] = [given[k] for k in self.cells]
        for row, (k, known) in enumerate(self.arrays.items(), 1):
            if given[k] is not known:
                array = self.arrays[k] = given[k]
                assert array.dtype == np.float64 and array.flags.c_contiguous and array.ndim == self.ndims[k]
                self.table[row, 0], self.table[row, 1 : 1 + array.ndim] = array.ctypes.data, array.shape
        self.address(self.begin)


def _kind(one: Any) -> type[Any]:
    """A type that the code knows: NumPy's floats are Python's."""
    return next(kind for kind in (bool, int, float) if isinstance(one, kind))


@cache
def machine(kernel: ModuleType) -> Machine:
    """The kernel as FMUs run it, made once."""
    return Machine(kernel)


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
    makers = "".join(path.read_text(encoding="utf-8") for path in MAKERS)
    means = hashlib.sha256("\n".join([here(), makers, text, function, *given]).encode()).hexdigest()
    kept = entry_folder(f"tested_{means[:24]}") / "kernel.o"
    with FileLock(kept.with_suffix(".lock")):
        if not kept.is_file():
            content = object_of(machine_text(text, {function: given}, arrays))
            kept.with_suffix(".new").write_bytes(content)
            kept.with_suffix(".new").rename(kept)
    return Loaded(kept.read_bytes())
