"""Values of a table that is straight between its rows, by functions with two lives like `run.run`.

A table lies in the coefficients from k on: the number of rows n, n times that never fall, n values. Two rows of one
time are a jump: the second is in force from then on.
"""

from __future__ import annotations

import numpy as np

from .lives import compilable


@compilable
def row_at(table: np.ndarray, k: int, time: float) -> int:
    """The last row at or before a time; the first where there is none."""
    low, high = 0, int(table[k]) - 1
    while low < high:
        middle = (low + high + 1) // 2
        if table[k + 1 + middle] <= time:
            low = middle
        else:
            high = middle - 1
    return low


@compilable
def held_at(table: np.ndarray, k: int, time: float) -> float:
    """The cell of the last row at or before a time, bit by bit."""
    return table[k + 1 + int(table[k]) + row_at(table, k, time)]  # type: ignore[no-any-return]


@compilable
def _on_line(table: np.ndarray, k: int, row: int, time: float) -> float:
    """The line from a row to the next one, at a time; behind the last row its value."""
    n = int(table[k])
    t, v = k + 1 + row, k + 1 + n + row
    if row + 1 == n:
        return table[v]  # type: ignore[no-any-return]
    return table[v] + (table[v + 1] - table[v]) * ((time - table[t]) / (table[t + 1] - table[t]))  # type: ignore[no-any-return]


@compilable
def value_at(table: np.ndarray, k: int, time: float) -> float:
    """The value at a time."""
    return _on_line(table, k, row_at(table, k, time), time)


@compilable
def mean_over(table: np.ndarray, k: int, begin: float, end: float) -> float:
    """The mean from `begin` to `end`, exact for the lines: the value in the middle where no row lies between."""
    n = int(table[k])
    row = row_at(table, k, begin)
    if row + 1 == n or table[k + 2 + row] >= end:
        return _on_line(table, k, row, 0.5 * (begin + end))
    total, x, left = 0.0, begin, _on_line(table, k, row, begin)
    while row + 1 < n and table[k + 2 + row] < end:
        row += 1
        value = table[k + 1 + n + row]
        total += 0.5 * (left + value) * (table[k + 1 + row] - x)
        x, left = table[k + 1 + row], value
    total += 0.5 * (left + _on_line(table, k, row, end)) * (end - x)
    return total / (end - begin)
