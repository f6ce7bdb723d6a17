"""A planar inextensible rod on a turning hub, its tip on a hull: exact kinematics, dynamics by polynomials.

The rod's angle is theta(s) = psi + sum q_k P_k(s), P_k the integral of a Legendre polynomial: no bending mode, no small
deflection, no rotating frame. Its equations are Lagrange's with all that inertia does, centrifugal and Coriolis forces
too. Angles are from +z_t, into the hull, towards +x_t, the sweep. Nothing of the brush's kernel is used here.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, exp, sin, sqrt

import numpy as np
from numba import njit
from numpy.polynomial import legendre
from scipy.linalg import eigh

POINTS = 16  # of Gauss and Legendre along the rod


@dataclass(frozen=True)
class Rod:
    """A bundle of bristles, the hub that turns it and the hull it sweeps; names and units as the brush has them."""

    L: float
    d: float
    E: float
    rho: float
    bristles: float
    R_brush: float
    alpha: float
    zeta: float
    k_c: float
    mu_s: float
    mu_c: float
    v_0: float
    k_v: float
    v_eps: float
    delta: float
    omega_b: float
    v_rov: float

    @property
    def R_h(self) -> float:
        """Radius of the root: the undeformed tip lies on R_brush."""
        return float(np.sqrt(self.R_brush**2 - (self.L * np.sin(self.alpha)) ** 2) - self.L * np.cos(self.alpha))


class Matrices:
    """What is constant: the polynomials at Gauss points, integrals from the root, stiffness and damping."""

    def __init__(self, rod: Rod, terms: int) -> None:
        x, weights = legendre.leggauss(POINTS)
        self.weights = 0.5 * weights
        integrals = [legendre.legint(np.eye(terms)[k], lbnd=-1) for k in range(terms)]
        self.P = np.array([legendre.legval(x, c) for c in integrals]).T.copy()
        slopes = 2.0 * legendre.legvander(x, terms - 1)  # over s/L, which runs from 0 to 1
        from_root = [0.5 * legendre.legval(x, legendre.legint(row, lbnd=-1)) for row in np.eye(POINTS)]
        self.A = np.array(from_root).T @ np.linalg.inv(legendre.legvander(x, POINTS - 1))
        self.mass = rod.bristles * rod.rho * np.pi * rod.d**2 / 4.0 * rod.L
        EI = rod.bristles * rod.E * np.pi * rod.d**4 / 64.0
        self.K = EI / rod.L * (slopes.T * self.weights) @ slopes
        # The same damping ratio for every mode of the straight rod at rest.
        across = rod.L * self.A @ self.P
        M = self.mass * (across.T * self.weights) @ across
        squares, modes = eigh(self.K, M)
        self.omega = np.sqrt(squares)
        self.C = M @ modes @ np.diag(2.0 * rod.zeta * self.omega) @ modes.T @ M


@njit
def _friction(v: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float) -> float:
    mu = mu_c + (mu_s - mu_c) * exp(-(v / v_0) * (v / v_0)) + k_v * abs(v)  # Eq. 9
    return mu * v / sqrt(sqrt(v**4 + v_eps**4))


@njit
def _solve(M: np.ndarray, x: np.ndarray, first: int) -> None:
    """By Cholesky: M, read in its lower half, is spoilt; x from `first` on goes from right-hand side to solution."""
    n = M.shape[0]
    for k in range(n):
        for r in range(k + 1):
            total = M[k, r]
            for i in range(r):
                total -= M[k, i] * M[r, i]
            M[k, r] = sqrt(total) if r == k else total / M[r, r]
        for i in range(k):
            x[first + k] -= M[k, i] * x[first + i]
        x[first + k] /= M[k, k]
    for k in range(n - 1, -1, -1):
        for i in range(k + 1, n):
            x[first + k] -= M[i, k] * x[first + i]
        x[first + k] /= M[k, k]


@njit
def _rates(y, phi, numbers, P, A, weights, K, C, J, M, b, out):  # type: ignore[no-untyped-def]
    """Of y = q, q', impulses; J, M, b are scratch: dr/dq at the points, the mass matrix, what r'' has without q''."""
    L, R_h, alpha, mass, plane, omega_b, v_rov, k_c, mu_s, mu_c, v_0, k_v, v_eps = numbers
    m, n = P.shape
    root_x, root_z = R_h * sin(phi), R_h * cos(phi)
    x, z, v_x = root_x, root_z, omega_b * root_z
    J[:] = 0.0  # the last row is the tip's
    for i in range(m):
        b[0, i], b[1, i] = -omega_b * omega_b * root_x, -omega_b * omega_b * root_z
    for j in range(m):
        theta, theta_dot = phi - alpha, omega_b
        for k in range(n):
            theta += P[j, k] * y[k]
            theta_dot += P[j, k] * y[n + k]
        s, c = sin(theta), cos(theta)
        x += L * weights[j] * s
        z += L * weights[j] * c
        v_x += L * weights[j] * c * theta_dot
        for i in range(m + 1):
            a = L * (A[i, j] if i < m else weights[j])
            if i < m:
                b[0, i] -= a * s * theta_dot * theta_dot
                b[1, i] -= a * c * theta_dot * theta_dot
            for k in range(n):
                J[0, i, k] += a * c * P[j, k]
                J[1, i, k] -= a * s * P[j, k]
    F_n, F_f = 0.0, 0.0
    if z > plane:
        F_n = k_c * (z - plane) * sqrt(z - plane)  # Eq. 7
        F_f = F_n * _friction(v_x - v_rov, mu_s, mu_c, v_0, k_v, v_eps)
    for k in range(n):
        total = -F_f * J[0, m, k] - F_n * J[1, m, k]
        for r in range(n):
            total -= K[k, r] * y[r] + C[k, r] * y[n + r]
        for i in range(m):
            total -= mass * weights[i] * (J[0, i, k] * b[0, i] + J[1, i, k] * b[1, i])
        for r in range(k + 1):
            product = 0.0
            for i in range(m):
                product += weights[i] * (J[0, i, k] * J[0, i, r] + J[1, i, k] * J[1, i, r])
            M[k, r] = mass * product
        out[k], out[n + k] = y[n + k], total
    _solve(M, out, n)
    out[2 * n], out[2 * n + 1], out[2 * n + 2] = -F_f, -F_n, x * F_n - z * F_f


