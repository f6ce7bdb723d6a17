"""A blade that a stream bends, exactly: Luhar and Nepf (2011), for what linear bending under an even drag is worth."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_bvp

from ...errors import RunError


@dataclass(frozen=True)
class Blade:
    """An upright blade at rest in a stream; `posture` gives theta, its slope and the two forces at s/L."""

    Ca: float  # C_d rho_w d U^2 L^3/(2 E I), drag over stiffness
    posture: Any

    @property
    def deflection(self) -> float:
        """Way of the tip along the stream over L; Ca/8 for a beam that bends linearly."""
        s = np.linspace(0.0, 1.0, 2001)
        return float(np.trapezoid(np.sin(self.posture(s)[0]), s))

    @property
    def effective_length(self) -> float:
        """Drag over that of the upright blade."""
        return float(self.posture(0.0)[2]) / self.Ca


def blade(Ca: float, B: float = 0.0, near: Blade | None = None) -> Blade:
    """Solve for the posture, from that of a blade `near`; B: buoyancy over stiffness, as Ca.

    Drag acts across the blade, by the square of the stream across it, Ca cos^2(theta). Raises RunError without a
    solution.
    """

    def rates(_s: np.ndarray, y: np.ndarray) -> np.ndarray:
        theta, curvature, across, along = y
        f = Ca * np.cos(theta) ** 2
        bending = along * np.sin(theta) - across * np.cos(theta)
        return np.array([curvature, bending, -f * np.cos(theta), f * np.sin(theta) - B])

    def ends(root: np.ndarray, tip: np.ndarray) -> np.ndarray:
        return np.array([root[0], tip[1], tip[2], tip[3]])

    s = np.linspace(0.0, 1.0, 200)
    guess = np.zeros((4, s.size)) if near is None else near.posture(s)
    solved = solve_bvp(rates, ends, s, guess, tol=1e-8, max_nodes=20000)
    if not solved.success:
        raise RunError(f"no posture of a blade with Ca = {Ca:g}, B = {B:g}: {solved.message}")
    return Blade(Ca, solved.sol)


def published_length(Ca: float, B: float) -> float:
    """Effective length by the fit that Luhar and Nepf give to their solutions."""
    return float(1.0 - (1.0 - 0.9 * Ca ** (-1.0 / 3.0)) / (1.0 + Ca**-1.5 * (8.0 + B**1.5)))
