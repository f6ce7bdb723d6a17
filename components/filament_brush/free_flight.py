"""Free flight: filaments that cannot reach the hull within a step share one linear map over it (Eq. 4)."""

from math import sqrt

from ..library.matrices import multiply
from .parameters import Parameters
from .records import Constants, Modes, Scratch, Stage, Stiffness


def free_flight(h: float, p: Parameters, c: Constants, m: Modes, k: Stiffness, s: Scratch) -> None:
    """Fill P with the map of (eta, eta_dot, 1) over h without contact: Runge-Kutta in 2^k equal micro-steps.

    For linear equations the classical Runge-Kutta step is the polynomial 1 + hA + .. + (hA)^4/24; k squarings of it
    give the whole step. omega_max times the micro-step is at most 0.2.
    """
    size = 2 * p.N_m + 1
    h_s = h
    squarings = 0
    while h_s * c.omega_max > 0.2 and squarings < 60:
        h_s = 0.5 * h_s
        squarings = squarings + 1
    linear_equations(h_s, p, m, k, s)
    for order in range(4):
        multiply(size, s.A, s.P, s.Q)
        for i in range(size):
            for j in range(size):
                s.P[i, j] = s.Q[i, j] / (4.0 - order)
            s.P[i, i] = s.P[i, i] + 1.0
    for _ in range(squarings):
        multiply(size, s.P, s.P, s.Q)
        for i in range(size):
            for j in range(size):
                s.P[i, j] = s.Q[i, j]


def linear_equations(h_s: float, p: Parameters, m: Modes, k: Stiffness, s: Scratch) -> None:
    """A h_s of the rates of (eta, eta_dot, 1), and P = 1."""
    N_m = p.N_m
    for i in range(2 * N_m + 1):
        for j in range(2 * N_m + 1):
            s.A[i, j] = 0.0
            s.P[i, j] = 0.0
        s.P[i, i] = 1.0
    for r in range(N_m):
        s.A[r, N_m + r] = h_s
        s.A[N_m + r, N_m + r] = -h_s * m.damping[r]  # Eq. 4
        s.A[N_m + r, 2 * N_m] = h_s * k.load[r]
        for q in range(N_m):
            s.A[N_m + r, q] = -h_s * k.K[r, q]


def relative_energy(f: Stage, p: Parameters, k: Stiffness) -> float:
    """Kinetic, strain and centrifugal energy per modal mass."""
    energy = 0.0
    for r in range(p.N_m):
        pull = -k.load[r]
        for s in range(p.N_m):
            pull = pull + 0.5 * k.K[r, s] * f.eta[s]
        energy = energy + 0.5 * f.eta_dot[r] * f.eta_dot[r] + pull * f.eta[r]
    return energy


def advance_free(now: Stage, after: Stage, p: Parameters, k: Stiffness, s: Scratch) -> float:
    """Map a filament over the communication step; returns the energy lost per modal mass, all of it to damping."""
    N_m = p.N_m
    before = relative_energy(now, p, k)
    for r in range(N_m):
        after.eta[r] = s.P[r, 2 * N_m]
        after.eta_dot[r] = s.P[N_m + r, 2 * N_m]
        for q in range(N_m):
            after.eta[r] = after.eta[r] + s.P[r, q] * now.eta[q] + s.P[r, N_m + q] * now.eta_dot[q]
            after.eta_dot[r] = after.eta_dot[r] + s.P[N_m + r, q] * now.eta[q] + s.P[N_m + r, N_m + q] * now.eta_dot[q]
    for r in range(N_m):
        now.eta[r] = after.eta[r]
        now.eta_dot[r] = after.eta_dot[r]
    now.z = 0.0
    return before - relative_energy(now, p, k)


def tip_speed_bound(f: Stage, p: Parameters, k: Stiffness) -> float:
    """Bound on the tip speed of free vibration: all energy kinetic, modes in phase, times 1.5."""
    speed = 0.0
    for r in range(p.N_m):
        speed = speed + 3.0 * sqrt(f.eta_dot[r] * f.eta_dot[r] + k.K[r, r] * f.eta[r] * f.eta[r])
    return speed
