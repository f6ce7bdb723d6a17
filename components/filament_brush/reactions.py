"""Reactions at the filaments' bases (Eqs. 11-13) and their sums over the brush (Eqs. 14, 15)."""

from math import pi

from .modes import deflection
from .parameters import Parameters
from .records import Base, Constants, Load, Modes, Outputs, Placement, Stage, State


def bending_stiffness(p: Parameters) -> float:
    """EI of a bundle."""
    return p.bristles_per_filament * p.E * pi * p.d * p.d * p.d * p.d / 64.0


def base_reactions(f: Stage, load: Load, p: Parameters, c: Constants, m: Modes) -> Base:
    """Base shear (Eq. 11), base moment (Eq. 12) and tip deflection.

    The plain sum is what the paper prints. Mode acceleration sums over modes only what inertia and damping give and
    takes the loads as they are, so that it is exact in statics: (F_a, F_t) at the tip and, along the filament, the
    centrifugal load q (r_A + x, y - offset).
    """
    EI = bending_stiffness(p)
    shear = 0.0
    moment = 0.0
    for r in range(p.N_m):
        shear = shear + EI * m.shear_0[r] * f.eta[r]  # Eq. 11
        moment = moment + EI * m.curvature_0[r] * f.eta[r]  # Eq. 12
    y = deflection(f, p, m)
    if p.mode_acceleration:
        mass = c.M / c.L
        q = c.M * c.chi * c.speed_2 / c.L
        r_A = c.x_a - c.L
        offset = -c.x_t
        shear = -load.F_t + q * c.L * offset
        moment = load.F_t * (c.L - load.shortening) - q * 0.5 * c.L * c.L * offset
        if load.shortening > 0.0:
            moment = moment - load.F_a * y
        for r in range(p.N_m):
            inertia = mass * (f.a[r] + m.damping[r] * f.eta_dot[r])
            shear = shear + (inertia - q * f.eta[r]) * m.int_Y[r]
            moment = moment - inertia * m.int_xY[r] - q * r_A * m.int_Y[r] * f.eta[r]
        if p.C_d > 0.0:
            shear = shear - f.F_w
            moment = moment + f.M_w
        if load.F_t != 0.0:
            y = y + load.F_t * c.L * c.L * c.L / (3.0 * EI)
            for r in range(p.N_m):
                y = y - load.F_t * m.Y_L[r] * m.Y_L[r] / (mass * c.L * m.omega_r[r] * m.omega_r[r])
    return Base(shear, moment, y)


def clear_sums(y: Outputs) -> None:
    """Nothing yet."""
    y.F_x = 0.0
    y.F_z = 0.0
    y.T_brush = 0.0
    y.M_x = 0.0
    y.M_z = 0.0
    y.contact_count = 0.0
    y.contact_length = 0.0
    y.v_sliding = 0.0
    y.F_y_eq11 = 0.0
    y.M_b_eq12 = 0.0
    y.F_z_eq13 = 0.0
    y.T_brush_eq15 = 0.0
    y.P_damping = 0.0
    y.P_friction = 0.0
    y.P_contact = 0.0
    y.T_water = 0.0
    y.P_water = 0.0
    y.E_kinetic = 0.0
    y.E_strain = 0.0
    y.E_contact = 0.0
    y.J_filaments = 0.0
    for r in range(6):
        y.kinetic_fraction[r] = 0.0


def add_tip(w: float, f: Stage, c: Constants, y: Outputs) -> None:
    """Add the forces and powers at a tip at y_t = w (Eq. 14)."""
    F_f = c.share * f.F_f
    F_n = c.share * f.F_n
    y.F_x = y.F_x - F_f  # Eq. 14
    y.F_z = y.F_z - F_n  # Eq. 14
    y.T_brush = y.T_brush + c.share * f.moment
    y.M_x = y.M_x - w * F_n
    y.M_z = y.M_z + w * F_f
    y.P_friction = y.P_friction + c.share * f.P_friction
    y.P_contact = y.P_contact + c.share * f.P_contact
    y.P_damping = y.P_damping + c.share * f.P_damping
    if f.F_n > 0.0:
        y.contact_count = y.contact_count + c.share
        y.v_sliding = y.v_sliding + c.share * f.v_slip


def add_energies(f: Stage, p: Parameters, c: Constants, m: Modes, y: Outputs) -> float:
    """Add the energies of a rod, kinetic_fraction being that of each mode; returns the foreshortening."""
    shortening = 0.0
    for r in range(p.N_m):
        kinetic = c.share * (0.5 * c.M * f.eta_dot[r] * f.eta_dot[r])
        y.kinetic_fraction[r] = y.kinetic_fraction[r] + kinetic
        y.E_kinetic = y.E_kinetic + kinetic
        y.E_strain = y.E_strain + c.share * (0.5 * c.M * m.omega_r[r] * m.omega_r[r] * f.eta[r] * f.eta[r])
        shortening = shortening + 0.5 * f.g[r] * f.eta[r]
    return shortening


def add_base(
    f: Stage, at: Placement, shortening: float, p: Parameters, c: Constants, m: Modes, y: Outputs,
) -> float:
    """Add the reactions at a rod's base (Eqs. 11-13, 15); returns the tip deflection."""
    slope = 0.0
    for r in range(p.N_m):
        slope = slope + m.slope_L[r] * f.eta[r]
    load = Load(
        F_a=-f.F_f * at.sin_psi - f.F_n * at.cos_psi,
        F_t=f.F_f * at.cos_psi - f.F_n * at.sin_psi,
        shortening=shortening,
    )
    base = base_reactions(f, load, p, c, m)
    y.F_y_eq11 = y.F_y_eq11 + c.share * base.shear
    y.M_b_eq12 = y.M_b_eq12 + c.share * base.moment
    y.F_z_eq13 = y.F_z_eq13 + c.share * f.F_n * slope - c.share * f.F_f  # Eq. 13
    # Eq. 15: cos(phi) = cos(psi + alpha)
    cos_phi = at.cos_psi * c.cos_alpha - at.sin_psi * c.sin_alpha
    y.T_brush_eq15 = y.T_brush_eq15 + p.R_brush * (c.share * base.shear) * cos_phi  # Eq. 15
    return base.y


def filament_inertia(c: Constants, p: Parameters) -> float:
    """Moment of inertia of the filaments about the brush axis, of a group's share."""
    return p.n * c.M * c.chi * (c.R_h * c.R_h + c.R_h * c.cos_alpha * c.L + c.L * c.L / 3.0) / p.n_groups


def take(i: int, f: Stage, p: Parameters, x: State) -> None:
    """Rod i from the state."""
    for r in range(p.N_m):
        f.eta[r] = x.eta[i, r]
        f.eta_dot[r] = x.eta_dot[i, r]
    f.z = x.z[i]


def give(i: int, f: Stage, p: Parameters, x: State) -> None:
    """Rod i back into the state."""
    for r in range(p.N_m):
        x.eta[i, r] = f.eta[r]
        x.eta_dot[i, r] = f.eta_dot[r]
    x.z[i] = f.z
