"""The functions of an FMU's library as fmpy binds them: one that is missing fails when it is called, not before."""

from __future__ import annotations

import ctypes
from typing import Any

from fmpy.fmi1 import FMICallException

from ..lifecycle import good

TYPES = ("argnames", "argtypes", "restype")  # that fmpy gives a function
_types: dict[type, dict[str, tuple[Any, ...]]] = {}  # by fmpy's class, and by names of functions


class MissingFunctionError(Exception):
    """A function was called that the library does not have."""


class Missing:
    """Stands for a function that the library lacks; fmpy writes its types to it."""

    restype: Any = None

    def __init__(self, name: str) -> None:
        self.name = name

    def __call__(self, *_: Any) -> Any:
        raise MissingFunctionError(f"its library has no function {self.name}")


class Exports:
    """A library that has a function of every name, for as long as fmpy looks for them."""

    def __init__(self, library: Any) -> None:
        self.library = library
        self.missing: list[str] = []

    def __getattr__(self, name: str) -> Any:
        try:
            return getattr(self.library, name)
        except AttributeError:
            self.missing.append(name)
            return Missing(name)


class Judged:
    """Beside fmpy's classes: it takes a negative status for a good one, and a library that lacks functions as it is."""

    missing: tuple[str, ...] = ()  # the functions that the library lacks
    _functions: dict[str, Any]

    def _loadFunctions(self) -> None:
        """As fmpy does it for the first instance of a class; it would look at all signatures anew for every other."""
        library, kind = self.dll, type(self)
        exports = Exports(library)
        if kind not in _types:
            self.dll: Any = exports
            try:
                super()._loadFunctions()  # type: ignore[misc]
            finally:
                self.dll = library
            _types[kind] = {name: tuple(getattr(f, t) for t in TYPES) for name, f in self._functions.items()}
        else:
            own = f"{self.modelIdentifier}_fmi" if "fmi1GetVersion" in _types[kind] else ""  # type: ignore[attr-defined]
            for name, types in _types[kind].items():
                self._functions[name] = getattr(exports, own + name.removeprefix("fmi1") if own else name)
                for attribute, value in zip(TYPES, types, strict=True):
                    setattr(self._functions[name], attribute, value)
        self.missing = tuple(exports.missing)

    def _call(self, name: str, *arguments: Any) -> Any:
        result = super()._call(name, *arguments)  # type: ignore[misc]
        if self._functions[name].restype is ctypes.c_int and not good(result):
            raise FMICallException(name, result)
        return result
