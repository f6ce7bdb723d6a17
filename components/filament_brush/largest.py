"""The largest deflection of those that sleep: looked for one by one only where bounds leave it open."""

from math import sqrt

from .calendar import catch_up
from .modes import deflection_ratio
from .parameters import Parameters
from .reach import known_swing, note_swing, swing_of, tip_range
from .reactions import give
from .records import Constants, Modes, Scratch, State, Stiffness
from .sleepers import stamp


def largest_asleep(
    g: int, so_far: float, p: Parameters, c: Constants, m: Modes, k: Stiffness, x: State, s: Scratch,
) -> float:
    """The largest |y(L)|/L of the sleepers of group g where this step begins, or `so_far` if none is larger.

    Nobody is beyond the largest bound on a swing, nor farther from the mean of all N than (N-1)/N of the root of the
    sum of the squares about it; somebody is as large as the root of their mean square. Who is looked at shows how far
    it swings by now, so that it is not looked at for long.
    """
    close = 1e-4  # a ratio by which one that is not looked at may be larger
    first = g * (2 * p.N_m + 1)
    count = x.sums[first + 2 * p.N_m, 2 * p.N_m]
    mean = 0.0
    square = 0.0
    for r in range(p.N_m):
        mean = mean + m.Y_L[r] * x.sums[first + r, 2 * p.N_m] / count
        for q in range(p.N_m):
            square = square + m.Y_L[r] * m.Y_L[q] * x.sums[first + r, q] / count
    square = max(square, mean * mean)
    largest = max(so_far, sqrt(square) / c.L)
    beyond = sqrt((square - mean * mean) * max(count - 1.0, 0.0))
    if min(abs(mean) + beyond, bends_at_most(g, x.widest[g], x)) > c.L * (largest + close):
        for rod in range(g * p.n * p.n_strips, (g + 1) * p.n * p.n_strips):
            if x.clock[rod] >= 0.0 and bends_at_most(g, x.swing[rod], x) > c.L * (largest + close):
                catch_up(rod, g, s.now, p, x, s)
                give(rod, s.now, p, x)
                x.swing[rod] = note_swing(g, swing_of(g, s.now, p, k, x.at_rest), x)
                stamp(rod, g, p, x)
                largest = max(largest, deflection_ratio(s.now, p, c, m))
    return largest


def bends_at_most(g: int, bound: float, x: State) -> float:
    """How far a rod bends at most that swings as was noted."""
    y = 1e3
    if x.y_per_swing[g] > 0.0:
        y = abs(x.y_rest[g]) + tip_range(g, known_swing(g, bound, x), x)
    return y
