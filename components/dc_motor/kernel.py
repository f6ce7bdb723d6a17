"""Brush motor with gearbox (Eqs. 16-17): armature circuit, shaft, gear loss, current limit and energy accounts."""

from math import sqrt

from ..library.integration import equal_steps, runge_kutta_sum
from .parameters import Parameters
from .records import Change, Inputs, Outputs, State


def gear_ratio(p: Parameters) -> float:
    """Total ratio N_g = omega_m/omega_b of equal stages in series."""
    N_g = 1.0
    for _ in range(p.gear_stages):
        N_g *= p.gear_ratio_per_stage
    return N_g


def inertia(N_g: float, p: Parameters) -> float:
    """Inertia that the rotor turns: its own and, through the gear, the brush's."""
    return p.J_m + p.J_b / (N_g * N_g)


def spin_inertia(N_g: float, p: Parameters) -> float:
    """Spin momentum of brush and rotor about +y_t per motor speed: the rotor counts by its sense."""
    return p.J_b / N_g + p.rotor_sense * p.J_m


def torque_ratio(T_m: float, omega_m: float, N_g: float, u: Inputs, p: Parameters) -> float:
    """Torque ratio out/in of the gear over N_g: the efficiency, or its inverse when the brush drives."""
    # The torque at the gear's input is positive where J_b*T_m/N_g - J_m*T_brush is, whatever the loss.
    share = omega_m / p.gear_speed_eps
    if share > 1.0:  # twice as fast as min and max, which a processor cannot guess
        share = 1.0
    if share < -1.0:
        share = -1.0
    if p.J_b * T_m / N_g < p.J_m * u.T_brush:
        share = -share
    e = 1.0 - (1.0 - p.gear_efficiency) * abs(share)
    if share < 0.0:
        e = 1.0 / e
    return e


def rates(i: float, omega_m: float, held: bool, N_g: float, u: Inputs, p: Parameters) -> Change:
    """Rates of the state at the current i and the speed omega_m.

    `held`: the drive holds the current at its limit and the motor sees only the voltage that this takes.
    """
    V_motor = u.V_in
    if held:
        V_motor = p.R * i + p.K_e * omega_m
    di = (V_motor - p.R * i - p.K_e * omega_m) / p.L_a  # Eq. 16
    T_m = p.K_t * i - p.B_m * omega_m
    e = torque_ratio(T_m, omega_m, N_g, u, p)
    # T_load = -T_brush, the brush inertia reflected to the motor shaft.
    domega_m = (T_m + u.T_brush / (e * N_g)) / (p.J_m + p.J_b / (e * N_g * N_g))  # Eq. 17
    T_gear = T_m - p.J_m * domega_m
    return Change(
        i=di,
        omega_m=domega_m,
        W_electrical=V_motor * i,
        W_copper=p.R * i * i,
        W_friction=p.B_m * omega_m * omega_m,
        W_gear=(1.0 - e) * T_gear * omega_m,
        W_shaft=-u.T_brush * omega_m / N_g,
    )


def increments(dt: float, x: State, held: bool, N_g: float, u: Inputs, p: Parameters) -> Change:
    """Increments of the state over one classical fourth-order Runge-Kutta step."""
    a = rates(x.i, x.omega_m, held, N_g, u, p)
    b = rates(x.i + 0.5 * dt * a.i, x.omega_m + 0.5 * dt * a.omega_m, held, N_g, u, p)
    c = rates(x.i + 0.5 * dt * b.i, x.omega_m + 0.5 * dt * b.omega_m, held, N_g, u, p)
    d = rates(x.i + dt * c.i, x.omega_m + dt * c.omega_m, held, N_g, u, p)
    return Change(
        i=runge_kutta_sum(dt, a.i, b.i, c.i, d.i),
        omega_m=runge_kutta_sum(dt, a.omega_m, b.omega_m, c.omega_m, d.omega_m),
        W_electrical=runge_kutta_sum(dt, a.W_electrical, b.W_electrical, c.W_electrical, d.W_electrical),
        W_copper=runge_kutta_sum(dt, a.W_copper, b.W_copper, c.W_copper, d.W_copper),
        W_friction=runge_kutta_sum(dt, a.W_friction, b.W_friction, c.W_friction, d.W_friction),
        W_gear=runge_kutta_sum(dt, a.W_gear, b.W_gear, c.W_gear, d.W_gear),
        W_shaft=runge_kutta_sum(dt, a.W_shaft, b.W_shaft, c.W_shaft, d.W_shaft),
    )


