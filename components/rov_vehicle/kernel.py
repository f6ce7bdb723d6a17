"""Underwater vehicle in six degrees of freedom (Eqs. 18-21), its thrusters, tool wrench and tool-to-hull kinematics.

World frame: north, east, down. Body frame: forward, starboard, down. The current is uniform and constant over a step:
the equations hold in the frame that moves with the water, where the velocity is the relative velocity nu_r.

x: [0..2] position, [3..6] quaternion body to world (scalar first), [7..12] nu over ground (nu_r inside a step),
   [13..17] energies: thrusters, tool, external wrench, current, damping.
thrust_state: thrust of each thruster. current: that of the last step. energy_start: kinetic and potential at start.
D: linear (row 0) and quadratic (row 1) damping. lever: W r_g - B r_b, the moment of weight and buoyancy per vertical.
"""

from math import asin, atan2, ceil, cos, exp, sin, sqrt


def rotation(R: 'float[:]', x: 'float[:]') -> None:
    """Rotation matrix body to world (row-major) of the quaternion x[3..6], whatever its length."""
    a = x[3]
    b = x[4]
    c = x[5]
    d = x[6]
    s = 2.0 / (a * a + b * b + c * c + d * d)
    R[0] = 1.0 - s * (c * c + d * d)
    R[1] = s * (b * c - d * a)
    R[2] = s * (b * d + c * a)
    R[3] = s * (b * c + d * a)
    R[4] = 1.0 - s * (b * b + d * d)
    R[5] = s * (c * d - b * a)
    R[6] = s * (b * d - c * a)
    R[7] = s * (c * d + b * a)
    R[8] = 1.0 - s * (b * b + c * c)


