"""The hull under a brush: what is done to each of its cells, and what is left of what grows there.

Symbols are those of README.md, names and units those of records.py.
"""

from math import pi, sqrt

from ..library.table import straight
from .parameters import Parameters
from .records import Contact, Inputs, Outputs, State


def setup(p: Parameters, x: State, y: Outputs) -> None:
    """What grows on each cell."""
    for i in range(50):
        y.place[i] = p.place_start + (i + 0.5) * p.cell_length
        x.scale[i] = straight(y.place[i], p.fouling_place, p.fouling_scale, 8)
        x.removal[i] = straight(y.place[i], p.fouling_place, p.removal_work, 8)


def half_contact(delta: float, p: Parameters) -> float:
    """Half the length on which undeformed tips touch; the hull's work needs a length also where they have just left."""
    half = 0.5 * p.cell_length
    if delta > 0.0:
        depth = min(delta, p.R_brush)
        half = max(half, sqrt(depth * (2.0 * p.R_brush - depth)))  # Eq. F1
    return half


def gathered(z: float, half: float) -> float:
    """Integral, from far below to z, of the share of an even contact about 0 that lies below."""
    area = 0.0
    if z >= half:
        area = z
    elif z > -half:
        area = (z + half) * (z + half) / (4.0 * half)
    return area


def share_below(place: float, c: Contact) -> float:
    """Share of the contact below a place, in the mean over a step in which the brush goes on evenly."""
    way = c.s_1 - c.s_0
    if abs(way) > 1e-6 * c.half:
        share = (gathered(place - c.s_0, c.half) - gathered(place - c.s_1, c.half)) / way  # Eq. F2
    else:
        share = min(max(0.5 + 0.5 * (place - c.s_1) / c.half, 0.0), 1.0)
    return share


def left(i: int, x: State) -> float:
    """Share of the fouling that is left on a cell."""
    phi = max(0.0, 1.0 - x.sheared[i] / x.removal[i])  # Eq. F4
    return phi


def friction_under(c: Contact, p: Parameters, x: State) -> float:
    """Mean of the friction scale under the brush where it stands at the end of a step."""
    here = Contact(c.s_1, c.s_1, c.half, c.speed, c.rate, c.work, c.load)
    below = share_below(p.place_start, here)
    total = 0.0
    inside = 0.0
    for i in range(50):
        above = share_below(p.place_start + (i + 1) * p.cell_length, here)
        total = total + (above - below) * (1.0 + left(i, x) * (x.scale[i] - 1.0))  # Eq. F5
        inside = inside + (above - below)
        below = above
    return total + (1.0 - inside) * straight(c.s_1, p.fouling_place, p.fouling_scale, 8)


def place_of(u: Inputs, p: Parameters, x: State) -> float:
    """Place of the brush axis."""
    place = u.s + p.offset
    if p.by_speed:
        place = place + x.way
    return place


def contact_of(u: Inputs, p: Parameters, x: State) -> Contact:
    """The brush on the hull in this step."""
    speed = 0.0
    rate = 0.0
    if u.delta > 0.0:
        speed = abs(u.omega_b * p.R_brush - u.v_rov)
        rate = p.n * abs(u.omega_b) / (2.0 * pi)
    return Contact(
        s_0=x.at,
        s_1=place_of(u, p, x),
        half=half_contact(u.delta, p),
        speed=speed,
        rate=rate,
        work=u.W_friction - x.W_last,
        load=abs(u.F_z),
    )


def initialize(u: Inputs, p: Parameters, x: State) -> None:
    """Nothing has been touched."""
    for i in range(50):
        x.slid[i] = 0.0
        x.sheared[i] = 0.0
        x.pressed[i] = 0.0
        x.struck[i] = 0.0
        x.visits[i] = 0.0
        x.touched[i] = -1e9
    x.W_last = u.W_friction
    x.W_cells = 0.0
    x.W_beyond = 0.0
    x.way = 0.0
    x.at = place_of(u, p, x)
    c = contact_of(u, p, x)
    x.friction = friction_under(c, p, x)


def outputs(p: Parameters, x: State, y: Outputs) -> None:
    """Write the map and the sums."""
    y.friction_scale = x.friction
    y.W_cells = x.W_cells
    y.W_beyond = x.W_beyond
    y.cleaned = 0.0
    for i in range(50):
        y.place[i] = p.place_start + (i + 0.5) * p.cell_length
        y.sliding[i] = x.slid[i]
        y.shear_work[i] = x.sheared[i]
        y.normal_work[i] = x.pressed[i]
        y.strikes[i] = x.struck[i]
        y.passes[i] = x.visits[i]
        y.fouling[i] = left(i, x)
        if y.fouling[i] <= 0.0:
            y.cleaned = y.cleaned + p.cell_length


def come(t: float, h: float, i: int, p: Parameters, x: State) -> None:
    """A cell is under the brush in a step from t on; however long that is, the next step goes on where it ends."""
    if t - x.touched[i] > p.pass_gap:
        x.visits[i] = x.visits[i] + 1.0
    x.touched[i] = t + h


def step(t: float, h: float, u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Part what the brush does in the step among the cells, by the time that each lies under it."""
    x.way = x.way + u.v_rov * h
    c = contact_of(u, p, x)
    area = p.cell_length * p.track_width
    below = share_below(p.place_start, c)
    done = 0.0
    for i in range(50):
        above = share_below(p.place_start + (i + 1) * p.cell_length, c)
        share = above - below
        below = above
        if share < 1e-9:
            share = 0.0  # rounding, far from the brush
        time = share * h * 2.0 * c.half / p.cell_length
        x.slid[i] = x.slid[i] + c.speed * time
        x.struck[i] = x.struck[i] + c.rate * time
        x.sheared[i] = x.sheared[i] + share * c.work / area  # Eq. F3
        x.pressed[i] = x.pressed[i] + share * c.load * c.speed * h / area
        done = done + share * c.work
        if share > 0.0 and c.speed > 0.0:
            come(t, h, i, p, x)
    x.W_cells = x.W_cells + done
    x.W_beyond = x.W_beyond + (c.work - done)
    x.W_last = u.W_friction
    x.at = c.s_1
    x.friction = friction_under(c, p, x)
    outputs(p, x, y)
