"""Rods that touch nothing sleep: they cost nothing until they come near, and count by sums that one map moves (Eq. 4).

All rods of a group in free flight obey one linear map, w' = P w with w = (eta, eta_dot, 1). So do their sums: w w^T, of
which all energies and losses are linear functions, and w times cosine and sine of the place on the hub (Eq. 15).
"""

from math import cos, floor, pi, sin

from ..declare.record import Matrix
from .calendar import catch_up
from .filament import modal_mass, share_of
from .parameters import Parameters
from .reach import filament_at, is_far, known_swing, note_swing, span_in_step, swing_of, within_step
from .reactions import give, take
from .records import Constants, Inputs, Modes, Scratch, Stage, State, Stiffness
from .rods import at_strip, place
from .standing import at_begin


def may_sleep(p: Parameters) -> bool:
    """Few rods are sooner moved than booked; with drag each feels a flow of its own."""
    return p.C_d == 0.0 and p.n * p.n_strips >= 8


def wake_all(p: Parameters, x: State) -> None:
    """Everybody is awake and nothing noted."""
    in_group = p.n * p.n_strips
    for k in range(in_group * p.n_groups):
        x.clock[k] = -1.0
        x.swing[k] = 0.0
        x.is_late[k] = 0.0
        x.awake[k] = 1.0 * k
    for g in range(p.n_groups):
        x.awake_count[g] = 1.0 * in_group
        x.late_count[g] = 0.0
        for j in range(2 * p.N_m + 1):
            x.around[2 * g, j] = 0.0
            x.around[2 * g + 1, j] = 0.0
            for i in range(2 * p.N_m + 1):
                x.sums[(2 * p.N_m + 1) * g + i, j] = 0.0
    x.delta = 0.0
    x.delta_end = 0.0
    x.h_before = 0.0
    x.steps = 0.0
    x.epoch_begin = 0.0
    x.era_begin = 0.0


def component_of(j: int, f: Stage, p: Parameters) -> float:
    """Component j of w."""
    result = 1.0
    if j < p.N_m:
        result = f.eta[j]
    elif j < 2 * p.N_m:
        result = f.eta_dot[j - p.N_m]
    return result


def count_in(g: int, sign: float, i: int, f: Stage, p: Parameters, sums: Matrix, around: Matrix) -> None:
    """Add a rod of filament i to the sums of group g, or take it out of them."""
    size = 2 * p.N_m + 1
    angle = 2.0 * pi * i / p.n
    cosine = sign * cos(angle)
    sine = sign * sin(angle)
    for r in range(size):
        w = component_of(r, f, p)
        around[2 * g, r] = around[2 * g, r] + cosine * w
        around[2 * g + 1, r] = around[2 * g + 1, r] + sine * w
        for q in range(r + 1):
            product = sign * w * component_of(q, f, p)
            sums[size * g + r, q] = sums[size * g + r, q] + product
            if q < r:
                sums[size * g + q, r] = sums[size * g + r, q]


def filament_of(k: int, p: Parameters) -> int:
    """The filament that rod k is one of."""
    return k - p.n * floor((k + 0.5) / p.n)


def strip_of(k: int, g: int, p: Parameters) -> int:
    """The strip of rod k of group g."""
    return floor((k + 0.5) / p.n) - g * p.n_strips


