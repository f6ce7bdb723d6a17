"""Thruster allocation (Eq. 20): the pseudoinverse of B, and thrusts within their range."""

from ..library.matrices import invert
from .bounded import nearest
from .parameters import Parameters
from .records import Scratch, State


def pseudoinverse(x: State, s: Scratch) -> None:
    """B^+ = B^T (B B^T)^-1."""
    for i in range(6):
        for n in range(6):
            s.BB[i, n] = 0.0
            for j in range(8):
                s.BB[i, n] += x.B[i, j] * x.B[n, j]
    invert(s.BB, s.BB_inv, 6)
    for j in range(8):
        for i in range(6):
            x.B_pinv[j, i] = 0.0
            for n in range(6):
                x.B_pinv[j, i] += x.B[n, j] * s.BB_inv[n, i]


def add_within(first: int, last: int, p: Parameters, x: State, s: Scratch) -> float:
    """Add the thrusts of tau[first..last-1] to F, scaled so that every thrust stays in its range; returns the scale."""
    scale = 1.0
    for j in range(8):
        wanted = 0.0
        for i in range(first, last):
            wanted += x.B_pinv[j, i] * s.tau[i]
        # The margin keeps a thruster that is already full from rounding to a hair beyond.
        if s.F[j] + wanted > p.k_T_forward and wanted > 1e-12 * p.k_T_forward:
            scale = min(scale, max(0.0, p.k_T_forward - s.F[j]) / wanted)
        if s.F[j] + wanted < -p.k_T_reverse and wanted < -1e-12 * p.k_T_reverse:
            scale = min(scale, max(0.0, p.k_T_reverse + s.F[j]) / -wanted)
    for j in range(8):
        for i in range(first, last):
            s.F[j] += scale * x.B_pinv[j, i] * s.tau[i]
    return scale


def by_pseudoinverse(p: Parameters, x: State, s: Scratch) -> bool:
    """Thrusts F = B^+ tau, whatever their range; True if one is beyond it."""
    beyond = False
    for j in range(8):
        s.F[j] = 0.0
        for i in range(6):
            s.F[j] += x.B_pinv[j, i] * s.tau[i]  # Eq. 20
        if s.F[j] > p.k_T_forward or s.F[j] < -p.k_T_reverse:
            beyond = True
    return beyond


def is_missed(p: Parameters, x: State, s: Scratch) -> bool:
    """Do the thrusts give another wrench than tau?"""
    missed = False
    for i in range(6):
        given = 0.0
        for j in range(8):
            given += x.B[i, j] * s.F[j]  # Eq. 20
        if abs(given - s.tau[i]) > 1e-4 * p.k_T_forward:  # what the regular part of the least squares costs is below
            missed = True
    return missed


def allocate(p: Parameters, x: State, s: Scratch) -> bool:
    """Thrusts F = B^+ tau within their range; True if tau cannot be had in full.

    With `bounded_least_squares` the nearest wrench that can be had, the moments and the force's direction before its
    length. Else with `attitude_first` the moments come first and the forces get what is left, one after the other;
    otherwise every thruster is clipped by itself, which at saturation also bends the moments.
    """
    saturated = False
    for j in range(8):
        s.F[j] = 0.0
    if p.bounded_least_squares:
        if by_pseudoinverse(p, x, s):
            nearest(p, x, s)
            saturated = is_missed(p, x, s)
    elif p.attitude_first:
        if add_within(3, 6, p, x, s) < 1.0:
            saturated = True
        for i in range(3):
            if add_within(i, i + 1, p, x, s) < 1.0:
                saturated = True
    else:
        saturated = by_pseudoinverse(p, x, s)
        for j in range(8):
            s.F[j] = max(-p.k_T_reverse, min(p.k_T_forward, s.F[j]))
    return saturated
