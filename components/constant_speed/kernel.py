"""A drive that turns the brush at a speed which no load changes."""

from .parameters import Parameters
from .records import Inputs, Outputs, State


def initialize(x: State) -> None:
    """No energy yet."""
    x.W_shaft = 0.0


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Write speed, power and energy."""
    y.omega_b = p.omega_b_set * u.V_in / p.V_nominal
    y.P_shaft = -u.T_brush * y.omega_b
    y.P_electrical = y.P_shaft
    y.W_electrical = x.W_shaft
    y.W_shaft = x.W_shaft


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Count the energy of a step at constant torque and speed."""
    x.W_shaft = x.W_shaft - u.T_brush * p.omega_b_set * u.V_in / p.V_nominal * h
    outputs(u, p, x, y)
