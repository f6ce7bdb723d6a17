"""The drive that holds its speed."""

from __future__ import annotations

import pytest
from lives import Instance, component
from rovbrush.components.kernels import compiled

DECLARED = component("constant_speed")


def test_speed_does_not_depend_on_the_load_and_energy_is_torque_times_angle() -> None:
    seen = Instance(DECLARED, compiled(DECLARED.kernel), omega_b_set=10.0)
    seen.start()
    energy = 0.0
    for T_brush in (0.0, -5.0, -50.0, 3.0):
        seen.set(T_brush=T_brush)
        seen.step(0.01)
        energy -= T_brush * 10.0 * 0.01
        assert seen["omega_b"] == 10.0
        assert seen["P_shaft"] == -10.0 * T_brush
        assert seen["W_shaft"] == seen["W_electrical"] == pytest.approx(energy, rel=1e-14)


def test_speed_is_in_proportion_to_the_voltage() -> None:
    seen = Instance(DECLARED, compiled(DECLARED.kernel))
    seen.set(V_in=6.0)
    seen.start()
    assert seen["omega_b"] == pytest.approx(7.85, rel=1e-15)


def test_it_can_take_the_place_of_the_motor() -> None:
    motor = component("dc_motor")
    assert {v.name: v.unit for v in DECLARED.inputs} == {v.name: v.unit for v in motor.inputs}
    units = {v.name: v.unit for v in motor.outputs}
    assert all(units[v.name] == v.unit for v in DECLARED.outputs)
