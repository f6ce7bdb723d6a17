"""The FMI functions that the loop may call by address, numbered for both sides of an isolated FMU."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any

from ...fmu.types import TYPES, function_type

POINTER, DOUBLE, SIZE_T, INT, BOOL = ctypes.c_void_p, ctypes.c_double, ctypes.c_size_t, ctypes.c_int, ctypes.c_bool


@dataclass(frozen=True)
class Function:
    """`kind`: set, get, step, or state; `size` bytes of a value; `text` where values are pointers to text."""

    name: str
    kind: str
    size: int
    text: bool
    prototype: Any


def functions(version: int) -> list[Function]:
    """All of one version, in the order of their numbers."""
    prefix = f"fmi{version}"
    exchange = [POINTER, POINTER, SIZE_T, POINTER, *([SIZE_T] if version == 3 else [])]
    found = [
        Function(f"{prefix}{verb}{name}", verb.lower(), kind.size, name == "String", ctypes.CFUNCTYPE(INT, *exchange))
        for kind in TYPES[version].values()
        for name in [function_type(version, kind.name)]
        if name == kind.name
        for verb in ("Set", "Get")
    ]
    step = [POINTER, DOUBLE, DOUBLE, *([INT] if version == 2 else [BOOL, *(POINTER,) * 4])]
    found.append(Function(f"{prefix}DoStep", "step", 0, False, ctypes.CFUNCTYPE(INT, *step)))
    state = "FMUstate" if version == 2 else "FMUState"
    return found + [
        Function(f"{prefix}{verb}{state}", verb.lower() + "_state", 0, False, ctypes.CFUNCTYPE(INT, POINTER, POINTER))
        for verb in ("Get", "Set", "Free")
    ]
