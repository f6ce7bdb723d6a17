"""One-step methods: a trial step from the states at TIME, whose first right-hand side is known.

The pair of Dormand and Prince of orders 5 and 4 (J. Comput. Appl. Math. 6, 1980) and the classical method of Runge and
Kutta of order 4. Both end with the right-hand side at the end of the step: the members stand there then, and the next
step begins with it.
"""

from __future__ import annotations

from math import isfinite, sqrt

from numba.extending import register_jitable

from .cells import (
    ABSOLUTE,
    CELL,
    K1,
    K2,
    METHOD,
    NOT_FINITE,
    OK,
    RELATIVE,
    RETRY,
    RUNGE_KUTTA,
    STAGE,
    STATES,
    TRIAL,
    X_NEW,
    X,
)  # fmt: skip
from .members import evaluate, fault
from .memory import call, number, put, whole

A21 = 1 / 5
A31, A32 = 3 / 40, 9 / 40
A41, A42, A43 = 44 / 45, -56 / 15, 32 / 9
A51, A52, A53, A54 = 19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729
A61, A62, A63, A64, A65 = 9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656
B1, B3, B4, B5, B6 = 35 / 384, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84
E1, E3, E4, E5, E6, E7 = 71 / 57600, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40


@register_jitable
def trial(g: int, time: float, h: float) -> int:
    """A step over `h` [s] to X_NEW, and the right-hand side there; a status."""
    return call(whole(g + TRIAL), g, time, h)


def try_step(g: int, time: float, h: float) -> int:
    """What TRIAL is the address of."""
    if whole(g + METHOD) == RUNGE_KUTTA:
        return runge_kutta(g, time, h)
    return dormand_prince(g, time, h)


@register_jitable
def last_derivative(g: int) -> int:
    """Where a trial step leaves the right-hand side at its end."""
    size = CELL * max(whole(g + STATES), 1)
    return whole(g + K2) + (3 * size if whole(g + METHOD) == RUNGE_KUTTA else 5 * size)


@register_jitable
def dormand_prince(g: int, time: float, h: float) -> int:
    """All its stages; the argument of the last but one stays in STAGE."""
    n, x, y, new = whole(g + STATES), whole(g + X), whole(g + STAGE), whole(g + X_NEW)
    size = CELL * max(n, 1)
    k1, k2 = whole(g + K1), whole(g + K2)
    k3, k4, k5, k6, k7 = k2 + size, k2 + 2 * size, k2 + 3 * size, k2 + 4 * size, k2 + 5 * size
    for j in range(0, CELL * n, CELL):
        put(y + j, number(x + j) + h * (A21 * number(k1 + j)))
    status = evaluate(g, time + h * 0.2, y, k2)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        put(y + j, number(x + j) + h * (A31 * number(k1 + j) + A32 * number(k2 + j)))
    status = evaluate(g, time + h * 0.3, y, k3)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        put(y + j, number(x + j) + h * (A41 * number(k1 + j) + A42 * number(k2 + j) + A43 * number(k3 + j)))
    status = evaluate(g, time + h * 0.8, y, k4)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        slope = A51 * number(k1 + j) + A52 * number(k2 + j) + A53 * number(k3 + j) + A54 * number(k4 + j)
        put(y + j, number(x + j) + h * slope)
    status = evaluate(g, time + h * (8 / 9), y, k5)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        slope = A61 * number(k1 + j) + A62 * number(k2 + j) + A63 * number(k3 + j) + A64 * number(k4 + j)
        put(y + j, number(x + j) + h * (slope + A65 * number(k5 + j)))
    status = evaluate(g, time + h, y, k6)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        slope = B1 * number(k1 + j) + B3 * number(k3 + j) + B4 * number(k4 + j) + B5 * number(k5 + j)
        put(new + j, number(x + j) + h * (slope + B6 * number(k6 + j)))
    return evaluate(g, time + h, new, k7)


@register_jitable
def error_of(g: int, h: float) -> float:
    """The error of the step of Dormand and Prince that was tried, as a multiple of what is allowed."""
    n, x, new = whole(g + STATES), whole(g + X), whole(g + X_NEW)
    size = CELL * max(n, 1)
    k1, k3 = whole(g + K1), whole(g + K2) + size
    k4, k5, k6, k7 = k3 + size, k3 + 2 * size, k3 + 3 * size, k3 + 4 * size
    absolute, relative = whole(g + ABSOLUTE), number(g + RELATIVE)
    total = 0.0
    for j in range(0, CELL * n, CELL):
        slope = E1 * number(k1 + j) + E3 * number(k3 + j) + E4 * number(k4 + j) + E5 * number(k5 + j)
        error = h * (slope + E6 * number(k6 + j) + E7 * number(k7 + j))
        scale = number(absolute + j) + relative * max(abs(number(x + j)), abs(number(new + j)))
        total += (error / scale) * (error / scale)
    if n == 0:
        return 0.0
    total = sqrt(total / n)
    if not isfinite(total):
        fault(g, NOT_FINITE, 0, 0, -1)
        return 1e30
    return total


@register_jitable
def stiffness(g: int, h: float) -> float:
    """The step times the largest eigenvalue that it saw (Hairer and Wanner, Solving ODEs II, IV.2)."""
    n, new, y = whole(g + STATES), whole(g + X_NEW), whole(g + STAGE)
    size = CELL * max(n, 1)
    k6 = whole(g + K2) + 4 * size
    k7, above, below = k6 + size, 0.0, 0.0
    for j in range(0, CELL * n, CELL):
        slope, shift = number(k7 + j) - number(k6 + j), number(new + j) - number(y + j)
        above += slope * slope
        below += shift * shift
    return h * sqrt(above / below) if below > 0.0 else 0.0


@register_jitable
def runge_kutta(g: int, time: float, h: float) -> int:
    """The classical method, and the right-hand side at the end."""
    n, x, y, new = whole(g + STATES), whole(g + X), whole(g + STAGE), whole(g + X_NEW)
    size = CELL * max(n, 1)
    k1, k2 = whole(g + K1), whole(g + K2)
    k3, k4, k5 = k2 + size, k2 + 2 * size, k2 + 3 * size
    for j in range(0, CELL * n, CELL):
        put(y + j, number(x + j) + (0.5 * h) * number(k1 + j))
    status = evaluate(g, time + 0.5 * h, y, k2)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        put(y + j, number(x + j) + (0.5 * h) * number(k2 + j))
    status = evaluate(g, time + 0.5 * h, y, k3)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        put(y + j, number(x + j) + h * number(k3 + j))
    status = evaluate(g, time + h, y, k4)
    if status != OK:
        return status
    for j in range(0, CELL * n, CELL):
        slope = number(k1 + j) + 2.0 * number(k2 + j) + 2.0 * number(k3 + j) + number(k4 + j)
        put(new + j, number(x + j) + (h / 6.0) * slope)
        if not isfinite(number(new + j)):
            fault(g, NOT_FINITE, 0, 0, -1)
            return RETRY
    return evaluate(g, time + h, new, k5)
