"""The nominal case of the paper's Table 3 at fixed speed: calibrated means, and what changes them little."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np
import pytest
from lives import Instance, component
from machine_life import machine
from rovbrush.components.filament_brush.parameters import STEEP_RAKE

DECLARED = component("filament_brush")
KERNEL = machine(DECLARED.kernel)
OMEGA_B = 15.7
STEPS = 400  # per revolution, 1.0005 ms each
FORCES = ("F_x", "F_z", "T_brush")


class Steady:
    """One revolution after twelve of settling (a factor of 0.37 each): means and sampled forces."""

    def __init__(self, **parameters: Any) -> None:
        self.brush = Instance(DECLARED, KERNEL, **parameters)
        self.brush.set(omega_b=OMEGA_B, delta=5e-3, v_rov=0.05)
        self.brush.start()
        h = 2.0 * np.pi / OMEGA_B / STEPS
        samples = []
        self.deflection_ratio = 0.0  # of the settled revolution
        before = {}
        for k in range(13 * STEPS):
            if k == 12 * STEPS:
                before = {name: self.brush[name] for name in ("J_x", "J_z", "J_T")}
            self.brush.step(h)
            if k >= 12 * STEPS:
                samples.append([self.brush[name] for name in FORCES])
                self.deflection_ratio = max(self.deflection_ratio, self.brush["deflection_ratio"])
        self.samples = np.array(samples)
        self.F_x, self.F_z, self.T_brush = ((self.brush[j] - start) / (STEPS * h) for j, start in before.items())


@pytest.fixture(scope="module")
def nominal() -> Steady:
    return Steady()


def test_defaults_give_table_3_within_three_percent(nominal: Steady) -> None:
    assert nominal.F_z == pytest.approx(-221.7, rel=1e-4)  # the fit is exact in F_z, up to its digits
    assert nominal.F_x == pytest.approx(-110.9, rel=0.03)
    assert nominal.T_brush == pytest.approx(-16.63, rel=0.03)


def test_deflection_of_the_defaults_is_within_the_range_of_validity(nominal: Steady) -> None:
    assert 0.1 < nominal.brush["deflection_ratio_max"] < 0.2


def test_a_fourth_mode_changes_steady_forces_little(nominal: Steady) -> None:
    four = Steady(N_m=4)
    for name in FORCES:
        assert getattr(four, name) == pytest.approx(getattr(nominal, name), rel=8e-3)


def test_steady_forces_do_not_depend_on_the_form_of_the_base_reactions(nominal: Steady) -> None:
    assert Steady(mode_acceleration=False).F_z == nominal.F_z


def test_friction_moves_the_tangential_force_in_proportion_and_the_normal_force_little(nominal: Steady) -> None:
    slippery, rough = (Steady(**friction(f)) for f in (0.8, 1.2))
    assert slippery.F_z / nominal.F_z == pytest.approx(0.93, abs=0.02)
    assert rough.F_z / nominal.F_z == pytest.approx(1.065, abs=0.02)
    assert slippery.F_x / nominal.F_x == pytest.approx(0.785, abs=0.02)
    assert rough.F_x / nominal.F_x == pytest.approx(1.23, abs=0.02)


def test_strongly_raked_tips_fit_table_3_too_but_dig_in() -> None:
    # The numbers of the README: with fewer bristles the fit is sensitive to friction and to damping.
    steep = asdict(STEEP_RAKE)
    base = Steady(**steep)
    assert base.F_z == pytest.approx(-221.7, rel=1e-4)
    assert Steady(**steep | friction(0.8)).F_z / base.F_z == pytest.approx(0.65, abs=0.02)
    assert Steady(**steep | friction(1.2)).F_z / base.F_z == pytest.approx(1.65, abs=0.02)
    assert Steady(**steep | {"zeta": (0.01,) * 6}).F_z / base.F_z == pytest.approx(1.48, abs=0.03)


def friction(factor: float) -> dict[str, float]:
    return {"mu_s": 0.6 * factor, "mu_c": 0.4 * factor}
