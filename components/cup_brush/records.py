"""What the cup brush is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Matrix, Packed, Record, Vector, calculated, input_, output, value

ALL = ("omega_b", "delta", "delta_dot", "v_rov", "friction_scale", "misalignment")
TABLE = (31, 35)  # 29 values of sqrt(e) and 33 of beta, and one more on each side
ROWS = 8


class Inputs(Record):
    """How the brush turns, and where the hull is and how it moves."""

    omega_b: float = input_("rad/s", "brush speed about +z_t")
    delta: float = input_("m", "penetration of the undeformed brush into the hull, on its axis")
    delta_dot: float = input_("m/s", "rate of delta; within a step delta goes on at this rate")
    v_rov: float = input_("m/s", "speed of the hull past the tool along +x_t")
    friction_scale: float = input_("1", "factor on mu_s and mu_c (fouling)", start=1.0, minimum=0.0)
    misalignment: float = input_(
        "rad", "angle of the normal into the hull from z_t, about +y_t: positive presses the side at +x_t deeper",
        minimum=-0.5, maximum=0.5,
    )


class Outputs(Packed):
    """Forces on the brush, its energies, and what tells whether the model is valid."""

    F_x: float = output("N", "force on the brush along x_t", ALL)
    F_z: float = output("N", "force on the brush along z_t", ALL)
    T_brush: float = output("N.m", "torque on the brush about z_t", ALL)
    F_y: float = output("N", "force on the brush along y_t", ALL)
    M_x: float = output("N.m", "moment on the brush about x_t", ALL)
    M_y: float = output("N.m", "moment on the brush about y_t", ALL)
    F_y_sum: float = output("N", "the tufts' friction added as numbers, negative for omega_b > 0: the paper's F_y", ALL)
    contact_count: float = output("1", "tufts in contact", ALL)
    deflection_ratio: float = output("1", "largest tip deflection over L in the last step")
    deflection_ratio_max: float = output("1", "largest tip deflection over L so far")
    theta_b: float = output("rad", "brush angle")
    J_x: float = output("N.s", "time integral of F_x")
    J_z: float = output("N.s", "time integral of F_z")
    J_T: float = output("N.m.s", "time integral of T_brush")
    J_y: float = output("N.s", "time integral of F_y")
    F_y_eq11: float = output("N", "sum of base shears, Eq. 11", ALL)
    M_b_eq12: float = output("N.m", "sum of base moments, Eq. 12", ALL)
    F_z_eq13: float = output("N", "sum of axial forces, Eq. 13", ALL)
    T_brush_eq15: float = output("N.m", "torque of Eq. 15, each tuft at the side of the brush", ALL)
    P_hub: float = output("W", "power of the hub", ALL)
    P_hull: float = output("W", "power of the hull", ALL)
    P_damping: float = output("W", "0: bristles have no inertia; their damping is P_contact")
    P_friction: float = output("W", "power lost in friction", ALL)
    P_contact: float = output("W", "power lost in the damping of pressed tufts", ALL)
    T_water: float = output("N.m", "torque of the water about z_t, part of T_brush", ("omega_b",))
    P_water: float = output("W", "power lost to the water", ("omega_b",))
    E_kinetic: float = output("J", "0: bristles have no inertia")
    E_strain: float = output("J", "strain energy", ALL)
    E_centrifugal: float = output("J", "0: bristles have no inertia")
    E_contact: float = output("J", "0: the hull is hard")
    W_hub: float = output("J", "work of the hub")
    W_hull: float = output("J", "work of the hull")
    W_damping: float = output("J", "0: bristles have no inertia; their damping is W_contact")
    W_friction: float = output("J", "energy lost in friction")
    W_contact: float = output("J", "energy lost in the damping of pressed tufts")
    W_water: float = output("J", "energy lost to the water")
    energy_residual: float = output("J", "energy that the integration created", ALL)
    micro_steps: float = output("1", "micro-steps so far")
    h_micro_min: float = output("s", "shortest micro-step so far")
    root_radius: float = calculated("m", "radius of the roots of the first row")
    J_filaments: float = calculated("kg.m2", "inertia of the bristles about z_t")
    m_filaments: float = calculated("kg", "mass of all bristles, dry")
    packing: float = calculated("1", "share of the disc within the outermost row that they take; at most 0.907")


class State(Record):
    """The brush's angle, the accounts, and what is constant after `setup`."""

    G: Matrix = value("1", "q/f of the elastica", TABLE)
    H: Matrix = value("1", "b/q of the elastica", TABLE)
    root: Vector = value("m", "radius of the roots of each row", ROWS)
    theta_b: float = value("rad", "brush angle")
    J_x: float = value("N.s", "time integral of F_x")
    J_y: float = value("N.s", "time integral of F_y")
    J_z: float = value("N.s", "time integral of F_z")
    J_T: float = value("N.m.s", "time integral of T_brush")
    W_hub: float = value("J", "work of the hub")
    W_hull: float = value("J", "work of the hull")
    W_friction: float = value("J", "energy lost in friction")
    W_contact: float = value("J", "energy lost in damping")
    W_water: float = value("J", "energy lost to the water")
    E_strain: float = value("J", "strain energy at the end of the last step")
    deflection_ratio: float = value("1", "largest deflection over L in the last step")
    deflection_ratio_max: float = value("1", "largest deflection over L since the start")
    micro_steps: float = value("1", "number of micro-steps")
    h_micro_min: float = value("s", "shortest micro-step")


