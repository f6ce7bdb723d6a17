"""What the controller is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Matrix, Packed, Record, Vector, input_, output, value


class Inputs(Record):
    """Measured motion and tool wrench, and the set-points."""

    x_n: float = input_("m", "measured position north", sampled=True)
    y_n: float = input_("m", "measured position east", sampled=True)
    z_n: float = input_("m", "measured position down", sampled=True)
    phi: float = input_("rad", "measured roll angle", sampled=True)
    theta: float = input_("rad", "measured pitch angle", sampled=True)
    psi: float = input_("rad", "measured yaw angle", sampled=True)
    u: float = input_("m/s", "surge velocity, body frame", sampled=True)
    v: float = input_("m/s", "sway velocity, body frame", sampled=True)
    w: float = input_("m/s", "heave velocity, body frame", sampled=True)
    p: float = input_("rad/s", "measured roll rate, body frame", sampled=True)
    q: float = input_("rad/s", "measured pitch rate, body frame", sampled=True)
    r: float = input_("rad/s", "measured yaw rate, body frame", sampled=True)
    x_ref: float = input_("m", "position set-point north", sampled=True)
    y_ref: float = input_("m", "position set-point east", sampled=True)
    z_ref: float = input_("m", "position set-point down", sampled=True)
    phi_ref: float = input_("rad", "roll angle set-point", sampled=True)
    theta_ref: float = input_("rad", "pitch angle set-point", sampled=True)
    psi_ref: float = input_("rad", "yaw angle set-point", sampled=True)
    v_ref: Vector = input_("m/s", "velocity of the position set-point, world frame", size=3, sampled=True)
    V_ref: float = input_("V", "set-point of the brush motor voltage", start=12.0, sampled=True)
    F_n_ref: float = input_("N", "force to press into the hull with; 0: position only", minimum=0.0, sampled=True)
    F_tool: Vector = input_("N", "measured force of the tool on the vehicle, body frame", size=3, sampled=True)
    M_tool: Vector = input_("N.m", "measured moment of the tool about the body origin", size=3, sampled=True)


class Outputs(Packed):
    """Commands, and what was asked of the thrusters."""

    u_thruster: Vector = output("1", "thruster commands, -1 to 1", size=8, sampled=True)
    V_in: float = output("V", "brush motor voltage", sampled=True)
    F_ref: Vector = output("N", "requested force, body frame", size=3, sampled=True)
    M_ref: Vector = output("N.m", "requested moment, body frame", size=3, sampled=True)
    saturated: float = output("1", "1 when the thrusters cannot give the requested wrench", sampled=True)
    saturation_count: float = output("1", "number of samples in which they could not", sampled=True)
    F_n: float = output("N", "measured force into the hull, filtered", sampled=True)
    pressing: float = output("1", "1 while the force along the hull normal is controlled", sampled=True)


class State(Record):
    """The matrices of the allocation, what the loops integrate, and what the last sample decided.

    Vectors of six are force and moment, or velocity and rate, in the body frame.
    """

    B: Matrix = value("1", "allocation matrix of Eq. 20: wrench per thrust", (6, 8))
    B_pinv: Matrix = value("1", "its pseudoinverse", (8, 6))
    integral: Vector = value("N", "integral part of the wrench", 6)
    nu_last: Vector = value("m/s", "measured velocities at the last sample", 6)
    wrench: Vector = value("N", "tool wrench, measured and filtered or observed", 6)
    into_hull: Vector = value("1", "unit vector into the hull, body frame", 3)
    given: Vector = value("N", "wrench that the thrusters were asked for by their commands", 6)
    thrust_seen: Vector = value("N", "that wrench behind the thruster lag, as the observer models it", 6)
    nu_seen: Vector = value("m/s", "velocity and rate of the observer", 6)
    d_seen: Vector = value("N", "disturbing wrench of the observer", 6)
    command: Vector = value("1", "thruster commands", 8)
    F_ref: Vector = value("N", "requested force", 3)
    M_ref: Vector = value("N.m", "requested moment", 3)
    sample: float = value("1", "number of the next sample, -1 before the first")
    V_in: float = value("V", "brush motor voltage")
    saturated: float = value("1", "1 when the thrusters could not give the wrench")
    saturation_count: float = value("1", "number of such samples")
    pressing: float = value("1", "1 while the force along the normal is controlled")
    was_pressing: float = value("1", "pressing at the sample before")
    seen: float = value("1", "1 once the observer has begun")
    force_integral: float = value("N", "integral of the force loop")


class Scratch(Record):
    """What lives within one step."""

    attitude: Vector = value("1", "attitude as a quaternion", 4)
    attitude_ref: Vector = value("1", "attitude set-point", 4)
    v_set: Vector = value("m/s", "velocity set-point, body frame", 3)
    omega_set: Vector = value("rad/s", "rate set-point, body frame", 3)
    e: Vector = value("m/s", "errors of velocity and rate", 6)
    nu: Vector = value("m/s", "velocity and rate that the loops use", 6)
    acceleration: Vector = value("m/s2", "their rate of change", 6)
    known: Vector = value("N", "weight less buoyancy in the observer's model, body frame", 6)
    measured: Vector = value("N", "measured tool wrench", 6)
    tau: Vector = value("N", "requested wrench", 6)
    F: Vector = value("N", "thrusts", 8)
    F_new: Vector = value("N", "thrusts with those at a bound held there", 8)
    bound: Vector = value("1", "the bound at which a thrust is held: -1 or 1, 0 none", 8)
    along: Vector = value("1", "direction of the requested force", 3)
    WB: Matrix = value("1", "weighted B", (6, 8))
    W_tau: Vector = value("N", "weighted tau", 6)
    H: Matrix = value("1", "matrix of the normal equations", (8, 8))
    A: Matrix = value("1", "that of the thrusts that are free", (8, 8))
    c: Vector = value("N", "right side of the normal equations", 8)
    scale: float = value("N", "its largest component")
    K_P: Vector = value("N.s/m", "gains on the errors", 6)
    K_I: Vector = value("N/m", "gains of their integrals", 6)
    K_D: Vector = value("kg", "gains on the measured accelerations", 6)
    BB: Matrix = value("1", "B B^T", (6, 6))
    BB_inv: Matrix = value("1", "its inverse", (6, 6))
