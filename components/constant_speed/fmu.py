"""The drive that holds its speed as an FMU: names and units only, the equations are in kernel.py."""

from __future__ import annotations

from ..interface import Array, input_, output
from ..slave import ComponentSlave
from . import kernel
from .parameters import Parameters


class ConstantSpeed(ComponentSlave):
    """Drive that turns the brush at a speed which no load changes; connects as dc_motor does"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-4
    inputs = (
        input_("V_in", "V", "input voltage", start=12.0),
        input_("T_brush", "N.m", "brush torque on the output shaft about +y_t, negative when it resists"),
    )
    outputs = (
        output("omega_b", "rad/s", "brush speed", depends=("V_in",)),
        output("P_electrical", "W", "electrical power taken in, without losses", depends=("V_in", "T_brush")),
        output("P_shaft", "W", "power delivered to the brush, -T_brush*omega_b", depends=("V_in", "T_brush")),
        output("W_electrical", "J", "electrical energy taken in since the start"),
        output("W_shaft", "J", "energy delivered to the brush"),
    )
    arrays = (Array("x", 1),)
