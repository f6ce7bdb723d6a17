"""The tufts of a brush added up: forces and powers at an instant (Eqs. 14, 15), impulses and losses of a micro-step."""

from math import cos, pi, sin

from ..library.integration import runge_kutta_sum
from ..library.rotating import cylinder_friction, disc_friction
from .parameters import Parameters
from .records import Inputs, Outputs, State, Tip


def clear_sums(y: Outputs) -> None:
    """Nothing yet."""
    y.F_x = 0.0
    y.F_y = 0.0
    y.F_z = 0.0
    y.T_brush = 0.0
    y.M_x = 0.0
    y.M_y = 0.0
    y.F_y_sum = 0.0
    y.contact_count = 0.0
    y.F_y_eq11 = 0.0
    y.M_b_eq12 = 0.0
    y.F_z_eq13 = 0.0
    y.P_friction = 0.0
    y.P_contact = 0.0
    y.E_strain = 0.0


def torque(tip: Tip) -> float:
    """The torque of a tip about z_t."""
    return tip.x * tip.F_y - tip.y * tip.F_x


def add_tip(tip: Tip, u: Inputs, y: Outputs) -> None:
    """Add a tuft (Eq. 14)."""
    sense = 1.0
    if u.omega_b < 0.0:
        sense = -1.0
    y.F_x = y.F_x + tip.F_x  # Eq. 14
    y.F_y = y.F_y + tip.F_y  # Eq. 14
    y.F_z = y.F_z + tip.F_z  # Eq. 14
    y.T_brush = y.T_brush + torque(tip)
    y.M_x = y.M_x + tip.y * tip.F_z - tip.z * tip.F_y
    y.M_y = y.M_y + tip.z * tip.F_x - tip.x * tip.F_z
    y.F_y_sum = y.F_y_sum - sense * tip.F_f
    y.F_y_eq11 = y.F_y_eq11 - sense * tip.shear
    y.M_b_eq12 = y.M_b_eq12 + sense * tip.M_b
    y.F_z_eq13 = y.F_z_eq13 + tip.F_n * tip.slope - tip.F_f  # Eq. 13
    y.P_friction = y.P_friction + tip.P_friction
    y.P_contact = y.P_contact + tip.P_contact
    y.E_strain = y.E_strain + tip.E
    if tip.F_n > 0.0:
        y.contact_count = y.contact_count + 1.0


def slip_of_bending(begin: Tip, middle: Tip, end: Tip, angle: float) -> float:
    """Work of friction on the tip's motion against the brush, which turns by `angle` in the micro-step.

    The integral of f db of the parabolas through the three instants, along the axes of the middle.
    """
    c = cos(0.5 * angle)
    s = sin(0.5 * angle)
    work = path(begin.f_z, middle.f_z, end.f_z, begin.z - middle.z, end.z - middle.z)
    work = work + path(
        c * begin.f_x - s * begin.f_y, middle.f_x, c * end.f_x + s * end.f_y,
        c * begin.x - s * begin.y - middle.x, c * end.x + s * end.y - middle.x)
    return work + path(
        c * begin.f_y + s * begin.f_x, middle.f_y, c * end.f_y - s * end.f_x,
        c * begin.y + s * begin.x - middle.y, c * end.y - s * end.x - middle.y)


def path(f_0: float, f_1: float, f_2: float, b_0: float, b_2: float) -> float:
    """The integral of f db of parabolas through three instants; b is 0 at the second."""
    return (
        f_0 * (-b_0 / 2.0 - b_2 / 6.0) + f_1 * (b_2 - b_0) * 2.0 / 3.0 + f_2 * (b_0 / 6.0 + b_2 / 2.0))


def book(h_s: float, begin: Tip, middle: Tip, end: Tip, u: Inputs, x: State) -> None:
    """Impulses and losses of a tuft in a micro-step, by Simpson's rule."""
    x.J_x = x.J_x + simpson(h_s, begin.F_x, middle.F_x, end.F_x)
    x.J_y = x.J_y + simpson(h_s, begin.F_y, middle.F_y, end.F_y)
    x.J_z = x.J_z + simpson(h_s, begin.F_z, middle.F_z, end.F_z)
    x.J_T = x.J_T + simpson(h_s, torque(begin), torque(middle), torque(end))
    x.W_friction = x.W_friction + simpson(h_s, begin.P_friction, middle.P_friction, end.P_friction)
    x.W_friction = x.W_friction + slip_of_bending(begin, middle, end, u.omega_b * h_s)
    x.W_contact = x.W_contact + simpson(h_s, begin.P_contact, middle.P_contact, end.P_contact)


def simpson(h_s: float, k_1: float, k_2: float, k_3: float) -> float:
    """The integral over a micro-step from the values at its begin, middle and end."""
    return runge_kutta_sum(h_s, k_1, k_2, k_2, k_3)


def adopt(begin: Tip, end: Tip) -> None:
    """The end of a micro-step is the begin of the next."""
    begin.x = end.x
    begin.y = end.y
    begin.z = end.z
    begin.f_x = end.f_x
    begin.f_y = end.f_y
    begin.f_z = end.f_z
    begin.F_x = end.F_x
    begin.F_y = end.F_y
    begin.F_z = end.F_z
    begin.P_friction = end.P_friction
    begin.P_contact = end.P_contact


def pack_torque(u: Inputs, p: Parameters) -> float:
    """Torque of the water on the turning brush: on both sides of a disc and on the cylinder around the bristles."""
    T_water = 0.0
    if p.pack_drag > 0.0:
        speed = abs(u.omega_b)
        R = p.R_brush
        Re = speed * R * R / p.nu_w
        C = disc_friction(Re) * R + 2.0 * pi * p.L * cos(p.alpha) * cylinder_friction(Re, p.pack_roughness / R)
        T_water = -p.pack_drag * C * 0.5 * p.rho_w * speed * u.omega_b * R * R * R * R
    return T_water


def torque_of_eq15(p: Parameters, y: Outputs) -> float:
    """Eq. 15, whose angles are all those of the contact here: R_brush times the sum of base shears."""
    return p.R_brush * y.F_y_eq11  # Eq. 15
