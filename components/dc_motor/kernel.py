"""Brush motor with gearbox (Eqs. 16-17): armature circuit, shaft, gear loss, current limit and energy accounts.

State x: [0] i, [1] omega_m, [2..6] energies (electrical, copper, friction, gear, shaft), [7] energy stored at start.
"""

from math import ceil, sqrt


def gear_ratio(gear_ratio_per_stage: float, gear_stages: int) -> float:
    """Total ratio N_g = omega_m/omega_b of equal stages in series."""
    N_g = 1.0
    for _ in range(gear_stages):
        N_g = N_g * gear_ratio_per_stage
    return N_g


def rates(
    i: float, omega_m: float, V_in: float, T_brush: float, held: bool, N_g: float, R: float, L_a: float, K_t: float,
    K_e: float, B_m: float, J_m: float, J_b: float, gear_efficiency: float, gear_speed_eps: float,
) -> tuple[float, float, float, float, float, float, float]:
    """Rates of i and omega_m, and the powers: electrical, copper, friction, gear, shaft.

    `held`: the drive holds the current at its limit and the motor sees only the voltage that this takes.
    """
    V_motor = V_in
    if held:
        V_motor = R * i + K_e * omega_m
    di = (V_motor - R * i - K_e * omega_m) / L_a  # Eq. 16
    T_m = K_t * i - B_m * omega_m

    # The torque at the gear's input is positive where J_b*T_m/N_g - J_m*T_brush is, whatever the loss.
    share = omega_m / gear_speed_eps
    if share > 1.0:
        share = 1.0
    if share < -1.0:
        share = -1.0
    if J_b * T_m / N_g < J_m * T_brush:
        share = -share
    # e = torque ratio out/in over N_g: the efficiency when the motor drives, its inverse when the brush drives.
    loss = (1.0 - gear_efficiency) * abs(share)
    e = 1.0 - loss
    if share < 0.0:
        e = 1.0 / e
    # Eq. 17 with T_load = -T_brush, the brush inertia reflected to the motor shaft.
    domega_m = (T_m + T_brush / (e * N_g)) / (J_m + J_b / (e * N_g * N_g))
    T_gear = T_m - J_m * domega_m
    return (
        di,
        domega_m,
        V_motor * i,
        R * i * i,
        B_m * omega_m * omega_m,
        (1.0 - e) * T_gear * omega_m,
        -T_brush * omega_m / N_g,
    )


def runge_kutta(
    dt: float, i: float, omega_m: float, V_in: float, T_brush: float, held: bool, N_g: float, R: float, L_a: float,
    K_t: float, K_e: float, B_m: float, J_m: float, J_b: float, gear_efficiency: float, gear_speed_eps: float,
) -> tuple[float, float, float, float, float, float, float]:
    """Increments of the first seven states over one classical fourth-order step."""
    a0, a1, a2, a3, a4, a5, a6 = rates(
        i, omega_m, V_in, T_brush, held, N_g, R, L_a, K_t, K_e, B_m, J_m, J_b, gear_efficiency, gear_speed_eps)
    b0, b1, b2, b3, b4, b5, b6 = rates(
        i + 0.5 * dt * a0, omega_m + 0.5 * dt * a1, V_in, T_brush, held, N_g, R, L_a, K_t, K_e, B_m, J_m, J_b,
        gear_efficiency, gear_speed_eps)
    c0, c1, c2, c3, c4, c5, c6 = rates(
        i + 0.5 * dt * b0, omega_m + 0.5 * dt * b1, V_in, T_brush, held, N_g, R, L_a, K_t, K_e, B_m, J_m, J_b,
        gear_efficiency, gear_speed_eps)
    d0, d1, d2, d3, d4, d5, d6 = rates(
        i + dt * c0, omega_m + dt * c1, V_in, T_brush, held, N_g, R, L_a, K_t, K_e, B_m, J_m, J_b,
        gear_efficiency, gear_speed_eps)
    w = dt / 6.0
    return (
        w * (a0 + 2.0 * (b0 + c0) + d0),
        w * (a1 + 2.0 * (b1 + c1) + d1),
        w * (a2 + 2.0 * (b2 + c2) + d2),
        w * (a3 + 2.0 * (b3 + c3) + d3),
        w * (a4 + 2.0 * (b4 + c4) + d4),
        w * (a5 + 2.0 * (b5 + c5) + d5),
        w * (a6 + 2.0 * (b6 + c6) + d6),
    )


def is_held(i: float, omega_m: float, V_in: float, R: float, K_e: float, current_limit: float) -> bool:
    """Is the current at its limit and would the input voltage drive it further out?"""
    held = False
    if current_limit > 0.0:
        # The margin takes up the rounding of the step that ends on the limit.
        at_limit = abs(i) >= current_limit * (1.0 - 1e-9)
        outward = (V_in - R * i - K_e * omega_m) * i > 0.0
        held = at_limit and outward
    return held


