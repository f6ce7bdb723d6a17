"""Underwater vehicle in six degrees of freedom (Eqs. 18-21), its thrusters, tool wrench and tool-to-hull kinematics.

World frame: north, east, down. Body frame: forward, starboard, down. The current is uniform and constant over a step:
the equations hold in the frame that moves with the water, where the velocity is the relative velocity nu_r.

x: [0..2] position, [3..6] quaternion body to world (scalar first), [7..12] nu over ground (nu_r inside a step),
   [13..17] energies: thrusters, tool, external wrench, current, damping.
thrust_state: thrust of each thruster. current: that of the last step. energy_start: kinetic and potential at start.
D: linear (row 0) and quadratic (row 1) damping. lever: W r_g - B r_b, the moment of weight and buoyancy per vertical.
"""

from math import ceil

from .energy import kinetic, potential
from .frames import change_frame, euler_angles, quaternion, rotation
from .inertia import inverse, mass_matrix
from .motion import rates
from .propulsion import allocation, thrust_of, thruster_wrench
from .runge_kutta import runge_kutta
from .tool import tool_motion, tool_wrench


def setup(
    B: "float[:,:]", M: "float[:,:]", M_inv: "float[:,:]", m: float, I: "float[:]", I_products: "float[:]",
    r_g: "float[:]", added_mass: "float[:]", added_inertia: "float[:]", thruster_position: "float[:]",
    thruster_direction: "float[:]", D: "float[:,:]", lever: "float[:]", D_force: "float[:]", D_moment: "float[:]",
    D_force_quadratic: "float[:]", D_moment_quadratic: "float[:]", W: float, net_buoyancy: float, r_b: "float[:]",
    work: "float[:]",
) -> None:
    """Allocation matrix B, mass matrix M = M_RB + M_A about the body origin and its inverse, D and lever."""
    for i in range(3):
        D[0, i] = D_force[i]
        D[0, 3 + i] = D_moment[i]
        D[1, i] = D_force_quadratic[i]
        D[1, 3 + i] = D_moment_quadratic[i]
        lever[i] = W * r_g[i] - (W + net_buoyancy) * r_b[i]
    allocation(B, thruster_position, thruster_direction, work)
    mass_matrix(M, m, I, I_products, r_g, added_mass, added_inertia)
    inverse(M, M_inv, work)


def initialize(
    x: "float[:]", thrust_state: "float[:]", current: "float[:]", energy_start: "float[:]", R: "float[:]",
    v_c: "float[:]", M: "float[:,:]", added_mass: "float[:]", lever: "float[:]", net_buoyancy: float,
    position_start: "float[:]", attitude_start: "float[:]", velocity_start: "float[:]", rates_start: "float[:]",
) -> None:
    """Initial pose and velocity, thrusters at rest, no work done."""
    for i in range(3):
        x[i] = position_start[i]
        x[7 + i] = velocity_start[i]
        x[10 + i] = rates_start[i]
        current[i] = v_c[i]
    quaternion(x, attitude_start[0], attitude_start[1], attitude_start[2])
    for i in range(5):
        x[13 + i] = 0.0
    for j in range(8):
        thrust_state[j] = 0.0
    rotation(R, x)
    energy_start[0] = kinetic(x, R, current, M, added_mass) + potential(x, R, lever, net_buoyancy)


def outputs(
    x: "float[:]", y: "float[:]", thrust_state: "float[:]", current: "float[:]", energy_start: "float[:]",
    quat: "float[:]", thrust: "float[:]", F_control: "float[:]", M_control: "float[:]", F_disturb: "float[:]",
    M_disturb: "float[:]", tau_external: "float[:]", tau_control: "float[:]", tau_disturb: "float[:]", R: "float[:]",
    v_water: "float[:]", force: "float[:]", stage: "float[:]", k: "float[:]", work: "float[:]", u_thruster: "float[:]",
    F_x: float, F_y: float, F_z: float, M_x: float, M_y: float, M_z: float, F_external: "float[:]",
    M_external: "float[:]", v_c: "float[:]", B: "float[:,:]", M: "float[:,:]", M_inv: "float[:,:]",
    added_mass: "float[:]", D: "float[:,:]", lever: "float[:]", net_buoyancy: float, k_T_forward: float,
    k_T_reverse: float, r_tool: "float[:]", R_tool_body: "float[:]", R_brush: float, hull_point: "float[:]",
    hull_normal: "float[:]",
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
    phi, theta, psi = euler_angles(R, x)
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

    delta, delta_dot, v_rov, misalignment = tool_motion(
        x, R, r_tool, R_tool_body, R_brush, hull_point, hull_normal, work)

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
    h: float, x: "float[:]", y: "float[:]", thrust_state: "float[:]", current: "float[:]", energy_start: "float[:]",
    quat: "float[:]", thrust: "float[:]", F_control: "float[:]", M_control: "float[:]", F_disturb: "float[:]",
    M_disturb: "float[:]", tau_external: "float[:]", tau_control: "float[:]", tau_disturb: "float[:]", R: "float[:]",
    v_water: "float[:]", force: "float[:]", stage: "float[:]", k: "float[:]", increment: "float[:]", work: "float[:]",
    u_thruster: "float[:]", F_x: float, F_y: float, F_z: float, M_x: float, M_y: float, M_z: float,
    F_external: "float[:]", M_external: "float[:]", v_c: "float[:]", B: "float[:,:]", M: "float[:,:]",
    M_inv: "float[:,:]", added_mass: "float[:]", D: "float[:,:]", lever: "float[:]", net_buoyancy: float,
    k_T_forward: float, k_T_reverse: float, thruster_lag: float, r_tool: "float[:]", R_tool_body: "float[:]",
    R_brush: float, hull_point: "float[:]", hull_normal: "float[:]", max_step: float,
) -> None:
    """Advance by h in equal Runge-Kutta steps of at most max_step."""
    count = max(1, ceil(h / max_step - 1e-6))
    dt = h / count
    if thruster_lag <= 0.0:
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
        runge_kutta(
            dt, x, thrust_state, stage, k, increment, R, v_water, force, tau_control, tau_disturb, tau_external,
            u_thruster, v_c, B, M, M_inv, added_mass, D, lever, net_buoyancy, k_T_forward, k_T_reverse, thruster_lag)
    change_frame(x, R, v_c, 1.0)
    outputs(
        x, y, thrust_state, current, energy_start, quat, thrust, F_control, M_control, F_disturb, M_disturb,
        tau_external, tau_control, tau_disturb, R, v_water, force, stage, k, work, u_thruster, F_x, F_y, F_z, M_x, M_y,
        M_z, F_external, M_external, v_c, B, M, M_inv, added_mass, D, lever, net_buoyancy, k_T_forward, k_T_reverse,
        r_tool, R_tool_body, R_brush, hull_point, hull_normal)
