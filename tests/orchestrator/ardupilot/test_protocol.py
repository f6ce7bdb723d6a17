"""ArduPilot's SITL JSON protocol as pure functions."""

from __future__ import annotations

import json
import math
import random
import struct

import pytest
from rovbrush.components.library.thrusters import DIRECTIONS, POSITIONS
from rovbrush.orchestrator.ardupilot.axes import along_world, from_home
from rovbrush.orchestrator.ardupilot.packet import NoServoPacketError, ServoPacket, packed, parse
from rovbrush.orchestrator.ardupilot.servos import HEAVY, MOTOR_FACTORS
from rovbrush.orchestrator.ardupilot.state_line import NotFiniteError, VehicleState, state_line

LEVEL = VehicleState(2.5, (0.0, 0.0, 0.0), (0.0, 0.0, -9.80665), (1.0, 2.0, 3.0), (0.1, 0.2, 0.3), (0.4, 0.5, 1e-9))


@pytest.mark.parametrize(("channels", "magic", "size"), [(16, 18458, 40), (32, 29569, 72)])
def test_a_packet_of_either_magic_is_read(channels: int, magic: int, size: int) -> None:
    pwm = tuple(range(1100, 1100 + channels))
    content = struct.pack(f"<HHI{channels}H", magic, 400, 70000, *pwm)
    assert len(content) == size
    assert parse(content) == ServoPacket(400, 70000, pwm)
    assert packed(ServoPacket(400, 70000, pwm)) == content


def test_any_other_size_or_magic_is_refused_with_its_reason() -> None:
    good = packed(ServoPacket(400, 1, (1500,) * 16))
    for content, said in (
        (b"", "0 bytes"),
        (good[:7], "too short"),
        (good[:-1], "39 bytes with magic 18458, which goes with 40"),
        (good + b"x", "41 bytes"),
        (struct.pack("<H", 29569) + good[2:], "40 bytes with magic 29569, which goes with 72"),
        (struct.pack(">H", 18458) + good[2:], "magic 6728; servo packets have 18458 or 29569"),
        (b'\n{"timestamp":0}\n', "magic"),
    ):
        with pytest.raises(NoServoPacketError, match=said):
            parse(content)


def test_no_bytes_whatever_raise_anything_else() -> None:
    draw = random.Random(1)
    for _ in range(3000):
        content = draw.randbytes(draw.choice((0, 1, 8, 39, 40, 41, 72, 500)))
        if draw.random() < 0.5:
            content = struct.pack("<H", draw.choice((18458, 29569))) + content[2:]
        try:
            parse(content)
        except NoServoPacketError:
            continue
        assert len(content) in (40, 72)


def test_a_state_is_one_line_of_json_between_newlines_without_spaces() -> None:
    line = state_line(LEVEL)
    assert line[:1] == line[-1:] == b"\n" and line.count(b"\n") == 2 and b" " not in line
    assert json.loads(line) == {
        "timestamp": 2.5,
        "imu": {"gyro": [0.0, 0.0, 0.0], "accel_body": [0.0, 0.0, -9.80665]},
        "position": [1.0, 2.0, 3.0],
        "attitude": [0.1, 0.2, 0.3],
        "velocity": [0.4, 0.5, 1e-9],
    }


def test_a_reader_that_searches_for_names_finds_those_that_are_told_and_no_others() -> None:
    """The firmware looks for a name anywhere in the line, and reads what is two characters behind it (SIM_JSON.cpp)."""
    line = state_line(VehicleState(0.0, *[(0.0, 0.0, 0.0)] * 5, distances=(0.5,), battery=(14.8, 3.0))).decode()
    told = ["timestamp", "imu", "gyro", "accel_body", "position", "attitude", "velocity", "rng_1", "battery"]
    for name in told:
        behind = line[line.index(name) + len(name) :]
        assert line.count(name) == 1 and behind[:2] == '":' and behind[2] in "[{0"
    others = ["latitude", "longitude", "altitude", "quaternion", "rng_2", "velocity_wind", "windvane", "airspeed"]
    assert not any(name in line for name in [*others, "no_time_sync", "no_lockstep", "rc"])


