"""What the frame is given and what it tells, each with unit and description. It remembers nothing."""

from __future__ import annotations

from ..declare.record import Packed, Record, Vector, input_, output, value

TOOLS = 3
PLACE = ("tilt_x", "tilt_y")


class Inputs(Record):
    """How the frame stands to the hull and moves, and what acts on each tool."""

    delta: float = input_("m", "penetration of the undeformed tool at the frame's point")
    delta_dot: float = input_("m/s", "its rate")
    v_rov: float = input_("m/s", "speed at which the hull passes the frame's point along +x_t")
    tilt_x: float = input_("rad", "turn of the frame against the hull about x_t", minimum=-1.5, maximum=1.5)
    tilt_y: float = input_("rad", "turn of the frame against the hull about y_t", minimum=-1.5, maximum=1.5)
    p: float = input_("rad/s", "rate of the frame about x_t")
    q: float = input_("rad/s", "rate of the frame about y_t")
    r: float = input_("rad/s", "rate of the frame about z_t")
    F_x_tool: Vector = input_("N", "force on each tool along x_t", size=TOOLS)
    F_y_tool: Vector = input_("N", "force on each tool along y_t", size=TOOLS)
    F_z_tool: Vector = input_("N", "force on each tool along z_t", size=TOOLS)
    M_x_tool: Vector = input_("N.m", "moment on each tool about x_t, at its own place", size=TOOLS)
    M_y_tool: Vector = input_("N.m", "moment on each tool about y_t, at its own place", size=TOOLS)
    M_z_tool: Vector = input_("N.m", "moment on each tool about z_t, at its own place", size=TOOLS)
    H_y_tool: Vector = input_("N.m.s", "spin momentum of each tool about y_t", size=TOOLS)
    H_z_tool: Vector = input_("N.m.s", "spin momentum of each tool about z_t", size=TOOLS)


class Outputs(Packed):
    """The wrench of all tools together at the frame's point, and how each tool stands to the hull and moves."""

    misalignment: float = output(
        "rad", "angle of the normal into the hull from z_t, about +y_t, as a cup brush takes it", ("tilt_y",)
    )
    F_x: float = output("N", "force of all tools along x_t", ("F_x_tool",))
    F_y: float = output("N", "force of all tools along y_t", ("F_y_tool",))
    F_z: float = output("N", "force of all tools along z_t", ("F_z_tool",))
    M_x: float = output("N.m", "moment of all tools about x_t", ("M_x_tool", "F_z_tool"))
    M_y: float = output("N.m", "moment of all tools about y_t", ("M_y_tool", "F_z_tool"))
    M_z: float = output("N.m", "moment of all tools about z_t", ("M_z_tool", "F_x_tool", "F_y_tool"))
    H_y: float = output("N.m.s", "spin momentum of all tools about y_t", ("H_y_tool",))
    H_z: float = output("N.m.s", "spin momentum of all tools about z_t", ("H_z_tool",))
    delta_tool: Vector = output("m", "penetration of each undeformed tool", ("delta", *PLACE), size=TOOLS)
    delta_dot_tool: Vector = output("m/s", "its rate", ("delta_dot", "p", "q", "r", *PLACE), size=TOOLS)
    v_rov_tool: Vector = output(
        "m/s", "speed at which the hull passes each tool along +x_t", ("v_rov", "r"), size=TOOLS
    )


class Normal(Record):
    """The unit normal into the hull, seen from the frame."""

    x: float = value("1", "along x_t")
    y: float = value("1", "along y_t")
    z: float = value("1", "along z_t")
