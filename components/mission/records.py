"""What a cleaning pass is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Packed, Record, Vector, input_, output, value


class Inputs(Record):
    """Where the vehicle is."""

    x_n: float = input_("m", "position north", sampled=True)
    y_n: float = input_("m", "position east", sampled=True)
    z_n: float = input_("m", "position down", sampled=True)


class Outputs(Packed):
    """Set-points, and the friction of the hull where the vehicle is."""

    x_ref: float = output("m", "position set-point north", sampled=True)
    y_ref: float = output("m", "position set-point east", sampled=True)
    z_ref: float = output("m", "position set-point down", sampled=True)
    v_ref: Vector = output("m/s", "velocity of the position set-point, world frame", size=3, sampled=True)
    F_n_ref: float = output("N", "force to press into the hull with; 0: position only", sampled=True)
    phase: float = output("1", "0 wait, 1 approach, 2 hold, 3 clean, 4 hold, 5 release, 6 leave, 7 done", sampled=True)
    friction_scale: float = output("1", "factor on the friction of the hull where the vehicle is", sampled=True)
    s: float = output("m", "way along the pass", ("x_n", "y_n", "z_n"), sampled=True)


class State(Record):
    """Set-points of the last sample, held until the next."""

    start: Vector = value("m", "position at time 0, world frame", 3)
    position: Vector = value("m", "position set-point, world frame", 3)
    velocity: Vector = value("m/s", "its velocity, world frame", 3)
    sample: float = value("1", "number of the next sample, -1 before the first")
    F_n: float = value("N", "force set-point")
    phase: float = value("1", "phase of the pass")
    friction_scale: float = value("1", "friction scale at the last step's begin")


class Stretch(Record):
    """A stretch that is covered at a constant speed, at some time."""

    way: float = value("m", "way covered")
    speed: float = value("m/s", "present speed along it")
    end: float = value("s", "time at its end")


class Times(Record):
    """When the phases of the pass begin."""

    touched: float = value("s", "first touch of the hull")
    clean: float = value("s", "begin of the pass")
    passed: float = value("s", "end of the pass")
    release: float = value("s", "the force begins to go back")
    leave: float = value("s", "the vehicle begins to leave")
    done: float = value("s", "it has left")
