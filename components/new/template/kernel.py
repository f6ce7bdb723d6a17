"""The equations: pure functions of numbers and records, the same text under Python, Numba and as C."""

from math import exp

from .parameters import Parameters
from .records import Inputs, Outputs, State


def kinetic_energy(x: State, p: Parameters) -> float:
    """Energy of the motion."""
    return 0.5 * p.m * x.v * x.v


def initialize(p: Parameters, x: State) -> None:
    """The state at the start."""
    x.v = p.v_start
    x.s = 0.0
    x.W_in = 0.0
    x.W_drag = 0.0
    x.E_start = kinetic_energy(x, p)


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Write all outputs from the state and the present inputs."""
    y.v = x.v
    y.s = x.s
    y.P = u.F * x.v
    y.W_in = x.W_in
    y.W_drag = x.W_drag
    y.E_kinetic = kinetic_energy(x, p)
    y.energy_residual = x.E_start + x.W_in - x.W_drag - y.E_kinetic


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Advance by h under a constant force, exactly: the speed decays towards its end with the time constant m/d."""
    v_end = u.F / p.d
    tau = p.m / p.d
    decay = exp(-h / tau)
    ahead = x.v - v_end
    way = v_end * h + tau * ahead * (1.0 - decay)  # Eq. A2
    square = v_end * v_end * h + 2.0 * v_end * tau * ahead * (1.0 - decay)  # integral of v^2 over the step
    square += 0.5 * tau * ahead * ahead * (1.0 - decay * decay)
    x.v = v_end + ahead * decay  # Eq. A1
    x.s += way
    x.W_in += u.F * way
    x.W_drag += p.d * square
    outputs(u, p, x, y)
