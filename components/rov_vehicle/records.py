"""What the vehicle is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Matrix, Packed, Record, Vector, input_, output, overlay, value

FORCES = ("F_x", "F_y", "F_z")
TOOL = (*FORCES, "M_x", "M_y", "M_z")
SPIN = ("H_x", "H_y", "H_z")
LOADS = (*TOOL, *SPIN, "F_external", "M_external", "v_c")


class Inputs(Record):
    """Commands, the wrench of the tool, further loads, and the water."""

    u_thruster: Vector = input_("1", "thruster commands; beyond -1 and 1 they saturate", size=8)
    F_x: float = input_("N", "force on the tool along x_t (with wrench_along_normal: along the hull)")
    F_y: float = input_("N", "force on the tool along y_t (or along the hull, across F_x)")
    F_z: float = input_("N", "force on the tool along z_t (or the normal into the hull)")
    M_x: float = input_("N.m", "moment on the tool about x_t")
    M_y: float = input_("N.m", "moment on the tool about y_t")
    M_z: float = input_("N.m", "moment on the tool about z_t")
    H_x: float = input_("N.m.s", "spin momentum of the tool about x_t")
    H_y: float = input_("N.m.s", "spin momentum of the tool about y_t")
    H_z: float = input_("N.m.s", "spin momentum of the tool about z_t")
    V_thruster: float = input_("V", "supply voltage of the thrusters", start=12.0)
    F_external: Vector = input_("N", "further force on the vehicle, body frame", size=3)
    M_external: Vector = input_("N.m", "further moment about the body origin, body frame", size=3)
    v_c: Vector = input_("m/s", "velocity of the water, world frame", size=3)


class Outputs(Packed):
    """Pose, velocities, the tool against the hull, thrusts, wrenches, powers and energies."""

    x_n: float = output("m", "position north")
    y_n: float = output("m", "position east")
    z_n: float = output("m", "position down")
    phi: float = output("rad", "roll angle")
    theta: float = output("rad", "pitch angle")
    psi: float = output("rad", "yaw angle")
    u: float = output("m/s", "surge velocity over ground, body frame")
    v: float = output("m/s", "sway velocity over ground, body frame")
    w: float = output("m/s", "heave velocity over ground, body frame")
    p: float = output("rad/s", "roll rate, body frame")
    q: float = output("rad/s", "pitch rate, body frame")
    r: float = output("rad/s", "yaw rate, body frame")
    quat: Vector = output("1", "attitude quaternion, body to world, scalar first", size=4)
    nu_dot: Vector = output(
        "m/s2",
        "acceleration of the body origin over ground (omega x v is in it); 4 to 6: angular [rad/s2]; body axes",
        LOADS,
        size=6,
    )
    delta: float = output("m", "penetration of the undeformed brush into the hull plane")
    delta_dot: float = output("m/s", "rate of delta")
    v_rov: float = output("m/s", "speed at which the hull passes under the tool along +x_t")
    misalignment: float = output("rad", "angle between z_t and the normal into the hull")
    tilt_x: float = output("rad", "angle by which the tool is turned about x_t against the hull")
    tilt_y: float = output("rad", "angle by which the tool is turned about y_t against the hull")
    thrust: Vector = output("N", "thrust of each thruster", size=8)
    i_thruster: float = output("A", "current that the thrusters draw")
    F_control: Vector = output("N", "force of the thrusters, body frame", size=3)
    M_control: Vector = output("N.m", "moment of the thrusters, body frame", size=3)
    F_disturb: Vector = output("N", "force of the tool, body frame", FORCES, size=3)
    M_disturb: Vector = output("N.m", "moment of the tool about the body origin, body frame", TOOL, size=3)
    P_thruster: float = output("W", "power of the thrusters on the vehicle")
    P_tool: float = output("W", "power of the tool wrench on the vehicle", TOOL)
    P_damping: float = output("W", "power lost to damping", ("v_c",))
    W_thruster: float = output("J", "work of the thrusters")
    W_tool: float = output("J", "work of the tool")
    W_external: float = output("J", "work of further wrenches")
    W_current: float = output("J", "work of the moving water")
    W_damping: float = output("J", "energy lost to damping")
    E_kinetic: float = output("J", "kinetic energy")
    E_potential: float = output("J", "energy of weight and buoyancy")
    energy_residual: float = output("J", "unaccounted energy")
    M_gyro: Vector = output("N.m", "gyroscopic moment of the spinning tool, body frame", SPIN, size=3)
    L: Vector = output("N.m.s", "angular momentum about the world origin, without the tool's spin, world frame", size=3)
    J_tool: Vector = output("N.m.s", "angular impulse of the tool about the world origin, its spin included", size=3)
    J_other: Vector = output("N.m.s", "angular impulse of thrusters, further wrenches, water and weight", size=3)


class Motion(Packed):
    """What is integrated: pose, velocity and the works; or the rates of these."""

    position: Vector = value("m", "position in the world: north, east, down", 3)
    q: Vector = value("1", "attitude as a quaternion, body to world, scalar first", 4)
    v: Vector = value("m/s", "velocity, body frame: over ground, through the water inside a step", 3)
    omega: Vector = value("rad/s", "angular velocity, body frame", 3)
    W_thruster: float = value("J", "work of the thrusters")
    W_tool: float = value("J", "work of the tool")
    W_external: float = value("J", "work of further wrenches")
    W_current: float = value("J", "work of the moving water")
    W_damping: float = value("J", "energy lost to damping")
    J_tool: Vector = value("N.m.s", "angular impulse of the tool about the world origin, world frame", 3)
    J_other: Vector = value("N.m.s", "angular impulse of all else", 3)
    nu: Vector = overlay("m/s", "v and omega as one", begins="v", size=6)


class State(Record):
    """Motion and thrusts, and the matrices that follow from the parameters."""

    motion: Motion = value("", "the vehicle's motion")
    thrust: Vector = value("N", "thrust of each thruster", 8)
    i_thruster: float = value("A", "current that the thrusters draw")
    command: Vector = value("1", "the commands that act", 8)
    held: Matrix = value("1", "commands on their way, a ring", (128, 8))
    due: Vector = value("s", "when each of them acts", 128)
    first_held: float = value("1", "place of the next one")
    count_held: float = value("1", "how many they are")
    clock: float = value("s", "time since the start")
    current: Vector = value("m/s", "velocity of the water in the last step, world frame", 3)
    E_start: float = value("J", "kinetic and potential energy at the start")
    B: Matrix = value("1", "allocation matrix of Eq. 20: wrench per thrust", (6, 8))
    M: Matrix = value("kg", "mass matrix of Eq. 19 about the body origin", (6, 6))
    M_inv: Matrix = value("1/kg", "its inverse", (6, 6))
    net_buoyancy: float = value("N", "buoyancy minus weight of vehicle and tool")
    lever: Vector = value("N.m", "W r_g - B r_b, the moment of weight and buoyancy per vertical", 3)
    R_tool: Matrix = value("1", "rotation from tool to body frame", (3, 3))


class Scratch(Record):
    """What lives within one step."""

    stage: Motion = value("", "motion at a stage of the Runge-Kutta step")
    k: Motion = value("", "rates at that stage")
    increment: Motion = value("", "weighted sum of the rates")
    R: Matrix = value("1", "rotation from body to world frame", (3, 3))
    v_water: Vector = value("m/s", "velocity of the water, body frame", 3)
    force: Vector = value("N", "all forces but those of inertia, body frame", 3)
    moment: Vector = value("N.m", "their moment about the body origin", 3)
    tau: Vector = value("N", "both as one", 6)
    hydrodynamic: Vector = value("N", "force of the water, without the acceleration", 3)
    momenta: Vector = value("N.s", "M nu_r", 6)
    a: Vector = value("N.s", "its linear part", 3)
    b: Vector = value("N.m.s", "its angular part", 3)
    F: Vector = value("N", "thrusts at a stage, without the hull", 8)
    F_steady: Vector = value("N", "thrusts that the commands lead to", 8)
    F_near: Vector = value("N", "thrusts at a stage", 8)
    F_control: Vector = value("N", "force of the thrusters, body frame", 3)
    M_control: Vector = value("N.m", "their moment about the body origin", 3)
    F_disturb: Vector = value("N", "force of the tool, body frame", 3)
    M_disturb: Vector = value("N.m", "its moment about the body origin", 3)
    H: Vector = value("N.m.s", "spin momentum of the tool, body frame", 3)
    M_gyro: Vector = value("N.m", "its gyroscopic moment", 3)
    acceleration: Vector = value("m/s2", "acceleration of the body origin over ground, body frame", 3)
    omega_dot: Vector = value("rad/s2", "angular acceleration, body frame", 3)
    nu_dot: Vector = value("m/s2", "both as one", 6)
    load_force: Vector = value("N", "forces but those of the tool and of inertia, body frame", 3)
    load_moment: Vector = value("N.m", "their moment about the body origin", 3)
    world: Vector = value("N", "a force or linear momentum, world frame", 3)
    impulse: Vector = value("N.m", "rate of an angular impulse, world frame", 3)
    L_before: Vector = value("N.m.s", "angular momentum before the current changes, world frame", 3)
    arm: Vector = value("m", "from the body origin to the tool point, world frame", 3)
    v_tool: Vector = value("m/s", "velocity of the tool point, body frame", 3)
    z_t: Vector = value("1", "the tool's z axis, world frame", 3)
    tilt: Vector = value("1", "z_t x hull normal", 3)
    normal: Vector = value("1", "normal into the hull, body frame", 3)
    along: Vector = value("1", "x_t along the hull, body frame", 3)
    across: Vector = value("1", "along the hull and across that, body frame", 3)
    tool_centre: Vector = value("m", "centre of gravity of the tool from the body origin", 3)
    first_moment: Vector = value("kg.m", "mass times its place, of vehicle and tool", 3)
    mass: Matrix = value("kg", "upper left block of M", (3, 3))
    coupling: Matrix = value("kg.m", "upper right block of M", (3, 3))
    inertia: Matrix = value("kg.m2", "lower right block of M", (3, 3))
    q_start: Vector = value("1", "attitude at the start", 4)
    used_up: Matrix = value("kg", "copy of M, used up by its inversion", (6, 6))


class Angles(Record):
    """An attitude as angles."""

    phi: float = value("rad", "roll")
    theta: float = value("rad", "pitch")
    psi: float = value("rad", "yaw")


class ToolMotion(Record):
    """The tool against the hull plane."""

    delta: float = value("m", "penetration of the undeformed brush")
    delta_dot: float = value("m/s", "its rate")
    v_rov: float = value("m/s", "speed at which the hull passes along +x_t")
    misalignment: float = value("rad", "angle between z_t and the normal into the hull")
    tilt_x: float = value("rad", "angle by which the tool is turned about x_t")
    tilt_y: float = value("rad", "angle by which it is turned about y_t")
