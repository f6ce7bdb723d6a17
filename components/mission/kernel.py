"""A cleaning pass as set-points over time, and the friction of the hull along it.

start: position at time 0. memory: [0] number of the next sample (-1 before the first), [1..3] position set-point,
[4..6] its velocity, [7] force set-point, [8] phase, [9] friction scale.
"""

from math import ceil


def friction_at(s: float, fouling_place: "float[:]", fouling_scale: "float[:]") -> float:
    """The friction scale at the place s of the pass; beyond the ends of the table its first or last value."""
    scale = fouling_scale[0]
    for k in range(7):
        width = fouling_place[k + 1] - fouling_place[k]
        if s >= fouling_place[k + 1]:
            scale = fouling_scale[k + 1]
        elif s > fouling_place[k] and width > 0.0:
            part = (s - fouling_place[k]) / width
            scale = fouling_scale[k] + part * (fouling_scale[k + 1] - fouling_scale[k])
    return scale


def stretch(t: float, begin: float, length: float, v: float) -> tuple[float, float, float]:
    """Way, speed and end of a stretch that begins at `begin` and is covered at the speed v."""
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
    return way, speed, end


def set_points(
    t: float, memory: "float[:]", start: "float[:]", along: "float[:]", into_hull: "float[:]", t_start: float,
    standoff: float, depth: float, v_approach: float, t_settle: float, length: float, v_clean: float, t_release: float,
    v_leave: float, leave: float, F_n: float,
) -> None:
    """Phases: 0 wait, 1 approach, 2 at the hull before the pass, 3 pass, 4 after it, 5 release, 6 leave, 7 done."""
    down, v_down, touched = stretch(t, t_start, standoff + depth, v_approach)
    way, speed, passed = stretch(t, touched + t_settle, length, v_clean)
    release = passed + t_settle
    up, v_up, done = stretch(t, release + t_release, -leave - depth, v_leave)
    for i in range(3):
        memory[1 + i] = start[i] + (down + up) * into_hull[i] + way * along[i]
        memory[4 + i] = (v_down + v_up) * into_hull[i] + speed * along[i]
    memory[7] = 0.0
    if t >= t_start and t < release:
        memory[7] = F_n
    elif t >= release and t < release + t_release:
        memory[7] = F_n * (release + t_release - t) / t_release
    memory[8] = 0.0
    if t >= t_start:
        memory[8] = 1.0
    if t >= touched:
        memory[8] = 2.0
    if t >= touched + t_settle:
        memory[8] = 3.0
    if t >= passed:
        memory[8] = 4.0
    if t >= release:
        memory[8] = 5.0
    if t >= release + t_release:
        memory[8] = 6.0
    if t >= done:
        memory[8] = 7.0


def initialize(
    start: "float[:]", memory: "float[:]", x_n: float, y_n: float, z_n: float, fouling_place: "float[:]",
    fouling_scale: "float[:]",
) -> None:
    """The pass begins where the vehicle is."""
    start[0] = x_n
    start[1] = y_n
    start[2] = z_n
    memory[0] = -1.0
    for i in range(3):
        memory[1 + i] = start[i]
        memory[4 + i] = 0.0
    memory[7] = 0.0
    memory[8] = 0.0
    memory[9] = friction_at(0.0, fouling_place, fouling_scale)


def outputs(
    y: "float[:]", memory: "float[:]", start: "float[:]", v_ref: "float[:]", along: "float[:]", x_n: float, y_n: float,
    z_n: float,
) -> None:
    """Write the set-points of the last sample, and where on the pass the vehicle is."""
    x_ref = memory[1]
    y_ref = memory[2]
    z_ref = memory[3]
    for i in range(3):
        v_ref[i] = memory[4 + i]
    F_n_ref = memory[7]
    phase = memory[8]
    friction_scale = memory[9]
    s = along[0] * (x_n - start[0]) + along[1] * (y_n - start[1]) + along[2] * (z_n - start[2])
    y[0] = x_ref
    y[1] = y_ref
    y[2] = z_ref
    for i in range(3):
        y[3 + i] = v_ref[i]
    y[6] = F_n_ref
    y[7] = phase
    y[8] = friction_scale
    y[9] = s


def step(
    t: float, h: float, y: "float[:]", memory: "float[:]", start: "float[:]", v_ref: "float[:]", x_n: float, y_n: float,
    z_n: float, T_s: float, along: "float[:]", into_hull: "float[:]", t_start: float, standoff: float, depth: float,
    v_approach: float, t_settle: float, length: float, v_clean: float, t_release: float, v_leave: float, leave: float,
    F_n: float, fouling_place: "float[:]", fouling_scale: "float[:]",
) -> None:
    """Set-points of the samples in [t, t + h), held in between; the friction is that of the place at t."""
    # A sample belongs to the step that starts at it, whatever the rounding of t.
    margin = 1e-6 * T_s
    if memory[0] < 0.0:
        memory[0] = ceil((t - margin) / T_s) * 1.0
    while memory[0] * T_s < t + h - margin:
        set_points(
            memory[0] * T_s, memory, start, along, into_hull, t_start, standoff, depth, v_approach, t_settle, length,
            v_clean, t_release, v_leave, leave, F_n)
        memory[0] = memory[0] + 1.0
    s = along[0] * (x_n - start[0]) + along[1] * (y_n - start[1]) + along[2] * (z_n - start[2])
    memory[9] = friction_at(s, fouling_place, fouling_scale)
    outputs(y, memory, start, v_ref, along, x_n, y_n, z_n)