def cross_add(out: 'float[:]', at: int, ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> None:
    """out[at..at+2] += a x b."""
    out[at] = out[at] + ay * bz - az * by
    out[at + 1] = out[at + 1] + az * bx - ax * bz
    out[at + 2] = out[at + 2] + ax * by - ay * bx


def tool_wrench(
    tau_disturb: 'float[:]', r_tool: 'float[:]', R_tool_body: 'float[:]', F_x: float, F_y: float, F_z: float,
    M_x: float, M_y: float, M_z: float,
) -> None:
    """The tool's force and moment, given in the tool frame, as a wrench about the body origin (Eq. 21)."""
    for r in range(3):
        k = 3 * r
        tau_disturb[r] = R_tool_body[k] * F_x + R_tool_body[k + 1] * F_y + R_tool_body[k + 2] * F_z
        tau_disturb[3 + r] = R_tool_body[k] * M_x + R_tool_body[k + 1] * M_y + R_tool_body[k + 2] * M_z
    cross_add(tau_disturb, 3, r_tool[0], r_tool[1], r_tool[2], tau_disturb[0], tau_disturb[1], tau_disturb[2])


def thrust_of(u: float, k_T_forward: float, k_T_reverse: float) -> float:
    """Steady thrust k_T sgn(u) u^2 of a command, which saturates at +-1."""
    s = min(1.0, max(-1.0, u))
    F = k_T_forward * s * s
    if s < 0.0:
        F = -k_T_reverse * s * s
    return F


def thruster_wrench(
    tau_control: 'float[:]', B: 'float[:,:]', thrust_state: 'float[:]', u_thruster: 'float[:]', k_T_forward: float,
    k_T_reverse: float, decay: float,
) -> None:
    """B F (Eq. 20) with the thrusts after a time in which the distance to their steady values fell by `decay`."""
    for r in range(6):
        tau_control[r] = 0.0
    for j in range(8):
        steady = thrust_of(u_thruster[j], k_T_forward, k_T_reverse)
        F = decay * thrust_state[j] + (1.0 - decay) * steady
        for r in range(6):
            tau_control[r] = tau_control[r] + B[r, j] * F


def rates(
    k: 'float[:]', x: 'float[:]', R: 'float[:]', v_water: 'float[:]', force: 'float[:]', tau_control: 'float[:]',
    tau_disturb: 'float[:]', tau_external: 'float[:]', v_c: 'float[:]', M: 'float[:,:]', M_inv: 'float[:,:]',
    added_mass: 'float[:]', D: 'float[:,:]', lever: 'float[:]', net_buoyancy: float,
) -> None:
    """Rates of x with nu_r in x[7..12]. Scratch: R, v_water (current in the body frame), force."""
    rotation(R, x)
    p = x[10]
    q = x[11]
    r = x[12]
    P_damping = 0.0
    for i in range(3):
        v_water[i] = R[i] * v_c[0] + R[3 + i] * v_c[1] + R[6 + i] * v_c[2]
        k[i] = R[3 * i] * x[7] + R[3 * i + 1] * x[8] + R[3 * i + 2] * x[9] + v_c[i]  # Eq. 18
        D_i = (D[0, i] + D[1, i] * abs(x[7 + i])) * x[7 + i]
        D_j = (D[0, 3 + i] + D[1, 3 + i] * abs(x[10 + i])) * x[10 + i]
        P_damping = P_damping + D_i * x[7 + i] + D_j * x[10 + i]
        # W - B acts along world z, which is R[6..8] in the body frame; its moment follows below.
        force[i] = -D_i - R[6 + i] * net_buoyancy
        force[3 + i] = -D_j
        # Hydrodynamic force on the vehicle, without the acceleration and Coriolis terms yet.
        force[6 + i] = -D_i
    k[3] = 0.5 * (-x[4] * p - x[5] * q - x[6] * r)
    k[4] = 0.5 * (x[3] * p + x[5] * r - x[6] * q)
    k[5] = 0.5 * (x[3] * q + x[6] * p - x[4] * r)
    k[6] = 0.5 * (x[3] * r + x[4] * q - x[5] * p)

    cross_add(force, 3, lever[0], lever[1], lever[2], R[6], R[7], R[8])

    # Momenta a (linear) and b (angular) of M nu_r in force[9..14]; C nu_r = (omega x a, v_r x a + omega x b).
    for i in range(6):
        force[9 + i] = 0.0
        for j in range(6):
            force[9 + i] = force[9 + i] + M[i, j] * x[7 + j]
    cross_add(force, 0, force[9], force[10], force[11], p, q, r)
    cross_add(force, 3, force[9], force[10], force[11], x[7], x[8], x[9])
    cross_add(force, 3, force[12], force[13], force[14], p, q, r)

    for i in range(6):
        force[i] = force[i] + tau_control[i] + tau_disturb[i] + tau_external[i]
    for i in range(6):
        k[7 + i] = 0.0
        for j in range(6):
            k[7 + i] = k[7 + i] + M_inv[i, j] * force[j]  # Eq. 19

    # Power of the water's motion: current velocity times hydrodynamic force.
    cross_add(force, 6, added_mass[0] * x[7], added_mass[1] * x[8], added_mass[2] * x[9], p, q, r)
    P_current = 0.0
    P_control = 0.0
    P_tool = 0.0
    P_external = 0.0
    for i in range(3):
        P_current = P_current + v_water[i] * (force[6 + i] - added_mass[i] * k[7 + i])
        over_ground = x[7 + i] + v_water[i]
        P_control = P_control + tau_control[i] * over_ground + tau_control[3 + i] * x[10 + i]
        P_tool = P_tool + tau_disturb[i] * over_ground + tau_disturb[3 + i] * x[10 + i]
        P_external = P_external + tau_external[i] * over_ground + tau_external[3 + i] * x[10 + i]
    k[13] = P_control
    k[14] = P_tool
    k[15] = P_external
    k[16] = P_current
    k[17] = P_damping


def kinetic(x: 'float[:]', R: 'float[:]', current: 'float[:]', M: 'float[:,:]', added_mass: 'float[:]') -> float:
    """Kinetic energy: rigid body over ground plus added mass through the water, with nu over ground in x."""
    E = 0.0
    for i in range(6):
        for j in range(6):
            E = E + 0.5 * x[7 + i] * M[i, j] * x[7 + j]
    for i in range(3):
        v_r = x[7 + i] - (R[i] * current[0] + R[3 + i] * current[1] + R[6 + i] * current[2])
        E = E + 0.5 * added_mass[i] * (v_r * v_r - x[7 + i] * x[7 + i])
    return E


def potential(x: 'float[:]', R: 'float[:]', lever: 'float[:]', net_buoyancy: float) -> float:
    """Energy of weight and buoyancy, zero with the body origin at depth 0 and the lever level."""
    return net_buoyancy * x[2] - lever[0] * R[6] - lever[1] * R[7] - lever[2] * R[8]


def change_frame(x: 'float[:]', R: 'float[:]', v_c: 'float[:]', sign: float) -> None:
    """nu += sign * current: between the velocity over ground and the one through the water."""
    rotation(R, x)
    for i in range(3):
        x[7 + i] = x[7 + i] + sign * (R[i] * v_c[0] + R[3 + i] * v_c[1] + R[6 + i] * v_c[2])


def setup(
    B: 'float[:,:]', M: 'float[:,:]', M_inv: 'float[:,:]', m: float, I: 'float[:]', I_products: 'float[:]',
    r_g: 'float[:]', added_mass: 'float[:]', added_inertia: 'float[:]', thruster_position: 'float[:]',
    thruster_direction: 'float[:]', D: 'float[:,:]', lever: 'float[:]', D_force: 'float[:]', D_moment: 'float[:]',
    D_force_quadratic: 'float[:]', D_moment_quadratic: 'float[:]', W: float, net_buoyancy: float, r_b: 'float[:]',
    work: 'float[:]',
) -> None:
    """Allocation matrix B, mass matrix M = M_RB + M_A about the body origin and its inverse, D and lever."""
    for i in range(3):
        D[0, i] = D_force[i]
        D[0, 3 + i] = D_moment[i]
        D[1, i] = D_force_quadratic[i]
        D[1, 3 + i] = D_moment_quadratic[i]
        lever[i] = W * r_g[i] - (W + net_buoyancy) * r_b[i]
    for j in range(8):
        k = 3 * j
        for i in range(6):
            work[i] = 0.0
        for i in range(3):
            work[i] = thruster_direction[k + i]
        cross_add(
             work, 3, thruster_position[k], thruster_position[k + 1], thruster_position[k + 2], work[0], work[1],
            work[2])
        for i in range(6):
            B[i, j] = work[i]

    for i in range(6):
        for j in range(6):
            M[i, j] = 0.0
            M_inv[i, j] = 0.0
        M_inv[i, i] = 1.0
    for i in range(3):
        M[i, i] = m + added_mass[i]
        M[3 + i, 3 + i] = I[i] + added_inertia[i]
    M[3, 4] = I_products[0]
    M[4, 3] = I_products[0]
    M[3, 5] = I_products[1]
    M[5, 3] = I_products[1]
    M[4, 5] = I_products[2]
    M[5, 4] = I_products[2]
    # Coupling -m S(r_g) of translation with rotation.
    M[0, 4] = m * r_g[2]
    M[0, 5] = -m * r_g[1]
    M[1, 3] = -m * r_g[2]
    M[1, 5] = m * r_g[0]
    M[2, 3] = m * r_g[1]
    M[2, 4] = -m * r_g[0]
    for i in range(3):
        for j in range(3):
            M[3 + i, j] = M[j, 3 + i]

    # Gauss-Jordan without pivoting, which a positive definite matrix does not need.
    for i in range(6):
        for j in range(6):
            work[6 * i + j] = M[i, j]
    for i in range(6):
        pivot = work[7 * i]
        for j in range(6):
            work[6 * i + j] = work[6 * i + j] / pivot
            M_inv[i, j] = M_inv[i, j] / pivot
        for n in range(6):
            if n != i:
                factor = work[6 * n + i]
                for j in range(6):
                    work[6 * n + j] = work[6 * n + j] - factor * work[6 * i + j]
                    M_inv[n, j] = M_inv[n, j] - factor * M_inv[i, j]


def initialize(
    x: 'float[:]', thrust_state: 'float[:]', current: 'float[:]', energy_start: 'float[:]', R: 'float[:]',
    v_c: 'float[:]', M: 'float[:,:]', added_mass: 'float[:]', lever: 'float[:]', net_buoyancy: float,
    position_start: 'float[:]', attitude_start: 'float[:]', velocity_start: 'float[:]', rates_start: 'float[:]',
) -> None:
    """Initial pose and velocity, thrusters at rest, no work done."""
    for i in range(3):
        x[i] = position_start[i]
        x[7 + i] = velocity_start[i]
        x[10 + i] = rates_start[i]
        current[i] = v_c[i]
    c1 = cos(0.5 * attitude_start[0])
    s1 = sin(0.5 * attitude_start[0])
    c2 = cos(0.5 * attitude_start[1])
    s2 = sin(0.5 * attitude_start[1])
    c3 = cos(0.5 * attitude_start[2])
    s3 = sin(0.5 * attitude_start[2])
    x[3] = c1 * c2 * c3 + s1 * s2 * s3
    x[4] = s1 * c2 * c3 - c1 * s2 * s3
    x[5] = c1 * s2 * c3 + s1 * c2 * s3
    x[6] = c1 * c2 * s3 - s1 * s2 * c3
    for i in range(5):
        x[13 + i] = 0.0
    for j in range(8):
        thrust_state[j] = 0.0
    rotation(R, x)
    energy_start[0] = kinetic(x, R, current, M, added_mass) + potential(x, R, lever, net_buoyancy)


def outputs(
    x: 'float[:]', y: 'float[:]', thrust_state: 'float[:]', current: 'float[:]', energy_start: 'float[:]',
    quat: 'float[:]', thrust: 'float[:]', F_control: 'float[:]', M_control: 'float[:]', F_disturb: 'float[:]',
    M_disturb: 'float[:]', tau_external: 'float[:]', tau_control: 'float[:]', tau_disturb: 'float[:]', R: 'float[:]',
    v_water: 'float[:]', force: 'float[:]', stage: 'float[:]', k: 'float[:]', work: 'float[:]',
    u_thruster: 'float[:]', F_x: float, F_y: float, F_z: float, M_x: float, M_y: float, M_z: float,
    F_external: 'float[:]', M_external: 'float[:]', v_c: 'float[:]', B: 'float[:,:]', M: 'float[:,:]',
    M_inv: 'float[:,:]', added_mass: 'float[:]', D: 'float[:,:]', lever: 'float[:]', net_buoyancy: float,
    k_T_forward: float, k_T_reverse: float, r_tool: 'float[:]', R_tool_body: 'float[:]', R_brush: float,
    hull_point: 'float[:]', hull_normal: 'float[:]',
) -> None:
    """Pose, velocities, thrusts, wrenches, the tool's place and motion against the hull, powers and energies."""
    thruster_wrench(tau_control, B, thrust_state, u_thruster, k_T_forward, k_T_reverse, 1.0)
    tool_wrench(tau_disturb, r_tool, R_tool_body, F_x, F_y, F_z, M_x, M_y, M_z)
    for i in range(3):
        tau_external[i] = F_external[i]
        tau_external[3 + i] = M_external[i]
    for i in range(18):
        stage[i] = x[i]
    change_frame(stage, R, v_c, -1.0)
    rates(
        k, stage, R, v_water, force, tau_control, tau_disturb, tau_external, v_c, M, M_inv, added_mass, D, lever,
        net_buoyancy)
    P_thruster = k[13]
    P_tool = k[14]
    P_damping = k[17]

    x_n = x[0]
    y_n = x[1]
    z_n = x[2]
    phi = atan2(R[7], R[8])
    theta = -asin(min(1.0, max(-1.0, R[6])))
    psi = atan2(R[3], R[0])
    u = x[7]
    v = x[8]
    w = x[9]
    p = x[10]
    q = x[11]
    r = x[12]
    for i in range(4):
        quat[i] = x[3 + i]
    for i in range(8):
        thrust[i] = thrust_state[i]
    for i in range(3):
        F_control[i] = tau_control[i]
        M_control[i] = tau_control[3 + i]
        F_disturb[i] = tau_disturb[i]
        M_disturb[i] = tau_disturb[3 + i]

    # Tool point: its distance from the body origin in the world in work[0..2], its velocity in the body frame in
    # work[3..5] and in the world in work[6..8]; z_t in the world in work[9..11].
    for i in range(3):
        work[i] = R[3 * i] * r_tool[0] + R[3 * i + 1] * r_tool[1] + R[3 * i + 2] * r_tool[2]
        work[3 + i] = x[7 + i]
        work[9 + i] = R[3 * i] * R_tool_body[2] + R[3 * i + 1] * R_tool_body[5] + R[3 * i + 2] * R_tool_body[8]
        work[12 + i] = 0.0
    cross_add(work, 3, p, q, r, r_tool[0], r_tool[1], r_tool[2])
    delta = R_brush
    delta_dot = 0.0
    v_rov = 0.0
    facing = 0.0
    for i in range(3):
        work[6 + i] = R[3 * i] * work[3] + R[3 * i + 1] * work[4] + R[3 * i + 2] * work[5]
        delta = delta - hull_normal[i] * (x[i] + work[i] - hull_point[i])
        delta_dot = delta_dot - hull_normal[i] * work[6 + i]
        v_rov = v_rov - R_tool_body[3 * i] * work[3 + i]
        facing = facing - hull_normal[i] * work[9 + i]
    # atan2 of sine and cosine is exact near zero, where acos is not.
    cross_add(work, 12, work[9], work[10], work[11], hull_normal[0], hull_normal[1], hull_normal[2])
    misalignment = atan2(sqrt(work[12] * work[12] + work[13] * work[13] + work[14] * work[14]), facing)

    W_thruster = x[13]
    W_tool = x[14]
    W_external = x[15]
    W_current = x[16]
    W_damping = x[17]
    E_kinetic = kinetic(x, R, current, M, added_mass)
    E_potential = potential(x, R, lever, net_buoyancy)
    work_done = W_thruster + W_tool + W_external + W_current - W_damping
    energy_residual = energy_start[0] + work_done - E_kinetic - E_potential
    y[0] = x_n
    y[1] = y_n
    y[2] = z_n
    y[3] = phi
    y[4] = theta
    y[5] = psi
    y[6] = u
    y[7] = v
    y[8] = w
    y[9] = p
    y[10] = q
    y[11] = r
    for i in range(4):
        y[12 + i] = quat[i]
    y[16] = delta
    y[17] = delta_dot
    y[18] = v_rov
    y[19] = misalignment
    for i in range(8):
        y[20 + i] = thrust[i]
    for i in range(3):
        y[28 + i] = F_control[i]
    for i in range(3):
        y[31 + i] = M_control[i]
    for i in range(3):
        y[34 + i] = F_disturb[i]
    for i in range(3):
        y[37 + i] = M_disturb[i]
    y[40] = P_thruster
    y[41] = P_tool
    y[42] = P_damping
    y[43] = W_thruster
    y[44] = W_tool
    y[45] = W_external
    y[46] = W_current
    y[47] = W_damping
    y[48] = E_kinetic
    y[49] = E_potential
    y[50] = energy_residual


def step(
    t: float, h: float, x: 'float[:]', y: 'float[:]', thrust_state: 'float[:]', current: 'float[:]',
    energy_start: 'float[:]', quat: 'float[:]', thrust: 'float[:]', F_control: 'float[:]', M_control: 'float[:]',
    F_disturb: 'float[:]', M_disturb: 'float[:]', tau_external: 'float[:]', tau_control: 'float[:]',
    tau_disturb: 'float[:]', R: 'float[:]', v_water: 'float[:]', force: 'float[:]', stage: 'float[:]', k: 'float[:]',
    increment: 'float[:]', work: 'float[:]', u_thruster: 'float[:]', F_x: float, F_y: float, F_z: float, M_x: float,
    M_y: float, M_z: float, F_external: 'float[:]', M_external: 'float[:]', v_c: 'float[:]', B: 'float[:,:]',
    M: 'float[:,:]', M_inv: 'float[:,:]', added_mass: 'float[:]', D: 'float[:,:]', lever: 'float[:]',
    net_buoyancy: float, k_T_forward: float, k_T_reverse: float, thruster_lag: float, r_tool: 'float[:]',
    R_tool_body: 'float[:]', R_brush: float, hull_point: 'float[:]', hull_normal: 'float[:]', max_step: float,
) -> None:
    """Advance by h in equal Runge-Kutta steps; the thrusters' lag is solved exactly beside them."""
    count = max(1, ceil(h / max_step - 1e-6))
    dt = h / count
    half_decay = 0.0
    decay = 0.0
    if thruster_lag > 0.0:
        half_decay = exp(-0.5 * dt / thruster_lag)
        decay = exp(-dt / thruster_lag)
    else:
        for j in range(8):
            thrust_state[j] = thrust_of(u_thruster[j], k_T_forward, k_T_reverse)
    tool_wrench(tau_disturb, r_tool, R_tool_body, F_x, F_y, F_z, M_x, M_y, M_z)
    for i in range(3):
        tau_external[i] = F_external[i]
        tau_external[3 + i] = M_external[i]

    # A change of the current changes the energy of the added mass at once: work of the water on the vehicle.
    rotation(R, x)
    x[16] = x[16] - kinetic(x, R, current, M, added_mass)
    for i in range(3):
        current[i] = v_c[i]
    x[16] = x[16] + kinetic(x, R, current, M, added_mass)

    change_frame(x, R, v_c, -1.0)
    for _ in range(count):
        for i in range(18):
            stage[i] = x[i]
            increment[i] = 0.0
        for s in range(4):
            reached = half_decay
            weight = 2.0
            if s == 0:
                reached = 1.0
                weight = 1.0
            if s == 3:
                reached = decay
                weight = 1.0
            thruster_wrench(tau_control, B, thrust_state, u_thruster, k_T_forward, k_T_reverse, reached)
            rates(
                k, stage, R, v_water, force, tau_control, tau_disturb, tau_external, v_c, M, M_inv, added_mass, D,
                lever, net_buoyancy)
            ahead = 0.5 * dt
            if s == 2:
                ahead = dt
            for i in range(18):
                increment[i] = increment[i] + weight * k[i]
                stage[i] = x[i] + ahead * k[i]
        for i in range(18):
            x[i] = x[i] + dt / 6.0 * increment[i]
        length = sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6])
        for i in range(3, 7):
            x[i] = x[i] / length
        for j in range(8):
            steady = thrust_of(u_thruster[j], k_T_forward, k_T_reverse)
            thrust_state[j] = decay * thrust_state[j] + (1.0 - decay) * steady
    change_frame(x, R, v_c, 1.0)
    outputs(
         x, y, thrust_state, current, energy_start, quat, thrust, F_control, M_control, F_disturb, M_disturb,
        tau_external, tau_control, tau_disturb, R, v_water, force, stage, k, work, u_thruster, F_x, F_y, F_z, M_x,
        M_y, M_z, F_external, M_external, v_c, B, M, M_inv, added_mass, D, lever, net_buoyancy, k_T_forward,
        k_T_reverse, r_tool, R_tool_body, R_brush, hull_point, hull_normal)
