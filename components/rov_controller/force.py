"""What the measured tool wrench is used for: its filter, feedforward, and the force along the hull normal."""

from math import exp

from ..library.vectors import dot, join
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


def feed_forward(p: Parameters, x: State, s: Scratch) -> None:
    """Take the measured tool wrench off what is asked of the thrusters."""
    for i in range(6):
        s.tau[i] = s.tau[i] - p.K_feedforward * x.wrench[i]


def press(u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """In contact: the force along the normal in tau follows F_n_ref; velocity errors count only across the normal.

    The integral of the velocity loop follows, so that neither the first nor the last sample in contact makes a jump.
    """
    F_n = -dot(x.wrench, p.normal)
    threshold = p.contact_force
    if x.pressing > 0.0:
        threshold = 0.5 * p.contact_force
    if u.F_n_ref > 0.0 and F_n > threshold:
        pushed = dot(s.tau, p.normal)
        if x.pressing == 0.0:
            x.force_integral = pushed - u.F_n_ref
        error = u.F_n_ref - F_n
        F = u.F_n_ref + p.K_force * error + x.force_integral - p.K_force_d * dot(s.nu, p.normal)
        change = u.F_n_ref + x.force_integral - dot(x.integral, p.normal)
        missed = dot(s.e, p.normal)
        for i in range(3):
            s.tau[i] = s.tau[i] + (F - pushed) * p.normal[i]
            x.integral[i] = x.integral[i] + change * p.normal[i]
            s.e[i] = s.e[i] - missed * p.normal[i]
        x.force_integral = x.force_integral + p.T_s * p.K_force_i * error
        x.pressing = 1.0
    else:
        x.pressing = 0.0
        x.force_integral = 0.0
