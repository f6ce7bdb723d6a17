"""The solver of an iterated macro step, as a state machine: it sees one pass, and says what the next one begins with.

The unknowns u are the inputs of the step, one by one; a pass gives their images g(u), the means of what their sources
made of u; wanted is g(u) = u. Fixed point with Aitken's relaxation (U. Kuettler, W. A. Wall, Fixed-point
fluid-structure interaction solvers with dynamic relaxation, Computational Mechanics 43 (2008) 61-72, Eq. 36), or
Newton with the Jacobian by forward differences, a pass for each unknown; it is kept while the residual falls tenfold.
Both work with residuals relative to the size of each unknown, which takes their units away.
"""

from __future__ import annotations

import numpy as np

from ..lives import compilable

CONVERGED, AGAIN, FAILED = range(3)
COUNT, COLUMN, RESIDUAL, WORST, FACTOR, STEP, HEAD = range(7)  # cells of `work`, and where its vectors begin
AITKEN, NEWTON = range(2)
SETTINGS = 3  # tolerance, largest number of iterations, method; the nominal values of the unknowns follow
ROOT_EPSILON = 2.0**-26


def workspace(unknowns: int, newton: bool) -> np.ndarray:
    """The array that `iterate` keeps its state in."""
    work = np.zeros(HEAD + 2 * unknowns + (2 * unknowns**2 if newton else 0))
    work[COLUMN] = -1.0
    return work


@compilable
def iterate(z: np.ndarray, u: int, g: int, n: int, settings: np.ndarray, k: int, work: np.ndarray) -> int:
    """Look at the pass that was just done and choose the unknowns of the next one.

    z[u : u + n] are the unknowns, z[g : g + n] their images, z[u - 2] and z[u - 1] get the number of iterations and
    the residual; `settings` from k on: see SETTINGS. Returns CONVERGED, AGAIN or FAILED.
    """
    if work[COLUMN] >= 0.0:
        return _next_column(z, u, g, n, settings, k, work)
    last, base = HEAD, HEAD + n
    before, residual = work[RESIDUAL], 0.0
    above, below = 0.0, 0.0
    for i in range(n):
        r = z[g + i] - z[u + i]
        scale = max(settings[k + SETTINGS + i], abs(z[g + i]))
        if abs(r) / scale > residual:
            residual, work[WORST] = abs(r) / scale, i
        change = (r - work[last + i]) / scale
        above += work[last + i] / scale * change
        below += change * change
        work[last + i] = r
    work[COUNT] += 1.0
    work[RESIDUAL] = residual
    if residual <= settings[k]:
        z[u - 2], z[u - 1] = work[COUNT], residual
        work[COUNT] = 0.0
        return CONVERGED
    if work[COUNT] >= settings[k + 1]:
        return FAILED
    if settings[k + 2] == AITKEN:
        work[FACTOR] = 1.0 if work[COUNT] == 1.0 or below == 0.0 else -work[FACTOR] * above / below
        for i in range(n):
            z[u + i] += work[FACTOR] * work[last + i]
        return AGAIN
    for i in range(n):
        work[base + i] = z[u + i]
    if work[COUNT] == 1.0 or residual > 0.1 * before:
        _perturb(z, u, 0, settings, k, work)
        return AGAIN
    return _newton_step(z, u, n, work)


@compilable
def _perturb(z: np.ndarray, u: int, column: int, settings: np.ndarray, k: int, work: np.ndarray) -> None:
    work[COLUMN] = column
    work[STEP] = ROOT_EPSILON * max(settings[k + SETTINGS + column], abs(z[u + column]))
    z[u + column] += work[STEP]


@compilable
def _next_column(z: np.ndarray, u: int, g: int, n: int, settings: np.ndarray, k: int, work: np.ndarray) -> int:
    """Take one column of the Jacobian of the residual from a pass with one unknown moved."""
    last, base, jacobian = HEAD, HEAD + n, HEAD + 2 * n
    column = int(work[COLUMN])
    for i in range(n):
        moved = z[g + i] - z[u + i]
        work[jacobian + i * n + column] = (moved - work[last + i]) / work[STEP]
    z[u + column] = work[base + column]
    if column + 1 < n:
        _perturb(z, u, column + 1, settings, k, work)
        return AGAIN
    work[COLUMN] = -1.0
    return _newton_step(z, u, n, work)


@compilable
def _newton_step(z: np.ndarray, u: int, n: int, work: np.ndarray) -> int:
    """u = base - J^-1 r, by elimination with row pivoting on a copy of J; FAILED if it is singular."""
    last, base, jacobian = HEAD, HEAD + n, HEAD + 2 * n
    a = jacobian + n * n
    for i in range(n * n):
        work[a + i] = work[jacobian + i]
    for i in range(n):
        z[u + i] = -work[last + i]
    for j in range(n):
        pivot = j
        for i in range(j + 1, n):
            if abs(work[a + i * n + j]) > abs(work[a + pivot * n + j]):
                pivot = i
        if work[a + pivot * n + j] == 0.0:
            return FAILED
        for m in range(n):
            work[a + j * n + m], work[a + pivot * n + m] = work[a + pivot * n + m], work[a + j * n + m]
        z[u + j], z[u + pivot] = z[u + pivot], z[u + j]
        for i in range(j + 1, n):
            ratio = work[a + i * n + j] / work[a + j * n + j]
            for m in range(j, n):
                work[a + i * n + m] -= ratio * work[a + j * n + m]
            z[u + i] -= ratio * z[u + j]
    for j in range(n - 1, -1, -1):
        for m in range(j + 1, n):
            z[u + j] -= work[a + j * n + m] * z[u + m]
        z[u + j] /= work[a + j * n + j]
    for i in range(n):
        z[u + i] += work[base + i]
    return AGAIN
