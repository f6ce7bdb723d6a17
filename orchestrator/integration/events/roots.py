"""Event indicators: an event is where one changes between above zero and not above it."""

from __future__ import annotations

from numba.extending import register_jitable

from ..cells import CELL, INDICATORS, OK, TIME, Z_NEW, Z
from ..members import indicate
from ..memory import into_caller, number, put, whole
from ..one_step import trial

EPSILON = 2.220446049250313e-16
MOST = 200  # steps of the search


@into_caller
def first_changed(g: int) -> int:
    """The first indicator that differs in sign between Z and Z_NEW; -1 if none does."""
    a, b = whole(g + Z), whole(g + Z_NEW)
    for j in range(whole(g + INDICATORS)):
        if (number(a + CELL * j) > 0.0) != (number(b + CELL * j) > 0.0):
            return j
    return -1


@into_caller
def keep_indicators(g: int) -> None:
    """Z becomes what Z_NEW is."""
    a, b = whole(g + Z), whole(g + Z_NEW)
    for j in range(0, CELL * whole(g + INDICATORS), CELL):
        put(a + j, number(b + j))


@register_jitable
def crossing(g: int, weight: float) -> float:
    """Where between Z and Z_NEW (0 and 1) the first zero is, by secants whose ends at Z are weighted (Illinois)."""
    a, b = whole(g + Z), whole(g + Z_NEW)
    first = 1.0
    for j in range(whole(g + INDICATORS)):
        before, after = number(a + CELL * j), number(b + CELL * j)
        if (before > 0.0) != (after > 0.0):
            before *= weight
            first = min(first, before / (before - after)) if before != after else 0.5
    return first


@register_jitable
def locate(g: int, h: float) -> float:
    """How far a step over `h` [s], over which indicators changed, goes to just behind the first change; below 0: a
    status, negative and less one.

    The step is done anew to each instant that is tried, so that the event is as exact as the method. Afterwards X_NEW,
    Z_NEW and the members are there; Z is what it was at a later beginning, if that is closer.
    """
    time = number(g + TIME)
    low, high, tried, weight, side = 0.0, h, h, 1.0, 0
    resolution = 4.0 * EPSILON * (abs(time) + h)
    for k in range(MOST):
        width = high - low
        if width <= resolution:
            break
        part = crossing(g, weight)
        if k % 4 == 3:  # secants that creep
            part = 0.5
        middle = low + min(max(part * width, 0.5 * resolution), width - 0.5 * resolution)
        if middle <= low or middle >= high:
            middle = low + 0.5 * width
            if middle <= low or middle >= high:
                break
        status = trial(g, time, middle)
        if status != OK:
            return -1.0 - status
        changed = look(g)
        if changed < 0:
            return float(changed)
        tried = middle
        if changed == 1:
            high = middle
            weight = 0.5 * weight if side == 1 else 1.0
            side = 1
        else:
            low = middle
            weight = 2.0 * weight if side == -1 else 1.0
            side = -1
            keep_indicators(g)
            restore_high(g)
    if tried != high:
        status = trial(g, time, high)
        if status == OK:
            status = indicate(g, whole(g + Z_NEW))
        if status != OK:
            return -1.0 - status
    return high


@register_jitable
def look(g: int) -> int:
    """After a trial step: 1 if indicators have changed at its end, 0 if not; below 0: a status, less one.

    What Z_NEW was is kept behind it where nothing has changed.
    """
    count, new = whole(g + INDICATORS), whole(g + Z_NEW)
    spare = new + CELL * count
    for j in range(0, CELL * count, CELL):
        put(spare + j, number(new + j))
    status = indicate(g, new)
    if status != OK:
        return -1 - status
    return 1 if first_changed(g) >= 0 else 0


@register_jitable
def restore_high(g: int) -> None:
    """Z_NEW becomes again what it was before the last `look`."""
    count, new = whole(g + INDICATORS), whole(g + Z_NEW)
    for j in range(0, CELL * count, CELL):
        put(new + j, number(new + CELL * count + j))
