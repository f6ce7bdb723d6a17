"""The step controller of energy-conservation-based co-simulation.

S. Sadjina, L. T. Kyllingstad, S. Skjong, E. Pedersen, Energy conservation and power bonds in co-simulations:
non-iterative adaptive step size control and error estimation, Engineering with Computers 33 (2017) 607-620.

At the end of a step each side of a bond has a power: the signal that it received and held, times its own output. What
they differ by, times the step H, is the residual energy dE of the bond. With tolerances tau and the energy E that the
bond carries over the step, eps = sqrt(mean((dE / (tau_abs + tau_rel E))^2)), and a PI controller takes the next step
H alpha eps^-(k_I + k_P) eps_before^k_P, between limits of growth and of the step itself. No step is repeated.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from ..cells import MAXIMUM, MINIMUM, NOW, STEP_TICKS, STOP
from ..lives import compilable

SUM, BONDS, BEFORE = range(3)  # cells of `work`
LEAST = 1e-10  # of eps: a bond at rest would lengthen the step without end


@compilable
def gauge(
    z: np.ndarray, effort: int, held_effort: int, flow: int, held_flow: int, h: float,
    settings: np.ndarray, k: int, work: np.ndarray,
) -> None:  # fmt: skip
    """Add the square of one bond's indicator to `work`; settings from k on: tau_abs [J], tau_rel."""
    at_flow, at_effort = z[held_effort] * z[flow] * h, z[held_flow] * z[effort] * h
    carried = max(abs(at_flow), abs(at_effort))
    indicator = (at_flow - at_effort) / (settings[k] + settings[k + 1] * carried)
    work[SUM] += indicator * indicator
    work[BONDS] += 1.0


@compilable
def control(clock: np.ndarray, settings: np.ndarray, k: int, work: np.ndarray) -> float:
    """Move the clock to the end of the step that was done and choose the next one, 0 at the stop; the indicator eps.

    settings from k on: alpha, k_I, k_P, theta_min, theta_max.
    """
    eps = max(sqrt(work[SUM] / work[BONDS]), LEAST)
    before = work[BEFORE] if work[BEFORE] > 0.0 else eps
    factor = settings[k] * eps ** -(settings[k + 1] + settings[k + 2]) * before ** settings[k + 2]
    factor = min(max(factor, settings[k + 3]), settings[k + 4])
    work[SUM], work[BONDS], work[BEFORE] = 0.0, 0.0, eps
    clock[NOW] += clock[STEP_TICKS]
    clock[STEP_TICKS] = fitted(clock, int(clock[STEP_TICKS] * factor), 1)
    return eps


@compilable
def fitted(clock: np.ndarray, length: int, even: int) -> int:
    """The next step [ticks], a multiple of `even`: between its limits, never beyond the largest one, and so that no
    small rest is left before the stop: that is taken along, or shared between the two last steps."""
    length = min(max(length // even * even, clock[MINIMUM]), clock[MAXIMUM])
    left = clock[STOP] - clock[NOW]
    if left >= length + clock[MINIMUM]:
        return int(length)
    return int(left if left <= clock[MAXIMUM] else left // (2 * even) * even)
