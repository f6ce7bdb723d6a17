"""A drive that turns the brush at a speed which no load changes."""

from .parameters import Parameters
from .records import Inputs, Outputs, State


def initialize(x: State) -> None:
    """No energy and no impulse of the brush yet."""
    x.W_shaft = 0.0
    x.J_brush = 0.0


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Write speed, power and energy."""
    y.omega_b = p.omega_b_set * u.V_in / p.V_nominal
    y.P_shaft = -u.T_brush * y.omega_b
    y.P_electrical = y.P_shaft
    y.W_electrical = x.W_shaft
    y.W_shaft = x.W_shaft
    y.H_spin = p.J_b * y.omega_b  # Eq. C1
    y.T_housing = u.T_brush  # Eq. C2: Newton, at constant speed all of it reaches the housing
    y.J_housing = x.J_brush - y.H_spin  # Eq. C3


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Count the energy of a step at constant torque and speed."""
    x.W_shaft = x.W_shaft - u.T_brush * p.omega_b_set * u.V_in / p.V_nominal * h
    x.J_brush = x.J_brush + u.T_brush * h
    outputs(u, p, x, y)
