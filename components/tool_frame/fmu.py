"""The frame of several tools as an FMU: names only; the variables are in records.py, the equations in kernel.py."""

from __future__ import annotations

from ..declare.interface_of import variables_of
from ..python.slave import ComponentSlave
from . import kernel
from .parameters import Parameters
from .records import Inputs, Outputs


class ToolFrame(ComponentSlave):
    """Rigid frame that carries up to three tools: sums their wrenches, and tells each how it stands and moves"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-4
    inputs = variables_of(Inputs)
    outputs = variables_of(Outputs)
    arrays = ()
