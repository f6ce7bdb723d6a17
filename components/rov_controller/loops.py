"""The loops of one sample: position and attitude to set-points, those to a wrench, that to thruster commands."""

from math import sqrt

from .allocation import allocate
from .attitude import attitude_error, quaternion, to_body
from .force import feed_forward, press


def limit(e: "float[:]", at: int, largest: float) -> None:
    """Shorten the vector e[at..at+2] to the length `largest`."""
    length = sqrt(e[at] * e[at] + e[at + 1] * e[at + 1] + e[at + 2] * e[at + 2])
    if length > largest:
        for i in range(3):
            e[at + i] = e[at + i] * largest / length


def set_points(
    e: "float[:]", work: "float[:]", x_n: float, y_n: float, z_n: float, phi: float, theta: float, psi: float,
    x_ref: float, y_ref: float, z_ref: float, phi_ref: float, theta_ref: float, psi_ref: float, v_ref: "float[:]",
    K_position: "float[:]", K_attitude: "float[:]", v_max: float, rate_max: float,
) -> None:
    """Outer loops: velocity and rate set-points, body frame, in e."""
    quaternion(work, 0, phi, theta, psi)
    quaternion(work, 4, phi_ref, theta_ref, psi_ref)
    e[0] = K_position[0] * (x_ref - x_n)
    e[1] = K_position[1] * (y_ref - y_n)
    e[2] = K_position[2] * (z_ref - z_n)
    for i in range(3):
        e[i] = e[i] + v_ref[i]
    limit(e, 0, v_max)
    to_body(e, work)
    attitude_error(e, work)
    for i in range(3):
        e[3 + i] = K_attitude[i] * e[3 + i]
    limit(e, 3, rate_max)


def sample(
    integral: "float[:]", nu_last: "float[:]", command: "float[:]", memory: "float[:]", e: "float[:]", nu: "float[:]",
    tau: "float[:]", F: "float[:]", gains: "float[:,:]", B: "float[:,:]", B_pinv: "float[:,:]", wrench: "float[:]",
    normal: "float[:]", V_ref: float, F_n_ref: float, mode: int, T_s: float, K_windup: float, K_feedforward: float,
    contact_force: float, K_force: float, K_force_i: float, K_force_d: float, attitude_first: bool, k_T_forward: float,
    k_T_reverse: float,
) -> None:
    """Inner loops and allocation: e holds the velocity and rate set-points, nu the measured velocities."""
    for i in range(6):
        acceleration = (nu[i] - nu_last[i]) / T_s
        nu_last[i] = nu[i]
        e[i] = e[i] - nu[i]
        tau[i] = gains[0, i] * e[i] + integral[i] - gains[2, i] * acceleration
    if mode >= 1:
        feed_forward(tau, wrench, K_feedforward)
    if mode == 2:
        press(
            tau, e, integral, nu, wrench, memory, normal, F_n_ref, T_s, contact_force, K_force, K_force_i, K_force_d)
    for i in range(6):
        memory[4 + i] = tau[i]
    memory[1] = V_ref
    memory[2] = 0.0
    if allocate(F, B_pinv, tau, attitude_first, k_T_forward, k_T_reverse):
        memory[2] = 1.0
        memory[3] = memory[3] + 1.0
    for i in range(6):
        # Anti-windup by back-calculation: the integral follows what the thrusters can give.
        given = 0.0
        for j in range(8):
            given = given + B[i, j] * F[j]
        integral[i] = integral[i] + T_s * (gains[1, i] * e[i] + K_windup * (given - tau[i]))
        if i < 3 and memory[10] > 0.0:
            memory[11] = memory[11] + T_s * K_windup * normal[i] * (given - tau[i])
    for j in range(8):
        # Inverse of F = k_T sgn(u) u^2.
        command[j] = sqrt(F[j] / k_T_forward) if F[j] >= 0.0 else -sqrt(-F[j] / k_T_reverse)
