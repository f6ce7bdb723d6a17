"""A small dense system of linear equations, in memory at addresses."""

from __future__ import annotations

from math import isfinite

from numba.extending import register_jitable

from ..cells import CELL
from ..memory import number, put


@register_jitable
def factorize_and_solve(matrix: int, right: int, n: int) -> bool:
    """Gauss with row pivots: solve for the `n` values at `right`, row by row in `matrix`; False if it is singular."""
    for k in range(n):
        best = k
        for i in range(k + 1, n):
            if abs(number(matrix + CELL * (n * i + k))) > abs(number(matrix + CELL * (n * best + k))):
                best = i
        pivot = number(matrix + CELL * (n * best + k))
        if pivot == 0.0 or not isfinite(pivot):
            return False
        if best != k:
            for j in range(n):
                a, b = matrix + CELL * (n * k + j), matrix + CELL * (n * best + j)
                value = number(a)
                put(a, number(b))
                put(b, value)
            value = number(right + CELL * k)
            put(right + CELL * k, number(right + CELL * best))
            put(right + CELL * best, value)
        for i in range(k + 1, n):
            factor = number(matrix + CELL * (n * i + k)) / pivot
            if factor != 0.0:
                for j in range(k + 1, n):
                    a = matrix + CELL * (n * i + j)
                    put(a, number(a) - factor * number(matrix + CELL * (n * k + j)))
                put(right + CELL * i, number(right + CELL * i) - factor * number(right + CELL * k))
    for k in range(n - 1, -1, -1):
        value = number(right + CELL * k)
        for j in range(k + 1, n):
            value -= number(matrix + CELL * (n * k + j)) * number(right + CELL * j)
        put(right + CELL * k, value / number(matrix + CELL * (n * k + k)))
    return True
