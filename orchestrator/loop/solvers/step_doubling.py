"""The step controller of step doubling: a macro step is done whole and in two halves, and judged by the difference.

For held inputs, a method of first order, the difference estimates the error that the two halves make in the step: L. F.
Richardson, The deferred approach to the limit, Philosophical Transactions A 226 (1927) 299-361; E. Hairer, S. P.
Norsett, G. Wanner, Solving ordinary differential equations I, section II.4 (Eq. 4.3, 4.4, 4.13), with p = 1. The halves
are what the run goes on with. A step whose error is beyond the tolerance is done again, shorter.

The error is of second order in the step; that of an output which depends at once on a held input, of first order.
"""

from __future__ import annotations

import numpy as np

from ..cells import MINIMUM, NOW, OFFSET, STEP_TICKS
from ..lives import compilable
from .step_control import fitted

ACCEPTED, REJECTED, FAILED = range(3)
INDICATOR, WORST, REPEATED, WORK_CELLS = range(4)  # cells of `work`: of the step that was done last
TOLERANCE, SAFETY, SHRINK, GROW, ORDER, NOMINALS = range(6)  # of the settings, from k on
EVEN = 2  # ticks: a step has a middle


@compilable
def estimate(z: np.ndarray, p: int, n: int, clock: np.ndarray, settings: np.ndarray, k: int, work: np.ndarray) -> int:
    """Judge n signals, z[p : p + n] after the whole step, z[p + n : p + 2 n] after its halves, and choose a step.

    Accepted: the clock is moved on, and the next step is chosen. Rejected: the same step is to be done again, shorter.
    Failed: it is as short as allowed already.
    """
    eps = 0.0
    for i in range(n):
        size = max(settings[k + NOMINALS + i], abs(z[p + n + i]))
        error = abs(z[p + n + i] - z[p + i]) / (settings[k + TOLERANCE] * size)
        if error > eps:
            eps, work[WORST] = error, i
    work[INDICATOR] = eps
    factor = settings[k + GROW]
    if eps > 0.0:
        factor = min(
            max(settings[k + SAFETY] * eps ** (-1.0 / settings[k + ORDER]), settings[k + SHRINK]), settings[k + GROW]
        )
    clock[OFFSET], whole = 0, 2 * clock[STEP_TICKS]
    clock[STEP_TICKS] = whole
    if eps <= 1.0:
        clock[NOW] += whole
        clock[STEP_TICKS] = fitted(clock, int(whole * factor), EVEN)
        return ACCEPTED
    if whole <= clock[MINIMUM]:
        return FAILED
    work[REPEATED] += 1.0
    clock[STEP_TICKS] = max(int(whole * factor) // EVEN * EVEN, clock[MINIMUM])
    return REJECTED
