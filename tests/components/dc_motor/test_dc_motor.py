"""The brush motor with the numbers of the paper."""

from __future__ import annotations

from typing import Any

import pytest
from helpers import Measured
from lives import Instance, component
from rovbrush.components.python.kernels import compiled

DECLARED = component("dc_motor")


def motor(V_in: float, T_brush: float, duration: float, h: float = 1e-3, **parameters: Any) -> Instance:
    instance = Instance(DECLARED, compiled(DECLARED.kernel), **parameters)
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
