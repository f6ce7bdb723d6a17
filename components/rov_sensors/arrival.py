"""What of the samples has arrived: the last one, or without samples the truth of an instant that lies back."""

from math import pi

from ..declare.record import Vector
from .parameters import Parameters
from .records import State
from .samples import kept, on_grid, reading_of, time_of


def show_now(k: int, c_0: int, truth: Vector, shown: Vector, p: Parameters, x: State) -> None:
    """What sensor k reads at once."""
    for c in range(c_0, c_0 + int(x.channels[k])):
        shown[c] = on_grid(reading_of(k, c, truth[c], p, x), x.quantum[c])


def show_sample(newest: float, k: int, c_0: int, truth: Vector, shown: Vector, p: Parameters, x: State) -> None:
    """Sample `newest` of sensor k, or the next, which is about to be taken, whichever comes first."""
    for c in range(c_0, c_0 + int(x.channels[k])):
        if newest < x.next[k]:
            shown[c] = on_grid(kept(newest, k, c, x), x.quantum[c])
        else:
            shown[c] = on_grid(reading_of(k, c, truth[c], p, x), x.quantum[c])


def last_before(instant: float, k: int, x: State) -> float:
    """The number of the last sample of sensor k that was taken at this instant or before."""
    number = x.before[k]
    while number + 1.0 < x.next[k] and time_of(number + 1.0, k, x) <= instant + 1e-9:
        number = number + 1.0
    return number


def way(a: float, b: float, wraps: float) -> float:
    """From a to b; for angles that begin again behind pi the shorter way round."""
    d = b - a
    if wraps > 0.0:
        if d > pi:
            d = d - 2.0 * pi
        elif d < -pi:
            d = d + 2.0 * pi
    return d


def on_the_way(a: float, b: float, part: float, wraps: float) -> float:
    """A part of the way from a to b, in the same turn as they are."""
    reading = a + part * way(a, b, wraps)
    if wraps > 0.0 and reading > pi:
        reading = reading - 2.0 * pi
    elif wraps > 0.0 and reading < -pi:
        reading = reading + 2.0 * pi
    return reading


def show_instant(
    t: float, before: float, k: int, c_0: int, truth: Vector, shown: Vector, p: Parameters, x: State
) -> None:
    """What sensor k reads at t - latency: straight between sample `before` and the one after it, or now."""
    instant = t - x.latency[k]
    after = before + 1.0
    t_after = t
    if after < x.next[k]:
        t_after = time_of(after, k, x)
    part = 0.0
    if before >= x.first[k] and instant - time_of(before, k, x) > 1e-9:
        t_before = time_of(before, k, x)
        part = (instant - t_before) / (t_after - t_before)
    for c in range(c_0, c_0 + int(x.channels[k])):
        shown[c] = kept(before, k, c, x)
        if part > 0.0:
            reading = reading_of(k, c, truth[c], p, x)
            if after < x.next[k]:
                reading = kept(after, k, c, x)
            shown[c] = on_the_way(shown[c], reading, part, x.wraps[c])
        shown[c] = on_grid(shown[c], x.quantum[c])
