"""A rigid frame that carries up to three tools: their wrenches summed at its point, its motion at each of them."""

from math import sqrt, tan

from .parameters import Parameters
from .records import Inputs, Normal, Outputs


def normal_into_hull(tilt_x: float, tilt_y: float) -> Normal:
    """The unit normal of which tilt_x = atan2(n_y, n_z) and tilt_y = atan2(-n_x, n_z)."""
    a = tan(tilt_x)
    b = tan(tilt_y)
    n_z = 1.0 / sqrt(1.0 + a * a + b * b)
    return Normal(-n_z * b, n_z * a, n_z)


def wrench(u: Inputs, p: Parameters, y: Outputs) -> None:
    """Forces add up, moments with their levers (x, y, 0) from the frame's point."""
    F_x = 0.0
    F_y = 0.0
    F_z = 0.0
    M_x = 0.0
    M_y = 0.0
    M_z = 0.0
    H_y = 0.0
    H_z = 0.0
    for i in range(3):
        F_x = F_x + u.F_x_tool[i]
        F_y = F_y + u.F_y_tool[i]
        F_z = F_z + u.F_z_tool[i]
        M_x = M_x + u.M_x_tool[i] + p.y_tool[i] * u.F_z_tool[i]
        M_y = M_y + u.M_y_tool[i] - p.x_tool[i] * u.F_z_tool[i]
        M_z = M_z + u.M_z_tool[i] + p.x_tool[i] * u.F_y_tool[i] - p.y_tool[i] * u.F_x_tool[i]
        H_y = H_y + u.H_y_tool[i]
        H_z = H_z + u.H_z_tool[i]
    y.F_x = F_x  # Eq. T1
    y.F_y = F_y  # Eq. T1
    y.F_z = F_z  # Eq. T1
    y.M_x = M_x  # Eq. T2
    y.M_y = M_y  # Eq. T2
    y.M_z = M_z  # Eq. T2
    y.H_y = H_y
    y.H_z = H_z


def motion(u: Inputs, p: Parameters, y: Outputs) -> None:
    """Each tool is (x, y, 0) from the frame's point and moves with it; a hull that is curved falls off with y^2."""
    n = normal_into_hull(u.tilt_x, u.tilt_y)
    for i in range(3):
        fall = 0.5 * p.hull_curvature * p.y_tool[i] * p.y_tool[i]
        y.delta_tool[i] = u.delta + n.x * p.x_tool[i] + n.y * p.y_tool[i] - fall  # Eq. T3
        turning = n.z * (u.p * p.y_tool[i] - u.q * p.x_tool[i]) + u.r * (n.y * p.x_tool[i] - n.x * p.y_tool[i])
        y.delta_dot_tool[i] = u.delta_dot + turning  # Eq. T4
        y.v_rov_tool[i] = u.v_rov + u.r * p.y_tool[i]  # Eq. T5
    y.misalignment = -u.tilt_y


def outputs(u: Inputs, p: Parameters, y: Outputs) -> None:
    """All of it at once: the frame has no mass of its own (it is the vehicle's)."""
    wrench(u, p, y)
    motion(u, p, y)


def step(u: Inputs, p: Parameters, y: Outputs) -> None:
    """Nothing to advance."""
    outputs(u, p, y)
