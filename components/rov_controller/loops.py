"""The loops of one sample: position and attitude to set-points, those to a wrench, that to thruster commands."""

from math import sqrt

from ..library.rotation import quaternion
from ..library.vectors import join, shorten, split
from .allocation import allocate
from .attitude import attitude_error, to_body
from .force import feed_forward, hand_over, press
from .observer import observe
from .parameters import Parameters
from .records import Inputs, Scratch, State


def velocities(u: Inputs, s: Scratch) -> None:
    """The measured velocity and rate as one vector."""
    s.v_set[0] = u.u
    s.v_set[1] = u.v
    s.v_set[2] = u.w
    s.omega_set[0] = u.p
    s.omega_set[1] = u.q
    s.omega_set[2] = u.r
    join(s.nu, s.v_set, s.omega_set)


def set_points(u: Inputs, p: Parameters, s: Scratch) -> None:
    """Outer loops: set-points of velocity and rate, body frame."""
    quaternion(s.attitude, u.phi, u.theta, u.psi)
    quaternion(s.attitude_ref, u.phi_ref, u.theta_ref, u.psi_ref)
    s.v_set[0] = p.K_position[0] * (u.x_ref - u.x_n)
    s.v_set[1] = p.K_position[1] * (u.y_ref - u.y_n)
    s.v_set[2] = p.K_position[2] * (u.z_ref - u.z_n)
    for i in range(3):
        s.v_set[i] += u.v_ref[i]
    shorten(s.v_set, p.v_max)
    to_body(s.v_set, s.attitude)
    attitude_error(s.omega_set, s.attitude, s.attitude_ref)
    for i in range(3):
        s.omega_set[i] = p.K_attitude[i] * s.omega_set[i]
    shorten(s.omega_set, p.rate_max)


def wrench(p: Parameters, x: State, s: Scratch) -> None:
    """Inner loops: the wrench for the errors of velocity and rate."""
    join(s.e, s.v_set, s.omega_set)
    for i in range(6):
        acceleration = (s.nu[i] - x.nu_last[i]) / p.T_s
        x.nu_last[i] = s.nu[i]
        s.acceleration[i] = acceleration
        s.e[i] = s.e[i] - s.nu[i]
        s.tau[i] = s.K_P[i] * s.e[i] + x.integral[i] - s.K_D[i] * acceleration


def integrate(p: Parameters, x: State, s: Scratch) -> None:
    """Anti-windup by back-calculation: the integrals follow what the thrusters can give."""
    for i in range(6):
        given = 0.0
        for j in range(8):
            given += x.B[i, j] * s.F[j]  # Eq. 20
        x.given[i] = given
        x.integral[i] = x.integral[i] + p.T_s * (s.K_I[i] * s.e[i] + p.K_windup * (given - s.tau[i]))
        if i < 3 and x.pressing > 0.0:
            x.force_integral = x.force_integral + p.T_s * p.K_windup * x.into_hull[i] * (given - s.tau[i])


def sample(u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Take one sample: from the inputs to the thruster commands."""
    velocities(u, s)  # the observer may have put its own in their place at the last sample of the step
    set_points(u, p, s)
    if p.mode == 3 or p.observed_velocity:
        observe(p, x, s)
    wrench(p, x, s)
    if p.mode >= 1:
        feed_forward(p, x, s)
    if p.mode >= 2:
        press(u, p, x, s)
    if p.bumpless:
        hand_over(x, s)
    split(s.tau, x.F_ref, x.M_ref)
    x.V_in = u.V_ref
    x.saturated = 0.0
    if allocate(p, x, s):
        x.saturated = 1.0
        x.saturation_count += 1.0
    integrate(p, x, s)
    for j in range(8):
        # Inverse of F = k_T sgn(u) u^2.
        x.command[j] = sqrt(s.F[j] / p.k_T_forward) if s.F[j] >= 0.0 else -sqrt(-s.F[j] / p.k_T_reverse)
