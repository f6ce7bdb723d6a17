"""The right-hand side of one filament: `free_acceleration` (Eq. 4), then `tip_force` of the hull (Eqs. 5-10).

Both read what `constants` filled in.
"""

from math import cos, pi, sin, sqrt

from .contact import friction_coefficient, normal_force
from .modes import stiffness


def hub_radius(R_brush: float, L: float, alpha: float) -> float:
    """R_h for which the undeformed tip lies on R_brush."""
    return sqrt(R_brush * R_brush - L * L * sin(alpha) * sin(alpha)) - L * cos(alpha)


def constants(
    omega_b: float, delta_dot: float, v_rov: float, friction_scale: float, L: float, d: float, rho: float, rho_w: float,
    C_a: float, N_m: int, bristles_per_filament: float, R_brush: float, alpha: float, k_c: float, c_c: float,
    Delta_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float, centrifugal: bool,
    omega_r: "float[:]", modes: "float[:,:]", S: "float[:,:]", K: "float[:,:]", c: "float[:]",
) -> None:
    """Fill K and c, what is constant over a step."""
    R_h = hub_radius(R_brush, L, alpha)
    chi = rho / (rho + C_a * rho_w)
    speed_2 = 0.0
    if centrifugal:
        speed_2 = omega_b * omega_b
    c[0] = R_h * cos(alpha) + L  # straight tip along e_a
    c[1] = -R_h * sin(alpha)  # straight tip along e_t
    c[2] = bristles_per_filament * rho * 0.25 * pi * d * d / chi * L  # modal mass M of a bundle
    c[3] = chi  # share of the bristle in it
    c[4] = speed_2  # omega_b^2 as far as it acts on the filaments
    c[5] = stiffness(speed_2, N_m, L, chi, R_h * sin(alpha), omega_r, modes, S, K)
    c[6] = omega_b
    c[7] = delta_dot
    c[8] = v_rov
    c[9] = k_c
    c[10] = c_c
    c[11] = Delta_s
    c[12] = friction_scale * mu_s
    c[13] = friction_scale * mu_c
    c[14] = v_0
    c[15] = k_v
    c[16] = v_eps


def free_acceleration(
    p: int, v: int, a: int, N_m: int, modes: "float[:,:]", K: "float[:,:]", work: "float[:,:]",
) -> None:
    """Row a of work = eta'' without tip force (Eq. 4) at eta, eta_dot in rows p, v."""
    for r in range(N_m):
        acceleration = K[6, r] - modes[0, r] * work[v, r]  # Eq. 4
        for s in range(N_m):
            acceleration = acceleration - K[r, s] * work[p, s]
        work[a, r] = acceleration


def tip_force(
    p: int, v: int, a: int, N_m: int, sin_psi: float, cos_psi: float, h_plane: float, foreshortening: bool,
    modes: "float[:,:]", G: "float[:,:]", c: "float[:]", work: "float[:,:]",
) -> tuple[float, float]:
    """Add the tip force to eta'' in row a; row a + 6 = forces and powers at eta, eta_dot in rows p, v.

    Returns Delta (a bound from above while out of reach) and the rate lambda [1/s] that limits the micro-step.
    """
    x_a = c[0]
    M = c[2]
    omega_b = c[6]
    delta_dot = c[7]
    v_rov = c[8]
    k_c = c[9]
    F_n = 0.0
    F_f = 0.0
    moment = 0.0
    P_friction = 0.0
    P_contact = 0.0
    P_damping = 0.0
    rate = c[5]
    y = 0.0
    y_dot = 0.0
    for r in range(N_m):
        y = y + modes[1, r] * work[p, r]  # Eq. 2 at x = L
        y_dot = y_dot + modes[1, r] * work[v, r]
        P_damping = P_damping + M * modes[0, r] * work[v, r] * work[v, r]
        work[9, r] = 0.0
    x_t = c[1] + y
    Delta = x_a * cos_psi + x_t * sin_psi - h_plane
    if Delta > 0.0 or cos_psi < 0.0:  # else foreshortening only takes the tip farther away
        shortening = 0.0
        shortening_dot = 0.0
        mobility = 0.0
        for r in range(N_m):
            g = 0.0
            if foreshortening:
                for s in range(N_m):
                    g = g + G[r, s] * work[p, s]
            shortening = shortening + 0.5 * g * work[p, r]
            shortening_dot = shortening_dot + g * work[v, r]
            work[9, r] = g
            mobility = mobility + (modes[1, r] * modes[1, r] + g * g) / M
        x = (x_a - shortening) * sin_psi - x_t * cos_psi
        z = (x_a - shortening) * cos_psi + x_t * sin_psi
        Delta = z - h_plane  # Eq. 8
        if Delta > 0.0:
            Delta_dot = delta_dot - omega_b * x - shortening_dot * cos_psi + y_dot * sin_psi
            v_s = omega_b * z - v_rov - shortening_dot * sin_psi - y_dot * cos_psi  # Eq. 10
            F_n, F_e, damping = normal_force(Delta, Delta_dot, k_c, c[10], c[11])  # Eq. 7
            mu, slope = friction_coefficient(v_s, c[12], c[13], c[14], c[15], c[16])
            F_f = mu * F_n  # Eq. 9
            F_a = -F_f * sin_psi - F_n * cos_psi  # Eq. 6
            F_t = F_f * cos_psi - F_n * sin_psi  # Eq. 6
            for r in range(N_m):
                work[a, r] = work[a, r] + (F_t * modes[1, r] - F_a * work[9, r]) / M  # Eq. 5, by virtual work
            moment = x * F_n - z * F_f
            P_friction = F_f * v_s
            P_contact = (F_n - F_e) * Delta_dot
            rise = 1.5 * k_c * sqrt(Delta) * (1.0 + abs(mu))
            fall = slope * F_n + damping * (1.0 + abs(mu))
            rate = sqrt(rate * rate + rise * mobility) + fall * mobility
    work[a + 6, 0] = F_f
    work[a + 6, 1] = F_n
    work[a + 6, 2] = moment
    work[a + 6, 3] = P_friction
    work[a + 6, 4] = P_contact
    work[a + 6, 5] = P_damping
    return Delta, rate
