r"""The state line, which answers a servo packet: one JSON object in one line, with `\n` before and behind it.

The autopilot's reader searches for names and checks no syntax: the line has no spaces, and no numbers that are none.
Source: ArduPilot, libraries/SITL/examples/JSON/readme.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

from .axes import Triple

DISTANCES = 6  # rangefinders at most: rng_1 to rng_6


class NotFiniteError(ValueError):
    """A value of the state is no number; the text says which, as the tail of a sentence."""


@dataclass(frozen=True, slots=True)
class VehicleState:
    """What the autopilot is told. World: north, east, down; body: forward, starboard, down (see axes.py)."""

    time: float  # s, absolute
    gyro: Triple  # rad/s, body
    specific_force: Triple  # m/s2, body: (0, 0, -g) at rest and level
    position: Triple  # m, world
    attitude: Triple  # rad: roll, pitch, yaw
    velocity: Triple  # m/s over ground, world
    distances: tuple[float, ...] = ()  # m, of the rangefinders
    battery: tuple[float, float] | None = None  # V, A


def state_line(state: VehicleState) -> bytes:
    """The datagram of a state. Raises NotFiniteError where a value is infinite or not a number."""
    fields = {
        "timestamp": _number("timestamp", state.time),
        "imu": f'{{"gyro":{_triple("gyro", state.gyro)},"accel_body":{_triple("accel_body", state.specific_force)}}}',
        "position": _triple("position", state.position),
        "attitude": _triple("attitude", state.attitude),
        "velocity": _triple("velocity", state.velocity),
    }
    for k, distance in enumerate(state.distances[:DISTANCES], 1):
        fields[f"rng_{k}"] = _number(f"rng_{k}", distance)
    if state.battery is not None:
        voltage, current = (_number("battery", value) for value in state.battery)
        fields["battery"] = f'{{"voltage":{voltage},"current":{current}}}'
    return ("\n{" + ",".join(f'"{name}":{text}' for name, text in fields.items()) + "}\n").encode("ascii")


def _triple(name: str, values: Triple) -> str:
    return f"[{_number(name, values[0])},{_number(name, values[1])},{_number(name, values[2])}]"


def _number(name: str, value: float) -> str:
    if not isfinite(value):
        raise NotFiniteError(f"{name} is {value}")
    return repr(float(value))
