"""Attitude as a quaternion, vectors between world and body, and the frame that moves with the water."""

from math import cos, sin


def quaternion(x: "float[:]", phi: float, theta: float, psi: float) -> None:
    """Quaternion of roll, pitch and yaw in x[3..6]."""
    c1 = cos(0.5 * phi)
    s1 = sin(0.5 * phi)
    c2 = cos(0.5 * theta)
    s2 = sin(0.5 * theta)
    c3 = cos(0.5 * psi)
    s3 = sin(0.5 * psi)
    x[3] = c1 * c2 * c3 + s1 * s2 * s3
    x[4] = s1 * c2 * c3 - c1 * s2 * s3
    x[5] = c1 * s2 * c3 + s1 * c2 * s3
    x[6] = c1 * c2 * s3 - s1 * s2 * c3


def rotation(R: "float[:]", x: "float[:]") -> None:
    """Rotation matrix body to world (row-major) of the quaternion x[3..6], whatever its length."""
    a = x[3]
    b = x[4]
    c = x[5]
    d = x[6]
    s = 2.0 / (a * a + b * b + c * c + d * d)
    R[0] = 1.0 - s * (c * c + d * d)
    R[1] = s * (b * c - d * a)
    R[2] = s * (b * d + c * a)
    R[3] = s * (b * c + d * a)
    R[4] = 1.0 - s * (b * b + d * d)
    R[5] = s * (c * d - b * a)
    R[6] = s * (b * d - c * a)
    R[7] = s * (c * d + b * a)
    R[8] = 1.0 - s * (b * b + c * c)


def cross_add(out: "float[:]", at: int, ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> None:
    """out[at..at+2] += a x b."""
    out[at] = out[at] + ay * bz - az * by
    out[at + 1] = out[at + 1] + az * bx - ax * bz
    out[at + 2] = out[at + 2] + ax * by - ay * bx


def change_frame(x: "float[:]", R: "float[:]", v_c: "float[:]", sign: float) -> None:
    """nu += sign * current: between the velocity over ground and the one through the water."""
    rotation(R, x)
    for i in range(3):
        x[7 + i] = x[7 + i] + sign * (R[i] * v_c[0] + R[3 + i] * v_c[1] + R[6 + i] * v_c[2])
