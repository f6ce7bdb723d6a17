"""A kernel as one source text, and compiled by Numba.

A kernel may be spread over files of its folder (`from .modes import tables`); `joined_source` makes one text of them.
The compiled form lives in a per-user cache under the hash of that text (`kernel_cache.py`), wherever the FMU was
unpacked: a second run starts at once, and code compiled from other text is never taken.
"""

from __future__ import annotations

import ast
import hashlib
import importlib.util
import inspect
import sys
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import numba

from .kernel_cache import CheckedCache, stored


def joined_source(kernel: ModuleType) -> str:
    """The text of a kernel module with the sibling modules it imports from put before it, each once."""
    done: list[Path] = []
    parts: list[str] = []

    def add(path: Path) -> None:
        if path in done:
            return
        done.append(path)
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        for node in ast.parse(text).body:
            if isinstance(node, ast.ImportFrom) and (node.level or node.module == "__future__"):
                if node.level:
                    add(path.with_name(f"{node.module}.py"))
                for number in range(node.lineno - 1, node.end_lineno or node.lineno):
                    lines[number] = ""
        parts.append("\n".join(lines))

    add(Path(str(kernel.__file__)))
    return "\n\n".join(parts) + "\n"


def precompile(function: Any, arguments: list[Any]) -> None:
    """Compile a function for the types of these arguments, or load what an earlier run has compiled.

    Where the environment switches Numba off (NUMBA_DISABLE_JIT) there is nothing to compile.
    """
    if hasattr(function, "compile"):
        function.compile(tuple(numba.typeof(argument) for argument in arguments))  # type: ignore[no-untyped-call,unused-ignore]


def compiled(kernel: ModuleType) -> ModuleType:
    """The functions of a kernel under Numba, as a module.

    Numba finds a called function through the module's globals, so each is replaced there by its compiled form (they
    compile at their first call). Floating-point results are those of IEEE 754 in source order: no fast-math; a
    division by zero gives inf or nan, which the finiteness checks then report.
    """
    text = joined_source(kernel)
    name = f"{kernel.__name__.split('.')[-2]}_{hashlib.sha256(text.encode()).hexdigest()[:24]}"
    if name in sys.modules:
        return sys.modules[name]
    spec = importlib.util.spec_from_file_location(name, stored(name, text))
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    jit = numba.njit(error_model="numpy")
    for key, function in inspect.getmembers(module, inspect.isfunction):
        if isinstance(function, FunctionType) and function.__module__ == name:
            dispatcher: Any = jit(function)
            dispatcher._cache = CheckedCache(function)
            setattr(module, key, dispatcher)
    return module
