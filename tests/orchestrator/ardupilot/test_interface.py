"""What a participant in the autopilot's place is given and gives."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from rovbrush.components.declare.interface_of import variables_of
from rovbrush.components.rov_controller.records import Inputs
from rovbrush.orchestrator.ardupilot.interface import (
    MOTION,
    Options,
    inputs_of,
    outputs_of,
    rate_of,
    state_of,
    values_of,
)
from rovbrush.orchestrator.ardupilot.packet import ServoPacket
from rovbrush.orchestrator.ardupilot.servos import HEAVY, Servo
from rovbrush.orchestrator.errors import InputError

BRUSH = Servo("V_in", (9,), (1100.0, 1900.0), (0.0, 12.0), 0.0, "V")
WHOLE = Options(origin=(0.0, 0.0, 10.0), rangefinders=2, battery=True, servos=(HEAVY, BRUSH))


def test_motion_has_the_names_and_units_of_rov_controller() -> None:
    theirs = {variable.name: variable.unit for variable in variables_of(Inputs)}
    for signal in MOTION[:-1]:
        assert theirs[signal.name] == signal.unit


def test_a_state_is_the_inputs_in_their_order() -> None:
    names = [signal.name for signal in inputs_of(WHOLE)]
    assert names[12:] == ["f", "rng_1", "rng_2", "V_battery", "i_battery"]
    values = [
        1.0,
        2.0,
        3.0,
        0.0,
        0.0,
        math.pi / 2,
        0.5,
        0.0,
        0.0,
        7.0,
        8.0,
        9.0,
        10.0,
        11.0,
        12.0,
        13.0,
        14.0,
        15.0,
        16.0,
    ]
    state = state_of(2.5, values, WHOLE)
    assert state.time == 2.5 and state.position == (1.0, 2.0, 13.0) and state.gyro == (7.0, 8.0, 9.0)
    assert state.velocity == pytest.approx((0.0, 0.5, 0.0))  # the bow looks east
    assert state.specific_force == (10.0, 11.0, 12.0)
    assert state.distances == (13.0, 14.0) and state.battery == (15.0, 16.0)
    plain = state_of(0.0, values[:15], Options())
    assert plain.distances == () and plain.battery is None


def test_outputs_are_the_servos_and_the_frame() -> None:
    assert [(s.name, s.size, s.unit) for s in outputs_of(WHOLE)] == [
        ("u_thruster", 8, "1"),
        ("V_in", 0, "V"),
        ("frame", 0, "1"),
    ]
    packet = ServoPacket(400, 77, (1900, *[1500] * 7, 1500, *[0] * 7))
    assert values_of(packet, WHOLE) == [1.0, *[0.0] * 7, 6.0, 77.0]


@pytest.mark.parametrize(("period", "rate"), [("0.0025", 400), ("1/1200", 1200), ("1/400", 400), ("0.02", 50)])
def test_a_period_is_a_rate(period: str, rate: int) -> None:
    assert rate_of(Fraction(period), "component autopilot") == rate


@pytest.mark.parametrize(("period", "near"), [("0.003", 333), ("0.1", 11), ("1e-6", 65535)])
def test_a_period_that_no_autopilot_has_is_refused_with_the_nearest_one(period: str, near: int) -> None:
    with pytest.raises(
        InputError, match=rf"component autopilot: its period of .* Hz from 11 to 65535; take 1/{near} s"
    ):
        rate_of(Fraction(period), "component autopilot")


def test_more_rangefinders_than_the_protocol_has_are_refused() -> None:
    with pytest.raises(InputError, match="rangefinders = 7; the protocol has 0 to 6"):
        Options(rangefinders=7)
