"""Attitude as rotation matrix and as angles, and the frame that moves with the water."""

from math import asin, atan2, pi, sqrt

from ..declare.record import Matrix
from ..library.rotation import turned_back
from .records import Angles, Inputs, Motion, Scratch


def rotation(R: Matrix, z: Motion) -> None:
    """Rotation matrix body to world of the quaternion of z, whatever its length."""
    a = z.q[0]
    b = z.q[1]
    c = z.q[2]
    d = z.q[3]
    s = 2.0 / (a * a + b * b + c * c + d * d)
    R[0, 0] = 1.0 - s * (c * c + d * d)
    R[0, 1] = s * (b * c - d * a)
    R[0, 2] = s * (b * d + c * a)
    R[1, 0] = s * (b * c + d * a)
    R[1, 1] = 1.0 - s * (b * b + d * d)
    R[1, 2] = s * (c * d - b * a)
    R[2, 0] = s * (b * d - c * a)
    R[2, 1] = s * (c * d + b * a)
    R[2, 2] = 1.0 - s * (b * b + c * c)


def euler_angles(R: Matrix, z: Motion) -> Angles:
    """Roll, pitch and yaw of R, the rotation of z: they describe it to rounding at any pitch.

    Near the vertical, asin and the small elements of R lose digits, and at +-90 degrees they say nothing: there only
    psi - phi (nose up) or psi + phi (nose down) is determined. So there half the sum and half the difference of roll
    and yaw are taken from the quaternion (Bernardes and Viollet 2022); one of the two is always well determined.
    """
    phi = atan2(R[2, 1], R[2, 2])
    theta = -asin(min(1.0, max(-1.0, R[2, 0])))
    psi = atan2(R[1, 0], R[0, 0])
    if abs(R[2, 0]) > 0.9:
        # (phi + psi)/2 and (phi - psi)/2 are the angles of two vectors, (pi/2 + theta)/2 that of their lengths.
        along_sum = z.q[0] - z.q[2]
        across_sum = z.q[1] + z.q[3]
        along_difference = z.q[0] + z.q[2]
        across_difference = z.q[1] - z.q[3]
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
    return Angles(phi, theta, psi)


def within_half_turn(angle: float) -> float:
    """The angle from -pi to pi, of one from -2 pi to 2 pi."""
    within = angle
    if angle > pi:
        within = angle - 2.0 * pi
    if angle < -pi:
        within = angle + 2.0 * pi
    return within


def change_frame(z: Motion, sign: float, u: Inputs, s: Scratch) -> None:
    """v += sign * current: between the velocity over ground and the one through the water."""
    rotation(s.R, z)
    for i in range(3):
        z.v[i] = z.v[i] + sign * turned_back(s.R, i, u.v_c)
