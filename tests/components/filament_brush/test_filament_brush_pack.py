"""The torque of the water on the spinning pack, and what share of the pack's speed its water has."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine
from rovbrush.components.library.quadrature import gauss_points
from rovbrush.components.library.rotating import cylinder_friction, disc_friction
from scipy.optimize import brentq

OMEGA_B, R, WIDTH, RHO_W, NU_W = 15.7, 0.15, 0.3, 1025.0, 1.2e-6
RE = OMEGA_B * R**2 / NU_W
GAP = 2.0 * np.pi * R / 50


def torque(name: str = "filament_brush", omega_b: float = OMEGA_B, **parameters: Any) -> float:
    declared = component(name)
    seen = Instance(declared, machine(declared.kernel), **parameters)
    seen.set(omega_b=omega_b, delta=-0.1)
    seen.start()
    assert seen["T_brush"] == seen["T_water"]
    return float(seen["T_water"])


def test_the_smooth_cylinder_solves_the_published_law() -> None:
    for Re in (1e3, RE, 1e7):
        root = brentq(lambda x, Re=Re: x + 0.6 - 4.07 * np.log10(Re / x), 1.0, 100.0, xtol=1e-14)  # type: ignore[misc]
        assert cylinder_friction(Re, 0.0) == pytest.approx(root**-2, rel=1e-10)
    assert cylinder_friction(20.0, 0.01) == 4.0 / 20.0  # laminar: 4 pi mu omega R^2 per length
    C = [cylinder_friction(Re, 0.0) for Re in np.geomspace(1.0, 1e7, 400)]
    assert np.all(np.diff(C) <= 0.0002)  # falls, but for a few per cent where laminar flow ends


def test_pack_as_a_cylinder_costs_as_much_as_the_review_found(measured: Measured) -> None:
    smooth, half, gap = (torque(pack_drag=1.0, pack_roughness=k) for k in (0.0, 0.5 * GAP, GAP))
    assert smooth == pytest.approx(-cylinder_friction(RE, 0.0) * np.pi * RHO_W * OMEGA_B**2 * R**4 * WIDTH, rel=1e-12)
    assert -smooth == pytest.approx(0.4, abs=0.05) and -gap == pytest.approx(3.6, abs=0.05)
    for text, T in (("smooth", smooth), ("roughness half the gap between bundles", half), ("the gap", gap)):
        measured(f"water: torque of the pack as a cylinder, {text} [N.m]", -T, "0.4 to 3.6, model.md 9.4")


def test_bundles_as_paddles_cost_as_much_as_the_review_found(measured: Measured) -> None:
    R_h = 0.071
    for co_rotation in (0.93, 0.9, 0.87):
        T = torque(C_paddle=1.2, co_rotation=co_rotation)
        bound = 50 * 0.5 * RHO_W * 1.2 * WIDTH * ((1.0 - co_rotation) * OMEGA_B) ** 2 * (R**4 - R_h**4) / 4.0
        assert pytest.approx(-bound, rel=0.01) == T
        assert 1.0 < -T < 5.0
        measured(f"water: torque of 50 paddles, {co_rotation:g} of their speed in the water [N.m]", -T, "1.5 to 5")


def test_bristles_shielded_to_a_strip_are_the_paddles() -> None:
    """Drag on all bristles of a bundle that together stand as wide as the brush is that of a paddle."""
    wet = {"alpha": 0.0, "C_a": 1.0, "co_rotation": 0.9, "bristles_per_filament": 1900.0}
    paddles = torque(C_paddle=1.1, **wet)
    assert torque(C_d=1.1, shielding=WIDTH / (1900.0 * 0.8e-3), **wet) == pytest.approx(paddles, rel=1e-3)


def test_the_water_in_the_pack_turns_as_the_balance_of_torques_says(measured: Measured) -> None:
    """What bristles give to their water, the water around takes from it as from a cylinder of its speed."""
    shielding = WIDTH / (1900.0 * 0.8e-3)
    wet = {"C_d": 1.1, "shielding": shielding, "bristles_per_filament": 1900.0}

    def left(share: float) -> float:
        return torque(co_rotation=share, **wet) - torque(omega_b=share * OMEGA_B, pack_drag=1.0)

    share = brentq(left, 0.01, 0.999)
    measured(
        "water: share of the speed of 50 bundles of 1900 bristles that their water has", share, "0.9 is the default"
    )
    measured("water: torque that this takes [N.m]", -torque(co_rotation=share, **wet), "told")
    assert share == pytest.approx(0.9, abs=0.03)


def test_a_cup_turns_as_a_disc_with_a_rim(measured: Measured) -> None:
    disc = 0.5 * disc_friction(RE) * RHO_W * OMEGA_B**2 * R**5
    rim = cylinder_friction(RE, 0.0094 / R) * np.pi * RHO_W * OMEGA_B**2 * R**4 * 0.08
    T = torque("cup_brush", pack_drag=1.0)
    assert pytest.approx(-disc - rim, rel=1e-12) == T
    assert torque("cup_brush", omega_b=-OMEGA_B, pack_drag=1.0) == -T
    assert torque("cup_brush") == 0.0
    measured("water: torque of the cup brush, of it the disc [N.m]", f"{-T:.3g}, {disc:.3g}", "told")
    # laminar up to Re = 3e5 or so, turbulent from there on (von Karman 1921)
    assert disc_friction(1e4) == pytest.approx(0.0387) and disc_friction(1e7) == pytest.approx(0.146 / 10**1.4)


def test_points_of_gauss_integrate_polynomials_of_twice_their_number() -> None:
    nodes, weights = np.zeros(6), np.zeros(6)
    gauss_points(6, nodes, weights)
    exact, of = np.polynomial.legendre.leggauss(6)
    assert nodes == pytest.approx(exact, abs=1e-15) and weights == pytest.approx(of, abs=1e-15)