class Tip(Packed):
    """A tuft's tip at one instant, in the frame of the tool."""

    x: float = value("m", "its place along x_t")
    y: float = value("m", "its place along y_t")
    z: float = value("m", "its place along z_t")
    P: float = value("N", "normal force of the bent bristles")
    F_n: float = value("N", "normal force, with damping")
    F_f: float = value("N", "friction")
    f_x: float = value("N", "friction of the bent bristles along their sliding: along x_t")
    f_y: float = value("N", "along y_t")
    f_z: float = value("N", "along z_t")
    F_x: float = value("N", "force along x_t")
    F_y: float = value("N", "force along y_t")
    F_z: float = value("N", "force along z_t")
    shear: float = value("N", "base shear")
    M_b: float = value("N.m", "base moment")
    slope: float = value("rad", "angle of the tip's tangent from the axis of the root")
    b: float = value("1", "deflection of the tip over L")
    E: float = value("J", "strain energy")
    P_friction: float = value("W", "power lost in friction")
    P_contact: float = value("W", "power lost in damping")


class Scratch(Record):
    """What lives within one step."""

    begin: Tip = value("", "a tuft where a micro-step begins")
    middle: Tip = value("", "in its middle")
    end: Tip = value("", "at its end")
    nodes: Vector = value("1", "points of the quadrature", 5)
    weights: Vector = value("1", "their weights", 5)


class Arc(Record):
    """An elastica, in units of L and E I/L^2."""

    f: float = value("1", "tip force")
    e: float = value("1", "shortening along the axis")
    b: float = value("1", "deflection beside it")


class Hull(Record):
    """The hull at an instant."""

    delta: float = value("m", "penetration on the axis")
    n_x: float = value("1", "normal into the hull along x_t")
    n_z: float = value("1", "normal into the hull along z_t")
    v_z: float = value("m/s", "speed of the hull along -z_t")
    mu_s: float = value("1", "static friction coefficient of the fouled hull")
    mu_c: float = value("1", "Coulomb friction coefficient of the fouled hull")


class Place(Record):
    """Where a tuft stands at an instant."""

    r: float = value("m", "radius of its root")
    cos_phi: float = value("1", "cosine of its angle from x_t")
    sin_phi: float = value("1", "sine of that angle")
    a_x: float = value("1", "axis of its bristles along x_t")
    a_y: float = value("1", "along y_t")
    a_z: float = value("1", "along z_t")


class Sliding(Record):
    """How a tip slides: direction in the hull plane, along its trace in the plane of x_t and z_t and along y_t."""

    u_1: float = value("1", "direction in the plane of x_t and z_t")
    u_2: float = value("1", "direction along y_t")
    V: float = value("m/s", "speed")


class Bend(Record):
    """How a bristle stands: the force at its tip and the way it bends."""

    mu: float = value("1", "F_f/F_n")
    beta: float = value("rad", "angle of the force from the line along the axis")
    q: float = value("1", "square root of the shortening over L")
    b: float = value("1", "deflection over L")
    d_x: float = value("1", "direction of the deflection along x_t")
    d_y: float = value("1", "along y_t")
    d_z: float = value("1", "along z_t")
