"""What the brush is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Matrix, Packed, Record, Rows, Vector, calculated, input_, output, value
from .parameters import Parameters

REACH = ("omega_b", "delta", "delta_dot", "tilt_x")  # what decides where the tips are and how they move
ALL = (*REACH, "v_rov", "friction_scale")
WATER = ("omega_b", "delta_dot", "v_rov")
MODES = 6  # as many as there can be; N_m of them are used


def rods(p: Parameters) -> int:
    """Rods of all filaments, as in `rods.py`: strip by strip, group by group."""
    return p.n * p.n_strips * p.n_groups


class Inputs(Record):
    """How the brush turns, and where the hull is and how it moves."""

    omega_b: float = input_("rad/s", "brush speed about +y_t")
    delta: float = input_("m", "penetration of the undeformed brush into the hull")
    delta_dot: float = input_("m/s", "rate of delta; within a step delta goes on at this rate")
    v_rov: float = input_("m/s", "speed of the hull past the tool along +x_t")
    friction_scale: float = input_("1", "factor on mu_s and mu_c (fouling)", start=1.0, minimum=0.0)
    tilt_x: float = input_("rad", "angle by which the tool is turned about x_t; positive presses the side at +y_t in")


class Outputs(Packed):
    """Forces on the brush, its energies, and what tells whether the model is valid."""

    F_x: float = output("N", "force on the brush along x_t", ALL)
    F_z: float = output("N", "force on the brush along z_t", (*REACH, "v_rov"))
    T_brush: float = output("N.m", "torque on the brush about y_t", ALL)
    M_x: float = output("N.m", "moment on the brush about x_t, of strips beside its middle", (*REACH, "v_rov"))
    M_z: float = output("N.m", "moment on the brush about z_t, of strips beside its middle", ALL)
    contact_count: float = output("1", "filaments in contact", REACH)
    contact_length: float = output("m", "from the foremost to the rearmost tip in contact, along x_t", REACH)
    v_sliding: float = output("m/s", "mean speed of sliding of the tips in contact", ALL)
    sliding_distance: float = output("m", "distance slid on the hull so far, summed over the filaments")
    strikes: float = output("1", "touch-downs so far, summed over the filaments")
    deflection_ratio: float = output("1", "largest |y(L)|/L in the last step; far from the hull, where it began")
    deflection_ratio_max: float = output("1", "largest |y(L)|/L so far")
    theta_b: float = output("rad", "brush angle")
    J_x: float = output("N.s", "time integral of F_x")
    J_z: float = output("N.s", "time integral of F_z")
    J_T: float = output("N.m.s", "time integral of T_brush")
    J_Mx: float = output("N.m.s", "time integral of M_x")
    J_Mz: float = output("N.m.s", "time integral of M_z")
    F_y_eq11: float = output("N", "sum of base shears, Eq. 11", ALL)
    M_b_eq12: float = output("N.m", "sum of base moments, Eq. 12", ALL)
    F_z_eq13: float = output("N", "sum of axial forces, Eq. 13", ALL)
    T_brush_eq15: float = output("N.m", "torque of Eq. 15", ALL)
    P_hub: float = output("W", "power of the hub", ALL)
    P_hull: float = output("W", "power of the hull", ALL)
    P_damping: float = output("W", "power lost in damping", ALL)
    P_friction: float = output("W", "power lost in friction", ALL)
    P_contact: float = output("W", "power lost in contact", ALL)
    T_water: float = output("N.m", "torque of the water about y_t, part of T_brush", WATER)
    P_water: float = output("W", "power lost to the water", WATER)
    E_kinetic: float = output("J", "kinetic energy relative to the hub")
    E_strain: float = output("J", "strain energy")
    E_centrifugal: float = output("J", "centrifugal potential", ("omega_b",))
    E_contact: float = output("J", "elastic energy of the contact", ("delta", "tilt_x"))
    W_hub: float = output("J", "work of the hub")
    W_hull: float = output("J", "work of the hull")
    W_damping: float = output("J", "energy lost in damping")
    W_friction: float = output("J", "energy lost in friction")
    W_contact: float = output("J", "energy lost in contact")
    W_water: float = output("J", "energy lost to the water")
    energy_residual: float = output("J", "energy that the integration created", ("omega_b", "delta", "tilt_x"))
    micro_steps: float = output("1", "micro-steps of touching filaments so far")
    h_micro_min: float = output("s", "shortest micro-step so far, but for those cut by a communication point")
    kinetic_fraction: Vector = output("1", "share of each mode in the kinetic energy", size=MODES)
    lambda_r: Vector = calculated("1", "eigenvalues", MODES)
    omega_r: Vector = calculated("rad/s", "frequencies at rest", MODES)
    R_h: float = calculated("m", "hub radius")
    J_filaments: float = calculated("kg.m2", "inertia of the filaments about y_t")
    m_filaments: float = calculated("kg", "mass of all bristles, dry")
    packing: float = calculated("1", "share of the hub's surface that they take; round ones take 0.907 at most")


class Modes(Rows):
    """Numbers of the bending modes, one per mode; what `setup` finds out."""

    lambda_r: Vector = value("1", "eigenvalue", MODES)
    omega_r: Vector = value("rad/s", "frequency at rest", MODES)
    damping: Vector = value("1/s", "2 zeta_r omega_r", MODES)
    Y_L: Vector = value("1", "Y_r at the tip", MODES)
    slope_L: Vector = value("1/m", "Y_r' at the tip", MODES)
    int_Y: Vector = value("m", "integral of Y_r", MODES)
    int_xY: Vector = value("m2", "integral of x Y_r", MODES)
    curvature_0: Vector = value("1/m2", "Y_r'' at the root", MODES)
    shear_0: Vector = value("1/m3", "Y_r''' at the root", MODES)
    x: Vector = value("m", "points of the quadrature along a bristle, as many as modes", MODES)
    weight: Vector = value("m", "their weights", MODES)


class State(Record):
    """The filaments' deflections, the accounts, and what is constant after `setup`."""

    nominal: Modes = value("", "numbers of the modes of the length L")
    G_nominal: Matrix = value("1/m", "integral of Y_r' Y_s' at the length L", (MODES, MODES))
    S_nominal: Matrix = value("1", "centrifugal stiffness over omega_b^2 and the modal mass there", (MODES, MODES))
    S_root: Matrix = value("1", "what of it goes with the radius of the root", (MODES, MODES))
    Y: Matrix = value("1", "Y_r at the points along a bristle", (MODES, MODES))
    sin_at: Vector = value("1", "sine of the angle of each filament's axis where the brush stands at 0", lambda p: p.n)
    cos_at: Vector = value("1", "its cosine", lambda p: p.n)
    linear: Vector = value("1", "1: drag of each rod linear in the last step", lambda p: rods(p))
    eta: Matrix = value("m", "modal deflections of each rod", lambda p: (rods(p), p.N_m))
    eta_dot: Matrix = value("m/s", "their rates", lambda p: (rods(p), p.N_m))
    h_next: Vector = value("s", "the next micro-step of each rod", lambda p: rods(p))
    z: Vector = value("m", "bend of LuGre's microscopic bristles at each tip", lambda p: rods(p))
    clock: Vector = value("1", "steps after which a sleeping rod's deflections hold; -1: awake", lambda p: rods(p))
    swing: Vector = value("m/s", "bound on the swing of each sleeping rod, as in `reach.py`", lambda p: rods(p))
    awake: Vector = value("1", "the rods that are awake, those of each group together", lambda p: rods(p))
    awake_count: Vector = value("1", "how many of each group", lambda p: p.n_groups)
    late: Vector = value("1", "rods that fell asleep within the present epoch", lambda p: rods(p))
    late_count: Vector = value("1", "how many of each group", lambda p: p.n_groups)
    is_late: Vector = value("1", "1: the rod is among them", lambda p: rods(p))
    sums: Matrix = value("", "w w^T over the sleepers of each group, w = (eta, eta_dot, 1)",
                         lambda p: (p.n_groups * (2 * p.N_m + 1), 2 * p.N_m + 1))
    around: Matrix = value("", "w cos(theta_i) and w sin(theta_i) over them, theta_i the angle on the hub",
                           lambda p: (p.n_groups * 2, 2 * p.N_m + 1))
    nearby: Matrix = value("", "the map of a step over the square of the speed, of each group; see `nearby_maps.py`",
                           lambda p: (p.n_groups * 6 * p.N_m, 2 * p.N_m + 1))
    nearby_h: Vector = value("s", "length of that step; 0: none", lambda p: p.n_groups)
    nearby_speed_2: Vector = value("rad2/s2", "square of the speed in its middle", lambda p: p.n_groups)
    nearby_range: Vector = value("rad2/s2", "how far it holds to both sides", lambda p: p.n_groups)
    maps: Matrix = value("", "maps of past steps, epochs and the era, of each group; see `calendar.py`",
                         lambda p: (p.n_groups * 68 * p.N_m, 2 * p.N_m + 1))
    at_rest: Matrix = value("m", "deflections at rest in the turning brush, by group", lambda p: (p.n_groups, p.N_m))
    y_rest: Vector = value("m", "tip deflection at rest, of each group", lambda p: p.n_groups)
    y_per_swing: Vector = value("s", "largest tip deflection of a swing, over it; 0: unknown", lambda p: p.n_groups)
    grow: Vector = value("1", "growth of all bounds by changes of speed, of each group", lambda p: p.n_groups)
    lift: Vector = value("m/s", "what those add to bounds, before growth", lambda p: p.n_groups)
    widest: Vector = value("m/s", "the largest bound of a group", lambda p: p.n_groups)
    arc_low: Vector = value("m", "least tip deflection that the arc is of, of each strip of each group",
                            lambda p: p.n_groups * p.n_strips)
    arc_high: Vector = value("m", "largest", lambda p: p.n_groups * p.n_strips)
    arc_h: Vector = value("m", "distance of the hull that it is of", lambda p: p.n_groups * p.n_strips)
    arc_begin: Vector = value("rad", "angle where tips come within reach", lambda p: p.n_groups * p.n_strips)
    arc_end: Vector = value("rad", "angle where they leave it", lambda p: p.n_groups * p.n_strips)
    since: Vector = value("1", "how many fell asleep since that was looked for", lambda p: p.n_groups)
    theta_b: float = value("rad", "brush angle")
    delta: float = value("m", "penetration given to the last step")
    delta_end: float = value("m", "penetration where it ended")
    steps: float = value("1", "steps so far")
    h_before: float = value("s", "length of the last step")
    epoch_begin: float = value("1", "steps before the present epoch")
    era_begin: float = value("1", "steps before the present era")
    J_x: float = value("N.s", "time integral of F_x")
    J_z: float = value("N.s", "time integral of F_z")
    J_T: float = value("N.m.s", "time integral of T_brush")
    J_Mx: float = value("N.m.s", "time integral of M_x")
    J_Mz: float = value("N.m.s", "time integral of M_z")
    sliding_distance: float = value("m", "distance slid on the hull")
    strikes: float = value("1", "touch-downs")
    touches: Vector = value("1", "1: the rod touched at the end of the last step", lambda p: rods(p))
    W_hub: float = value("J", "work of the hub")
    W_hull: float = value("J", "work of the hull")
    W_damping: float = value("J", "energy lost in damping")
    W_friction: float = value("J", "energy lost in friction")
    W_contact: float = value("J", "energy lost in contact")
    W_water: float = value("J", "energy lost to the water")
    E_contact: float = value("J", "elastic energy of the contact at the end of the last step")
    E_per_speed_2: float = value("kg.m2", "centrifugal potential over omega_b^2 at the end of the last step")
    speed_2: float = value("rad2/s2", "omega_b^2 in the last step")
    deflection_ratio: float = value("1", "largest |y|/L in the last step")
    deflection_ratio_max: float = value("1", "largest |y|/L since the start")
    micro_steps: float = value("1", "number of micro-steps")
    h_micro_min: float = value("s", "shortest micro-step")


