"""The functions of an FMU's library as fmpy binds them: one that is missing fails when it is called, not before."""

from __future__ import annotations

import ctypes
from typing import Any

from fmpy.fmi1 import FMICallException

from ..lifecycle import good


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

    def _loadFunctions(self) -> None:
        library = self.dll
        self.dll: Any = Exports(library)
        try:
            super()._loadFunctions()  # type: ignore[misc]
            self.missing = tuple(self.dll.missing)
        finally:
            self.dll = library

    def _call(self, name: str, *arguments: Any) -> Any:
        result = super()._call(name, *arguments)  # type: ignore[misc]
        if self._functions[name].restype is ctypes.c_int and not good(result):  # type: ignore[attr-defined]
            raise FMICallException(name, result)
        return result
