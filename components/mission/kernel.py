"""A cleaning pass as set-points over time, and the friction of the hull along it."""

from ..declare.record import Vector
from ..library.sampling import first_sample, is_due
from ..library.table import straight
from .parameters import Parameters
from .records import Inputs, Outputs, State, Stretch, Times


def friction_at(s: float, p: Parameters) -> float:
    """The friction scale at the place s of the pass; beyond the ends of the table its first or last value."""
    return straight(s, p.fouling_place, p.fouling_scale, 8)


def stretch(t: float, begin: float, length: float, v: float) -> Stretch:
    """Where one is at time t on a stretch that begins at `begin` and is covered at the speed v."""
    end = begin + abs(length) / v
    way = 0.0
    speed = 0.0
    if t >= end:
        way = length
    elif t >= begin:
        speed = v
        if length < 0.0:
            speed = -v
        way = speed * (t - begin)
    return Stretch(way, speed, end)


def force_at(t: float, at: Times, p: Parameters) -> float:
    """The force set-point: F_n from the approach on, and back to 0 before leaving."""
    F_n = 0.0
    if t >= p.t_start and t < at.release:
        F_n = p.F_n
    elif t >= at.release and t < at.leave:
        F_n = p.F_n * (at.leave - t) / p.t_release
    return F_n


def phase_at(t: float, at: Times, p: Parameters) -> float:
    """0 wait, 1 approach, 2 at the hull before the pass, 3 pass, 4 after it, 5 release, 6 leave, 7 done."""
    phase = 0.0
    if t >= p.t_start:
        phase = 1.0
    if t >= at.touched:
        phase = 2.0
    if t >= at.clean:
        phase = 3.0
    if t >= at.passed:
        phase = 4.0
    if t >= at.release:
        phase = 5.0
    if t >= at.leave:
        phase = 6.0
    if t >= at.done:
        phase = 7.0
    return phase


def set_points(t: float, p: Parameters, x: State) -> None:
    """The sample at time t."""
    down = stretch(t, p.t_start, p.standoff + p.depth, p.v_approach)
    along = stretch(t, down.end + p.t_settle, p.length, p.v_clean)
    release = along.end + p.t_settle
    up = stretch(t, release + p.t_release, -p.leave - p.depth, p.v_leave)
    at = Times(
        touched=down.end,
        clean=down.end + p.t_settle,
        passed=along.end,
        release=release,
        leave=release + p.t_release,
        done=up.end,
    )
    for i in range(3):
        x.position[i] = x.start[i] + (down.way + up.way) * p.into_hull[i] + along.way * p.along[i]
        x.velocity[i] = (down.speed + up.speed) * p.into_hull[i] + along.speed * p.along[i]
    x.F_n = force_at(t, at, p)
    x.phase = phase_at(t, at, p)


def way_along(u: Inputs, along: Vector, start: Vector) -> float:
    """How far along the pass the vehicle is."""
    return along[0] * (u.x_n - start[0]) + along[1] * (u.y_n - start[1]) + along[2] * (u.z_n - start[2])


def initialize(u: Inputs, p: Parameters, x: State) -> None:
    """The pass begins where the vehicle is."""
    x.start[0] = u.x_n
    x.start[1] = u.y_n
    x.start[2] = u.z_n
    for i in range(3):
        x.position[i] = x.start[i]
        x.velocity[i] = 0.0
    x.sample = -1.0
    x.F_n = 0.0
    x.phase = 0.0
    x.friction_scale = friction_at(0.0, p)


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Write the set-points of the last sample, and where on the pass the vehicle is."""
    y.x_ref = x.position[0]
    y.y_ref = x.position[1]
    y.z_ref = x.position[2]
    for i in range(3):
        y.v_ref[i] = x.velocity[i]
    y.F_n_ref = x.F_n
    y.phase = x.phase
    y.friction_scale = x.friction_scale
    y.s = way_along(u, p.along, x.start)


def step(t: float, h: float, u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Set-points of the samples in [t, t + h), held in between; the friction is that of the place at t."""
    if x.sample < 0.0:
        x.sample = first_sample(t, p.T_s)
    while is_due(x.sample, t, h, p.T_s):
        set_points(x.sample * p.T_s, p, x)
        x.sample += 1.0
    x.friction_scale = friction_at(way_along(u, p.along, x.start), p)
    outputs(u, p, x, y)
