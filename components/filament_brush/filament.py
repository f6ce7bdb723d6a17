"""The right-hand side of one filament: `free_acceleration` (Eq. 4), then `tip_force` of the hull (Eqs. 5-10).

Both read what `constants` filled in.
"""

from math import cos, pi, sin, sqrt

from ..declare.record import Matrix
from .contact import friction_coefficient, growth_of_contact, normal_force
from .modes import stiffness
from .parameters import Parameters
from .records import Constants, Friction, Inputs, Modes, Normal, Placement, Reach, Stage, Stiffness


def hub_radius(p: Parameters) -> float:
    """R_h for which the undeformed tip lies on R_brush."""
    return sqrt(p.R_brush * p.R_brush - p.L * p.L * sin(p.alpha) * sin(p.alpha)) - p.L * cos(p.alpha)


def constants(L: float, c: Constants, k: Stiffness, u: Inputs, p: Parameters, m: Modes, S: Matrix) -> None:
    """Fill c and k, what is constant over a step, for rods of the length L with the modes m."""
    R_h = hub_radius(p)
    c.L = L
    c.R_tip = p.R_brush + max(0.0, L - p.L)
    c.share = 1.0 / (p.n_strips * p.n_groups)
    c.R_h = R_h
    c.sin_alpha = sin(p.alpha)
    c.cos_alpha = cos(p.alpha)
    c.x_a = R_h * c.cos_alpha + L
    c.x_t = -R_h * c.sin_alpha
    c.chi = p.rho / (p.rho + p.C_a * p.rho_w)
    c.M = p.bristles_per_filament * p.rho * 0.25 * pi * p.d * p.d / c.chi * L
    c.per_M = 1.0 / c.M
    c.speed_2 = 0.0
    if p.centrifugal:
        c.speed_2 = u.omega_b * u.omega_b
    c.omega_max = stiffness(-c.x_t, k, p, c, m, S)
    c.mu_s = u.friction_scale * p.mu_s
    c.mu_c = u.friction_scale * p.mu_c
    c.fouling = u.friction_scale
    c.drag = p.bristles_per_filament * p.shielding * 0.5 * p.rho_w * p.C_d * p.d
    c.slip = 1.0 - p.co_rotation


def modal_mass(c: Constants) -> float:
    """Modal mass of a bundle."""
    return c.M


def share_of(c: Constants) -> float:
    """Share of a filament that a rod is."""
    return c.share


def tip_radius(c: Constants) -> float:
    """Bound on the radius of the tips."""
    return c.R_tip


def free_acceleration(f: Stage, p: Parameters, m: Modes, k: Stiffness) -> None:
    """The accelerations without tip force (Eq. 4)."""
    for r in range(p.N_m):
        acceleration = k.load[r] - m.damping[r] * f.eta_dot[r]  # Eq. 4
        for s in range(p.N_m):
            acceleration = acceleration - k.K[r, s] * f.eta[s]
        f.a[r] = acceleration


def rate_limit(rate: float, mobility: float, Delta: float, normal: Normal, friction: Friction, p: Parameters) -> float:
    """What limits the micro-step of a tip in contact: the modes' rate with contact and friction on top."""
    rise = 1.5 * p.k_c * sqrt(Delta) * (1.0 + abs(friction.mu)) + friction.spring * normal.F_n
    fall = friction.slope * normal.F_n + normal.damping * (1.0 + abs(friction.mu))
    return sqrt(rate * rate + rise * mobility) + fall * mobility + friction.forgets


def tip_force(
    limited: bool, f: Stage, at: Placement, u: Inputs, p: Parameters, c: Constants, m: Modes, G: Matrix,
) -> Reach:
    """Add the tip force to the accelerations; fills in forces and powers. `limited`: is the rate asked for?"""
    f.F_n = 0.0
    f.F_f = 0.0
    f.moment = 0.0
    f.P_friction = 0.0
    P_damping = 0.0
    f.P_contact = 0.0
    f.z_dot = 0.0
    f.v_slip = 0.0
    rate = c.omega_max
    y = 0.0
    y_dot = 0.0
    for r in range(p.N_m):
        y = y + m.Y_L[r] * f.eta[r]  # Eq. 2 at x = L
        y_dot = y_dot + m.Y_L[r] * f.eta_dot[r]
        P_damping = P_damping + c.M * m.damping[r] * f.eta_dot[r] * f.eta_dot[r]
        f.g[r] = 0.0
    x_t = c.x_t + y
    Delta = c.x_a * at.cos_psi + x_t * at.sin_psi - at.h_plane
    if Delta > 0.0 or at.cos_psi < 0.0:  # else foreshortening only takes the tip farther away
        shortening = 0.0
        shortening_dot = 0.0
        square = 0.0
        for r in range(p.N_m):
            g = 0.0
            if p.foreshortening:
                for s in range(p.N_m):
                    g = g + G[r, s] * f.eta[s]
            shortening = shortening + 0.5 * g * f.eta[r]
            shortening_dot = shortening_dot + g * f.eta_dot[r]
            f.g[r] = g
            square = square + (m.Y_L[r] * m.Y_L[r] + g * g)
        x = (c.x_a - shortening) * at.sin_psi - x_t * at.cos_psi
        z = (c.x_a - shortening) * at.cos_psi + x_t * at.sin_psi
        Delta = z - at.h_plane  # Eq. 8
        if Delta > 0.0:
            Delta_dot = u.delta_dot - u.omega_b * x - shortening_dot * at.cos_psi + y_dot * at.sin_psi
            v_s = u.omega_b * z - u.v_rov - shortening_dot * at.sin_psi - y_dot * at.cos_psi  # Eq. 10
            normal = normal_force(Delta, Delta_dot, p)  # Eq. 7
            friction = friction_coefficient(v_s, f.z, growth_of_contact(Delta, Delta_dot), p, c)
            f.F_n = normal.F_n
            f.F_f = friction.mu * normal.F_n  # Eq. 9
            if limited:
                rate = rate_limit(rate, square * c.per_M, Delta, normal, friction, p)
            F_a = -f.F_f * at.sin_psi - f.F_n * at.cos_psi  # Eq. 6
            F_t = f.F_f * at.cos_psi - f.F_n * at.sin_psi  # Eq. 6
            for r in range(p.N_m):
                f.a[r] = f.a[r] + (F_t * m.Y_L[r] - F_a * f.g[r]) * c.per_M  # Eq. 5, by virtual work
            f.moment = x * f.F_n - z * f.F_f
            f.P_friction = f.F_f * v_s
            f.P_contact = (normal.F_n - normal.F_e) * Delta_dot
            f.z_dot = friction.z_dot
            f.v_slip = abs(v_s)
            f.x = x
    f.P_damping = P_damping
    return Reach(Delta, rate)
