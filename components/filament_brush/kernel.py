"""Filament brush: modal filaments with contact and friction (Eqs. 1-13) and their sum over the brush (Eqs. 14-15).

Frames and symbols are those of README.md. Tables filled by `setup`, column r - 1 for mode r:
  modes[q, r]: q = 0 2 zeta_r omega_r, 1 Y_r(L), 2 Y_r'(L), 3 int Y_r dx, 4 int x Y_r dx, 5 Y_r''(0), 6 Y_r'''(0)
  G[r, s] = int Y_r' Y_s' dx;  S[r, s] = centrifugal stiffness over omega_b^2 and the modal mass
State: eta, eta_dot [n, N_m], the next micro-step h_next [n], and total: 0 theta_b, 1 J_x, 2 J_z, 3 J_T, 4 W_hub,
  5 W_hull, 6 W_damping, 7 W_friction, 8 W_contact; at the end of the last step 9 E_contact, 10 E_centrifugal over
  omega_b^2, 11 omega_b^2; largest |y|/L 12 in the last step and 13 since the start;
  14 number and 15 shortest of the micro-steps
Scratch: K[r, s] stiffness and K[6, r] load per modal mass; c the constants of a step (see `constants`); P, Q, A the
  map of free flight and its making; filament [n, 4]: phi, F_n, F_f, tip deflection; work rows 0 eta, 1 eta_dot, 2 and
  3 the same at a Runge-Kutta stage, 4..8 accelerations of stages 1..5, 9 G eta, 10..14 the stages' F_f, F_n, moment
  about the brush axis and powers of friction, contact loss and damping
"""

from math import cos, pi, sin

from .contact import contact_energy
from .filament import constants, free_acceleration, hub_radius, tip_force
from .free_flight import advance_free, free_flight, tip_speed_bound
from .micro_steps import advance_touching
from .modes import centrifugal_energy, mode_table, slope_integrals
from .reactions import brush_sums


def setup(
    L: float, d: float, E: float, rho: float, rho_w: float, C_a: float, R_brush: float, alpha: float, zeta: "float[:]",
    lambda_r: "float[:]", omega_r: "float[:]", modes: "float[:,:]", G: "float[:,:]", S: "float[:,:]",
    work: "float[:,:]",
) -> None:
    """Fill lambda_r, omega_r, modes, G and S for six modes."""
    A = 0.25 * pi * d * d
    EI_zz = E * pi * d * d * d * d / 64.0
    m = (rho + C_a * rho_w) * A
    r_A = hub_radius(R_brush, L, alpha) * cos(alpha)
    mode_table(L, EI_zz, m, zeta, lambda_r, omega_r, modes)
    slope_integrals(L, r_A, rho, A, m, lambda_r, G, S, work)


def initialize(
    n: int, N_m: int, theta_b_0: float, h_min: float, h_max: float, eta: "float[:,:]", eta_dot: "float[:,:]",
    h_next: "float[:]", total: "float[:]",
) -> None:
    """Straight filaments at rest in the turning brush. Energy counts from here; what is pressed in is hull work."""
    for k in range(15):
        total[k] = 0.0
    total[0] = theta_b_0
    total[15] = h_max
    for i in range(n):
        h_next[i] = h_min
        for r in range(N_m):
            eta[i, r] = 0.0
            eta_dot[i, r] = 0.0


def outputs(
    omega_b: float, delta: float, delta_dot: float, v_rov: float, friction_scale: float, L: float, d: float, E: float,
    rho: float, rho_w: float, C_a: float, N_m: int, n: int, bristles_per_filament: float, R_brush: float, alpha: float,
    k_c: float, c_c: float, Delta_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float,
    foreshortening: bool, centrifugal: bool, mode_acceleration: bool, lambda_r: "float[:]", omega_r: "float[:]",
    modes: "float[:,:]", G: "float[:,:]", S: "float[:,:]", K: "float[:,:]", c: "float[:]", work: "float[:,:]",
    eta: "float[:,:]", eta_dot: "float[:,:]", total: "float[:]", filament: "float[:,:]", kinetic_fraction: "float[:]",
    y: "float[:]",
) -> None:
    """Write y and the table `filament` from the state and the inputs."""
    constants(
        omega_b, delta_dot, v_rov, friction_scale, L, d, rho, rho_w, C_a, N_m, bristles_per_filament, R_brush, alpha,
        k_c, c_c, Delta_s, mu_s, mu_c, v_0, k_v, v_eps, centrifugal, omega_r, modes, S, K, c)
    EI = bristles_per_filament * E * pi * d * d * d * d / 64.0
    (F_x, F_z, T_brush, contact_count, F_y_eq11, M_b_eq12, F_z_eq13, T_brush_eq15, P_damping, P_friction, P_contact,
     E_kinetic, E_strain, E_contact) = brush_sums(
        total[0], R_brush - delta, L, EI, N_m, n, R_brush, alpha, k_c, foreshortening, mode_acceleration, omega_r,
        modes, G, K, c, work, eta, eta_dot, filament, kinetic_fraction)
    for r in range(6):
        kinetic_fraction[r] = kinetic_fraction[r] / max(E_kinetic, 1e-30)
    theta_b = total[0]
    J_x = total[1]
    J_z = total[2]
    J_T = total[3]
    W_hub = total[4]
    W_hull = total[5]
    W_damping = total[6]
    W_friction = total[7]
    W_contact = total[8]
    P_hub = -omega_b * T_brush
    P_hull = F_x * v_rov - F_z * delta_dot
    E_centrifugal = c[4] * total[10]
    # inputs that jump do work at once; it is booked when the next step begins
    jump = E_contact - total[9] + E_centrifugal - total[10] * total[11]
    supplied = W_hub + W_hull + jump - W_damping - W_friction - W_contact
    energy_residual = E_kinetic + E_strain + E_centrifugal + E_contact - supplied
    deflection_ratio = total[12]
    deflection_ratio_max = total[13]
    micro_steps = total[14]
    h_micro_min = total[15]
    R_h = hub_radius(R_brush, L, alpha)
    J_filaments = n * c[2] * c[3] * (R_h * R_h + R_h * cos(alpha) * L + L * L / 3.0)

    y[0] = F_x
    y[1] = F_z
    y[2] = T_brush
    y[3] = contact_count
    y[4] = deflection_ratio
    y[5] = deflection_ratio_max
    y[6] = theta_b
    y[7] = J_x
    y[8] = J_z
    y[9] = J_T
    y[10] = F_y_eq11
    y[11] = M_b_eq12
    y[12] = F_z_eq13
    y[13] = T_brush_eq15
    y[14] = P_hub
    y[15] = P_hull
    y[16] = P_damping
    y[17] = P_friction
    y[18] = P_contact
    y[19] = E_kinetic
    y[20] = E_strain
    y[21] = E_centrifugal
    y[22] = E_contact
    y[23] = W_hub
    y[24] = W_hull
    y[25] = W_damping
    y[26] = W_friction
    y[27] = W_contact
    y[28] = energy_residual
    y[29] = micro_steps
    y[30] = h_micro_min
    for r in range(6):
        y[31 + r] = kinetic_fraction[r]
    for r in range(6):
        y[37 + r] = lambda_r[r]
    for r in range(6):
        y[43 + r] = omega_r[r]
    y[49] = R_h
    y[50] = J_filaments


