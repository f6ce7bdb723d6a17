"""Cup brush: bristles as elasticas that trail behind their roots on circles, their friction, and their sum.

Frames and symbols are those of README.md, names and units those of records.py.
"""

from math import cos, pi, sin, sqrt

from ..library.integration import equal_steps
from .elastica import sideways, tabulate
from .parameters import Parameters
from .records import Inputs, Outputs, Scratch, State, Tip
from .sums import add_tip, adopt, book, clear_sums, pack_torque, torque_of_eq15
from .tuft import hull_at, place, press


def setup(p: Parameters, x: State, s: Scratch) -> None:
    """The tables of the elastica, and where the rows stand."""
    tabulate(x, s)
    for k in range(8):
        x.root[k] = root_radius(p.R_brush * p.row_radius[k], p, x)


def root_radius(r: float, p: Parameters, x: State) -> float:
    """Radius of the roots whose tips slide on r when delta_0 is pressed in: a tip trails at a right angle to r."""
    trail = 0.0
    if p.delta_0 > 0.0:
        D = p.delta_0 / p.L
        lean = sin(p.alpha)
        H = sideways(sqrt(D), p.alpha + 0.4, x.H)  # hardly depends on the angle
        half = 0.5 * H * lean
        q = D / (half + sqrt(half * half + cos(p.alpha) * D))
        trail = p.L * ((1.0 - q * q) * lean + H * q * cos(p.alpha))
    return sqrt(r * r + trail * trail)


def tufts_in(k: int, p: Parameters) -> int:
    """Tufts of a row."""
    return int(p.row_tufts[k] + 0.5)


