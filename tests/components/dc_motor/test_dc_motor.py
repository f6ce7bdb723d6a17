"""The brush motor with the numbers of the paper."""

from __future__ import annotations

from typing import Any

import pytest
from helpers import Measured
from lives import Instance, component
from machine_life import machine

DECLARED = component("dc_motor")


def motor(V_in: float, T_brush: float, duration: float, h: float = 1e-3, **parameters: Any) -> Instance:
    instance = Instance(DECLARED, machine(DECLARED.kernel), **parameters)
    instance.set(V_in=V_in, T_brush=T_brush)
    instance.start()
    for _ in range(round(duration / h)):
        instance.step(h)
    return instance


def test_damping_that_gives_the_loaded_speed_of_table_3_gives_a_no_load_speed_above_20(measured: Measured) -> None:
    loaded, free = (motor(12.0, torque, 6.0, B_m=9.83e-4)["omega_b"] for torque in (-16.63, 0.0))
    measured("motor: speed under 16.63 N.m with B_m = 9.83e-4 [rad/s]", loaded, "15.70 within 0.005")
    measured("motor: no-load speed with B_m = 9.83e-4 [rad/s]", free, "21.05 within 0.01 (paper: 20)")
    assert loaded == pytest.approx(15.70, abs=0.005)
    assert free == pytest.approx(21.05, abs=0.01)  # the paper's figure rounds it to 20


def test_one_planetary_stage_cannot_carry_the_torque_of_table_3() -> None:
    assert motor(12.0, -16.63, 4.0, gear_stages=1)["omega_b"] < 0.0


def test_calibrated_damping_means_35_a_and_418_w_off_the_hull(measured: Measured) -> None:
    free = motor(12.0, 0.0, 6.0)
    measured("motor: current without load with the default B_m [A]", free["i"], "34.8 within 0.1")
    measured("motor: power without load with the default B_m [W]", free["P_electrical"], "418 within 0.5")
    assert free["i"] == pytest.approx(34.8, abs=0.1)
    assert free["P_electrical"] == pytest.approx(418.0, abs=0.5)


def test_a_no_load_current_and_a_gear_efficiency_lead_through_the_same_operating_point(measured: Measured) -> None:
    split = {"B_m": 4.33e-5, "gear_efficiency": 0.61}  # of the README, for 2 A
    together, apart = (motor(12.0, -16.81, 6.0, **values)["omega_b"] for values in ({}, split))
    free = motor(12.0, 0.0, 6.0, **split)
    measured(
        "motor: speed under 16.81 N.m with friction and gear apart, over that together", apart / together, "1 +- 5e-3"
    )
    assert apart == pytest.approx(together, rel=5e-3)  # two digits of the efficiency
    assert free["i"] == pytest.approx(2.0, rel=2e-3) and free["omega_b"] == pytest.approx(27.2, abs=0.05)
