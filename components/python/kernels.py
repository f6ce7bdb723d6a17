"""A kernel as one source text, and compiled by Numba: what `machine/` does not know, and what tests call by name.

A kernel may be spread over files (`from .modes import tables`); `lowering/` makes one text of them, in which records
are named scalars and cells of arrays. The compiled form lives in a per-user cache under the hash of that text
(`kernel_cache.py`), wherever the FMU was unpacked: a second run starts at once, and code compiled from other text is
never taken.
"""

# mypy: disable-error-code="no-untyped-call, attr-defined, unused-ignore"
# Numba has no types.

from __future__ import annotations

import hashlib
import importlib.util
import inspect
import sys
from types import FunctionType, ModuleType
from typing import Any

import numba
from numba.core import cgutils
from numba.extending import intrinsic

from ..lowering.lowered import Lowered, lowered
from .kernel_cache import stored
from .numba_files import CheckedCache

TRIED = ((0, 61), (0, 68))  # versions of Numba of which `parts.py` knows the inside


def joined_source(kernel: ModuleType) -> str:
    """The text of a kernel, lowered, with the files it imports from put before it, each once."""
    return lowered(kernel).text


def argument_names(kernel: ModuleType, function: str) -> list[str]:
    """What a lowered entry point is called with, by name: `t`, `h`, `y` (all outputs), arrays and variables."""
    return lowered(kernel).arguments[function]


def precompile(function: Any, arguments: list[Any]) -> None:
    """Compile a function for the types of these arguments, or load what an earlier run has compiled.

    Where the environment switches Numba off (NUMBA_DISABLE_JIT) there is nothing to compile.
    """
    if hasattr(function, "compile"):
        function.compile(tuple(numba.typeof(argument) for argument in arguments))  # type: ignore[no-untyped-call,unused-ignore]


def compiled(kernel: ModuleType) -> CalledFromPython:
    """The functions of a kernel under Numba, as a module.

    Numba finds a called function through the module's globals, so each is replaced there by its compiled form (they
    compile at their first call). Floating-point results are those of IEEE 754 in source order: no fast-math; a
    division by zero gives inf or nan, which the finiteness checks then report.
    """
    source = lowered(kernel)
    text = source.text
    name = f"{kernel.__name__.split('.')[-2]}_{hashlib.sha256(text.encode()).hexdigest()[:24]}"
    known: Any = sys.modules.get(name)
    if known is not None:
        return known  # type: ignore[no-any-return]
    module = CalledFromPython(name)
    spec = importlib.util.spec_from_file_location(name, stored(name, text))
    assert spec is not None and spec.loader is not None
    inner = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(inner)
    for key, function in inspect.getmembers(inner, inspect.isfunction):
        if isinstance(function, FunctionType) and function.__module__ == name:
            module.inner[key] = vars(inner)[key] = _inlined(_shown_at_source(function, source))
    sys.modules[name] = module
    return module


def _inlined(function: FunctionType) -> Any:
    """A function for compiled code to call; under a Numba that nobody has tried, as that compiles by itself."""
    # A call that hands on ten arrays costs as much as what it calls.
    options: dict[str, Any] = {"error_model": "numpy", "forceinline": True}
    if TRIED[0] <= numba.version_info[:2] <= TRIED[1]:
        from .parts import PartCompiler

        options["pipeline_class"] = PartCompiler
    return numba.njit(**options)(function)


class CalledFromPython(ModuleType):
    """The functions of a kernel for Python to call, each compiled when it is first asked for.

    `inner`: those that kernel functions call; they are part of whatever calls them, and Python cannot call them.
    """

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.inner: dict[str, Any] = {}

    def has(self, key: str) -> bool:
        """Is there such a function?"""
        return key in self.inner

    def __getattr__(self, key: str) -> Any:
        if key not in self.inner:
            raise AttributeError(f"the kernel {self.__name__} has no function {key}")
        code = getattr(self.inner[key], "py_func", self.inner[key]).__code__
        names = list(code.co_varnames[: code.co_argcount])
        made = entry(self, key, names, ", ".join(names))
        setattr(self, key, made)
        return made


@intrinsic  # type: ignore[untyped-decorator]
def lent(_: Any, array: Any) -> Any:
    """The same array without an owner, so that nobody counts references to it; the caller keeps it."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        made = cgutils.create_struct_proxy(signature.args[0])(context, builder, value=arguments[0])
        made.meminfo = cgutils.get_null_value(made.meminfo.type)
        made.parent = cgutils.get_null_value(made.parent.type)
        return made._getvalue()

    return array(array), code


def entry(functions: CalledFromPython, function: str, arguments: list[str], given: str) -> Any:
    """A compiled kernel function that takes its arguments out of a few arrays: `given` names, `arguments` says how.

    Unpacking dozens of arrays from Python for every call would cost more than most kernels.
    """
    text = f"def {function}_from({given}):\n    return {function}({', '.join(arguments)})\n"
    name = f"{functions.__name__}_{hashlib.sha256(text.encode()).hexdigest()[:12]}"
    if name not in vars(functions):
        namespace = {function: functions.inner[function], "__name__": functions.__name__, "lent": lent}
        if numba.config.DISABLE_JIT:
            namespace["lent"] = lambda array: array
        exec(compile(text, str(stored(name, text)), "exec"), namespace)
        made = namespace[f"{function}_from"]
        options: Any = {"error_model": "numpy", "no_cfunc_wrapper": True}  # nobody calls it from C
        dispatcher: Any = numba.njit(**options)(made)
        if hasattr(dispatcher, "_cache"):
            dispatcher._cache = CheckedCache(made)
        setattr(functions, name, dispatcher)
    return getattr(functions, name)


def _shown_at_source(function: FunctionType, source: Lowered) -> FunctionType:
    """The same function, whose errors and tracebacks name the file and the lines that it was written in."""
    path, line = source.place(function.__code__.co_firstlineno)
    code = function.__code__.replace(co_filename=str(path), co_firstlineno=line)
    shown = FunctionType(code, function.__globals__, function.__name__)
    shown.__annotations__, shown.__module__ = function.__annotations__, function.__module__
    return shown