def below_limit(i: float, p: Parameters) -> bool:
    """Is the current inside its limit? The margin takes up the rounding of the step that ends on it."""
    return abs(i) < p.current_limit * (1.0 - 1e-9)


def is_held(x: State, u: Inputs, p: Parameters) -> bool:
    """Is the current at its limit and would the input voltage drive it further out?"""
    held = False
    if p.current_limit > 0.0 and not below_limit(x.i, p):
        held = (u.V_in - p.R * x.i - p.K_e * x.omega_m) * x.i > 0.0
    return held


def stored_energy(x: State, N_g: float, p: Parameters) -> float:
    """Energy in the inductance, the rotor and the brush inertia."""
    return 0.5 * p.L_a * x.i * x.i + 0.5 * inertia(N_g, p) * x.omega_m * x.omega_m


def initialize(p: Parameters, x: State) -> None:
    """Set the initial current, speed and energies."""
    N_g = gear_ratio(p)
    x.i = p.i_start
    x.omega_m = p.omega_b_start * N_g
    x.W_electrical = 0.0
    x.W_copper = 0.0
    x.W_friction = 0.0
    x.W_gear = 0.0
    x.W_shaft = 0.0
    x.E_start = stored_energy(x, N_g, p)
    x.J_brush = 0.0
    x.H_start = spin_inertia(N_g, p) * x.omega_m


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Write current, speeds, powers and energies."""
    N_g = gear_ratio(p)
    power = rates(x.i, x.omega_m, is_held(x, u, p), N_g, u, p)
    y.i = x.i
    y.omega_m = x.omega_m
    y.omega_b = x.omega_m / N_g
    y.T_motor = p.K_t * x.i
    y.P_electrical = power.W_electrical
    y.P_copper = power.W_copper
    y.P_friction = power.W_friction
    y.P_gear = power.W_gear
    y.P_shaft = power.W_shaft
    y.W_electrical = x.W_electrical
    y.W_copper = x.W_copper
    y.W_friction = x.W_friction
    y.W_gear = x.W_gear
    y.W_shaft = x.W_shaft
    y.E_stored = stored_energy(x, N_g, p)
    # With K_e different from K_t the conversion itself makes or loses energy; the residual shows it.
    y.energy_residual = x.E_start + x.W_electrical - x.W_copper - x.W_friction - x.W_gear - x.W_shaft - y.E_stored
    y.H_spin = spin_inertia(N_g, p) * x.omega_m  # Eq. M1
    # Newton: what the brush torque does not spend on the spin momentum reaches the housing.
    y.T_housing = u.T_brush - spin_inertia(N_g, p) * power.omega_m  # Eq. M2
    y.J_housing = x.J_brush - (y.H_spin - x.H_start)  # Eq. M3


def longest_step(N_g: float, p: Parameters) -> float:
    """A tenth of the circuit's fastest time, which keeps the local error below 1e-7 for any motor, or max_step."""
    J = inertia(N_g, p)
    rate = p.R / p.L_a + p.B_m / J + sqrt(p.K_e * p.K_t / (p.L_a * J))  # bound of the eigenvalues
    return min(p.max_step, 0.1 / rate)


def time_of_limit(left: float, x: State, N_g: float, u: Inputs, p: Parameters) -> float:
    """The time within `left` at which the current meets its limit, by bisection."""
    low = 0.0
    high = left
    part = left
    for _ in range(60):
        part = 0.5 * (low + high)
        change = increments(part, x, False, N_g, u, p)
        if abs(x.i + change.i) > p.current_limit:
            high = part
        else:
            low = part
    return part


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Advance by h in equal Runge-Kutta steps; a step in which the current meets its limit is split there."""
    N_g = gear_ratio(p)
    count = equal_steps(h, longest_step(N_g, p))
    dt = h / count
    for _ in range(count):
        left = dt
        while left > 0.0:
            held = is_held(x, u, p)
            part = left
            change = increments(part, x, held, N_g, u, p)
            if p.current_limit > 0.0 and not held and below_limit(x.i, p) and abs(x.i + change.i) > p.current_limit:
                part = time_of_limit(left, x, N_g, u, p)
                change = increments(part, x, held, N_g, u, p)
            x.i += change.i
            x.omega_m += change.omega_m
            x.W_electrical += change.W_electrical
            x.W_copper += change.W_copper
            x.W_friction += change.W_friction
            x.W_gear += change.W_gear
            x.W_shaft += change.W_shaft
            left -= part
    x.J_brush += u.T_brush * h
    outputs(u, p, x, y)
