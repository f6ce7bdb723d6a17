"""What a kernel's values are in machine code: numbers of three kinds, and arrays of float64."""

from __future__ import annotations

import ast
import struct
from dataclasses import dataclass

FLOAT, INT, BOOL = "double", "i64", "i1"
OF_ANNOTATION = {"float": FLOAT, "int": INT, "bool": BOOL}
DIMENSIONS = {"float[:]": 1, "float[:,:]": 2}


class UnknownError(Exception):
    """Something that this compiler does not know; Numba compiles such a kernel."""


@dataclass(frozen=True)
class Number:
    """A value: how LLVM's text names it, and its kind."""

    text: str
    kind: str


@dataclass(frozen=True)
class Array:
    """An array of float64 without gaps: its address, and its one or two sizes."""

    pointer: str
    sizes: tuple[str, ...]


def annotation(node: ast.expr | None) -> str:
    """The text of an annotation, quoted or not."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    return ast.unparse(node) if node is not None else ""


def returned(node: ast.FunctionDef) -> tuple[str, ...]:
    """The kinds that a function returns; none where it returns nothing."""
    text = annotation(node.returns)
    inner = text.removeprefix("tuple[").removesuffix("]") if text.startswith("tuple[") else text
    if text == "None":
        return ()
    kinds = tuple(OF_ANNOTATION.get(one.strip(), "") for one in inner.split(","))
    if not all(kinds):
        raise UnknownError(f"{node.name} returns {text or 'what is not said'}")
    return kinds


def joined(one: str, other: str) -> str:
    """The kind of a variable that takes both."""
    if not one or not other or one == other:
        return one or other
    if BOOL in (one, other):
        raise UnknownError("a variable that is a number here and true or false there")
    return FLOAT


def constant(value: object) -> Number:
    """A number of Python's as LLVM writes it."""
    if isinstance(value, bool):
        return Number("true" if value else "false", BOOL)
    if isinstance(value, int) and -(2**63) <= value < 2**63:
        return Number(str(value), INT)
    if isinstance(value, float):
        return Number(f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}", FLOAT)
    raise UnknownError(f"the constant {value!r}")