def step(
    h: float, omega_b: float, delta: float, delta_dot: float, v_rov: float, friction_scale: float, L: float, d: float,
    E: float, rho: float, rho_w: float, C_a: float, N_m: int, n: int, bristles_per_filament: float, R_brush: float,
    alpha: float, k_c: float, c_c: float, Delta_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float,
    v_eps: float, foreshortening: bool, centrifugal: bool, mode_acceleration: bool, h_min: float, h_max: float,
    tolerance: float, lambda_r: "float[:]", omega_r: "float[:]", modes: "float[:,:]", G: "float[:,:]", S: "float[:,:]",
    K: "float[:,:]", P: "float[:,:]", Q: "float[:,:]", A: "float[:,:]", c: "float[:]", work: "float[:,:]",
    eta: "float[:,:]", eta_dot: "float[:,:]", h_next: "float[:]", total: "float[:]", filament: "float[:,:]",
    kinetic_fraction: "float[:]", y: "float[:]",
) -> None:
    """Advance the brush by h at constant omega_b, v_rov and delta_dot; delta goes on from its value at the start."""
    constants(
        omega_b, delta_dot, v_rov, friction_scale, L, d, rho, rho_w, C_a, N_m, bristles_per_filament, R_brush, alpha,
        k_c, c_c, Delta_s, mu_s, mu_c, v_0, k_v, v_eps, centrifugal, omega_r, modes, S, K, c)
    free_flight(h, N_m, c[5], modes, K, P, Q, A)
    J_x = total[1]
    J_z = total[2]
    J_T = total[3]
    E_start = 0.0
    E_end = 0.0
    E_centrifugal = 0.0
    total[12] = 0.0
    for i in range(n):
        psi = total[0] + 2.0 * pi * i / n - alpha
        for r in range(N_m):
            work[0, r] = eta[i, r]
            work[1, r] = eta_dot[i, r]
        free_acceleration(0, 1, 4, N_m, modes, K, work)
        Delta, rate = tip_force(0, 1, 4, N_m, sin(psi), cos(psi), R_brush - delta, foreshortening, modes, G, c, work)
        E_start = E_start + contact_energy(Delta, k_c)
        if Delta + h * (abs(omega_b) * R_brush + abs(delta_dot) + tip_speed_bound(N_m, K, work)) < 0.0:
            advance_free(N_m, c[2], K, P, work, total)
        else:
            h_next[i], Delta = advance_touching(
                psi, h, h_next[i], rate, Delta, R_brush - delta, N_m, L, foreshortening, h_min, h_max, tolerance,
                omega_r, modes, G, K, c, work, total)
            E_end = E_end + contact_energy(Delta, k_c)
        E_centrifugal = E_centrifugal + centrifugal_energy(N_m, L, modes, S, c, work)
        y_tip = 0.0
        for r in range(N_m):
            eta[i, r] = work[0, r]
            eta_dot[i, r] = work[1, r]
            y_tip = y_tip + modes[1, r] * work[0, r]
        total[12] = max(total[12], abs(y_tip) / L)
    total[0] = total[0] + omega_b * h
    # work of the hub and of the hull, and of the jumps of omega_b and delta before this step
    total[4] = total[4] - omega_b * (total[3] - J_T) + (c[4] - total[11]) * total[10]
    total[5] = total[5] + v_rov * (total[1] - J_x) - delta_dot * (total[2] - J_z) + E_start - total[9]
    total[9] = E_end
    total[10] = E_centrifugal
    total[11] = c[4]
    total[13] = max(total[12], total[13])
    outputs(
        omega_b, delta + delta_dot * h, delta_dot, v_rov, friction_scale, L, d, E, rho, rho_w, C_a, N_m, n,
        bristles_per_filament, R_brush, alpha, k_c, c_c, Delta_s, mu_s, mu_c, v_0, k_v, v_eps, foreshortening,
        centrifugal, mode_acceleration, lambda_r, omega_r, modes, G, S, K, c, work, eta, eta_dot, total, filament,
        kinetic_fraction, y)
