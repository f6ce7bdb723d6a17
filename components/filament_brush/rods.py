"""A filament as a bundle of rods: bristles of one free length (a group) in one part of the width (a strip).

Each rod goes its own way as if it were the whole filament; what it does counts by its share.
"""

from math import sin

from .filament import constants
from .parameters import Parameters
from .records import Inputs, Modes, Scratch, State


def length_ratio(g: int, p: Parameters) -> float:
    """Length of group g over L: the middles of n_groups equal parts of the range."""
    return 1.0 + p.length_spread * ((2.0 * g + 1.0) / p.n_groups - 1.0)


def place(j: int, p: Parameters) -> float:
    """y_t of the middle of strip j."""
    return p.width * ((j + 0.5) / p.n_strips - 0.5)


def at_strip(w: float, delta: float, u: Inputs, p: Parameters) -> Inputs:
    """What the strip at y_t = w is given where the middle is pressed in by delta."""
    depth = delta
    if w != 0.0:
        depth = delta + w * sin(u.tilt_x) - 0.5 * p.hull_curvature * w * w
    return Inputs(
        u.omega_b, delta=depth, delta_dot=u.delta_dot, v_rov=u.v_rov, friction_scale=u.friction_scale, tilt_x=u.tilt_x
    )


def take_group(g: int, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Modes and constants of group g: those of the length L, scaled, since all cantilevers are similar."""
    ratio = length_ratio(g, p)
    scale(ratio, x.nominal, p, s.modes)
    for r in range(p.N_m):
        for q in range(p.N_m):
            s.G[r, q] = x.G_nominal[r, q] / ratio
            s.S[r, q] = x.S_nominal[r, q] + (1.0 / ratio - 1.0) * x.S_root[r, q]
    constants(ratio * p.L, s.c, s.k, u, p, s.modes, s.S)
    if p.C_d > 0.0:
        for i in range(6):
            for r in range(p.N_m):
                s.shapes[i, r] = x.Y[i, r]


def scale(ratio: float, nominal: Modes, p: Parameters, m: Modes) -> None:
    """The numbers of the modes of a cantilever that is longer by this ratio."""
    for r in range(p.N_m):
        m.lambda_r[r] = nominal.lambda_r[r]
        m.omega_r[r] = nominal.omega_r[r] / (ratio * ratio)
        m.damping[r] = nominal.damping[r] / (ratio * ratio)
        m.Y_L[r] = nominal.Y_L[r]
        m.slope_L[r] = nominal.slope_L[r] / ratio
        m.int_Y[r] = nominal.int_Y[r] * ratio
        m.int_xY[r] = nominal.int_xY[r] * ratio * ratio
        m.curvature_0[r] = nominal.curvature_0[r] / (ratio * ratio)
        m.shear_0[r] = nominal.shear_0[r] / (ratio * ratio * ratio)
    if p.C_d > 0.0:
        for i in range(6):
            m.x[i] = nominal.x[i] * ratio
            m.weight[i] = nominal.weight[i] * ratio
