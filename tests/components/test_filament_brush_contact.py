"""Contact and friction of the brush: directions, symmetries and the printed laws as limits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from lives import Instance, component
from rovbrush.components.kernels import compiled

DECLARED = component("filament_brush")
P = DECLARED.parameters()
KERNEL = compiled(DECLARED.kernel)
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}
FORCES = ("F_x", "F_z", "T_brush")


def run(duration: float, inputs: dict[str, float], h: float = 1e-3, **parameters: Any) -> Instance:
    instance = Instance(DECLARED, KERNEL, **parameters)
    instance.set(**inputs)
    instance.start()
    for _ in range(round(duration / h)):
        instance.step(h)
    return instance


def forces(instance: Instance) -> np.ndarray:
    return np.array([instance[name] for name in FORCES])


def test_hull_pushes_the_brush_back_and_friction_resists_the_sweep() -> None:
    assert np.all(forces(run(0.1, NOMINAL)) < 0.0)


def test_friction_and_torque_turn_with_the_direction_of_rotation() -> None:
    backwards = run(0.1, NOMINAL | {"omega_b": -15.7}, alpha=0.0)
    assert backwards["F_x"] > 0.0 and backwards["T_brush"] > 0.0 and backwards["F_z"] < 0.0


def test_a_passing_hull_drags_a_brush_at_rest_along() -> None:
    assert run(0.1, {"delta": 5e-3, "v_rov": 0.5})["F_x"] > 0.0
    assert run(0.1, {"delta": 5e-3, "v_rov": -0.5})["F_x"] < 0.0


def test_a_brush_clear_of_the_hull_has_no_forces() -> None:
    instance = run(0.2, NOMINAL | {"delta": -1e-3})
    assert np.array_equal(forces(instance), np.zeros(3))
    assert instance["contact_count"] == 0.0 and instance["W_friction"] == 0.0


def test_mirror_images_give_mirrored_forces() -> None:
    inputs = {"omega_b": 12.0, "delta": 5e-3, "v_rov": 0.3}
    mirrored = {"omega_b": -12.0, "delta": 5e-3, "v_rov": -0.3}
    right = forces(run(0.05, inputs, n=6, alpha=-0.3, theta_b_0=0.1))
    left = forces(run(0.05, mirrored, n=6, alpha=0.3, theta_b_0=-0.1))
    assert left == pytest.approx(right * (-1.0, 1.0, -1.0), rel=1e-9)  # angles differ by rounding


def test_two_opposite_filaments_give_equal_forces_half_a_turn_apart() -> None:
    # One communication step per degree, so that both histories are cut at the same angles.
    h = np.pi / 15.7 / 180.0
    first, second = (Instance(DECLARED, KERNEL, n=1, theta_b_0=angle) for angle in (0.0, np.pi))
    both = Instance(DECLARED, KERNEL, n=2)
    for instance in (first, second, both):
        instance.set(**NOMINAL)
        instance.start()
    for _ in range(720):
        for instance in (first, second, both):
            instance.step(h)
        # the smallest forces are lost in 1e-9 of the peak force
        assert forces(both) == pytest.approx(forces(first) + forces(second), rel=1e-7, abs=1e-7)
    assert both["J_z"] == pytest.approx(first["J_z"] + second["J_z"], rel=1e-9)


def test_only_filaments_within_the_contact_arc_touch() -> None:
    # Straight and radial: cos(phi) > 1 - delta/R_brush, which is 14.8 degrees to either side, 4.1 of 50.
    instance = run(0.0, {"delta": 5e-3}, alpha=0.0)
    arc = np.arccos(1.0 - 5e-3 / P.R_brush)
    assert np.degrees(arc) == pytest.approx(14.8, abs=0.05)
    assert instance["contact_count"] == np.sum(np.abs((np.arange(50) + 25) % 50 - 25) * 2.0 * np.pi / 50 < arc) == 5


def test_straight_filament_force_follows_the_printed_law() -> None:
    instance = run(0.0, NOMINAL, n=1, alpha=0.0)
    F_n = P.k_c * 5e-3**1.5  # Eq. 7 at phi = 0, where Delta = delta
    v_s = 15.7 * P.R_brush - 0.05  # Eq. 10
    mu = P.mu_c + (P.mu_s - P.mu_c) * np.exp(-((v_s / P.v_0) ** 2)) + P.k_v * v_s  # Eq. 9
    assert instance["F_z"] == pytest.approx(-F_n, rel=1e-12)
    # the smoothed sign is 1 - (v_eps/v_s)^4/4
    assert instance["F_x"] == pytest.approx(-mu * F_n, rel=1e-8)
    assert instance["T_brush"] == pytest.approx(-mu * F_n * P.R_brush, rel=1e-8)
    assert instance["P_friction"] == pytest.approx(mu * F_n * v_s, rel=1e-8)


def test_normal_force_never_pulls_and_starts_from_zero() -> None:
    assert KERNEL.normal_force(1e-3, -10.0, 1e5, 100.0, 1e-4)[0] == 0.0
    assert KERNEL.normal_force(1e-9, 1.0, 1e5, 100.0, 1e-4)[0] < 1e-5
    printed = 1e5 * 1e-3**1.5 + 100.0 * 0.2
    assert KERNEL.normal_force(1e-3, 0.2, 1e5, 100.0, 0.0)[0] == pytest.approx(printed, rel=1e-14)
    assert KERNEL.normal_force(1e-3, 0.2, 1e5, 100.0, 1e-4)[0] == pytest.approx(printed, rel=1e-14)


def test_friction_curve_is_odd_and_its_slope_is_bounded() -> None:
    v = np.linspace(-3.0, 3.0, 6001)
    law = np.array([KERNEL.friction_coefficient(x, 0.6, 0.4, 0.05, 0.1, 0.02) for x in v])
    assert law[:, 0] == pytest.approx(-law[::-1, 0], abs=1e-12)  # the grid is symmetric to rounding
    slope = np.abs(np.gradient(law[:, 0], v))
    assert np.all(slope <= 1.05 * np.maximum.reduce([law[:, 1], np.roll(law[:, 1], 1), np.roll(law[:, 1], -1)]))
    assert law[-1, 0] == pytest.approx(0.4 + 0.1 * 3.0, rel=1e-8)


def test_fouling_scales_friction_and_leaves_the_first_normal_force() -> None:
    clean = run(0.0, NOMINAL)
    foul = run(0.0, NOMINAL | {"friction_scale": 1.5})
    assert foul["F_z"] == clean["F_z"]
    viscous = P.k_v * (15.7 * P.R_brush - 0.05)
    assert foul["F_x"] / clean["F_x"] == pytest.approx((1.5 * 0.4 + viscous) / (0.4 + viscous), rel=1e-2)


def test_tip_velocity_is_the_derivative_of_the_tip_position() -> None:
    # Contact power must equal force times motion: a frictionless, undamped bristle keeps its energy at rest of the hub.
    instance = run(0.05, {"delta": 5e-3, "friction_scale": 0.0}, h=2.5e-4, n=1, alpha=-0.4, k_v=0.0,
                   zeta=(0.0,) * 6, tolerance=1e-9, h_min=1e-6)  # fmt: skip
    energy = sum(instance[f"E_{part}"] for part in ("kinetic", "strain", "centrifugal", "contact"))
    assert energy == pytest.approx(instance["W_hull"], rel=1e-7)
    assert instance["E_kinetic"] + instance["E_strain"] > 0.01 * energy


def test_kinetic_fractions_sum_to_one_and_vanish_beyond_the_retained_modes() -> None:
    fraction = run(0.05, NOMINAL, N_m=4)["kinetic_fraction"]
    assert np.sum(fraction) == pytest.approx(1.0, rel=1e-12)
    assert np.array_equal(fraction[4:], np.zeros(2))
