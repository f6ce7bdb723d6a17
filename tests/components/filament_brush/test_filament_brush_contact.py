"""The laws of contact and friction by themselves."""

from __future__ import annotations

import numpy as np
import pytest
from lives import component
from rovbrush.components.filament_brush.contact import friction_coefficient, normal_force
from rovbrush.components.filament_brush.records import Constants

DECLARED = component("filament_brush")


def test_normal_force_never_pulls_and_starts_from_zero() -> None:
    ramped, printed_law = (DECLARED.parameters(k_c=1e5, c_c=100.0, Delta_s=depth) for depth in (1e-4, 0.0))
    assert normal_force(1e-3, -10.0, ramped).F_n == 0.0
    assert normal_force(1e-9, 1.0, ramped).F_n < 1e-5
    printed = 1e5 * 1e-3**1.5 + 100.0 * 0.2
    assert normal_force(1e-3, 0.2, printed_law).F_n == pytest.approx(printed, rel=1e-14)
    assert normal_force(1e-3, 0.2, ramped).F_n == pytest.approx(printed, rel=1e-14)


def test_friction_curve_is_odd_and_its_slope_is_bounded() -> None:
    v = np.linspace(-3.0, 3.0, 6001)
    p = DECLARED.parameters(v_0=0.05, k_v=0.1, v_eps=0.02)
    c = Constants(L=0.08, R_tip=0.15, share=1.0, x_a=0.0, x_t=0.0, R_h=0.0, sin_alpha=0.0, cos_alpha=1.0, M=1.0,
                  per_M=1.0, chi=1.0, speed_2=0.0, omega_max=0.0, mu_s=0.6, mu_c=0.4, fouling=1.0, drag=0.0,
                  slip=1.0)  # fmt: skip
    found = [friction_coefficient(float(x), 0.0, 0.0, p, c) for x in v]
    law = np.array([(one.mu, one.slope) for one in found])
    assert law[:, 0] == pytest.approx(-law[::-1, 0], abs=1e-12)  # the grid is symmetric to rounding
    slope = np.abs(np.gradient(law[:, 0], v))
    assert np.all(slope <= 1.05 * np.maximum.reduce([law[:, 1], np.roll(law[:, 1], 1), np.roll(law[:, 1], -1)]))
    assert law[-1, 0] == pytest.approx(0.4 + 0.1 * 3.0, rel=1e-8)