@njit
def _run(phi, h, steps, numbers, P, A, weights, K, C, y):  # type: ignore[no-untyped-def]
    """Classical Runge-Kutta steps from the root's angle phi; y is where it starts and ends."""
    m, n = P.shape
    J, M, b = np.zeros((2, m + 1, n)), np.zeros((n, n)), np.zeros((2, m))
    rates, at = np.zeros((4, y.shape[0])), np.zeros(y.shape[0])
    for step in range(steps):
        for stage in range(4):
            share = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
            for k in range(y.shape[0]):
                at[k] = y[k] + (share * h * rates[stage - 1, k] if stage else 0.0)
            angle = phi + numbers[5] * h * (step + share)
            _rates(at, angle, numbers, P, A, weights, K, C, J, M, b, rates[stage])
        for k in range(y.shape[0]):
            y[k] += h / 6.0 * (rates[0, k] + 2.0 * (rates[1, k] + rates[2, k]) + rates[3, k])


def means(rod: Rod, terms: int, per_turn: int, turns: int) -> np.ndarray:
    """Mean F_x, F_z and moment about the hub of one rod over the last of `turns` turns, from straight and at rest."""
    on, R_h = Matrices(rod, terms), rod.R_h
    numbers = (rod.L, R_h, rod.alpha, on.mass, rod.R_brush - rod.delta, rod.omega_b, rod.v_rov, rod.k_c,
               rod.mu_s, rod.mu_c, rod.v_0, rod.k_v, rod.v_eps)  # fmt: skip
    h, y = 2.0 * np.pi / rod.omega_b / per_turn, np.zeros(2 * terms + 3)
    for steps in ((turns - 1) * per_turn, per_turn):
        before = y[-3:].copy()
        _run(0.5 * np.pi, h, steps, numbers, on.P, on.A, on.weights, on.K, on.C, y)
    return np.asarray((y[-3:] - before) / (h * per_turn))
