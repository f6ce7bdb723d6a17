"""The drive that holds its speed, beside the motor."""

from __future__ import annotations

from lives import component

DECLARED = component("constant_speed")


def test_it_can_take_the_place_of_the_motor() -> None:
    motor = component("dc_motor")
    assert {v.name: v.unit for v in DECLARED.inputs} == {v.name: v.unit for v in motor.inputs}
    units = {v.name: v.unit for v in motor.outputs}
    assert all(units[v.name] == v.unit for v in DECLARED.outputs)
