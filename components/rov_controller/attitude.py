"""Attitudes as quaternions: from angles, their difference, and vectors turned into the body frame."""

from math import atan2, cos, sin, sqrt


def quaternion(out: "float[:]", at: int, phi: float, theta: float, psi: float) -> None:
    """Quaternion of roll, pitch and yaw (body to world, scalar first) in out[at..at+3]."""
    c1 = cos(0.5 * phi)
    s1 = sin(0.5 * phi)
    c2 = cos(0.5 * theta)
    s2 = sin(0.5 * theta)
    c3 = cos(0.5 * psi)
    s3 = sin(0.5 * psi)
    out[at] = c1 * c2 * c3 + s1 * s2 * s3
    out[at + 1] = s1 * c2 * c3 - c1 * s2 * s3
    out[at + 2] = c1 * s2 * c3 + s1 * c2 * s3
    out[at + 3] = c1 * c2 * s3 - s1 * s2 * c3


def attitude_error(e: "float[:]", work: "float[:]") -> None:
    """Rotation vector in e[3..5], body frame, that takes the attitude work[0..3] to work[4..7] the short way."""
    a = work[0] * work[4] + work[1] * work[5] + work[2] * work[6] + work[3] * work[7]
    e[3] = work[0] * work[5] - work[1] * work[4] - work[2] * work[7] + work[3] * work[6]
    e[4] = work[0] * work[6] - work[2] * work[4] - work[3] * work[5] + work[1] * work[7]
    e[5] = work[0] * work[7] - work[3] * work[4] - work[1] * work[6] + work[2] * work[5]
    sine = sqrt(e[3] * e[3] + e[4] * e[4] + e[5] * e[5])
    factor = 2.0
    if sine > 1e-12:
        factor = 2.0 * atan2(sine, abs(a)) / sine
    if a < 0.0:
        factor = -factor
    for i in range(3):
        e[3 + i] = factor * e[3 + i]


def to_body(e: "float[:]", q: "float[:]") -> None:
    """Turn e[0..2] from the world into the body frame of the quaternion q[0..3]."""
    v_x = e[0]
    v_y = e[1]
    v_z = e[2]
    # v - 2 q0 (q x v) + 2 q x (q x v)
    c_x = q[2] * v_z - q[3] * v_y
    c_y = q[3] * v_x - q[1] * v_z
    c_z = q[1] * v_y - q[2] * v_x
    e[0] = v_x - 2.0 * q[0] * c_x + 2.0 * (q[2] * c_z - q[3] * c_y)
    e[1] = v_y - 2.0 * q[0] * c_y + 2.0 * (q[3] * c_x - q[1] * c_z)
    e[2] = v_z - 2.0 * q[0] * c_z + 2.0 * (q[1] * c_y - q[2] * c_x)
