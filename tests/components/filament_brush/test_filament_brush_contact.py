"""The laws of contact and friction by themselves."""

from __future__ import annotations

import numpy as np
import pytest
from lives import component
from rovbrush.components.kernels import compiled

DECLARED = component("filament_brush")
KERNEL = compiled(DECLARED.kernel)


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
