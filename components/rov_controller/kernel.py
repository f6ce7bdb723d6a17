"""Cascaded PID at a fixed rate: position -> velocity -> force and attitude -> rate -> moment, then thruster allocation.

Samples are taken at multiples of T_s.
"""

from ..library.sampling import first_sample, is_due
from ..library.thrust import allocation_matrix
from ..library.vectors import dot, join
from .allocation import pseudoinverse
from .force import filter_wrench, point_normal
from .loops import sample, velocities
from .parameters import Parameters
from .records import Inputs, Outputs, Scratch, State


def setup(p: Parameters, x: State, s: Scratch) -> None:
    """B of Eq. 20 from the geometry and its pseudoinverse."""
    allocation_matrix(x.B, p.thruster_position, p.thruster_direction)
    pseudoinverse(x, s)


def initialize(u: Inputs, p: Parameters, x: State) -> None:
    """Thrusters off until the first sample; the brush voltage is on at once."""
    for i in range(6):
        x.integral[i] = 0.0
        x.nu_last[i] = 0.0
        x.wrench[i] = 0.0
        x.given[i] = 0.0
        x.thrust_seen[i] = 0.0
        x.nu_seen[i] = 0.0
        x.d_seen[i] = 0.0
    for i in range(3):
        x.F_ref[i] = 0.0
        x.M_ref[i] = 0.0
        x.into_hull[i] = p.normal[i]
    for j in range(8):
        x.command[j] = 0.0
    x.sample = -1.0
    x.V_in = u.V_ref
    x.saturated = 0.0
    x.saturation_count = 0.0
    x.pressing = 0.0
    x.was_pressing = 0.0
    x.seen = 0.0
    x.force_integral = 0.0


def outputs(x: State, y: Outputs) -> None:
    """Write what the last sample decided."""
    for j in range(8):
        y.u_thruster[j] = x.command[j]
    for i in range(3):
        y.F_ref[i] = x.F_ref[i]
        y.M_ref[i] = x.M_ref[i]
    y.V_in = x.V_in
    y.saturated = x.saturated
    y.saturation_count = x.saturation_count
    y.F_n = -dot(x.wrench, x.into_hull)
    y.pressing = x.pressing


def step(t: float, h: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Take the samples that fall into [t, t + h), with the inputs as they are; most often one, or none."""
    if p.mode != 3:
        filter_wrench(h, u, p, x, s)
    point_normal(u, p, x, s)
    velocities(u, s)
    join(s.K_P, p.K_velocity, p.K_rate)
    join(s.K_I, p.K_velocity_i, p.K_rate_i)
    join(s.K_D, p.K_velocity_d, p.K_rate_d)
    if x.sample < 0.0:
        x.sample = first_sample(t, p.T_s)
        for i in range(6):
            x.nu_last[i] = s.nu[i]
    while is_due(x.sample, t, h, p.T_s):
        sample(u, p, x, s)
        x.sample += 1.0
    outputs(x, y)
