"""A planar inextensible rod with a clamped root, its tip on a hull with friction: statics, by collocation.

Nothing of the brush's kernel is used here. Angles are from +z_t, into the hull, towards +x_t, the sweep.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev
from scipy.optimize import root

DEGREE = 20  # of the polynomial theta(s); two more change F_n by 1e-12 of itself


@dataclass(frozen=True)
class Brush:
    """A rod on a hub: a bundle of `bristles` that bend together. Friction is mu times the normal force."""

    L: float
    d: float
    E: float
    bristles: float
    R_brush: float
    alpha: float
    k_c: float
    mu: float
    delta: float

    @property
    def EI(self) -> float:
        return self.bristles * self.E * np.pi * self.d**4 / 64.0

    @property
    def R_h(self) -> float:
        """Of the undeformed tip: R_h^2 + L^2 + 2 R_h L cos(alpha) = R_brush^2."""
        return float(np.sqrt(self.R_brush**2 - (self.L * np.sin(self.alpha)) ** 2) - self.L * np.cos(self.alpha))

    @property
    def first_touch(self) -> float:
        """Angle of the root where the undeformed tip comes to the hull."""
        hub_to_tip = np.arctan2(-self.L * np.sin(self.alpha), self.R_h + self.L * np.cos(self.alpha))
        return float(-np.arccos(1.0 - self.delta / self.R_brush) - hub_to_tip)


class Collocation:
    """Matrices on the Chebyshev points of 0 .. 1, from the root to the tip."""

    def __init__(self, degree: int) -> None:
        self.s = 0.5 * (1.0 - np.cos(np.pi * np.arange(degree + 1) / degree))
        basis = np.eye(degree + 1)
        values = chebyshev.chebvander(2.0 * self.s - 1.0, degree)
        inverse = np.linalg.inv(values)

        def operator(of: np.ndarray) -> np.ndarray:
            return np.asarray(chebyshev.chebval(2.0 * self.s - 1.0, of).T @ inverse)

        self.first = operator(2.0 * chebyshev.chebder(basis))
        self.second = operator(4.0 * chebyshev.chebder(basis, 2))
        self.integral = chebyshev.chebval(1.0, chebyshev.chebint(0.5 * basis, lbnd=-1)) @ inverse  # over 0 .. 1


@dataclass(frozen=True)
class Pressed:
    """A rod at rest on the hull, the root at the angle phi."""

    phi: float
    F_n: float
    side: float  # y(L)/L, across the root's axis, against the sweep
    tip: tuple[float, float]  # from the brush axis
    theta: np.ndarray


def tip_of(brush: Brush, phi: float, theta: np.ndarray, on: Collocation) -> tuple[float, float]:
    """Where the tip is, from the brush axis."""
    x = brush.R_h * np.sin(phi) + brush.L * float(on.integral @ np.sin(theta))
    z = brush.R_h * np.cos(phi) + brush.L * float(on.integral @ np.cos(theta))
    return x, z


def pressed(brush: Brush, phi: float, guess: np.ndarray, on: Collocation) -> Pressed | None:
    """Equilibrium near `guess`, (theta at the points, depth over L); none where none is found."""
    psi, load = phi - brush.alpha, brush.k_c * brush.L**1.5 * brush.L**2 / brush.EI
    plane = brush.R_brush - brush.delta

    def residual(unknown: np.ndarray) -> np.ndarray:
        theta, depth = unknown[:-1], unknown[-1]
        P = load * depth * np.sqrt(abs(depth))  # Eq. 7
        # Moment balance of the piece beyond s: EI theta'' = F_f cos(theta) - F_n sin(theta).
        beam = on.second @ theta - P * (brush.mu * np.cos(theta) - np.sin(theta))
        beam[0] = theta[0] - psi
        beam[-1] = on.first[-1] @ theta
        return np.append(beam, depth - (tip_of(brush, phi, theta, on)[1] - plane) / brush.L)

    def jacobian(unknown: np.ndarray) -> np.ndarray:
        theta, depth = unknown[:-1], unknown[-1]
        P, rise = load * depth * np.sqrt(abs(depth)), 1.5 * load * np.sqrt(abs(depth))
        J = np.zeros((len(unknown), len(unknown)))
        J[:-1, :-1] = on.second + P * np.diag(brush.mu * np.sin(theta) + np.cos(theta))
        J[:-1, -1] = -rise * (brush.mu * np.cos(theta) - np.sin(theta))
        J[0], J[-2] = 0.0, 0.0
        J[0, 0], J[-2, :-1] = 1.0, on.first[-1]
        J[-1, :-1], J[-1, -1] = on.integral * np.sin(theta), 1.0
        return J

    found = root(residual, guess, jac=jacobian, tol=1e-12)
    if np.max(np.abs(found.fun)) > 1e-8:
        return None
    theta, depth = found.x[:-1], float(found.x[-1])
    x, z = tip_of(brush, phi, theta, on)
    side = -(x - brush.R_h * np.sin(phi)) * np.cos(psi) + (z - brush.R_h * np.cos(phi)) * np.sin(psi)
    return Pressed(phi, brush.k_c * max(depth * brush.L, 0.0) ** 1.5, side / brush.L, (x, z), theta)


def sweep(brush: Brush, advance: float = 1e-3) -> list[Pressed]:
    """The rod at rest every `advance` rad of the root, from touching the hull to leaving it."""
    on = Collocation(DEGREE)
    phi = brush.first_touch
    found = [Pressed(phi, 0.0, 0.0, tip_of(brush, phi, np.full(DEGREE + 1, phi - brush.alpha), on), on.s)]
    guess = np.append(np.full(DEGREE + 1, phi - brush.alpha), 1e-8)
    while True:
        phi += advance
        at = pressed(brush, phi, guess, on)
        if at is None:
            raise AssertionError(f"no equilibrium near that before at {phi:.4f} rad: the rod snaps there")
        found.append(at)
        if at.F_n == 0.0:
            return found
        guess = np.append(at.theta, (at.tip[1] - brush.R_brush + brush.delta) / brush.L)
