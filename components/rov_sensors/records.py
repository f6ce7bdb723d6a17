"""What the sensors are given, what they tell and what they remember, each with unit and description."""

from __future__ import annotations

from ..declare.record import Matrix, Packed, Record, Vector, input_, output, value

SENSORS = 7
CHANNELS = 21
ROWS = 512  # in the ring: a second at 500 Hz, and some more
FELT = ("phi", "theta", "p", "q", "r", "nu_dot")  # by the accelerometer


class Inputs(Record):
    """The truth: what the vehicle tells of its motion, and the wrench between tool and vehicle."""

    x_n: float = input_("m", "position north")
    y_n: float = input_("m", "position east")
    z_n: float = input_("m", "position down")
    phi: float = input_("rad", "roll angle")
    theta: float = input_("rad", "pitch angle")
    psi: float = input_("rad", "yaw angle")
    u: float = input_("m/s", "surge velocity over ground, body frame")
    v: float = input_("m/s", "sway velocity over ground, body frame")
    w: float = input_("m/s", "heave velocity over ground, body frame")
    p: float = input_("rad/s", "roll rate, body frame")
    q: float = input_("rad/s", "pitch rate, body frame")
    r: float = input_("rad/s", "yaw rate, body frame")
    nu_dot: Vector = input_(
        "m/s2",
        "acceleration of the body origin over ground (omega x v is in it); 4 to 6: angular [rad/s2]; body axes",
        size=6,
    )
    F_tool: Vector = input_("N", "force of the tool on the vehicle, body frame", size=3)
    M_tool: Vector = input_("N.m", "moment of the tool about the body origin", size=3)


class Outputs(Packed):
    """What the sensors show, under the names of the truth."""

    u_m: float = output("m/s", "measured surge velocity over ground (DVL), body frame", ("u",))
    v_m: float = output("m/s", "measured sway velocity over ground (DVL), body frame", ("v",))
    w_m: float = output("m/s", "measured heave velocity over ground (DVL), body frame", ("w",))
    x_n_m: float = output("m", "measured position north", ("x_n",))
    y_n_m: float = output("m", "measured position east", ("y_n",))
    z_n_m: float = output("m", "measured position down (depth sensor)", ("z_n",))
    phi_m: float = output("rad", "measured roll angle", ("phi",))
    theta_m: float = output("rad", "measured pitch angle", ("theta",))
    psi_m: float = output("rad", "measured yaw angle", ("psi",))
    p_m: float = output("rad/s", "measured roll rate (gyro), body frame", ("p",))
    q_m: float = output("rad/s", "measured pitch rate (gyro), body frame", ("q",))
    r_m: float = output("rad/s", "measured yaw rate (gyro), body frame", ("r",))
    f_m: Vector = output("m/s2", "measured specific force at the accelerometer, body frame", FELT, size=3)
    F_tool_m: Vector = output("N", "measured force of the tool on the vehicle, body frame", ("F_tool",), size=3)
    M_tool_m: Vector = output("N.m", "measured moment of the tool about the body origin", ("M_tool",), size=3)


class Channels(Packed):
    """One number for each channel, in the order of the outputs."""

    u: float = value("m/s", "surge velocity")
    v: float = value("m/s", "sway velocity")
    w: float = value("m/s", "heave velocity")
    x_n: float = value("m", "position north")
    y_n: float = value("m", "position east")
    z_n: float = value("m", "position down")
    phi: float = value("rad", "roll angle")
    theta: float = value("rad", "pitch angle")
    psi: float = value("rad", "yaw angle")
    p: float = value("rad/s", "roll rate")
    q: float = value("rad/s", "pitch rate")
    r: float = value("rad/s", "yaw rate")
    f: Vector = value("m/s2", "specific force", 3)
    F_tool: Vector = value("N", "force of the tool", 3)
    M_tool: Vector = value("N.m", "moment of the tool", 3)


class Sensors(Packed):
    """One number for each sensor, in the order of their channels."""

    dvl: float = value("1", "Doppler velocity log")
    position: float = value("1", "position")
    depth: float = value("1", "depth sensor")
    attitude: float = value("1", "attitude")
    gyro: float = value("1", "gyro")
    accelerometer: float = value("1", "accelerometer")
    force: float = value("1", "force and torque sensor")


class State(Record):
    """The settings by sensor and by channel, and the samples that are on their way."""

    channels: Vector = value("1", "number of channels of each sensor", SENSORS)
    period: Vector = value("s", "time between two samples, 0 = one at every communication point", SENSORS)
    latency: Vector = value("s", "time from a sample to its arrival", SENSORS)
    scale: Vector = value("1", "reading per truth", SENSORS)
    dropout: Vector = value("1", "probability that a sample is lost", SENSORS)
    noise: Vector = value("1", "standard deviation of each channel", CHANNELS)
    bias: Vector = value("1", "what each channel reads at 0", CHANNELS)
    quantum: Vector = value("1", "step between two readings, 0 = none", CHANNELS)
    wraps: Vector = value("1", "1 for an angle that begins again behind pi", CHANNELS)
    start: Vector = value("1", "readings at the start", CHANNELS)
    first: Vector = value("1", "number of the first sample of each sensor", SENSORS)
    next: Vector = value("1", "number of the next sample", SENSORS)
    before: Vector = value("1", "number of the sample before the instant that is shown; without a period only", SENSORS)
    ring: Matrix = value("1", "samples; number k stands in row k mod 512", (ROWS, CHANNELS))
    times: Matrix = value("s", "when they were taken; without a period only", (ROWS, SENSORS))


class Scratch(Record):
    """What lives within one call."""

    sensors: Sensors = value("", "a setting by sensor")
    settings: Channels = value("", "a setting by channel")
    truth: Channels = value("", "the truth")
    shown: Channels = value("", "what arrives")
    f: Vector = value("m/s2", "specific force where the accelerometer sits, body frame", 3)
    alpha: Vector = value("rad/s2", "angular acceleration, body frame", 3)
    across: Vector = value("m/s", "velocity of the accelerometer about the body origin", 3)
