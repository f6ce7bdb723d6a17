"""Strips across the width and groups of free length: what they add up to, and what they are for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine

DECLARED = component("filament_brush")
KERNEL = machine(DECLARED.kernel)
P = DECLARED.parameters()


def started(omega_b: float, delta: float, tilt_x: float, **parameters: Any) -> Instance:
    brush = Instance(DECLARED, KERNEL, **parameters)
    brush.set(omega_b=omega_b, delta=delta, v_rov=0.05, tilt_x=tilt_x)
    brush.start()
    return brush


def mean_normal_force(omega_b: float = 15.7, delta: float = 5e-3, tilt_x: float = 0.0, **parameters: Any) -> float:
    """Mean of -F_z over a revolution after eight of settling (a factor of 0.37 each)."""
    brush = started(omega_b, delta, tilt_x, **parameters)
    h = 2.0 * np.pi / omega_b / 400
    for _ in range(8 * 400):
        brush.step(h)
    before = brush["J_z"]
    for _ in range(400):
        brush.step(h)
    return (before - brush["J_z"]) / (400 * h)


def test_a_group_is_a_brush_of_its_own_length() -> None:
    """Two groups against two brushes of those lengths, hub and bristles the same: all numbers of the modes scale."""
    spread = 0.1
    settings: dict[str, Any] = {"n": 6, "tolerance": 1e-9, "h_min": 1e-6, "C_a": 0.5}
    R_h = started(0.0, -0.1, 0.0)["R_h"]
    groups = started(15.7, 5e-3, 0.0, n_groups=2, length_spread=spread, **settings)
    brushes = []
    for ratio in (1.0 - 0.5 * spread, 1.0 + 0.5 * spread):
        straight = R_h * np.cos(P.alpha) + ratio * P.L
        radius = float(np.hypot(straight, R_h * np.sin(P.alpha)))
        brushes.append(started(15.7, 5e-3 + radius - P.R_brush, 0.0, L=ratio * P.L, R_brush=radius, **settings))
    for _ in range(150):
        for brush in (groups, *brushes):
            brush.step(1e-3)
    for name in ("J_x", "J_z", "J_T", "W_friction", "E_kinetic", "E_strain", "E_centrifugal", "F_y_eq11", "M_b_eq12",
                 "strikes", "J_filaments"):  # fmt: skip
        assert groups[name] == pytest.approx(0.5 * sum(b[name] for b in brushes), rel=2e-5), name
    # Where a tip comes and goes its speed jumps within a micro-step.
    assert groups["sliding_distance"] == pytest.approx(0.5 * sum(b["sliding_distance"] for b in brushes), rel=1e-3)


# Width 0.3 m, 11 strips. What the review found, +21 % and -49 %, holds at 2.1 mm; a deeper brush feels it less.
CASES = {5e-3: (0.026, -0.273), 2.1e-3: (0.21, -0.49)}


@pytest.mark.parametrize("delta", CASES)
def test_ten_milliradians_of_roll_and_a_hull_of_five_metres_radius(delta: float, measured: Measured) -> None:
    plane = mean_normal_force(delta=delta)
    tilted = mean_normal_force(delta=delta, tilt_x=0.01, n_strips=11) / plane - 1.0
    curved = mean_normal_force(delta=delta, hull_curvature=0.2, n_strips=11) / plane - 1.0
    measured(f"brush at {1e3 * delta:g} mm: F_z with 10 mrad of roll [%]", 100.0 * tilted, "README")
    measured(f"brush at {1e3 * delta:g} mm: F_z on a hull of 5 m radius [%]", 100.0 * curved, "README")
    assert (tilted, curved) == pytest.approx(CASES[delta], abs=0.03 if delta < 3e-3 else 0.002)


def peak(**parameters: Any) -> float:
    """F_z at omega_1/9 = 18 rad/s over what it is 1 rad/s beside, less 1."""
    below, at, above = (mean_normal_force(omega_b, **parameters) for omega_b in (17.0, 18.0, 19.0))
    return 2.0 * at / (below + above) - 1.0


def test_a_spread_of_three_percent_removes_the_resonance_of_coherent_bundles(measured: Measured) -> None:
    coherent, spread = peak(), peak(n_groups=5, length_spread=0.03)
    measured("brush: peak of F_z at omega_1/9 over its neighbours, coherent bundles [%]", 100.0 * coherent, "README")
    measured("brush: the same with five groups within 3 % of the length [%]", 100.0 * spread, "README")
    assert mean_normal_force(18.0) == pytest.approx(256.0, abs=1.0)
    assert coherent > 0.15
    assert abs(spread) < 0.03
