"""A bristle that a stream bends: the exact blade of Luhar and Nepf (2011), and how far linear bending is right."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine
from rovbrush.orchestrator.paper.theory.blade import Blade, blade, published_length

DECLARED = component("filament_brush")
L, D_BRISTLE, RHO_W, E = 0.08, 0.8e-3, 1025.0, 2.5e9
EI = E * np.pi * D_BRISTLE**4 / 64.0
CAUCHY = (0.1, 0.3, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0)


def test_the_exact_blade_is_the_published_curve(measured: Measured) -> None:
    for B in (0.0, 10.0):
        exact: Blade | None = None
        worst = 0.0
        for Ca in CAUCHY:
            exact = blade(Ca, B, exact)
            worst = max(worst, abs(exact.effective_length / published_length(Ca, B) - 1.0))
        measured(f"water: exact blade beside the published effective length, B = {B:g}", worst, "5e-2, a fit")
        assert worst < 0.06


def bent(Ca: float) -> Instance:
    """The kernel's bristle at rest in the stream of that Cauchy number."""
    U = float(np.sqrt(2.0 * Ca * EI / (RHO_W * D_BRISTLE * L**3)))
    seen = Instance(
        DECLARED, machine(DECLARED.kernel), n=1, bristles_per_filament=1.0, alpha=0.0, centrifugal=False, N_m=4,
        zeta=(0.2,) * 6, C_d=1.0, co_rotation=0.0,
    )  # fmt: skip
    seen.set(v_rov=U, delta=-0.1)
    seen.start()
    for _ in range(600):
        seen.step(1e-3)
    return seen


def test_linear_bending_is_right_up_to_a_deflection_of_a_sixth_of_the_length(measured: Measured) -> None:
    errors = {}
    exact: Blade | None = None
    for Ca in CAUCHY[:6]:
        exact = blade(Ca, 0.0, exact)
        seen = bent(Ca)
        ratio = float(seen["deflection_ratio"])
        assert ratio == pytest.approx(Ca / 8.0, rel=4e-3)  # a beam under an even load, four modes of it
        assert seen["F_x"] == pytest.approx(Ca * EI / L**2, rel=1e-4)  # and its drag is that of the straight one
        errors[ratio] = (ratio / exact.deflection - 1.0, 1.0 / exact.effective_length - 1.0)
    ratios = np.array(list(errors))
    deflection, drag = np.array(list(errors.values())).T
    leaves = float(np.interp(0.05, deflection, ratios))
    measured("water: |y(L)|/L at which the deflection in a stream is 5 % too large", leaves, "told in the README")
    measured("water: error of the drag there", float(np.interp(leaves, ratios, drag)), "told in the README")
    U = np.sqrt(2.0 * 8.0 * leaves * EI / (RHO_W * D_BRISTLE * L**3))
    measured("water: speed of the stream at which a bristle of Table 2 with C_d = 1 is there [m/s]", float(U), "told")
    assert leaves == pytest.approx(0.16, abs=0.01)
    assert np.interp(leaves, ratios, drag) == pytest.approx(0.045, abs=0.01)
