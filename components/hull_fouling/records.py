"""What the hull is given, what it tells and what it remembers, each with unit and description."""

from __future__ import annotations

from ..declare.record import Packed, Record, Vector, calculated, input_, output, value

CELLS = 50


class Inputs(Record):
    """Where the brush is, how it turns, and what it does."""

    s: float = input_("m", "place along the pass")
    delta: float = input_("m", "penetration of the undeformed brush into the hull")
    omega_b: float = input_("rad/s", "brush speed")
    v_rov: float = input_("m/s", "speed of the hull past the tool along +x_t")
    F_z: float = input_("N", "normal force on the brush")
    W_friction: float = input_("J", "energy that the brush has lost in friction since the start")


class Outputs(Packed):
    """The friction under the brush, sums, and the map: a value for each cell."""

    friction_scale: float = output("1", "factor on the friction of the hull under the brush")
    W_cells: float = output("J", "friction work done on the cells")
    W_beyond: float = output("J", "friction work done beyond the first and the last cell")
    cleaned: float = output("m", "length on which nothing is left of the fouling")
    place: Vector = calculated("m", "middle of each cell", size=CELLS)
    sliding: Vector = output("m", "way of the tips past each cell while it lay under the brush", size=CELLS)
    shear_work: Vector = output("J/m2", "friction work per area", size=CELLS)
    normal_work: Vector = output("J/m2", "normal force times way of the tips, per area", size=CELLS)
    strikes: Vector = output("1", "filaments that have passed over each point", size=CELLS)
    passes: Vector = output("1", "how often the brush has come", size=CELLS)
    fouling: Vector = output("1", "share of the fouling that is left", size=CELLS)


class State(Record):
    """The map, and where the brush was."""

    scale: Vector = value("1", "friction scale of the untouched hull", CELLS)
    removal: Vector = value("J/m2", "shear work per area that removes the fouling", CELLS)
    slid: Vector = value("m", "way of the tips", CELLS)
    sheared: Vector = value("J/m2", "friction work per area", CELLS)
    pressed: Vector = value("J/m2", "normal force times way, per area", CELLS)
    struck: Vector = value("1", "filaments that have passed", CELLS)
    visits: Vector = value("1", "passes", CELLS)
    touched: Vector = value("s", "when the cell was last under the brush", CELLS)
    at: float = value("m", "place of the brush axis")
    way: float = value("m", "way that the hull has passed the tool")
    friction: float = value("1", "friction scale under the brush")
    W_last: float = value("J", "friction work of the brush when the last step began")
    W_cells: float = value("J", "friction work on the cells")
    W_beyond: float = value("J", "friction work beyond them")


class Contact(Record):
    """The brush on the hull in a step."""

    s_0: float = value("m", "place of its axis where the step begins")
    s_1: float = value("m", "where it ends")
    half: float = value("m", "half the length on which tips touch")
    speed: float = value("m/s", "speed of the tips over the hull, 0 off it")
    rate: float = value("1/s", "filaments that pass over a point, 0 off the hull")
    work: float = value("J", "friction work of the step")
    load: float = value("N", "normal force")
