"""The entry points of a kernel, bound to the arrays of an instance: machine code by `machine/`, or else by Numba.

Machine code is kept in the cache under a hash of all that it is made of, this processor and LLVM's version among it:
it is compiled once, by `rovbrush build` or by whoever runs the FMU first, and taken from then on without Numba. Where
LLVM is missing or old, or the kernel uses what `machine/` does not know, Numba compiles, and the bits are the same.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
from collections.abc import Callable, Mapping
from functools import cache, partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from ..declare.usual import usual_sizes, usual_values
from ..lowering.lowered import Lowered, lowered
from .kernel_cache import entry_folder, keep, kept
from .memory import Memory, places_of
from .options import ROWS

STAGES = ("setup", "initialize", "outputs", "step", *["table"] * bool(ROWS))
OBJECT = "kernel.o"
WITH_NUMBA = "ROVBRUSH_KERNELS"  # set to `numba`: that compiles all kernels, to compare
# Python's lock is kept: a step is shorter than giving it away and taking it again.
_STAGE = ctypes.PYFUNCTYPE(ctypes.c_int64, ctypes.c_int64)
_REPEAT = ctypes.PYFUNCTYPE(ctypes.c_int64, ctypes.c_int64, ctypes.c_int64)

Bound = Callable[[], object]
_loaded: dict[str, Any] = {}  # by name in the cache: the machine code, or None where Numba compiles


def bound(kernel: ModuleType, memory: Memory) -> dict[str, Bound]:
    """What a kernel has of `STAGES`, each to be called without arguments. The arrays of `memory` stay where they are.

    Raises TypeError for an argument that the interface lacks.
    """
    source = lowered(kernel)
    entries, arrays = {}, {"values": memory.values, "block": memory.block}
    for stage in STAGES:
        if stage in source.arguments and hasattr(kernel, stage):
            entries[stage], others = places_of(memory, source.arguments[stage])
            arrays |= {name: memory.store[name] for name in others}
    code = _machine_code(kernel, source, entries, arrays, memory)
    if code is None:
        return _by_numba(kernel, memory, entries)
    table = np.zeros((len(arrays), 3), dtype=np.int64)
    for row, array in zip(table, arrays.values(), strict=True):
        row[0], row[1 : 1 + array.ndim] = array.ctypes.data, array.shape
    place = int(table.ctypes.data)
    found: dict[str, Bound] = {}
    for stage in entries:
        function: Any = partial(_STAGE(code.address(stage)), place)
        function.alive = code, table, arrays
        function.repeated = partial(_REPEAT(code.address(f"{stage}.repeat")), place)
        found[stage] = function
    return found


def repeated(function: Any, count: int) -> None:
    """Call a bound stage so often, with nothing of Python between where it is machine code."""
    if hasattr(function, "repeated"):
        function.repeated(count)
        return
    for _ in range(count):
        function()


def _machine_code(
    kernel: ModuleType, source: Lowered, entries: Mapping[str, list[str]], arrays: Mapping[str, Any], memory: Memory
) -> Any:
    """From the cache, or compiled now; None where Numba is to do it."""
    if os.environ.get(WITH_NUMBA) == "numba" or os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return None
    try:
        from .machine.objects import Loaded, here, object_of
    except ImportError:
        return None
    dimensions = {name: array.ndim for name, array in arrays.items()}
    usual = _usual(memory)
    made_of = "\0".join([source.text, repr(entries), repr(dimensions), repr(usual), compiler(), here()])
    name = f"{kernel.__name__.split('.')[-2]}_{hashlib.sha256(made_of.encode()).hexdigest()[:24]}"
    if name not in _loaded:
        path = entry_folder(name) / OBJECT
        content = kept(path)
        try:
            if content is None:
                from .machine.module import machine_text

                known = _known(source, entries, memory) if usual else None
                content = object_of(machine_text(source.text, entries, dimensions, known))
                keep(path, content)
            _loaded[name] = Loaded(content)
        except _unknown():
            _loaded[name] = None
    return _loaded[name]


def _usual(memory: Memory) -> dict[str, float]:
    """The parameters that are usual, where all of them have their start values; else none.

    They keep them: none of them is tunable, and for others the stages are bound anew.
    """
    usual = usual_values(memory.variables.values())
    return usual if all(memory.values[memory.index[name]] == value for name, value in usual.items()) else {}


def _known(source: Lowered, entries: Mapping[str, list[str]], memory: Memory) -> Any:
    """What is known of the step where parameters are what they usually are."""
    from .machine.module import Usual

    variables = list(memory.variables.values())
    literals = {
        name: repr({"Integer": int, "Boolean": bool, "Real": float}[memory.variables[name].kind](value))
        for name, value in usual_values(variables).items()
    }
    given = [literals.get(name, text) for name, text in zip(source.arguments["step"], entries["step"], strict=True)]
    return Usual("step", given, usual_sizes(variables, memory.arrays))


def _unknown() -> tuple[type[Exception], ...]:
    """What is raised where `machine/` cannot compile: by itself, or by LLVM."""
    from .machine.kinds import UnknownError

    return UnknownError, RuntimeError, NotImplementedError


@cache
def compiler() -> str:
    """A hash of the files that make machine code of a kernel."""
    total = hashlib.sha256()
    for path in sorted(Path(__file__).with_name("machine").glob("*.py")):
        total.update(path.read_bytes())
    return total.hexdigest()


def _by_numba(kernel: ModuleType, memory: Memory, entries: Mapping[str, list[str]]) -> dict[str, Bound]:
    from .kernels import compiled, entry, precompile

    functions = compiled(kernel)
    found: dict[str, Bound] = {}
    for stage, texts in entries.items():
        others = places_of(memory, lowered(kernel).arguments[stage])[1]
        given = [memory.values, memory.block, *(memory.store[name] for name in others)]
        function = entry(functions, stage, texts, ", ".join(["values", "block", *others]))
        precompile(function, given)
        found[stage] = partial(function, *given)
    return found
