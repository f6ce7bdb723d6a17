"""Axes and signs, ours and ArduPilot's: they are the same, but for the velocity's axes and the place of the origin.

| | here | ArduPilot |
| --- | --- | --- |
| world | north, east, down | the same (NED) |
| body | forward, starboard, down | the same (FRD) |
| attitude | roll, pitch, yaw of the turn from world to body, in the order yaw, pitch, roll | the same |
| rates | body, rad/s | the same (`gyro`) |
| accelerometer | specific force, acceleration less gravity: (0, 0, -g) at rest and level | the same (`accel_body`) |
| velocity over ground | u, v, w along the body | along the world: turned here |
| position | from the world's origin | from the autopilot's home, at the water's surface: `origin` is added |
"""

from __future__ import annotations

from math import cos, sin

Triple = tuple[float, float, float]


def along_world(attitude: Triple, velocity: Triple) -> Triple:
    """A vector in body axes, in the world's: R(phi, theta, psi) times it (Fossen 2011, Eqs. 2.18 and 2.20)."""
    phi, theta, psi = attitude
    u, v, w = velocity
    c_f, s_f, c_theta, s_theta, c_psi, s_psi = cos(phi), sin(phi), cos(theta), sin(theta), cos(psi), sin(psi)
    return (
        c_psi * c_theta * u + (c_psi * s_theta * s_f - s_psi * c_f) * v + (s_psi * s_f + c_psi * s_theta * c_f) * w,
        s_psi * c_theta * u + (s_psi * s_theta * s_f + c_psi * c_f) * v + (s_psi * s_theta * c_f - c_psi * s_f) * w,
        -s_theta * u + c_theta * s_f * v + c_theta * c_f * w,
    )


def from_home(origin: Triple, position: Triple) -> Triple:
    """A position from the autopilot's home, of one from the world's origin, which lies at `origin` from home."""
    return origin[0] + position[0], origin[1] + position[1], origin[2] + position[2]
