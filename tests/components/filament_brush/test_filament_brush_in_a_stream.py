"""A bristle that a stream bends: the exact blade of Luhar and Nepf (2011), and how far linear bending is right."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from rovbrush.components.python.kernels import compiled
from scipy.integrate import solve_bvp

DECLARED = component("filament_brush")
L, D_BRISTLE, RHO_W, E = 0.08, 0.8e-3, 1025.0, 2.5e9
EI = E * np.pi * D_BRISTLE**4 / 64.0
CAUCHY = (0.1, 0.3, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0)


def blade(Ca: float, B: float, start: object = None) -> object:
    """Luhar and Nepf's blade at rest: theta from upright over s/L, with drag Ca cos^2(theta) across it and buoyancy B.

    Ca = rho_w C_d d U^2 L^3/(2 E I), B the buoyancy over the restoring force likewise.
    """

    def rates(_s: np.ndarray, y: np.ndarray) -> np.ndarray:
        theta, curvature, across, along = y
        f = Ca * np.cos(theta) ** 2
        return np.array([
            curvature, along * np.sin(theta) - across * np.cos(theta), -f * np.cos(theta), f * np.sin(theta) - B,
        ])  # fmt: skip

    def ends(root: np.ndarray, tip: np.ndarray) -> np.ndarray:
        return np.array([root[0], tip[1], tip[2], tip[3]])

    s = np.linspace(0.0, 1.0, 200)
    solved = solve_bvp(rates, ends, s, np.zeros((4, s.size)) if start is None else start(s), tol=1e-8, max_nodes=20000)  # type: ignore[operator]
    assert solved.success
    return solved.sol


def effective_length(solution: object, Ca: float) -> float:
    """l_e/l: drag over that of the upright blade."""
    return float(solution(0.0)[2]) / Ca  # type: ignore[operator]


def published(Ca: float, B: float) -> float:
    """l_e/l by Luhar and Nepf's fit to their solutions."""
    return 1.0 - (1.0 - 0.9 * Ca ** (-1.0 / 3.0)) / (1.0 + Ca**-1.5 * (8.0 + B**1.5))


def test_the_exact_blade_is_the_published_curve(measured: Measured) -> None:
    for B in (0.0, 10.0):
        solution, worst = None, 0.0
        for Ca in CAUCHY:
            solution = blade(Ca, B, solution)
            worst = max(worst, abs(effective_length(solution, Ca) / published(Ca, B) - 1.0))
        measured(f"water: exact blade beside the published effective length, B = {B:g}", worst, "5e-2, a fit")
        assert worst < 0.06


def bent(Ca: float) -> Instance:
    """The kernel's bristle at rest in the stream of that Cauchy number."""
    U = float(np.sqrt(2.0 * Ca * EI / (RHO_W * D_BRISTLE * L**3)))
    seen = Instance(
        DECLARED, compiled(DECLARED.kernel), n=1, bristles_per_filament=1.0, alpha=0.0, centrifugal=False, N_m=4,
        zeta=(0.2,) * 6, C_d=1.0, co_rotation=0.0,
    )  # fmt: skip
    seen.set(v_rov=U, delta=-0.1)
    seen.start()
    for _ in range(600):
        seen.step(1e-3)
    return seen


def test_linear_bending_is_right_up_to_a_deflection_of_a_sixth_of_the_length(measured: Measured) -> None:
    errors, solution = {}, None
    for Ca in CAUCHY[:6]:
        solution = blade(Ca, 0.0, solution)
        seen = bent(Ca)
        s = np.linspace(0.0, 1.0, 4001)
        w = float(np.trapezoid(np.sin(solution(s)[0]), s))  # type: ignore[operator]
        ratio = float(seen["deflection_ratio"])
        assert ratio == pytest.approx(Ca / 8.0, rel=4e-3)  # a beam under an even load, four modes of it
        assert seen["F_x"] == pytest.approx(Ca * EI / L**2, rel=1e-4)  # and its drag is that of the straight one
        errors[ratio] = (ratio / w - 1.0, 1.0 / effective_length(solution, Ca) - 1.0)
    ratios = np.array(list(errors))
    deflection, drag = np.array(list(errors.values())).T
    leaves = float(np.interp(0.05, deflection, ratios))
    measured("water: |y(L)|/L at which the deflection in a stream is 5 % too large", leaves, "told in the README")
    measured("water: error of the drag there", float(np.interp(leaves, ratios, drag)), "told in the README")
    U = np.sqrt(2.0 * 8.0 * leaves * EI / (RHO_W * D_BRISTLE * L**3))
    measured("water: speed of the stream at which a bristle of Table 2 with C_d = 1 is there [m/s]", float(U), "told")
    assert leaves == pytest.approx(0.16, abs=0.01)
    assert np.interp(leaves, ratios, drag) == pytest.approx(0.045, abs=0.01)
