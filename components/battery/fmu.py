"""The battery as an FMU: names only; the variables are in records.py, the equations in kernel.py."""

from __future__ import annotations

from ..declare.interface_of import arrays_of, variables_of
from ..python.slave import ComponentSlave
from . import kernel
from .parameters import Parameters
from .records import Inputs, Outputs, State


class Battery(ComponentSlave):
    """Lithium-ion battery with open-circuit voltage, internal resistance, polarisation and charge (Thevenin model)"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-4
    inputs = variables_of(Inputs)
    outputs = variables_of(Outputs)
    arrays = arrays_of(State)
