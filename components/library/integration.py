"""Quadrature and step counts of the fixed-step integrations."""

from math import ceil

from ..declare.record import Vector


def runge_kutta_sum(h: float, k_1: float, k_2: float, k_3: float, k_4: float) -> float:
    """Increment of a classical fourth-order Runge-Kutta step of length h from the rates at its four stages."""
    return h / 6.0 * (k_1 + 2.0 * (k_2 + k_3) + k_4)


def equal_steps(h: float, longest: float) -> int:
    """Number of equal steps that cover h, none longer than `longest`, whatever the rounding of h."""
    return max(1, ceil(h / longest - 1e-6))


def runge_kutta_stage(
    size: int, x: Vector, k: Vector, weight: float, ahead: float, increment: Vector, stage: Vector,
) -> None:
    """Weigh the rates k of a stage into the increment, and go `ahead` from x at these rates to the next stage."""
    for i in range(size):
        increment[i] = increment[i] + weight * k[i]
        stage[i] = x[i] + ahead * k[i]
