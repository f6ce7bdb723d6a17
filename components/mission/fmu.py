"""A cleaning pass as an FMU: names and units only, the equations are in kernel.py."""

from __future__ import annotations

from ..interface import Array, input_, output
from ..slave import ComponentSlave
from . import kernel
from .parameters import Parameters

POSITION = {"x": "north", "y": "east", "z": "down"}


class Mission(ComponentSlave):
    """Set-points of a cleaning pass (approach, clean, leave) and the fouling of the hull along it"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-3
    inputs = tuple(input_(f"{name}_n", "m", f"position {text}", sampled=True) for name, text in POSITION.items())
    outputs = (
        *(output(f"{name}_ref", "m", f"position set-point {text}", sampled=True) for name, text in POSITION.items()),
        output("v_ref", "m/s", "velocity of the position set-point, world frame", size=3, sampled=True),
        output("F_n_ref", "N", "force to press into the hull with; 0: position only", sampled=True),
        output("phase", "1", "0 wait, 1 approach, 2 hold, 3 clean, 4 hold, 5 release, 6 leave, 7 done", sampled=True),
        output("friction_scale", "1", "factor on the friction of the hull where the vehicle is", sampled=True),
        output("s", "m", "way along the pass", ("x_n", "y_n", "z_n"), sampled=True),
    )
    arrays = (Array("start", 3), Array("memory", 10), Array("v_ref", 3, scratch=True))
