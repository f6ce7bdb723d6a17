"""The integration of vehicle and thrusters over one internal step."""

from math import exp, sqrt

from ..library.integration import runge_kutta_stage
from ..library.vectors import add_scaled, clear, copy
from .motion import rates
from .parameters import Parameters
from .propulsion import thruster_wrench, thrusts
from .records import Inputs, Motion, Scratch, State


def runge_kutta(dt: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """One classical Runge-Kutta step of the motion through the water; the thrusters' lag is solved exactly."""
    half_decay = 0.0
    decay = 0.0
    if p.thruster_lag > 0.0:
        half_decay = exp(-0.5 * dt / p.thruster_lag)
        decay = exp(-dt / p.thruster_lag)
    copy(24, s.stage, x.motion)
    clear(24, s.increment)
    for stage in range(4):
        reached = half_decay
        weight = 2.0
        if stage == 0:
            reached = 1.0
            weight = 1.0
        if stage == 3:
            reached = decay
            weight = 1.0
        thruster_wrench(reached, u, p, x, s)
        rates(s.k, s.stage, u, p, x, s)
        ahead = 0.5 * dt
        if stage == 2:
            ahead = dt
        runge_kutta_stage(24, x.motion, s.k, weight, ahead, s.increment, s.stage)
    add_scaled(24, x.motion, x.motion, dt / 6.0, s.increment)
    normalize(x.motion)
    thrusts(decay, u, p, x)


def normalize(z: Motion) -> None:
    """Give the quaternion the length 1."""
    length = sqrt(z.q[0] * z.q[0] + z.q[1] * z.q[1] + z.q[2] * z.q[2] + z.q[3] * z.q[3])
    for i in range(4):
        z.q[i] = z.q[i] / length
