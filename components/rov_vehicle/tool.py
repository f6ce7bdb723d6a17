"""The tool on the vehicle: its wrench (Eq. 21) and its place and motion against the hull."""

from math import atan2, sqrt

from ..library.rotation import turned, turned_back
from ..library.vectors import cross_add
from .parameters import Parameters
from .records import Inputs, Motion, Scratch, State, ToolMotion


def tool_wrench(u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """The tool's force and moment, given in the tool frame, as a wrench about the body origin (Eq. 21)."""
    if p.wrench_along_normal:
        hull_directions(p, x, s)
        for i in range(3):
            s.F_disturb[i] = s.along[i] * u.F_x + s.across[i] * u.F_y + s.normal[i] * u.F_z  # Eq. V7
    else:
        for i in range(3):
            s.F_disturb[i] = x.R_tool[i, 0] * u.F_x + x.R_tool[i, 1] * u.F_y + x.R_tool[i, 2] * u.F_z  # Eq. 21
    for i in range(3):
        s.M_disturb[i] = x.R_tool[i, 0] * u.M_x + x.R_tool[i, 1] * u.M_y + x.R_tool[i, 2] * u.M_z  # Eq. 21
    cross_add(
        s.M_disturb, p.r_tool[0], p.r_tool[1], p.r_tool[2], s.F_disturb[0], s.F_disturb[1], s.F_disturb[2])


def hull_directions(p: Parameters, x: State, s: Scratch) -> None:
    """The normal into the hull, x_t along the hull and the direction across, in the body frame that s.R turns."""
    facing = 0.0
    for i in range(3):
        s.normal[i] = -turned_back(s.R, i, p.hull_normal)
        facing += s.normal[i] * x.R_tool[i, 0]
        s.across[i] = 0.0
    square = 0.0
    for i in range(3):
        s.along[i] = x.R_tool[i, 0] - facing * s.normal[i]
        square += s.along[i] * s.along[i]
    if square > 0.0:  # else x_t stands on the hull: no direction along it is meant
        length = sqrt(square)
        for i in range(3):
            s.along[i] = s.along[i] / length
    cross_add(s.across, s.normal[0], s.normal[1], s.normal[2], s.along[0], s.along[1], s.along[2])


def tool_motion(z: Motion, p: Parameters, x: State, s: Scratch) -> ToolMotion:
    """Penetration, its rate, hull speed along x_t, and how the tool stands against the normal into the hull."""
    hull_directions(p, x, s)
    for i in range(3):
        s.arm[i] = turned(s.R, i, p.r_tool)
        s.z_t[i] = s.R[i, 0] * x.R_tool[0, 2] + s.R[i, 1] * x.R_tool[1, 2] + s.R[i, 2] * x.R_tool[2, 2]
        s.v_tool[i] = z.v[i]
        s.tilt[i] = 0.0
        if not p.wrench_along_normal:
            s.along[i] = x.R_tool[i, 0]
    cross_add(s.v_tool, z.omega[0], z.omega[1], z.omega[2], p.r_tool[0], p.r_tool[1], p.r_tool[2])
    delta = p.R_brush
    delta_dot = 0.0
    v_rov = 0.0
    facing = 0.0
    for i in range(3):
        v_world = turned(s.R, i, s.v_tool)
        delta = delta - p.hull_normal[i] * (z.position[i] + s.arm[i] - p.hull_point[i])
        delta_dot = delta_dot - p.hull_normal[i] * v_world
        v_rov = v_rov - s.along[i] * s.v_tool[i]
        facing = facing - p.hull_normal[i] * s.z_t[i]
    # atan2 of sine and cosine is exact near zero, where acos is not.
    cross_add(s.tilt, s.z_t[0], s.z_t[1], s.z_t[2], p.hull_normal[0], p.hull_normal[1], p.hull_normal[2])
    sine = sqrt(s.tilt[0] * s.tilt[0] + s.tilt[1] * s.tilt[1] + s.tilt[2] * s.tilt[2])
    n_x = turned_back(x.R_tool, 0, s.normal)
    n_y = turned_back(x.R_tool, 1, s.normal)
    n_z = turned_back(x.R_tool, 2, s.normal)
    return ToolMotion(
        delta, delta_dot, v_rov, misalignment=atan2(sine, facing),
        tilt_x=atan2(n_y, n_z), tilt_y=atan2(-n_x, n_z))  # Eq. V8
