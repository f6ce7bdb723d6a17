"""The controller as an FMU: names and units only, the equations are in kernel.py and the files it imports."""

from __future__ import annotations

from ..interface import Array, Shape, input_, output
from ..slave import ComponentSlave
from . import kernel
from .parameters import Parameters

POSITION = {"x": "north", "y": "east", "z": "down"}
ATTITUDE = {"phi": "roll", "theta": "pitch", "psi": "yaw"}
VELOCITY = {"u": "surge", "v": "sway", "w": "heave"}
RATES = {"p": "roll", "q": "pitch", "r": "yaw"}
STATE: dict[str, Shape] = {"B": (6, 8), "B_pinv": (8, 6), "integral": 6, "nu_last": 6, "command": 8,
                           "memory": 12, "wrench": 6}  # fmt: skip
SCRATCH: dict[str, Shape] = {
    "e": 6, "nu": 6, "tau": 6, "F": 8, "gains": (3, 6), "work": 72, "u_thruster": 8, "F_ref": 3, "M_ref": 3,
}  # fmt: skip


class RovController(ComponentSlave):
    """Cascaded PID, with feedforward of the tool wrench or force control along the hull normal on choice"""

    parameters = Parameters
    kernel = kernel
    default_step = 0.02
    inputs = (
        *(input_(f"{name}_n", "m", f"measured position {text}", sampled=True) for name, text in POSITION.items()),
        *(input_(name, "rad", f"measured {text} angle", sampled=True) for name, text in ATTITUDE.items()),
        *(input_(name, "m/s", f"{text} velocity, body frame", sampled=True) for name, text in VELOCITY.items()),
        *(input_(name, "rad/s", f"measured {text} rate, body frame", sampled=True) for name, text in RATES.items()),
        *(input_(f"{name}_ref", "m", f"position set-point {text}", sampled=True) for name, text in POSITION.items()),
        *(input_(f"{name}_ref", "rad", f"{text} angle set-point", sampled=True) for name, text in ATTITUDE.items()),
        input_("v_ref", "m/s", "velocity of the position set-point, world frame", size=3, sampled=True),
        input_("V_ref", "V", "set-point of the brush motor voltage", start=12.0, sampled=True),
        input_("F_n_ref", "N", "force to press into the hull with; 0: position only", minimum=0.0, sampled=True),
        input_("F_tool", "N", "measured force of the tool on the vehicle, body frame", size=3, sampled=True),
        input_("M_tool", "N.m", "measured moment of the tool about the body origin", size=3, sampled=True),
    )
    outputs = (
        output("u_thruster", "1", "thruster commands, -1 to 1", size=8, sampled=True),
        output("V_in", "V", "brush motor voltage", sampled=True),
        output("F_ref", "N", "requested force, body frame", size=3, sampled=True),
        output("M_ref", "N.m", "requested moment, body frame", size=3, sampled=True),
        output("saturated", "1", "1 when the thrusters cannot give the requested wrench", sampled=True),
        output("saturation_count", "1", "number of samples in which they could not", sampled=True),
        output("F_n", "N", "measured force into the hull, filtered", sampled=True),
        output("pressing", "1", "1 while the force along the hull normal is controlled", sampled=True),
    )
    arrays = tuple(Array(name, shape, name in SCRATCH) for name, shape in (STATE | SCRATCH).items())
