"""The vehicle as an FMU: names and units only, the equations are in kernel.py and the files it imports."""

from __future__ import annotations

from ..interface import Array, Shape, input_, output
from ..slave import ComponentSlave
from . import kernel
from .parameters import Parameters

TOOL = ("F_x", "F_y", "F_z", "M_x", "M_y", "M_z")
POSITION = {"x_n": "position north", "y_n": "position east", "z_n": "position down"}
ATTITUDE = {"phi": "roll angle", "theta": "pitch angle", "psi": "yaw angle"}
VELOCITY, RATES = {"u": "surge", "v": "sway", "w": "heave"}, {"p": "roll", "q": "pitch", "r": "yaw"}
WORK = {"W_thruster": "work of the thrusters", "W_tool": "work of the tool", "W_external": "work of further wrenches",
        "W_current": "work of the moving water", "W_damping": "energy lost to damping", "E_kinetic": "kinetic energy",
        "E_potential": "energy of weight and buoyancy", "energy_residual": "unaccounted energy"}  # fmt: skip
STATE: dict[str, Shape] = {"x": 18, "thrust_state": 8, "current": 3, "energy_start": 1, "B": (6, 8), "M": (6, 6),
                           "M_inv": (6, 6), "D": (2, 6), "lever": 3}  # fmt: skip
SCRATCH: dict[str, Shape] = {
    "quat": 4, "thrust": 8, "F_control": 3, "M_control": 3, "F_disturb": 3, "M_disturb": 3, "tau_external": 6,
    "tau_control": 6, "tau_disturb": 6, "R": 9, "v_water": 3, "force": 15, "stage": 18, "k": 18, "increment": 18,
    "work": 36,
}  # fmt: skip


class RovVehicle(ComponentSlave):
    """Underwater vehicle in six degrees of freedom with eight thrusters and a tool (Eqs. 18-21)"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-3
    inputs = (
        input_("u_thruster", "1", "thruster commands; beyond -1 and 1 they saturate", size=8),
        *(input_(name, "N", f"force on the tool along {name[-1]}_t") for name in TOOL[:3]),
        *(input_(name, "N.m", f"moment on the tool about {name[-1]}_t") for name in TOOL[3:]),
        input_("F_external", "N", "further force on the vehicle, body frame", size=3),
        input_("M_external", "N.m", "further moment about the body origin, body frame", size=3),
        input_("v_c", "m/s", "velocity of the water, world frame", size=3),
    )
    outputs = (
        *(output(name, "m", text) for name, text in POSITION.items()),
        *(output(name, "rad", text) for name, text in ATTITUDE.items()),
        *(output(name, "m/s", f"{text} velocity over ground, body frame") for name, text in VELOCITY.items()),
        *(output(name, "rad/s", f"{text} rate, body frame") for name, text in RATES.items()),
        output("quat", "1", "attitude quaternion, body to world, scalar first", size=4),
        output("delta", "m", "penetration of the undeformed brush into the hull plane"),
        output("delta_dot", "m/s", "rate of delta"),
        output("v_rov", "m/s", "speed at which the hull passes under the tool along +x_t"),
        output("misalignment", "rad", "angle between z_t and the normal into the hull"),
        output("thrust", "N", "thrust of each thruster", size=8),
        output("F_control", "N", "force of the thrusters, body frame", size=3),
        output("M_control", "N.m", "moment of the thrusters, body frame", size=3),
        output("F_disturb", "N", "force of the tool, body frame", TOOL[:3], size=3),
        output("M_disturb", "N.m", "moment of the tool about the body origin, body frame", TOOL, size=3),
        output("P_thruster", "W", "power of the thrusters on the vehicle"),
        output("P_tool", "W", "power of the tool wrench on the vehicle", TOOL),
        output("P_damping", "W", "power lost to damping", ("v_c",)),
        *(output(name, "J", text) for name, text in WORK.items()),
    )
    arrays = tuple(Array(name, shape, name in SCRATCH) for name, shape in (STATE | SCRATCH).items())
