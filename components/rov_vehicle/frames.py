"""Attitude as a quaternion, vectors between world and body, and the frame that moves with the water."""

from math import asin, atan2, cos, pi, sin, sqrt


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


def euler_angles(R: "float[:]", x: "float[:]") -> tuple[float, float, float]:
    """Roll, pitch and yaw of R, the rotation of the quaternion x[3..6]: they describe it to rounding at any pitch.

    Near the vertical, asin and the small elements of R lose digits, and at +-90 degrees they say nothing: there only
    psi - phi (nose up) or psi + phi (nose down) is determined. So there half the sum and half the difference of roll
    and yaw are taken from the quaternion (Bernardes and Viollet 2022); one of the two is always well determined.
    """
    phi = atan2(R[7], R[8])
    theta = -asin(min(1.0, max(-1.0, R[6])))
    psi = atan2(R[3], R[0])
    if abs(R[6]) > 0.9:
        # (phi + psi)/2 and (phi - psi)/2 are the angles of two vectors, (pi/2 + theta)/2 that of their lengths.
        along_sum = x[3] - x[5]
        across_sum = x[4] + x[6]
        along_difference = x[3] + x[5]
        across_difference = x[4] - x[6]
        length_sum = sqrt(along_sum * along_sum + across_sum * across_sum)
        length_difference = sqrt(along_difference * along_difference + across_difference * across_difference)
        theta = 2.0 * atan2(length_difference, length_sum) - 0.5 * pi
        half_sum = atan2(across_sum, along_sum)
        half_difference = atan2(across_difference, along_difference)
        # Rounding is all that is left of the shorter vector: the roll is zero, the yaw tells the whole.
        if length_sum < 4e-16 * length_difference:
            half_sum = -half_difference
        if length_difference < 4e-16 * length_sum:
            half_difference = -half_sum
        phi = within_half_turn(half_sum + half_difference)
        psi = within_half_turn(half_sum - half_difference)
    return phi, theta, psi


def within_half_turn(angle: float) -> float:
    """The angle from -pi to pi, of one from -2 pi to 2 pi."""
    within = angle
    if angle > pi:
        within = angle - 2.0 * pi
    if angle < -pi:
        within = angle + 2.0 * pi
    return within


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
