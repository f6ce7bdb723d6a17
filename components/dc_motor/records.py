"""What the brush motor is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Packed, Record, input_, output, value


class Inputs(Record):
    """What acts on the motor at its two ends."""

    V_in: float = input_("V", "input voltage")
    T_brush: float = input_("N.m", "brush torque on the output shaft about +y_t, negative when it resists")


class Outputs(Packed):
    """Current, speeds, powers and the energies since the start."""

    i: float = output("A", "armature current")
    omega_m: float = output("rad/s", "motor shaft speed")
    omega_b: float = output("rad/s", "brush speed")
    T_motor: float = output("N.m", "air-gap torque K_t*i")
    P_electrical: float = output("W", "electrical power taken in", depends=("V_in",))
    P_copper: float = output("W", "loss in the terminal resistance")
    P_friction: float = output("W", "viscous loss on the motor shaft")
    P_gear: float = output("W", "loss in the gearbox", depends=("T_brush",))
    P_shaft: float = output("W", "power delivered to the brush, -T_brush*omega_b", depends=("T_brush",))
    W_electrical: float = output("J", "electrical energy taken in since the start")
    W_copper: float = output("J", "energy lost in the terminal resistance")
    W_friction: float = output("J", "energy lost to viscous friction")
    W_gear: float = output("J", "energy lost in the gearbox")
    W_shaft: float = output("J", "energy delivered to the brush")
    E_stored: float = output("J", "energy in the inductance, the rotor and the brush inertia")
    energy_residual: float = output("J", "energy taken in and not accounted for; zero when K_e = K_t")
    H_spin: float = output("N.m.s", "spin momentum of brush and rotor about +y_t")
    T_housing: float = output("N.m", "torque of the motor housing on the vehicle about +y_t", depends=("T_brush",))
    J_housing: float = output("N.m.s", "angular impulse of T_housing since the start, exactly")


class State(Record):
    """What the motor carries from step to step."""

    i: float = value("A", "armature current")
    omega_m: float = value("rad/s", "motor shaft speed")
    W_electrical: float = value("J", "electrical energy taken in")
    W_copper: float = value("J", "energy lost in the terminal resistance")
    W_friction: float = value("J", "energy lost to viscous friction")
    W_gear: float = value("J", "energy lost in the gearbox")
    W_shaft: float = value("J", "energy delivered to the brush")
    E_start: float = value("J", "energy stored at the start")
    J_brush: float = value("N.m.s", "angular impulse of the brush torque")
    H_start: float = value("N.m.s", "spin momentum at the start")


class Change(Record):
    """Rates of the state, or its increments over a step; those of the energies are the powers."""

    i: float = value("A/s", "armature current")
    omega_m: float = value("rad/s2", "motor shaft speed")
    W_electrical: float = value("W", "electrical power taken in")
    W_copper: float = value("W", "loss in the terminal resistance")
    W_friction: float = value("W", "viscous loss on the motor shaft")
    W_gear: float = value("W", "loss in the gearbox")
    W_shaft: float = value("W", "power delivered to the brush")
