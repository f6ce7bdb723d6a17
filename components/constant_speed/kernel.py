"""A drive that turns the brush at a speed which no load changes. State x: energy delivered."""


def initialize(x: "float[:]") -> None:
    """No energy yet."""
    x[0] = 0.0


def outputs(y: "float[:]", x: "float[:]", V_in: float, T_brush: float, omega_b_set: float, V_nominal: float) -> None:
    """Write speed, power and energy."""
    omega_b = omega_b_set * V_in / V_nominal
    P_shaft = -T_brush * omega_b
    P_electrical = P_shaft
    W_shaft = x[0]
    W_electrical = x[0]
    y[0] = omega_b
    y[1] = P_electrical
    y[2] = P_shaft
    y[3] = W_electrical
    y[4] = W_shaft


def step(
    h: float, y: "float[:]", x: "float[:]", V_in: float, T_brush: float, omega_b_set: float, V_nominal: float,
) -> None:
    """Count the energy of a step at constant torque and speed."""
    x[0] = x[0] - T_brush * omega_b_set * V_in / V_nominal * h
    outputs(y, x, V_in, T_brush, omega_b_set, V_nominal)
