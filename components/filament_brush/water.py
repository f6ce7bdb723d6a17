"""What the water does: drag along the bristles (Morison), its linear form off the hull, and the torque of the pack."""

from math import pi

from ..declare.record import Matrix
from ..library.quadrature import gauss_points
from ..library.rotating import cylinder_friction
from .filament import hub_radius
from .modes import mode_shape
from .parameters import Parameters
from .records import Constants, Inputs, Modes, Outputs, Placement, Scratch, Stage, State


def drag_points(p: Parameters, m: Modes, Y: Matrix, s: Scratch) -> None:
    """Where drag is evaluated along a bristle: six points, which is exact for polynomials up to the eleventh power."""
    gauss_points(6, s.slopes, s.shares)
    for i in range(6):
        xi = 0.5 + 0.5 * s.slopes[i]
        m.x[i] = xi * p.L
        m.weight[i] = 0.5 * s.shares[i] * p.L
        for r in range(6):
            Y[i, r] = mode_shape(m.lambda_r[r], xi)


def add_drag(
    linear: float, f: Stage, at: Placement, u: Inputs, p: Parameters, c: Constants, m: Modes, shapes: Matrix,
) -> float:
    """Add the drag of the water to the accelerations, fill in its forces; returns a bound on its rate of damping.

    Each point of a bristle moves past water at rest with omega_b r, v_rov and delta_dot, all seen along e_t, and past
    the water around it with a share of that, and its own rate. linear > 0: the square of that speed about omega_b r.
    """
    F_w = 0.0
    M_w = 0.0
    P_water = 0.0
    fastest = 0.0
    passing = u.v_rov * at.cos_psi + u.delta_dot * at.sin_psi
    for i in range(6):
        y_dot = 0.0
        for r in range(p.N_m):
            y_dot = y_dot + shapes[i, r] * f.eta_dot[r]
        sweep = u.omega_b * (c.x_a - c.L + m.x[i])
        v_n = c.slip * (passing - sweep) + y_dot
        speed = abs(v_n)
        square = speed * v_n
        if linear > 0.0:
            speed = c.slip * abs(sweep)
            square = speed * (2.0 * v_n + c.slip * sweep)
        F_i = -c.drag * m.weight[i] * square  # Morison et al. 1950
        F_w = F_w + F_i
        M_w = M_w + F_i * m.x[i]
        P_water = P_water - F_i * (passing - sweep + y_dot)
        if speed > fastest:
            fastest = speed
        for r in range(p.N_m):
            f.a[r] = f.a[r] + F_i * shapes[i, r] / c.M
    f.F_w = F_w
    f.M_w = M_w
    f.P_water = P_water
    return 2.0 * c.drag * fastest * c.L / c.M


def torque_of_drag(F_w: float, M_w: float, c: Constants) -> float:
    """Torque about the brush axis of a drag with its moment about the root."""
    return -(c.x_a - c.L) * F_w - M_w


def pushed_by_water(h: float, f: Stage, p: Parameters, c: Constants) -> float:
    """Bound on what the drag of a bristle that starts with it moves the tip in h: all modes in phase."""
    return 2.0 * p.N_m * h * h * abs(f.F_w) / c.M


def has_pack_torque(p: Parameters) -> bool:
    """Does the pack as a whole feel the water?"""
    return p.pack_drag > 0.0 or p.C_paddle > 0.0


def pack_torque(u: Inputs, p: Parameters, c: Constants) -> float:
    """Torque on the whole pack: as a rough cylinder in water at rest, and of its bundles as paddles."""
    sense = 1.0
    if u.omega_b < 0.0:
        sense = -1.0
    speed = abs(u.omega_b)
    R = p.R_brush
    torque = 0.0
    if p.pack_drag > 0.0:
        C = cylinder_friction(speed * R * R / p.nu_w, p.pack_roughness / R)
        torque = p.pack_drag * C * pi * p.rho_w * speed * speed * R * R * R * R * p.width
    if p.C_paddle > 0.0:
        R_h = hub_radius(p)
        slip = c.slip * speed
        torque = torque + (
            p.n * p.C_paddle * 0.125 * p.rho_w * p.width * slip * slip * (R * R * R * R - R_h * R_h * R_h * R_h))
    return -sense * torque


def add_water(w: float, f: Stage, at: Placement, c: Constants, y: Outputs) -> None:
    """Add the drag of a rod at y_t = w to the forces of the brush."""
    F_x = -c.share * (at.cos_psi * f.F_w)
    F_z = c.share * (at.sin_psi * f.F_w)
    y.F_x = y.F_x + F_x
    y.F_z = y.F_z + F_z
    y.M_x = y.M_x + w * F_z
    y.M_z = y.M_z - w * F_x
    y.T_water = y.T_water + c.share * torque_of_drag(f.F_w, f.M_w, c)
    y.P_water = y.P_water + c.share * f.P_water


def book_drag(F_w: float, M_w: float, at: Placement, c: Constants, x: State) -> None:
    """Impulses of a drag impulse and its moment, of a rod's share."""
    x.J_x = x.J_x - c.share * (at.cos_psi * F_w)
    x.J_z = x.J_z + c.share * (at.sin_psi * F_w)
    x.J_T = x.J_T + c.share * torque_of_drag(F_w, M_w, c)