class Stage(Rows):
    """One rod at one instant: deflection, its rates, and what the hull does to the tip."""

    eta: Vector = value("m", "modal deflections", MODES)
    eta_dot: Vector = value("m/s", "their rates", MODES)
    a: Vector = value("m/s2", "their accelerations", MODES)
    g: Vector = value("1", "G eta, the gradient of the foreshortening", MODES)
    z: float = value("m", "bend of LuGre's microscopic bristles")
    z_dot: float = value("m/s", "its rate")
    F_f: float = value("N", "friction")
    F_n: float = value("N", "normal force")
    moment: float = value("N.m", "moment about the brush axis")
    x: float = value("m", "place of a tip in contact along x_t")
    v_slip: float = value("m/s", "speed of sliding of a tip in contact")
    P_friction: float = value("W", "power lost in friction")
    P_contact: float = value("W", "power lost in contact")
    P_damping: float = value("W", "power lost in damping")
    F_w: float = value("N", "drag along e_t")
    M_w: float = value("N.m", "its moment about the root")
    P_water: float = value("W", "power lost to the water")


class Stiffness(Record):
    """The linear part of Eq. 4 at a speed, per modal mass."""

    K: Matrix = value("1/s2", "stiffness", (MODES, MODES))
    load: Vector = value("m/s2", "centrifugal load K_6r", MODES)


