"""Reactions at the filaments' bases (Eqs. 11-13) and their sums over the brush (Eqs. 14, 15)."""

from math import cos, floor, pi, sin

from .contact import contact_energy
from .micro_steps import evaluate
from .modes import deflection
from .parameters import Parameters
from .records import Base, Constants, Inputs, Load, Modes, Outputs, Placement, Scratch, Stage, State
from .water import add_water, take_drag


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
        mass = c.M / p.L
        q = c.M * c.chi * c.speed_2 / p.L
        r_A = c.x_a - p.L
        offset = -c.x_t
        shear = -load.F_t + q * p.L * offset
        moment = load.F_t * (p.L - load.shortening) - q * 0.5 * p.L * p.L * offset
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
            y = y + load.F_t * p.L * p.L * p.L / (3.0 * EI)
            for r in range(p.N_m):
                y = y - load.F_t * m.Y_L[r] * m.Y_L[r] / (mass * p.L * m.omega_r[r] * m.omega_r[r])
    return Base(shear, moment, y)


def clear_sums(y: Outputs) -> None:
    """Nothing yet."""
    y.F_x = 0.0
    y.F_z = 0.0
    y.T_brush = 0.0
    y.contact_count = 0.0
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
    for r in range(6):
        y.kinetic_fraction[r] = 0.0


def add_tip(f: Stage, y: Outputs) -> None:
    """Add the forces and powers at a tip (Eq. 14)."""
    y.F_x = y.F_x - f.F_f  # Eq. 14
    y.F_z = y.F_z - f.F_n  # Eq. 14
    y.T_brush = y.T_brush + f.moment
    y.P_friction = y.P_friction + f.P_friction
    y.P_contact = y.P_contact + f.P_contact
    y.P_damping = y.P_damping + f.P_damping
    if f.F_n > 0.0:
        y.contact_count = y.contact_count + 1.0


def add_energies(f: Stage, p: Parameters, c: Constants, m: Modes, y: Outputs) -> float:
    """Add the energies of a filament, kinetic_fraction being that of each mode; returns the foreshortening."""
    shortening = 0.0
    for r in range(p.N_m):
        kinetic = 0.5 * c.M * f.eta_dot[r] * f.eta_dot[r]
        y.kinetic_fraction[r] = y.kinetic_fraction[r] + kinetic
        y.E_kinetic = y.E_kinetic + kinetic
        y.E_strain = y.E_strain + 0.5 * c.M * m.omega_r[r] * m.omega_r[r] * f.eta[r] * f.eta[r]
        shortening = shortening + 0.5 * f.g[r] * f.eta[r]
    return shortening


def add_base(
    f: Stage, at: Placement, shortening: float, p: Parameters, c: Constants, m: Modes, y: Outputs,
) -> float:
    """Add the reactions at a filament's base (Eqs. 11-13, 15); returns the tip deflection."""
    slope = 0.0
    for r in range(p.N_m):
        slope = slope + m.slope_L[r] * f.eta[r]
    load = Load(
        F_a=-f.F_f * at.sin_psi - f.F_n * at.cos_psi,
        F_t=f.F_f * at.cos_psi - f.F_n * at.sin_psi,
        shortening=shortening,
    )
    base = base_reactions(f, load, p, c, m)
    y.F_y_eq11 = y.F_y_eq11 + base.shear
    y.M_b_eq12 = y.M_b_eq12 + base.moment
    y.F_z_eq13 = y.F_z_eq13 + f.F_n * slope - f.F_f  # Eq. 13
    # Eq. 15: cos(phi) = cos(psi + alpha)
    cos_phi = at.cos_psi * cos(p.alpha) - at.sin_psi * sin(p.alpha)
    y.T_brush_eq15 = y.T_brush_eq15 + p.R_brush * base.shear * cos_phi  # Eq. 15
    return base.y


def tell(i: int, phi: float, y_tip: float, f: Stage, s: Scratch) -> None:
    """What filament i does, for those who look at single ones."""
    s.filament_phi[i] = phi - 2.0 * pi * floor((phi + pi) / (2.0 * pi))
    s.filament_F_n[i] = f.F_n
    s.filament_F_f[i] = f.F_f
    s.filament_y[i] = y_tip


def brush_sums(delta: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Forces, torques, powers and energies of the whole brush; fills the table `filament`."""
    clear_sums(y)
    for i in range(p.n):
        phi = x.theta_b + 2.0 * pi * i / p.n
        psi = phi - p.alpha
        at = Placement(sin(psi), cos(psi), h_plane=p.R_brush - delta)
        take(i, s.now, p, x)
        take_drag(x.linear[i], s.c)
        reach = evaluate(s.now, at, u, p, s.c, x.modes, s.k, x.G)
        add_tip(s.now, y)
        if p.C_d > 0.0:
            add_water(s.now, at, p, s.c, y)
        y.E_contact = y.E_contact + contact_energy(reach.Delta, p)
        shortening = add_energies(s.now, p, s.c, x.modes, y)
        y_tip = add_base(s.now, at, shortening, p, s.c, x.modes, y)
        tell(i, phi, y_tip, s.now, s)


def take(i: int, f: Stage, p: Parameters, x: State) -> None:
    """Filament i from the state."""
    for r in range(p.N_m):
        f.eta[r] = x.eta[i, r]
        f.eta_dot[r] = x.eta_dot[i, r]
    f.z = x.z[i]


def give(i: int, f: Stage, p: Parameters, x: State) -> None:
    """Filament i back into the state."""
    for r in range(p.N_m):
        x.eta[i, r] = f.eta[r]
        x.eta_dot[i, r] = f.eta_dot[r]
    x.z[i] = f.z
