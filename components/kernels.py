"""Kernels under Numba: every function of a kernel module compiled in place, in a fresh copy of the module."""

from __future__ import annotations

import importlib.util
import inspect
import sys
from types import FunctionType, ModuleType
from typing import Any

import numba


def precompile(function: Any, arguments: list[Any]) -> None:
    """Compile a function for the types of these arguments, or load what an earlier run has compiled."""
    function.compile(tuple(numba.typeof(argument) for argument in arguments))


def compiled(kernel: ModuleType) -> ModuleType:
    """A copy of `kernel` whose functions are compiled; the compiled code is cached beside the source file.

    Numba finds a called function through the module's globals, so callees are replaced before their callers are
    compiled (they compile at their first call). Floating-point results are those of IEEE 754 in source order: no
    fast-math; a division by zero gives inf or nan, which the component's finiteness check then reports.
    """
    name = f"{kernel.__name__}__compiled"
    if name in sys.modules:
        return sys.modules[name]
    spec = importlib.util.spec_from_file_location(name, kernel.__file__)
    assert spec is not None and spec.loader is not None
    copy = importlib.util.module_from_spec(spec)
    sys.modules[name] = copy
    spec.loader.exec_module(copy)
    jit = numba.njit(cache=True, error_model="numpy")
    for key, function in inspect.getmembers(copy, inspect.isfunction):
        if isinstance(function, FunctionType) and function.__module__ == name:
            setattr(copy, key, jit(function))
    return copy
