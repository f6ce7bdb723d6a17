"""Bounded least squares: the thrusts within their range that come closest to a wrench they cannot give.

    minimize  sum_i (W (B F - tau))_i^2 + 1e-6 |F|^2,   -k_T_reverse <= F_j <= k_T_forward

by an active set (Stark and Parker 1995; Haerkegaard 2002 for allocation). `W` weighs moments above the force's
direction, and that above its length: what is missed of the force is parted along tau's force and across it. The sum is
strictly convex, each round lowers it or ends, and every round is within the range: rounds that are cut off still leave
thrusts that can be had.
"""

from math import sqrt

from ..library.matrices import solve
from .parameters import Parameters
from .records import Scratch, State


def weighted(p: Parameters, x: State, s: Scratch) -> None:
    """W B and W tau: the force's row along tau's own direction has weight 1, those across and the moments more."""
    length = sqrt(s.tau[0] * s.tau[0] + s.tau[1] * s.tau[1] + s.tau[2] * s.tau[2])
    # A force beyond any that eight thrusters have asks for no more than that, or its length would outweigh the rest.
    shorter = min(1.0, 8.0 * max(p.k_T_forward, p.k_T_reverse) / max(length, 1e-9))
    for i in range(3):
        s.along[i] = s.tau[i] / length if length > 1e-9 else 0.0
    for j in range(8):
        part = 0.0
        for i in range(3):
            part = part + s.along[i] * x.B[i, j]
        for i in range(6):
            s.WB[i, j] = p.weight_moment * x.B[i, j]
        for i in range(3):
            s.WB[i, j] = p.weight_direction * x.B[i, j] + (1.0 - p.weight_direction) * part * s.along[i]
    for i in range(6):
        s.W_tau[i] = p.weight_moment * s.tau[i]
    for i in range(3):
        s.W_tau[i] = shorter * s.tau[i]


def normal_equations(s: Scratch) -> None:
    """H = (W B)^T W B + 1e-6 and c = (W B)^T W tau."""
    for j in range(8):
        for n in range(8):
            total = 0.0
            for i in range(6):
                total = total + s.WB[i, j] * s.WB[i, n]
            s.H[j, n] = total
        # Chooses among thrusts of equal wrench, as the pseudoinverse does; it costs a millionth of a thrust.
        s.H[j, j] = s.H[j, j] + 1e-6
        total = 0.0
        for i in range(6):
            total = total + s.WB[i, j] * s.W_tau[i]
        s.c[j] = total


def with_bounds_held(s: Scratch) -> None:
    """F_new: the best thrusts with those at a bound held there."""
    for j in range(8):
        s.F_new[j] = s.F[j]
        if s.bound[j] == 0.0:
            s.F_new[j] = s.c[j]
            for n in range(8):
                if s.bound[n] != 0.0:
                    s.F_new[j] = s.F_new[j] - s.H[j, n] * s.F[n]
        for n in range(8):
            s.A[j, n] = 0.0
            if s.bound[j] == 0.0 and s.bound[n] == 0.0:
                s.A[j, n] = s.H[j, n]
        if s.bound[j] != 0.0:
            s.A[j, j] = 1.0
    solve(s.A, s.F_new, 8)


def step_within(p: Parameters, s: Scratch) -> bool:
    """Go from F towards F_new as far as the range allows; False if a thrust came to its bound, where it is held."""
    share = 1.0
    first = -1
    for j in range(8):
        if s.bound[j] == 0.0:
            room = share
            if s.F_new[j] > p.k_T_forward:
                room = (p.k_T_forward - s.F[j]) / (s.F_new[j] - s.F[j])
            elif s.F_new[j] < -p.k_T_reverse:
                room = (-p.k_T_reverse - s.F[j]) / (s.F_new[j] - s.F[j])
            if room < share:
                share = room
                first = j
    for j in range(8):
        if s.bound[j] == 0.0:
            s.F[j] = s.F[j] + share * (s.F_new[j] - s.F[j])
    if first >= 0:
        s.bound[first] = 1.0 if s.F_new[first] > s.F[first] else -1.0
        s.F[first] = p.k_T_forward if s.bound[first] > 0.0 else -p.k_T_reverse
    return first < 0


def release(s: Scratch) -> bool:
    """Let go of the bound that holds back most; False if none does: the thrusts are the best."""
    worst = 1e-13 * s.scale
    chosen = -1
    for j in range(8):
        slope = -s.c[j]
        for n in range(8):
            slope = slope + s.H[j, n] * s.F[n]
        if s.bound[j] * slope > worst:
            worst = s.bound[j] * slope
            chosen = j
    if chosen >= 0:
        s.bound[chosen] = 0.0
    return chosen >= 0


def nearest(p: Parameters, x: State, s: Scratch) -> None:
    """F: the thrusts within their range with the least weighted error of the wrench tau."""
    weighted(p, x, s)
    normal_equations(s)
    s.scale = 0.0
    for j in range(8):
        s.scale = max(s.scale, abs(s.c[j]))
        s.bound[j] = 0.0
        if s.F[j] >= p.k_T_forward:
            s.F[j] = p.k_T_forward
            s.bound[j] = 1.0
        elif s.F[j] <= -p.k_T_reverse:
            s.F[j] = -p.k_T_reverse
            s.bound[j] = -1.0
    for _ in range(60):  # rounds: thousands of seeded wrenches need 20 at most, 5 in the mean
        with_bounds_held(s)
        if step_within(p, s) and not release(s):
            break
