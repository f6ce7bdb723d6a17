"""The sensors as an FMU: names only; the variables are in records.py, the equations in kernel.py."""

from __future__ import annotations

from ..declare.interface_of import arrays_of, variables_of
from ..python.slave import ComponentSlave
from . import kernel
from .parameters import Parameters
from .records import Inputs, Outputs, Scratch, State


class RovSensors(ComponentSlave):
    """Sensors of the vehicle: DVL, position, depth, attitude, gyro, accelerometer and tool force, with their errors"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-3
    inputs = variables_of(Inputs)
    outputs = variables_of(Outputs)
    arrays = arrays_of(State, Scratch)
