"""Attitude as a quaternion, body to world, scalar first."""

from math import cos, sin

from ..declare.record import Vector


def quaternion(q: Vector, phi: float, theta: float, psi: float) -> None:
    """Quaternion of roll, pitch and yaw."""
    c1 = cos(0.5 * phi)
    s1 = sin(0.5 * phi)
    c2 = cos(0.5 * theta)
    s2 = sin(0.5 * theta)
    c3 = cos(0.5 * psi)
    s3 = sin(0.5 * psi)
    q[0] = c1 * c2 * c3 + s1 * s2 * s3
    q[1] = s1 * c2 * c3 - c1 * s2 * s3
    q[2] = c1 * s2 * c3 + s1 * c2 * s3
    q[3] = c1 * c2 * s3 - s1 * s2 * c3