class Constants(Record):
    """What is constant over a step for the rods of one length."""

    L: float = value("m", "length of these rods")
    R_tip: float = value("m", "bound on the radius of their tips")
    share: float = value("1", "share of a filament that a rod is")
    x_a: float = value("m", "straight tip along e_a")
    x_t: float = value("m", "straight tip along e_t")
    R_h: float = value("m", "hub radius")
    sin_alpha: float = value("1", "sine of the cant")
    cos_alpha: float = value("1", "its cosine")
    M: float = value("kg", "modal mass of a bundle")
    per_M: float = value("1/kg", "one over it")
    chi: float = value("1", "share of the bristle in it")
    speed_2: float = value("rad2/s2", "omega_b^2 as far as it acts on the filaments")
    omega_max: float = value("rad/s", "bound on the highest natural frequency")
    mu_s: float = value("1", "static friction coefficient of the fouled hull")
    mu_c: float = value("1", "Coulomb friction coefficient of the fouled hull")
    fouling: float = value("1", "friction_scale")
    drag: float = value("kg/m2", "drag of a bundle per length and speed squared")
    slip: float = value("1", "share of the pack's speed that the water within it lacks")


class Scratch(Record):
    """What lives within one step."""

    c: Constants = value("", "what is constant over a step for the rods at hand")
    modes: Modes = value("", "numbers of their modes")
    G: Matrix = value("1/m", "integral of Y_r' Y_s'", (MODES, MODES))
    S: Matrix = value("1", "centrifugal stiffness over omega_b^2 and the modal mass", (MODES, MODES))
    k: Stiffness = value("", "stiffness at the present speed")
    now: Stage = value("", "a rod where a micro-step begins")
    second: Stage = value("", "at the second stage of Runge-Kutta")
    third: Stage = value("", "at the third stage")
    fourth: Stage = value("", "at the fourth stage")
    end: Stage = value("", "at the end of the micro-step")
    P: Matrix = value("1", "map of free flight over the step", lambda p: (2 * p.N_m + 2, 2 * p.N_m + 2))
    Q: Matrix = value("1", "a product", lambda p: (2 * p.N_m + 2, 2 * p.N_m + 2))
    A: Matrix = value("1", "the linear equations times a micro-step", lambda p: (2 * p.N_m + 2, 2 * p.N_m + 2))
    nodes: Vector = value("1", "points of the quadrature", 5)
    weights: Vector = value("1", "their weights", 5)
    slopes: Vector = value("1/m", "Y_r' at a point", MODES)
    shapes: Matrix = value("1", "Y_r at the points along a bristle, with drag", (MODES, MODES))
    rest: Vector = value("m", "deflections at rest in the flow, with drag", MODES)
    moved: Vector = value("", "deflections and rates after a map", 2 * MODES)
    lean: Vector = value("", "a right-hand side, and what solves it", MODES)
    left: Matrix = value("", "`sums` of the group at hand, less what is looked at by itself",
                         lambda p: (2 * p.N_m + 1, 2 * p.N_m + 1))
    looked_at: Vector = value("1", "rods that are looked at by themselves", lambda p: p.n * p.n_strips)
    left_around: Matrix = value("", "`around` of that", lambda p: (2, 2 * p.N_m + 1))
    shares: Vector = value("1", "weights of the points along a bristle", MODES)
    sin_begin: float = value("1", "sine of the brush angle where the step begins")
    cos_begin: float = value("1", "its cosine")
    sin_end: float = value("1", "sine of the brush angle where the step ends")
    cos_end: float = value("1", "its cosine")
    x_front: float = value("m", "place of the foremost tip in contact")
    x_rear: float = value("m", "place of the rearmost")
    filament_phi: Vector = value("rad", "angle from +z_t of filament i", lambda p: p.n, shown=True)
    filament_F_n: Vector = value("N", "normal force of filament i", lambda p: p.n, shown=True)
    filament_F_f: Vector = value("N", "friction of filament i", lambda p: p.n, shown=True)
    filament_y: Vector = value("m", "bending of filament i", lambda p: p.n, shown=True)


