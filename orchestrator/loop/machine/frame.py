"""The loop as a function of C: it takes the place of a table of arrays, and five whole numbers.

Numba would look at each of the arrays in every call, which costs more than a step of a small system; here they are
looked at when they change.
"""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np

TABLE, CELLS, NUMBERS, FLOATS, BYTES = "table", "cells", "numbers", "floats", "bytes"
ARRAYS = (  # of `run.run`, in its order
    TABLE, NUMBERS, TABLE, TABLE,
    NUMBERS, CELLS, BYTES, FLOATS, BYTES, CELLS,
    CELLS, TABLE, NUMBERS, CELLS,
    CELLS,
    CELLS, NUMBERS, NUMBERS, NUMBERS,
    CELLS, TABLE,
)  # fmt: skip
WHOLE_NUMBERS = 5  # behind them
WORDS = 3  # of an array: address, rows, columns
_DTYPES = {TABLE: np.int64, CELLS: np.int64, NUMBERS: np.float64, FLOATS: np.float32, BYTES: np.uint8}
# Python's lock is kept, as around any call of an extension: FMUs may call back into Python.
_PROTOTYPE = ctypes.PYFUNCTYPE(ctypes.c_int64, *(ctypes.c_int64,) * (1 + WHOLE_NUMBERS))


class Loop:
    """`run.run` by the address of its machine code; each session has one. `owner` lives as long."""

    def __init__(self, address: int, owner: Any = None) -> None:
        self._function, self._owner = _PROTOTYPE(address), owner
        self._frame = np.zeros((len(ARRAYS), WORDS), dtype=np.int64)
        self._at = int(self._frame.ctypes.data)
        self._arrays: list[np.ndarray | None] = [None] * len(ARRAYS)

    def __call__(self, *arguments: Any) -> int:
        """What `run.run` returns for the same arguments. Raises TypeError for an array of another kind."""
        known = self._arrays
        for k in range(len(ARRAYS)):
            if arguments[k] is not known[k]:
                self._place(k, arguments[k])
        return int(self._function(self._at, *arguments[len(ARRAYS) :]))

    def _place(self, k: int, array: np.ndarray) -> None:
        kind = ARRAYS[k]
        rows, columns = array.shape if kind == TABLE else (*array.shape, 1)
        if array.dtype != _DTYPES[kind] or not array.flags.c_contiguous:
            raise TypeError(f"argument {k} of the loop: {kind} wanted, not {array.dtype} {array.strides}")
        self._frame[k] = array.ctypes.data, rows, columns
        self._arrays[k] = array
