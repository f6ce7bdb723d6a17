"""Attitude as a quaternion, body to world, scalar first."""

from math import cos, sin

from ..declare.record import Matrix, Vector


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


def turned(R: Matrix, i: int, v: Vector) -> float:
    """Component i of R v: with R from a frame to another, v in that other frame."""
    return R[i, 0] * v[0] + R[i, 1] * v[1] + R[i, 2] * v[2]


def turned_back(R: Matrix, i: int, v: Vector) -> float:
    """Component i of the transpose of R, its inverse, times v: v in the frame that R is from."""
    return R[0, i] * v[0] + R[1, i] * v[1] + R[2, i] * v[2]