class Placement(Record):
    """How a filament stands to the hull at an instant."""

    sin_psi: float = value("1", "sine of the angle of its axis from +z_t")
    cos_psi: float = value("1", "cosine of that angle")
    h_plane: float = value("m", "distance of the hull from the brush axis")


class Turn(Record):
    """An angle by which something turns."""

    sine: float = value("1", "its sine")
    cosine: float = value("1", "its cosine")


class Reach(Record):
    """How far a tip is in the hull, and how fast it can react."""

    Delta: float = value("m", "penetration; a bound from above while out of reach")
    rate: float = value("1/s", "what limits the micro-step")


class Trial(Record):
    """A micro-step that was tried."""

    error: float = value("m/s", "error of the velocity")
    Delta: float = value("m", "penetration at the end")
    rate: float = value("1/s", "what limits the next micro-step")
    sin_psi: float = value("1", "how the filament stands at the end, as in `Placement`")
    cos_psi: float = value("1", "the same")
    h_plane: float = value("m", "the same")


class Drag(Record):
    """Drag on a bundle over a step of free flight."""

    F_w: float = value("N.s", "its impulse along e_t")
    M_w: float = value("N.m.s", "the moment of that about the root")
    work: float = value("J", "work of its constant part")


class Losses(Record):
    """What a filament loses in free flight."""

    damping: float = value("W", "to modal damping")
    drag: float = value("W", "to linear drag, by its own motion")


