"""What the measured tool wrench is used for: its filter, feedforward, and the force along the hull normal."""

from math import exp

from ..library.rotation import quaternion
from ..library.vectors import dot, join
from .attitude import to_body
from .parameters import Parameters
from .records import Inputs, Scratch, State


def filter_wrench(h: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """First-order low-pass of the measured wrench over a communication step in which it is constant."""
    keep = 0.0
    if p.T_filter > 0.0:
        keep = exp(-h / p.T_filter)
    join(s.measured, u.F_tool, u.M_tool)
    for i in range(6):
        x.wrench[i] = keep * x.wrench[i] + (1.0 - keep) * s.measured[i]


def point_normal(u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """The unit vector into the hull, body frame: the parameter `normal`, or against `hull_normal` by the attitude."""
    if dot(p.hull_normal, p.hull_normal) > 0.0:
        for i in range(3):
            x.into_hull[i] = -p.hull_normal[i]
        quaternion(s.attitude, u.phi, u.theta, u.psi)
        to_body(x.into_hull, s.attitude)


def feed_forward(p: Parameters, x: State, s: Scratch) -> None:
    """Take the measured tool wrench off what is asked of the thrusters."""
    for i in range(6):
        s.tau[i] = s.tau[i] - p.K_feedforward * x.wrench[i]


def press(u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """In contact: the force along the normal in tau follows F_n_ref; velocity errors count only across the normal.

    The integral of the velocity loop follows. With `bumpless` the integral begins so that the first sample goes on
    from the PID's force; else damping and K_force come on top at once.
    """
    F_n = -dot(x.wrench, x.into_hull)
    threshold = p.contact_force
    x.was_pressing = x.pressing
    if x.pressing > 0.0:
        threshold = 0.5 * p.contact_force
    if u.F_n_ref > 0.0 and F_n > threshold:
        pushed = dot(s.tau, x.into_hull)
        error = u.F_n_ref - F_n
        damping = p.K_force_d * dot(s.nu, x.into_hull)
        if p.K_force_a > 0.0:
            damping = damping + p.K_force_a * dot(s.acceleration, x.into_hull)
        if x.pressing == 0.0:
            x.force_integral = pushed - u.F_n_ref
            if p.bumpless:
                x.force_integral = pushed - u.F_n_ref - p.K_force * error + damping
        F = u.F_n_ref + p.K_force * error + x.force_integral - damping
        change = u.F_n_ref + x.force_integral - dot(x.integral, x.into_hull)
        missed = dot(s.e, x.into_hull)
        for i in range(3):
            s.tau[i] = s.tau[i] + (F - pushed) * x.into_hull[i]
            x.integral[i] = x.integral[i] + change * x.into_hull[i]
            s.e[i] = s.e[i] - missed * x.into_hull[i]
        x.force_integral = x.force_integral + p.T_s * p.K_force_i * error
        x.pressing = 1.0
    else:
        x.pressing = 0.0
        x.force_integral = 0.0


def hand_over(x: State, s: Scratch) -> None:
    """The first sample after pressing: the PID's integral takes what its force along the normal would jump by."""
    if x.was_pressing > 0.0 and x.pressing == 0.0:
        jump = dot(x.F_ref, x.into_hull) - dot(s.tau, x.into_hull)
        for i in range(3):
            s.tau[i] = s.tau[i] + jump * x.into_hull[i]
            x.integral[i] = x.integral[i] + jump * x.into_hull[i]
