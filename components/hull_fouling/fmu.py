"""The hull as an FMU: names only; the variables are in records.py, the equations in kernel.py."""

from __future__ import annotations

from ..declare.interface_of import arrays_of, variables_of
from ..python.slave import ComponentSlave
from . import kernel
from .parameters import Parameters
from .records import Inputs, Outputs, State


class HullFouling(ComponentSlave):
    """Hull along a pass: fouling that wears off under the brush, and a map of what was done to each place"""

    parameters = Parameters
    kernel = kernel
    default_step = 0.05
    inputs = variables_of(Inputs)
    outputs = variables_of(Outputs)
    arrays = arrays_of(State)