def initialize(
    x: 'float[:]', L_a: float, J_m: float, J_b: float, gear_ratio_per_stage: float, gear_stages: int, i_start: float,
    omega_b_start: float,
) -> None:
    """Set the initial current, speed and energies."""
    N_g = gear_ratio(gear_ratio_per_stage, gear_stages)
    x[0] = i_start
    x[1] = omega_b_start * N_g
    for k in range(2, 7):
        x[k] = 0.0
    x[7] = 0.5 * L_a * x[0] * x[0] + 0.5 * (J_m + J_b / (N_g * N_g)) * x[1] * x[1]


def outputs(
    x: 'float[:]', y: 'float[:]', V_in: float, T_brush: float, R: float, L_a: float, K_t: float, K_e: float,
    B_m: float, J_m: float, J_b: float, gear_ratio_per_stage: float, gear_stages: int, gear_efficiency: float,
    gear_speed_eps: float, current_limit: float,
) -> None:
    """Write current, speeds, powers and energies."""
    N_g = gear_ratio(gear_ratio_per_stage, gear_stages)
    i = x[0]
    omega_m = x[1]
    omega_b = omega_m / N_g
    held = is_held(i, omega_m, V_in, R, K_e, current_limit)
    _di, _domega_m, P_electrical, P_copper, P_friction, P_gear, P_shaft = rates(
        i, omega_m, V_in, T_brush, held, N_g, R, L_a, K_t, K_e, B_m, J_m, J_b, gear_efficiency, gear_speed_eps)
    T_motor = K_t * i
    W_electrical = x[2]
    W_copper = x[3]
    W_friction = x[4]
    W_gear = x[5]
    W_shaft = x[6]
    E_stored = 0.5 * L_a * i * i + 0.5 * (J_m + J_b / (N_g * N_g)) * omega_m * omega_m
    # With K_e different from K_t the conversion itself makes or loses energy; the residual shows it.
    energy_residual = x[7] + W_electrical - W_copper - W_friction - W_gear - W_shaft - E_stored
    y[0] = i
    y[1] = omega_m
    y[2] = omega_b
    y[3] = T_motor
    y[4] = P_electrical
    y[5] = P_copper
    y[6] = P_friction
    y[7] = P_gear
    y[8] = P_shaft
    y[9] = W_electrical
    y[10] = W_copper
    y[11] = W_friction
    y[12] = W_gear
    y[13] = W_shaft
    y[14] = E_stored
    y[15] = energy_residual


def step(
    t: float, h: float, x: 'float[:]', y: 'float[:]', V_in: float, T_brush: float, R: float, L_a: float, K_t: float,
    K_e: float, B_m: float, J_m: float, J_b: float, gear_ratio_per_stage: float, gear_stages: int,
    gear_efficiency: float, gear_speed_eps: float, current_limit: float, max_step: float,
) -> None:
    """Advance by h in equal Runge-Kutta steps; a step in which the current meets its limit is split there."""
    N_g = gear_ratio(gear_ratio_per_stage, gear_stages)
    # Bound of the circuit's eigenvalues: a tenth of its time keeps the local error below 1e-7 for any motor.
    J = J_m + J_b / (N_g * N_g)
    rate = R / L_a + B_m / J + sqrt(K_e * K_t / (L_a * J))
    dt_max = min(max_step, 0.1 / rate)
    count = max(1, ceil(h / dt_max - 1e-6))
    dt = h / count
    for _ in range(count):
        left = dt
        while left > 0.0:
            held = is_held(x[0], x[1], V_in, R, K_e, current_limit)
            part = left
            s0, s1, s2, s3, s4, s5, s6 = runge_kutta(
                part, x[0], x[1], V_in, T_brush, held, N_g, R, L_a, K_t, K_e, B_m, J_m, J_b, gear_efficiency,
                gear_speed_eps)
            crossing = (
                current_limit > 0.0
                and not held
                and abs(x[0]) < current_limit * (1.0 - 1e-9)
                and abs(x[0] + s0) > current_limit
            )
            if crossing:
                low = 0.0
                high = left
                for _ in range(60):
                    part = 0.5 * (low + high)
                    s0, s1, s2, s3, s4, s5, s6 = runge_kutta(
                        part, x[0], x[1], V_in, T_brush, held, N_g, R, L_a, K_t, K_e, B_m, J_m, J_b, gear_efficiency,
                        gear_speed_eps)
                    if abs(x[0] + s0) > current_limit:
                        high = part
                    else:
                        low = part
                left = left - part
            else:
                left = 0.0
            x[0] = x[0] + s0
            x[1] = x[1] + s1
            x[2] = x[2] + s2
            x[3] = x[3] + s3
            x[4] = x[4] + s4
            x[5] = x[5] + s5
            x[6] = x[6] + s6
    outputs(x, y, V_in, T_brush, R, L_a, K_t, K_e, B_m, J_m, J_b, gear_ratio_per_stage, gear_stages, gear_efficiency,
            gear_speed_eps, current_limit)