def test_rangefinders_and_battery_are_told_where_there_are_any() -> None:
    state = VehicleState(0.0, *[(0.0, 0.0, 0.0)] * 5, distances=(0.5, 1.5), battery=(14.8, 3.0))
    told = json.loads(state_line(state))
    assert (told["rng_1"], told["rng_2"]) == (0.5, 1.5)
    assert told["battery"] == {"voltage": 14.8, "current": 3.0}


@pytest.mark.parametrize("wrong", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_is_never_sent(wrong: float) -> None:
    with pytest.raises(NotFiniteError, match=f"velocity is {wrong}"):
        state_line(VehicleState(0.0, *[(0.0, 0.0, 0.0)] * 4, (0.0, wrong, 0.0)))


def test_every_number_arrives_with_all_its_bits() -> None:
    draw = random.Random(2)
    for _ in range(300):
        values = tuple(draw.uniform(-1, 1) * 10.0 ** draw.randrange(-30, 30) for _ in range(3))
        told = json.loads(state_line(VehicleState(values[0], values, values, values, values, values)))
        assert tuple(told["imu"]["accel_body"]) == values and told["timestamp"] == values[0]


def test_velocity_along_the_body_turns_with_roll_pitch_and_yaw() -> None:
    half = math.pi / 2
    assert along_world((0, 0, 0), (1.0, 2.0, 3.0)) == (1.0, 2.0, 3.0)
    assert along_world((0, 0, half), (1.0, 0.0, 0.0)) == pytest.approx((0.0, 1.0, 0.0), abs=1e-15)  # bow east
    assert along_world((0, half, 0), (1.0, 0.0, 0.0)) == pytest.approx((0.0, 0.0, -1.0), abs=1e-15)  # bow up
    assert along_world((half, 0, 0), (0.0, 1.0, 0.0)) == pytest.approx((0.0, 0.0, 1.0), abs=1e-15)  # starboard down
    attitude = (0.3, -0.8, 2.0)
    turned = along_world(attitude, (0.1, -0.2, 0.3))
    assert math.hypot(*turned) == pytest.approx(math.hypot(0.1, 0.2, 0.3), rel=1e-14)


def test_a_position_is_told_from_the_autopilots_home() -> None:
    assert from_home((0.0, 0.0, 10.0), (1.0, 2.0, -0.5)) == (1.0, 2.0, 9.5)


def test_pulses_of_the_heavy_frame_are_straight_from_1100_to_1900_and_end_there() -> None:
    pulses = (1100, 1300, 1500, 1510, 1900, 900, 2200, 0)
    assert [HEAVY.value(pulse) for pulse in pulses] == [-1.0, -0.5, 0.0, 0.025, 1.0, -1.0, 1.0, 0.0]
    assert HEAVY.read((1100, 1900, *[1500] * 14)) == [-1.0, 1.0, *[0.0] * 6]
    assert HEAVY.read((1100,)) == [-1.0, *[0.0] * 7]  # no such channels: no pulse


def test_our_thrusters_are_ardusubs_motors_in_order_and_sense() -> None:
    """The sign of each thruster's force and moment is the factor of ArduSub's motor of that number (throttle is up)."""
    for j, (roll, pitch, yaw, throttle, forward, lateral) in enumerate(MOTOR_FACTORS):
        x, y, z = POSITIONS[3 * j : 3 * j + 3]
        d_x, d_y, d_z = DIRECTIONS[3 * j : 3 * j + 3]
        ours = {"forward": d_x, "lateral": d_y, "throttle": -d_z, "yaw": x * d_y - y * d_x}
        if d_z:  # horizontal thrusters sit below the origin and roll and pitch it a little; ArduSub leaves that out
            ours |= {"roll": y * d_z - z * d_y, "pitch": z * d_x - x * d_z}
        theirs = {
            "forward": forward,
            "lateral": lateral,
            "throttle": throttle,
            "yaw": yaw,
            "roll": roll,
            "pitch": pitch,
        }
        for name, value in ours.items():
            sign = 0.0 if abs(value) < 1e-12 else math.copysign(1.0, value)
            assert sign == theirs[name], (j + 1, name)
