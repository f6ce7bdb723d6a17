"""Reactions at the filaments' bases (Eqs. 11-13) and their sums over the brush (Eqs. 14, 15)."""

from math import cos, floor, pi, sin

from .contact import contact_energy
from .filament import free_acceleration, tip_force


def base_reactions(
    F_a: float, F_t: float, shortening: float, q: float, r_A: float, offset: float, mode_acceleration: bool, N_m: int,
    L: float, EI: float, m: float, omega_r: "float[:]", modes: "float[:,:]", work: "float[:,:]",
) -> tuple[float, float, float]:
    """Base shear (Eq. 11), base moment (Eq. 12) and tip deflection from eta, eta_dot, eta'' in rows 0, 1, 4 of work.

    The plain sum is what the paper prints. Mode acceleration sums over modes only what inertia and damping give and
    takes the loads as they are, so that it is exact in statics: (F_a, F_t) at the tip and, along the filament, the
    centrifugal load q (r_A + x, y - offset).
    """
    shear = 0.0
    moment = 0.0
    y = 0.0
    for r in range(N_m):
        shear = shear + EI * modes[6, r] * work[0, r]  # Eq. 11
        moment = moment + EI * modes[5, r] * work[0, r]  # Eq. 12
        y = y + modes[1, r] * work[0, r]  # Eq. 2
    if mode_acceleration:
        shear = -F_t + q * L * offset
        moment = F_t * (L - shortening) - q * 0.5 * L * L * offset
        if shortening > 0.0:
            moment = moment - F_a * y
        for r in range(N_m):
            inertia = m * (work[4, r] + modes[0, r] * work[1, r])
            shear = shear + (inertia - q * work[0, r]) * modes[3, r]
            moment = moment - inertia * modes[4, r] - q * r_A * modes[3, r] * work[0, r]
        if F_t != 0.0:
            y = y + F_t * L * L * L / (3.0 * EI)
            for r in range(N_m):
                y = y - F_t * modes[1, r] * modes[1, r] / (m * L * omega_r[r] * omega_r[r])
    return shear, moment, y


def brush_sums(
    theta_b: float, h_plane: float, L: float, EI: float, N_m: int, n: int, R_brush: float, alpha: float, k_c: float,
    foreshortening: bool, mode_acceleration: bool, omega_r: "float[:]", modes: "float[:,:]", G: "float[:,:]",
    K: "float[:,:]", c: "float[:]", work: "float[:,:]", eta: "float[:,:]", eta_dot: "float[:,:]",
    filament: "float[:,:]", kinetic_fraction: "float[:]",
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """Forces, torques, powers and energies of the whole brush; fills the table `filament`.

    kinetic_fraction holds the kinetic energy of each mode afterwards.
    """
    M = c[2]
    F_x = 0.0
    F_z = 0.0
    T_brush = 0.0
    contact_count = 0.0
    F_y_eq11 = 0.0
    M_b_eq12 = 0.0
    F_z_eq13 = 0.0
    T_brush_eq15 = 0.0
    P_damping = 0.0
    P_friction = 0.0
    P_contact = 0.0
    E_kinetic = 0.0
    E_strain = 0.0
    E_contact = 0.0
    for r in range(6):
        kinetic_fraction[r] = 0.0
    for i in range(n):
        phi = theta_b + 2.0 * pi * i / n
        psi = phi - alpha
        sin_psi = sin(psi)
        cos_psi = cos(psi)
        for r in range(N_m):
            work[0, r] = eta[i, r]
            work[1, r] = eta_dot[i, r]
        free_acceleration(0, 1, 4, N_m, modes, K, work)
        Delta, _ = tip_force(0, 1, 4, N_m, sin_psi, cos_psi, h_plane, foreshortening, modes, G, c, work)
        F_f = work[10, 0]
        F_n = work[10, 1]
        F_x = F_x - F_f  # Eq. 14
        F_z = F_z - F_n  # Eq. 14
        T_brush = T_brush + work[10, 2]
        P_friction = P_friction + work[10, 3]
        P_contact = P_contact + work[10, 4]
        P_damping = P_damping + work[10, 5]
        if F_n > 0.0:
            contact_count = contact_count + 1.0
        E_contact = E_contact + contact_energy(Delta, k_c)
        slope = 0.0
        shortening = 0.0
        for r in range(N_m):
            kinetic = 0.5 * M * work[1, r] * work[1, r]
            kinetic_fraction[r] = kinetic_fraction[r] + kinetic
            E_kinetic = E_kinetic + kinetic
            E_strain = E_strain + 0.5 * M * omega_r[r] * omega_r[r] * work[0, r] * work[0, r]
            slope = slope + modes[2, r] * work[0, r]
            shortening = shortening + 0.5 * work[9, r] * work[0, r]
        shear, moment, y_tip = base_reactions(
            -F_f * sin_psi - F_n * cos_psi, F_f * cos_psi - F_n * sin_psi, shortening, M * c[3] * c[4] / L, c[0] - L,
            -c[1], mode_acceleration, N_m, L, EI, M / L, omega_r, modes, work)
        F_y_eq11 = F_y_eq11 + shear
        M_b_eq12 = M_b_eq12 + moment
        F_z_eq13 = F_z_eq13 + F_n * slope - F_f  # Eq. 13
        # Eq. 15: cos(phi) = cos(psi + alpha)
        T_brush_eq15 = T_brush_eq15 + R_brush * shear * (cos_psi * cos(alpha) - sin_psi * sin(alpha))
        filament[i, 0] = phi - 2.0 * pi * floor((phi + pi) / (2.0 * pi))
        filament[i, 1] = F_n
        filament[i, 2] = F_f
        filament[i, 3] = y_tip
    return (
        F_x, F_z, T_brush, contact_count, F_y_eq11, M_b_eq12, F_z_eq13, T_brush_eq15, P_damping, P_friction, P_contact,
        E_kinetic, E_strain, E_contact)
