"""The cantilever of Eqs. 1-3 by itself, from the eigenvalues that the brush FMU computed."""

from __future__ import annotations

from functools import cache

import numpy as np


def shape(lam: float, xi: np.ndarray) -> np.ndarray:
    """Y_r of Eq. 3 at xi = x/L, (k,); the growing exponentials of cosh and sinh are combined before they can cancel."""
    sigma = (np.sinh(lam) - np.sin(lam)) / (np.cosh(lam) + np.cos(lam))  # below Eq. 3
    growing = (
        (np.exp(-lam) + np.sin(lam) + np.cos(lam)) / (np.cosh(lam) + np.cos(lam)) / 2.0
    )  # (1 - sigma)/2, without cancellation
    z = lam * xi
    result: np.ndarray = growing * np.exp(z) + 0.5 * (1.0 + sigma) * np.exp(-z) - np.cos(z) + sigma * np.sin(z)
    return result


def slope(lam: float, xi: np.ndarray) -> np.ndarray:
    """L Y_r' at xi = x/L, (k,)."""
    sigma = (np.sinh(lam) - np.sin(lam)) / (np.cosh(lam) + np.cos(lam))
    growing = (np.exp(-lam) + np.sin(lam) + np.cos(lam)) / (np.cosh(lam) + np.cos(lam)) / 2.0
    z = lam * xi
    result: np.ndarray = lam * (growing * np.exp(z) - 0.5 * (1.0 + sigma) * np.exp(-z) + np.sin(z) + sigma * np.cos(z))
    return result


@cache
def quadrature() -> tuple[np.ndarray, np.ndarray]:
    """Gauss-Legendre points and weights on 0 .. 1."""
    x, w = np.polynomial.legendre.leggauss(64)
    return 0.5 * (x + 1.0), 0.5 * w


def slope_integrals(lam: np.ndarray, tension: np.ndarray | float = 1.0) -> np.ndarray:
    """Integral of tension Y_r' Y_s' over xi, (k, k); `tension` at the points of `quadrature`."""
    xi, weight = quadrature()
    slopes = np.array([slope(value, xi) for value in lam])
    result: np.ndarray = (slopes * weight * tension) @ slopes.T
    return result


def centrifugal_frequencies(
    lam: np.ndarray, omega_r: np.ndarray, speed: float, root: float, in_plane: bool = True
) -> np.ndarray:
    """Frequencies [rad/s] of the beam turning at `speed` with its root at `root` lengths from the axis, (k,).

    Stiffness on the modes: omega_r^2 + speed^2 (S - 1 in the plane of rotation), S the tension's slope integral.
    """
    xi, _ = quadrature()
    S = slope_integrals(lam, root * (1.0 - xi) + 0.5 * (1.0 - xi**2))
    K = np.diag(omega_r**2) + speed**2 * (S - (np.eye(len(lam)) if in_plane else 0.0))
    result: np.ndarray = np.sqrt(np.linalg.eigvalsh(K))
    return result
