"""The FMI functions that the loop may call by address, numbered for both sides of an isolated FMU."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any

from ...fmu.types import TYPES, function_type
from ..lifecycle import PREFIX

POINTER, DOUBLE, SIZE_T, INT, BOOL = ctypes.c_void_p, ctypes.c_double, ctypes.c_size_t, ctypes.c_int, ctypes.c_bool
IN_C = {POINTER: "uintptr_t", DOUBLE: "double", SIZE_T: "size_t", INT: "int", BOOL: "_Bool"}


@dataclass(frozen=True)
class Function:
    """`kind`: the action of `lifecycle.py`; `size` bytes of a value; `text` where values are pointers to text, `binary`
    where they are pointers to bytes, whose sizes stand before them."""

    name: str
    kind: str
    size: int
    text: bool
    arguments: tuple[Any, ...]
    binary: bool = False

    @property
    def prototype(self) -> Any:
        """For ctypes."""
        return ctypes.CFUNCTYPE(INT, *self.arguments)

    @property
    def signature(self) -> str:
        """In C, with addresses as whole numbers."""
        return f"int({', '.join(IN_C[kind] for kind in self.arguments)})"


def functions(version: int) -> list[Function]:
    """All of one version, in the order of their numbers."""
    prefix = PREFIX[version]
    exchange = (POINTER, POINTER, SIZE_T, POINTER, *([SIZE_T] if version == 3 else []))
    found = [
        Function(
            f"{prefix}{verb}{name}", verb.lower(), kind.size, name == "String",
            (*exchange[:3], POINTER, *exchange[3:]) if name == "Binary" else exchange, name == "Binary",
        )
        for kind in TYPES[version].values()
        for name in [function_type(version, kind.name)]
        if name == kind.name
        for verb in ("Set", "Get")
    ]  # fmt: skip
    step = (POINTER, DOUBLE, DOUBLE, *([BOOL, *(POINTER,) * 4] if version == 3 else [INT]))
    found.append(Function(f"{prefix}DoStep", "step", 0, False, step))
    if version == 1:
        return found
    state = "FMUstate" if version == 2 else "FMUState"
    return found + [
        Function(f"{prefix}{verb}{state}", kind, 0, False, (POINTER, POINTER))
        for verb, kind in (("Get", "save"), ("Set", "restore"), ("Free", "forget"))
    ]
