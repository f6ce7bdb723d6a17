"""What the body is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ...declare.record import Packed, Record, input_, output, value


class Inputs(Record):
    """What acts on the body; an input keeps its value over a communication step."""

    F: float = input_("N", "force that pushes it")


class Outputs(Packed):
    """Motion, power and the energies since the start."""

    v: float = output("m/s", "speed")
    s: float = output("m", "way since the start")
    P: float = output("W", "power of the force", depends=("F",))
    W_in: float = output("J", "work of the force since the start")
    W_drag: float = output("J", "energy lost to the drag")
    E_kinetic: float = output("J", "kinetic energy")
    energy_residual: float = output("J", "energy taken in and not accounted for")


class State(Record):
    """What the body carries from step to step."""

    v: float = value("m/s", "speed")
    s: float = value("m", "way since the start")
    W_in: float = value("J", "work of the force")
    W_drag: float = value("J", "energy lost to the drag")
    E_start: float = value("J", "kinetic energy at the start")
