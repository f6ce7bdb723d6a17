"""The loop as a function of C: it takes the place of a table of arrays, and five whole numbers.

Numba would look at each of the arrays in every call, which costs more than a step of a small system; here they are
looked at once.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import partial
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
    TABLE, TABLE,
)  # fmt: skip
WHOLE_NUMBERS = 5  # behind them
WORDS = 3  # of an array: address, rows, columns
_DTYPES = {TABLE: np.int64, CELLS: np.int64, NUMBERS: np.float64, FLOATS: np.float32, BYTES: np.uint8}
# Python's lock is kept, as around any call of an extension: FMUs may call back into Python.
_PROTOTYPE = ctypes.PYFUNCTYPE(ctypes.c_int64, *(ctypes.c_int64,) * (1 + WHOLE_NUMBERS))
# A loop that waits gives it to other threads; FMUs that call back into Python take it as everybody does.
_WITHOUT_LOCK = ctypes.CFUNCTYPE(ctypes.c_int64, *(ctypes.c_int64,) * (1 + WHOLE_NUMBERS))

# The same, called with numbers of C: Python makes none of its own into them.
_PLAIN = ctypes.PYFUNCTYPE(ctypes.c_int64)


class Loop:
    """`run.run` by the address of its machine code. `owner` lives as long. `waits`: without Python's lock.
    `addresses`: what stands behind the arrays in the table, for code that wants it (`loop/straight/`); `one`: the same
    function with its six numbers in memory (`wrapped.with_its_numbers`), if there is one."""

    def __init__(
        self, address: int, owner: Any = None, waits: bool = False, addresses: np.ndarray | None = None, one: int = 0
    ) -> None:
        self._function, self._owner = (_WITHOUT_LOCK if waits else _PROTOTYPE)(address), owner
        self.waits, self._addresses, self.one = waits, addresses, one

    def __call__(self, *arguments: Any) -> int:
        """What `run.run` returns for the same arguments. Raises TypeError for an array of another kind."""
        return int(self.with_arrays(*arguments[: len(ARRAYS)])(*arguments[len(ARRAYS) :]))

    def with_arrays(self, *arrays: np.ndarray) -> Callable[..., int]:
        """The loop with its arrays, to be called with the whole numbers. Raises TypeError for one of another kind."""
        frame = np.zeros((len(ARRAYS) + 1, WORDS), dtype=np.int64)
        if self._addresses is not None:
            frame[-1, 0] = self._addresses.ctypes.data
        for k, (kind, array) in enumerate(zip(ARRAYS, arrays, strict=True)):
            if (
                array.dtype != _DTYPES[kind]
                or array.ndim != (2 if kind == TABLE else 1)
                or not array.flags.c_contiguous
            ):
                raise TypeError(f"argument {k} of the loop: {kind} wanted, not {array.dtype} {array.strides}")
            frame[k, 0], frame[k, 1 : 1 + array.ndim] = array.ctypes.data, array.shape
        function: Any = partial(self._function, int(frame.ctypes.data))
        function.alive = self, frame, arrays
        return function  # type: ignore[no-any-return]


def with_arrays(function: Callable[..., int], arrays: tuple[np.ndarray, ...]) -> Callable[..., int]:
    """`run.run` in any of its lives with its arrays, to be called with the whole numbers."""
    return function.with_arrays(*arrays) if isinstance(function, Loop) else partial(function, *arrays)


def one_cycle(function: Callable[..., int], ticks: int, numerator: int, denominator: int) -> Callable[[int], int]:
    """What `with_arrays` gave, to be called with a cycle, which it does alone: quicker, and it keeps Python's lock."""
    if not isinstance(function, partial) or not isinstance(function.func, _PROTOTYPE):
        return lambda cycle: function(cycle, 1, ticks, numerator, denominator)
    loop: Loop = function.alive[0]  # type: ignore[attr-defined]
    if loop.one:
        numbers = np.array([function.args[0], 0, 1, ticks, numerator, denominator], dtype=np.int64)
        cells, at = numbers.data, ctypes.c_int64(numbers.ctypes.data)
        call: Any = _PLAIN(loop.one)

        def one_in_memory(cycle: int) -> int:
            cells[1] = cycle
            return call(at)  # type: ignore[no-any-return]

        one_in_memory.alive = function, numbers  # type: ignore[attr-defined]
        return one_in_memory
    called: Any = _PLAIN(ctypes.cast(function.func, ctypes.c_void_p).value or 0)
    number = ctypes.c_int64()
    address, count, *clock = map(ctypes.c_int64, (function.args[0], 1, ticks, numerator, denominator))

    def one(cycle: int) -> int:
        number.value = cycle
        return called(address, number, count, *clock)  # type: ignore[no-any-return]

    made: Any = one
    made.alive = function
    return one