class Touched(Record):
    """A filament after a step near the hull."""

    h_next: float = value("s", "micro-step to try next")
    Delta: float = value("m", "penetration at the end")


class Advanced(Record):
    """Energies of a rod, or of the rods of a group, at the begin and the end of a step."""

    E_start: float = value("J", "elastic energy of the contact at the begin")
    E_end: float = value("J", "elastic energy of the contact at the end")
    E_per_speed_2: float = value("kg.m2", "centrifugal potential over omega_b^2 at the end")


class Normal(Record):
    """The normal force of a tip."""

    F_n: float = value("N", "normal force")
    F_e: float = value("N", "its elastic part")
    damping: float = value("N.s/m", "contact damping, ramped c_c")


class Friction(Record):
    """The friction law at a sliding speed."""

    mu: float = value("1", "F_f/F_n")
    slope: float = value("s/m", "bound on its slope")
    z_dot: float = value("m/s", "rate of LuGre's z")
    spring: float = value("1/m", "bound on what LuGre's z adds to the stiffness at the tip, over F_n")
    forgets: float = value("1/s", "bound on the rate at which z forgets")


class Load(Record):
    """What a filament's base has to carry."""

    F_a: float = value("N", "tip force along e_a")
    F_t: float = value("N", "tip force along e_t")
    shortening: float = value("m", "foreshortening")


class Base(Record):
    """What a filament does at its base."""

    shear: float = value("N", "base shear")
    moment: float = value("N.m", "base moment")
    y: float = value("m", "tip deflection")


class Sweep(Record):
    """How the brush and the hull move within a step."""

    turn: float = value("rad", "angle that the brush turns")
    sin_turn: float = value("1", "its sine")
    cos_turn: float = value("1", "its cosine")
    h_least: float = value("m", "least distance of the hull from the brush axis")


class Span(Record):
    """Neighbouring rods of a strip."""

    first: int = value("1", "number of the first, counted on over full turns")
    count: int = value("1", "how many")
