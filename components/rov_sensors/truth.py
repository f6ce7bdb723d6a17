"""What there is to measure: the vehicle's motion as it is, and the specific force where the accelerometer sits."""

from math import cos, sin

from ..declare.record import Vector
from ..library.vectors import clear, cross_add, split
from .parameters import Parameters
from .records import Channels, Inputs, Scratch


def specific_force(u: Inputs, p: Parameters, s: Scratch) -> None:
    """What an accelerometer feels: its acceleration over ground without gravity, which acts on it as on all else."""
    split(u.nu_dot, s.f, s.alpha)
    clear(3, s.across)
    cross_add(s.across, u.p, u.q, u.r, p.r_imu[0], p.r_imu[1], p.r_imu[2])
    cross_add(s.f, s.alpha[0], s.alpha[1], s.alpha[2], p.r_imu[0], p.r_imu[1], p.r_imu[2])  # Eq. N1
    cross_add(s.f, u.p, u.q, u.r, s.across[0], s.across[1], s.across[2])  # Eq. N1
    s.f[0] = s.f[0] + p.g * sin(u.theta)  # Eq. N2
    s.f[1] = s.f[1] - p.g * cos(u.theta) * sin(u.phi)  # Eq. N2
    s.f[2] = s.f[2] - p.g * cos(u.theta) * cos(u.phi)  # Eq. N2


def find_motion(c: Channels, u: Inputs) -> None:
    """The channels of pose, velocity and rates."""
    c.u = u.u
    c.v = u.v
    c.w = u.w
    c.x_n = u.x_n
    c.y_n = u.y_n
    c.z_n = u.z_n
    c.phi = u.phi
    c.theta = u.theta
    c.psi = u.psi
    c.p = u.p
    c.q = u.q
    c.r = u.r


def find_forces(c: Channels, f: Vector, u: Inputs) -> None:
    """The channels of specific force and tool wrench."""
    for i in range(3):
        c.f[i] = f[i]
        c.F_tool[i] = u.F_tool[i]
        c.M_tool[i] = u.M_tool[i]


def find_truth(u: Inputs, p: Parameters, s: Scratch) -> None:
    """All channels, without any error."""
    specific_force(u, p, s)
    find_motion(s.truth, u)
    find_forces(s.truth, s.f, u)
