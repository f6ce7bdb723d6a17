"""The variable types of FMI 1.0, 2.0 and 3.0: their families, sizes and ranges.

In the run's vector a floating-point signal is a double; every other one is a 64-bit whole number in the same eight
bytes (UInt64: its bits): 0 or 1 of a Boolean, the value of an Enumeration, the number of a text or of
bytes (`loop/texts.py`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

Value = float | int | bool | str | bytes  # of a scalar
REALS = ("Real", "Float64", "Float32")
# How the loop turns a raw value into a cell of the vector, and back; NEGATED: whole numbers of negated aliases.
FLOAT, WHOLE, BOOLEAN, TEXT, NEGATED, BINARY = range(6)
FLOAT32 = math.nextafter(2.0**128 - 2.0**103, 0.0)  # the largest double that is rounded to a finite one of 4 bytes


@dataclass(frozen=True)
class FmiType:
    """One type of a variable: `size` in bytes as the FMI functions take it; text is passed as a pointer."""

    name: str
    code: int
    size: int
    dtype: np.dtype[np.generic]

    @property
    def real(self) -> bool:
        """Floating point: may be extrapolated and averaged, has a unit, must be finite. Everything else is held."""
        return self.code == FLOAT

    @property
    def signed(self) -> bool:
        return self.dtype.kind == "i"

    @property
    def range(self) -> tuple[int, int]:
        """Smallest and largest value of a whole number."""
        info = np.iinfo(str(self.dtype))
        return int(info.min), int(info.max)

    @property
    def largest(self) -> float:
        """Of a real number: the largest double that is finite in it, be it rounded; inf where it holds all doubles."""
        return FLOAT32 if self.size == 4 else math.inf


def _type(name: str, code: int, size: int, dtype: str) -> FmiType:
    return FmiType(name, code, size, np.dtype(dtype))


_FMI2 = (
    _type("Real", FLOAT, 8, "f8"),
    _type("Integer", WHOLE, 4, "i4"),
    _type("Enumeration", WHOLE, 4, "i4"),
    _type("Boolean", BOOLEAN, 4, "?"),
    _type("String", TEXT, 8, "O"),
)
_FMI1 = tuple(_type("Boolean", BOOLEAN, 1, "?") if t.name == "Boolean" else t for t in _FMI2)  # a char there
_FMI3 = (
    _type("Float64", FLOAT, 8, "f8"),
    _type("Float32", FLOAT, 4, "f4"),
    *(_type(f"Int{8 * size}", WHOLE, size, f"i{size}") for size in (1, 2, 4, 8)),
    *(_type(f"UInt{8 * size}", WHOLE, size, f"u{size}") for size in (1, 2, 4, 8)),
    _type("Enumeration", WHOLE, 8, "i8"),
    _type("Boolean", BOOLEAN, 1, "?"),
    _type("String", TEXT, 8, "O"),
    _type("Binary", BINARY, 8, "O"),
)
TYPES = {1: {t.name: t for t in _FMI1}, 2: {t.name: t for t in _FMI2}, 3: {t.name: t for t in _FMI3}}
GROUPED = {name: k for k, name in enumerate(dict.fromkeys(t.name for t in (*_FMI2, *_FMI3)))}  # order in a layout


def function_type(version: int, name: str) -> str:
    """The name by which FMI functions know a type: in `fmi2SetInteger` an Enumeration is an Integer."""
    if name == "Enumeration":
        return "Int64" if version == 3 else "Integer"
    return name


def encode(kind: FmiType, value: float | int | bool) -> float:
    """A number as the double whose eight bytes are its cell in the run's vector."""
    if kind.real:
        return float(value)
    whole = int(value)
    dtype = np.uint64 if whole >= 2**63 else np.int64
    return float(np.array(whole, dtype=dtype).view(np.float64))


def decode(kind: FmiType, cells: np.ndarray) -> np.ndarray:
    """Cells of the run's vector, any shape, as numbers of the type; texts and bytes stay numbers of theirs."""
    if kind.real:
        return cells if kind.size == 8 else cells.astype(kind.dtype)
    whole = cells.view(np.uint64 if kind.dtype == np.uint64 else np.int64)
    return whole if kind.code in (TEXT, BINARY) else whole.astype(kind.dtype)


def encode_cells(values: np.ndarray) -> np.ndarray:
    """Numbers of one type, any shape, as cells of the run's vector; see `decode`."""
    if values.dtype.kind == "f":
        return values.astype(np.float64)
    return values.astype(np.uint64 if values.dtype == np.uint64 else np.int64).view(np.float64)
