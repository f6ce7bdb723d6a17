"""The controller as an FMU: names only; the variables are in records.py, the equations in kernel.py."""

from __future__ import annotations

from ..declare.interface_of import arrays_of, variables_of
from ..python.slave import ComponentSlave
from . import kernel
from .parameters import Parameters
from .records import Inputs, Outputs, Scratch, State


class RovController(ComponentSlave):
    """Cascaded PID, with feedforward of the tool wrench or force control along the hull normal on choice"""

    parameters = Parameters
    kernel = kernel
    default_step = 0.02
    inputs = variables_of(Inputs)
    outputs = variables_of(Outputs)
    arrays = arrays_of(State, Scratch)
