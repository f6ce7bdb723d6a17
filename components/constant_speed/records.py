"""What the drive is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Packed, Record, input_, output, value


class Inputs(Record):
    """What acts on the drive at its two ends."""

    V_in: float = input_("V", "input voltage", start=12.0)
    T_brush: float = input_("N.m", "brush torque on the output shaft about +y_t, negative when it resists")


class Outputs(Packed):
    """Speed, powers and energies."""

    omega_b: float = output("rad/s", "brush speed", depends=("V_in",))
    P_electrical: float = output("W", "electrical power taken in, without losses", depends=("V_in", "T_brush"))
    P_shaft: float = output("W", "power delivered to the brush, -T_brush*omega_b", depends=("V_in", "T_brush"))
    W_electrical: float = output("J", "electrical energy taken in since the start")
    W_shaft: float = output("J", "energy delivered to the brush")
    H_spin: float = output("N.m.s", "spin momentum of the brush about +y_t", depends=("V_in",))
    T_housing: float = output("N.m", "torque of the motor housing on the vehicle about +y_t", depends=("T_brush",))
    J_housing: float = output(
        "N.m.s", "rises by the angular impulse of T_housing exactly, jumps of the speed included", depends=("V_in",)
    )


class State(Record):
    """What the drive carries from step to step."""

    W_shaft: float = value("J", "energy delivered to the brush")
    J_brush: float = value("N.m.s", "angular impulse of the brush torque")