def settle(g: int, h: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Those of group g that are awake, touch nothing and cannot reach the hull within this step fall asleep."""
    first = g * p.n * p.n_strips
    kept = 0
    for a in range(int(x.awake_count[g])):
        k = int(x.awake[first + a])
        sleepy = x.touches[k] == 0.0
        if sleepy:
            take(k, s.now, p, x)
            swing = swing_of(g, s.now, p, s.k, x.at_rest)
            there = at_strip(place(strip_of(k, g, p), p), u.delta, u, p)
            way = within_step(h, there, p)
            at = at_begin(filament_of(k, p), there.delta, p, x, s)
            sleepy = is_far(g, at, swing, way, s.c, x)
            if sleepy:
                fall_asleep(k, g, swing, p, x, s)
        if not sleepy:
            x.awake[first + kept] = 1.0 * k
            kept = kept + 1
    x.awake_count[g] = 1.0 * kept


def fall_asleep(k: int, g: int, swing: float, p: Parameters, x: State, s: Scratch) -> None:
    """Rod k, which is in `now`, sleeps from this step on."""
    give(k, s.now, p, x)
    x.z[k] = 0.0  # off the hull nothing bends them
    x.touches[k] = 0.0
    count_in(g, 1.0, filament_of(k, p), s.now, p, x.sums, x.around)
    x.swing[k] = note_swing(g, swing, x)
    stamp(k, g, p, x)
    x.since[g] = x.since[g] + 1.0
    if x.since[g] >= p.n * p.n_strips:
        look_for_widest(g, p, x)


def stamp(k: int, g: int, p: Parameters, x: State) -> None:
    """What the state holds of rod k is as of now."""
    x.clock[k] = x.steps
    if x.steps > x.epoch_begin and x.is_late[k] == 0.0:
        x.is_late[k] = 1.0
        x.late[g * p.n * p.n_strips + int(x.late_count[g])] = 1.0 * k
        x.late_count[g] = x.late_count[g] + 1.0


def look_for_widest(g: int, p: Parameters, x: State) -> None:
    """The largest bound of those asleep."""
    first = g * p.n * p.n_strips
    widest = -x.lift[g]
    for k in range(first, first + p.n * p.n_strips):
        if x.clock[k] >= 0.0:
            widest = max(widest, x.swing[k])
    x.widest[g] = widest
    x.since[g] = 0.0


def wake_near(g: int, h: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Sleepers of group g that may reach the hull within this step wake up."""
    for j in range(p.n_strips):
        there = at_strip(place(j, p), u.delta, u, p)
        way = within_step(h, there, p)
        within = span_in_step(g, j, way, p, s.c, x)
        for m in range(within.count):
            i = filament_at(within.first, m, p)
            k = (g * p.n_strips + j) * p.n + i
            if x.clock[k] >= 0.0:
                at = at_begin(i, there.delta, p, x, s)
                if not is_far(g, at, known_swing(g, x.swing[k], x), way, s.c, x):
                    catch_up(k, g, s.now, p, x, s)
                    give(k, s.now, p, x)
                    swing = swing_of(g, s.now, p, s.k, x.at_rest)
                    if is_far(g, at, swing, way, s.c, x):
                        x.swing[k] = note_swing(g, swing, x)
                        stamp(k, g, p, x)
                    else:
                        wake(k, g, i, p, x, s)


def wake(k: int, g: int, i: int, p: Parameters, x: State, s: Scratch) -> None:
    """Rod k of filament i, which is in `now`, is awake from this step on."""
    count_in(g, -1.0, i, s.now, p, x.sums, x.around)
    x.clock[k] = -1.0
    x.awake[g * p.n * p.n_strips + int(x.awake_count[g])] = 1.0 * k
    x.awake_count[g] = x.awake_count[g] + 1.0


def are_asleep(g: int, p: Parameters, x: State) -> bool:
    """Does anybody of group g sleep?"""
    return x.awake_count[g] < p.n * p.n_strips


def energy_of_sum(first: int, p: Parameters, k: Stiffness, sums: Matrix) -> float:
    """Kinetic, strain and centrifugal energy per modal mass, over rods whose sums begin at a row."""
    N_m = p.N_m
    energy = 0.0
    for r in range(N_m):
        energy = energy + 0.5 * sums[first + N_m + r, N_m + r] - k.load[r] * sums[first + r, 2 * N_m]
        for q in range(N_m):
            energy = energy + 0.5 * k.K[r, q] * sums[first + r, q]
    return energy


def carry(g: int, p: Parameters, x: State, s: Scratch) -> None:
    """The sums of group g after this step, and what damping takes of their energy."""
    size = 2 * p.N_m + 1
    first = size * g
    before = energy_of_sum(first, p, s.k, x.sums)
    last = size - 1  # the map leaves 1 as it is
    for i in range(last):
        for j in range(size):
            total = 0.0
            for k in range(size):
                total = total + s.P[i, k] * x.sums[first + k, j]
            s.Q[i, j] = total
    for i in range(last):
        for j in range(i + 1):
            total = 0.0
            for k in range(size):
                total = total + s.Q[i, k] * s.P[j, k]
            x.sums[first + i, j] = total
            x.sums[first + j, i] = total
        x.sums[first + i, last] = s.Q[i, last]
        x.sums[first + last, i] = s.Q[i, last]
    for row in range(2 * g, 2 * g + 2):
        for i in range(last):
            total = 0.0
            for k in range(size):
                total = total + s.P[i, k] * x.around[row, k]
            s.Q[0, i] = total
        for i in range(last):
            x.around[row, i] = s.Q[0, i]
    lost = modal_mass(s.c) * (before - energy_of_sum(first, p, s.k, x.sums))
    x.W_damping = x.W_damping + share_of(s.c) * lost


def centrifugal_energy_of_sum(first: int, p: Parameters, c: Constants, m: Modes, S: Matrix, sums: Matrix) -> float:
    """Centrifugal potential over omega_b^2, as `centrifugal_energy` of each."""
    energy = 0.0
    for r in range(p.N_m):
        energy = energy - c.chi * (c.x_t * m.int_Y[r] / c.L * sums[first + r, 2 * p.N_m] + 0.5 * sums[first + r, r])
        for q in range(p.N_m):
            energy = energy + 0.5 * S[r, q] * sums[first + r, q]
    return c.M * energy
