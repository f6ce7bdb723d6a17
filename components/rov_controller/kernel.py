"""Cascaded PID at a fixed rate: position -> velocity -> force and attitude -> rate -> moment, then thruster allocation.

command: held thruster commands. memory: [0] number of the next sample (-1 before the first), [1] held brush voltage,
[2] saturated, [3] number of saturated samples, [4..9] requested wrench, [10] pressing, [11] integral of the force
error. wrench: filtered tool wrench, body frame. Samples are taken at multiples of T_s.
"""

from math import ceil

from .allocation import allocation, pseudoinverse
from .force import along, filter_wrench
from .loops import sample, set_points


def setup(
    B: "float[:,:]", B_pinv: "float[:,:]", work: "float[:]", thruster_position: "float[:]",
    thruster_direction: "float[:]",
) -> None:
    """B of Eq. 20 from the geometry and its pseudoinverse."""
    allocation(B, thruster_position, thruster_direction)
    pseudoinverse(B, B_pinv, work)


def initialize(
    integral: "float[:]", nu_last: "float[:]", command: "float[:]", memory: "float[:]", wrench: "float[:]",
    V_ref: float,
) -> None:
    """Thrusters off until the first sample; the brush voltage is on at once."""
    for i in range(6):
        integral[i] = 0.0
        nu_last[i] = 0.0
        wrench[i] = 0.0
        memory[4 + i] = 0.0
    for j in range(8):
        command[j] = 0.0
    memory[0] = -1.0
    memory[1] = V_ref
    memory[2] = 0.0
    memory[3] = 0.0
    memory[10] = 0.0
    memory[11] = 0.0


def outputs(
    y: "float[:]", u_thruster: "float[:]", F_ref: "float[:]", M_ref: "float[:]", command: "float[:]",
    memory: "float[:]", wrench: "float[:]", normal: "float[:]",
) -> None:
    """Write what the last sample decided."""
    for j in range(8):
        u_thruster[j] = command[j]
    for i in range(3):
        F_ref[i] = memory[4 + i]
        M_ref[i] = memory[7 + i]
    V_in = memory[1]
    saturated = memory[2]
    saturation_count = memory[3]
    F_n = -along(wrench, normal)
    pressing = memory[10]
    for j in range(8):
        y[j] = u_thruster[j]
    y[8] = V_in
    for i in range(3):
        y[9 + i] = F_ref[i]
    for i in range(3):
        y[12 + i] = M_ref[i]
    y[15] = saturated
    y[16] = saturation_count
    y[17] = F_n
    y[18] = pressing


def step(
    t: float, h: float, y: "float[:]", integral: "float[:]", nu_last: "float[:]", command: "float[:]",
    memory: "float[:]", e: "float[:]", nu: "float[:]", tau: "float[:]", F: "float[:]", gains: "float[:,:]",
    work: "float[:]", u_thruster: "float[:]", F_ref: "float[:]", M_ref: "float[:]", B: "float[:,:]",
    B_pinv: "float[:,:]", x_n: float, y_n: float, z_n: float, phi: float, theta: float, psi: float, u: float, v: float,
    w: float, p: float, q: float, r: float, x_ref: float, y_ref: float, z_ref: float, phi_ref: float, theta_ref: float,
    psi_ref: float, v_ref: "float[:]", V_ref: float, F_n_ref: float, F_tool: "float[:]", M_tool: "float[:]",
    wrench: "float[:]", mode: int, normal: "float[:]", T_s: float, K_position: "float[:]", K_velocity: "float[:]",
    K_velocity_i: "float[:]", K_velocity_d: "float[:]", K_attitude: "float[:]", K_rate: "float[:]",
    K_rate_i: "float[:]", K_rate_d: "float[:]", K_windup: float, K_feedforward: float, T_filter: float,
    contact_force: float, K_force: float, K_force_i: float, K_force_d: float, v_max: float, rate_max: float,
    attitude_first: bool, k_T_forward: float, k_T_reverse: float,
) -> None:
    """Take the samples that fall into [t, t + h), with the inputs as they are; most often one, or none."""
    # A sample belongs to the step that starts at it, whatever the rounding of t.
    margin = 1e-6 * T_s
    filter_wrench(wrench, F_tool, M_tool, h, T_filter)
    nu[0] = u
    nu[1] = v
    nu[2] = w
    nu[3] = p
    nu[4] = q
    nu[5] = r
    for i in range(3):
        gains[0, i] = K_velocity[i]
        gains[0, 3 + i] = K_rate[i]
        gains[1, i] = K_velocity_i[i]
        gains[1, 3 + i] = K_rate_i[i]
        gains[2, i] = K_velocity_d[i]
        gains[2, 3 + i] = K_rate_d[i]
    if memory[0] < 0.0:
        memory[0] = ceil((t - margin) / T_s) * 1.0
        for i in range(6):
            nu_last[i] = nu[i]
    while memory[0] * T_s < t + h - margin:
        set_points(
            e, work, x_n, y_n, z_n, phi, theta, psi, x_ref, y_ref, z_ref, phi_ref, theta_ref, psi_ref, v_ref,
            K_position, K_attitude, v_max, rate_max)
        sample(
            integral, nu_last, command, memory, e, nu, tau, F, gains, B, B_pinv, wrench, normal, V_ref, F_n_ref, mode,
            T_s, K_windup, K_feedforward, contact_force, K_force, K_force_i, K_force_d, attitude_first, k_T_forward,
            k_T_reverse)
        memory[0] = memory[0] + 1.0
    outputs(y, u_thruster, F_ref, M_ref, command, memory, wrench, normal)
