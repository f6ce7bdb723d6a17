"""The brush motor as an FMU: names and units only, the equations are in kernel.py."""

from __future__ import annotations

from ..interface import Array, input_, output
from ..slave import ComponentSlave
from . import kernel
from .parameters import Parameters


class DcMotor(ComponentSlave):
    """DC motor with planetary gearbox that turns the brush (Eqs. 16-17)"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-4
    inputs = (
        input_("V_in", "V", "input voltage"),
        input_("T_brush", "N.m", "brush torque on the output shaft about +y_t, negative when it resists"),
    )
    outputs = (
        output("i", "A", "armature current"),
        output("omega_m", "rad/s", "motor shaft speed"),
        output("omega_b", "rad/s", "brush speed"),
        output("T_motor", "N.m", "air-gap torque K_t*i"),
        output("P_electrical", "W", "electrical power taken in", depends=("V_in",)),
        output("P_copper", "W", "loss in the terminal resistance"),
        output("P_friction", "W", "viscous loss on the motor shaft"),
        output("P_gear", "W", "loss in the gearbox", depends=("T_brush",)),
        output("P_shaft", "W", "power delivered to the brush, -T_brush*omega_b", depends=("T_brush",)),
        output("W_electrical", "J", "electrical energy taken in since the start"),
        output("W_copper", "J", "energy lost in the terminal resistance"),
        output("W_friction", "J", "energy lost to viscous friction"),
        output("W_gear", "J", "energy lost in the gearbox"),
        output("W_shaft", "J", "energy delivered to the brush"),
        output("E_stored", "J", "energy in the inductance, the rotor and the brush inertia"),
        output("energy_residual", "J", "energy taken in and not accounted for; zero when K_e = K_t"),
    )
    arrays = (Array("x", 8),)