def initialize(p: Parameters, x: State) -> None:
    """The brush at its first angle. Energy counts from here; what is pressed in is hull work."""
    x.theta_b = p.theta_b_0
    x.J_x = 0.0
    x.J_y = 0.0
    x.J_z = 0.0
    x.J_T = 0.0
    x.W_hub = 0.0
    x.W_hull = 0.0
    x.W_friction = 0.0
    x.W_contact = 0.0
    x.W_water = 0.0
    x.E_strain = 0.0
    x.deflection_ratio = 0.0
    x.deflection_ratio_max = 0.0
    x.micro_steps = 0.0
    x.h_micro_min = p.h_max


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Write the outputs from the state and the inputs."""
    hull = hull_at(u.delta, u, p)
    clear_sums(y)
    for k in range(8):
        count = tufts_in(k, p)
        for i in range(count):
            at = place(x.root[k], x.theta_b + 2.0 * pi * i / count, p)
            press(s.end, at, hull, u, p, x)
            add_tip(s.end, u, y)
    tell(u, p, x, y)


def tell(u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """All outputs that are no sums over tufts."""
    hull = hull_at(u.delta, u, p)
    y.theta_b = x.theta_b
    y.J_x = x.J_x
    y.J_y = x.J_y
    y.J_z = x.J_z
    y.J_T = x.J_T
    y.T_brush_eq15 = torque_of_eq15(p, y)
    y.T_water = pack_torque(u, p)
    y.P_water = -u.omega_b * y.T_water
    y.T_brush = y.T_brush + y.T_water
    y.P_hub = -u.omega_b * y.T_brush
    y.P_hull = y.F_x * u.v_rov - y.F_z * hull.v_z
    y.P_damping = 0.0
    y.E_kinetic = 0.0
    y.E_centrifugal = 0.0
    y.E_contact = 0.0
    y.W_hub = x.W_hub
    y.W_hull = x.W_hull
    y.W_damping = 0.0
    y.W_friction = x.W_friction
    y.W_contact = x.W_contact
    y.W_water = x.W_water
    # inputs that jump do work at once; it is booked when the next step begins
    jump = y.E_strain - x.E_strain
    y.energy_residual = y.E_strain - (x.W_hub + x.W_hull + jump - x.W_friction - x.W_contact - x.W_water)
    y.deflection_ratio = x.deflection_ratio
    y.deflection_ratio_max = x.deflection_ratio_max
    y.micro_steps = x.micro_steps
    y.h_micro_min = x.h_micro_min
    y.root_radius = x.root[0]
    y.J_filaments = bristle_inertia(p, x)
    write_sizes(p, y)


def write_sizes(p: Parameters, y: Outputs) -> None:
    """Mass of the bristles, and how densely they stand on a disc that ends with the outermost row."""
    tufts = 0.0
    outermost = 0.0
    for k in range(8):
        tufts = tufts + tufts_in(k, p)
        if tufts_in(k, p) > 0.0:
            outermost = max(outermost, p.row_radius[k] * p.R_brush)
    section = tufts * p.bristles_per_tuft * 0.25 * pi * p.d * p.d
    y.m_filaments = section * p.rho * p.L
    y.packing = section / (pi * max(outermost * outermost, 1e-12))


def bristle_inertia(p: Parameters, x: State) -> float:
    """Moment of inertia of all bristles about the brush axis, straight and without cant."""
    mass = p.bristles_per_tuft * p.rho * 0.25 * pi * p.d * p.d * p.L
    total = 0.0
    for k in range(8):
        total = total + tufts_in(k, p) * mass * x.root[k] * x.root[k]
    return total


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Advance the brush by h at constant omega_b, v_rov and delta_dot; delta goes on from its value at the start."""
    count = equal_steps(h, min(p.h_max, 0.05 / max(abs(u.omega_b), 1e-9)))  # Simpson's rule over at most 0.05 rad
    h_s = h / count
    J_x = x.J_x
    J_z = x.J_z
    J_T = x.J_T
    x.deflection_ratio = 0.0
    E_start = 0.0
    clear_sums(y)
    for k in range(8):
        tufts = tufts_in(k, p)
        for i in range(tufts):
            E_start = E_start + advance_tuft(k, x.theta_b + 2.0 * pi * i / tufts, count, h_s, u, p, x, s)
            add_tip(s.end, u, y)
    hull = hull_at(u.delta, u, p)
    T_water = pack_torque(u, p)
    x.J_T = x.J_T + T_water * h
    x.W_water = x.W_water - u.omega_b * T_water * h
    x.theta_b = x.theta_b + u.omega_b * h
    x.W_hub = x.W_hub - u.omega_b * (x.J_T - J_T)
    x.W_hull = x.W_hull + E_start - x.E_strain + u.v_rov * (x.J_x - J_x) - hull.v_z * (x.J_z - J_z)
    x.E_strain = y.E_strain
    x.micro_steps = x.micro_steps + count
    x.h_micro_min = min(x.h_micro_min, h_s)
    x.deflection_ratio_max = max(x.deflection_ratio, x.deflection_ratio_max)
    tell(u, p, x, y)


def advance_tuft(
    k: int, phi: float, count: int, h_s: float, u: Inputs, p: Parameters, x: State, s: Scratch,
) -> float:
    """Book a tuft of row k, which stood at phi when the step began, in micro-steps; returns its energy at the begin."""
    hull = hull_at(u.delta, u, p)
    at = place(x.root[k], phi, p)
    press(s.begin, at, hull, u, p, x)
    E_start = energy_of(s.begin)
    for m in range(count):
        turn = (m + 0.5) * h_s
        hull = hull_at(u.delta + u.delta_dot * turn, u, p)
        at = place(x.root[k], phi + u.omega_b * turn, p)
        press(s.middle, at, hull, u, p, x)
        turn = (m + 1) * h_s
        hull = hull_at(u.delta + u.delta_dot * turn, u, p)
        at = place(x.root[k], phi + u.omega_b * turn, p)
        press(s.end, at, hull, u, p, x)
        book(h_s, s.begin, s.middle, s.end, u, x)
        adopt(s.begin, s.end)
        x.deflection_ratio = max(x.deflection_ratio, bend_ratio(s.end))
    return E_start


def energy_of(tip: Tip) -> float:
    """Strain energy of a tuft."""
    return tip.E


def bend_ratio(tip: Tip) -> float:
    """Deflection of a tuft's bristles over L."""
    return tip.b
