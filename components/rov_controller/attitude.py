"""Attitudes as quaternions: their difference, and vectors turned into the body frame."""

from math import atan2, sqrt

from ..declare.record import Vector


def attitude_error(e: Vector, q: Vector, q_ref: Vector) -> None:
    """Rotation vector e, body frame, that takes the attitude q to q_ref the short way."""
    a = q[0] * q_ref[0] + q[1] * q_ref[1] + q[2] * q_ref[2] + q[3] * q_ref[3]
    e[0] = q[0] * q_ref[1] - q[1] * q_ref[0] - q[2] * q_ref[3] + q[3] * q_ref[2]
    e[1] = q[0] * q_ref[2] - q[2] * q_ref[0] - q[3] * q_ref[1] + q[1] * q_ref[3]
    e[2] = q[0] * q_ref[3] - q[3] * q_ref[0] - q[1] * q_ref[2] + q[2] * q_ref[1]
    sine = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2])
    factor = 2.0
    if sine > 1e-12:
        factor = 2.0 * atan2(sine, abs(a)) / sine
    if a < 0.0:
        factor = -factor
    for i in range(3):
        e[i] = factor * e[i]


def to_body(v: Vector, q: Vector) -> None:
    """Turn v from the world into the body frame of the quaternion q."""
    v_x = v[0]
    v_y = v[1]
    v_z = v[2]
    # v - 2 q0 (q x v) + 2 q x (q x v)
    c_x = q[2] * v_z - q[3] * v_y
    c_y = q[3] * v_x - q[1] * v_z
    c_z = q[1] * v_y - q[2] * v_x
    v[0] = v_x - 2.0 * q[0] * c_x + 2.0 * (q[2] * c_z - q[3] * c_y)
    v[1] = v_y - 2.0 * q[0] * c_y + 2.0 * (q[3] * c_x - q[1] * c_z)
    v[2] = v_z - 2.0 * q[0] * c_z + 2.0 * (q[1] * c_y - q[2] * c_x)
