"""What the battery is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Packed, Record, input_, output, value

CURRENTS = ("i", "i_other")


class Inputs(Record):
    """Currents drawn at the terminals; negative ones charge."""

    i: float = input_("A", "current that the main consumer draws")
    i_other: float = input_("A", "current of everything else: thrusters, lights, electronics")


class Outputs(Packed):
    """Voltage, state of charge, powers and the energies since the start."""

    V: float = output("V", "voltage at the terminals", depends=CURRENTS)
    V_oc: float = output("V", "open-circuit voltage")
    soc: float = output("1", "state of charge, 1 = full")
    charge: float = output("A.s", "charge drawn since the start")
    P: float = output("W", "power delivered at the terminals", depends=CURRENTS)
    P_loss: float = output("W", "heat made in the cells and leads", depends=CURRENTS)
    empty: float = output("1", "1 when soc is 0 or the voltage has fallen to V_cell_min", CURRENTS, sampled=True)
    W_terminals: float = output("J", "energy delivered at the terminals since the start")
    W_ohmic: float = output("J", "energy lost in the ohmic resistance")
    W_polarisation: float = output("J", "energy lost in the polarisation resistance")
    E_stored: float = output("J", "energy stored, 0 when empty and at rest")
    energy_residual: float = output("J", "energy given off and not accounted for")


class State(Record):
    """What the battery carries from step to step."""

    soc: float = value("1", "state of charge")
    i_1: float = value("A", "current through the polarisation resistance")
    W_terminals: float = value("J", "energy delivered at the terminals")
    W_ohmic: float = value("J", "energy lost in the ohmic resistance")
    W_polarisation: float = value("J", "energy lost in the polarisation resistance")
    E_start: float = value("J", "energy stored at the start")
