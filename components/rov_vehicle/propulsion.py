"""Thrusters: thrust, lag and wrench (Eq. 20)."""

from ..library.matrices import rows_times
from .parameters import Parameters
from .records import Inputs, Scratch, State


def thrust_of(u: float, p: Parameters) -> float:
    """Steady thrust k_T sgn(u) u^2 of a command, which saturates at +-1."""
    c = min(1.0, max(-1.0, u))
    F = p.k_T_forward * c * c
    if c < 0.0:
        F = -p.k_T_reverse * c * c
    return F


def thruster_wrench(decay: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """B F (Eq. 20) with the thrusts after a time in which the distance to their steady values fell by `decay`."""
    for j in range(8):
        s.F[j] = decay * x.thrust[j] + (1.0 - decay) * thrust_of(u.u_thruster[j], p)
    rows_times(s.F_control, x.B, 0, 3, s.F, 8)  # Eq. 20
    rows_times(s.M_control, x.B, 3, 6, s.F, 8)  # Eq. 20


def thrusts(decay: float, u: Inputs, p: Parameters, x: State) -> None:
    """The thrusts after a time in which the distance to their steady values fell by `decay`."""
    for j in range(8):
        x.thrust[j] = decay * x.thrust[j] + (1.0 - decay) * thrust_of(u.u_thruster[j], p)
