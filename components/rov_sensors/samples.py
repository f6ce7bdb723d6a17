"""Samples: what a channel reads, and the ring in which samples wait until they have arrived."""

from math import floor

from ..declare.record import Vector
from ..library.noise import gaussian, uniform
from ..library.sampling import is_due
from .parameters import Parameters
from .records import State


def row_of(number: float) -> int:
    """The row of the ring in which a sample of this number stands."""
    return int(number - 512.0 * floor(number / 512.0))


def on_grid(reading: float, quantum: float) -> float:
    """The next multiple of a quantum, if there is one."""
    if quantum > 0.0:
        reading = quantum * floor(reading / quantum + 0.5)  # Eq. N4
    return reading


def without_noise(k: int, c: int, truth: float, x: State) -> float:
    """Scale and bias of channel c of sensor k; neither changes a bit where there is none."""
    reading = x.scale[k] * truth
    if x.bias[c] != 0.0:
        reading = reading + x.bias[c]
    return reading


def kept(number: float, k: int, c: int, x: State) -> float:
    """The reading of sample `number` of sensor k, before its quantum; before the first that of the start."""
    reading = x.start[c]
    if number >= x.first[k]:
        row = row_of(number)
        reading = x.ring[row, c]
    return reading


def time_of(number: float, k: int, x: State) -> float:
    """When sample `number` of sensor k, which has no period, was taken."""
    row = row_of(number)
    t = x.times[row, k]
    return t


def reading_of(k: int, c: int, truth: float, p: Parameters, x: State) -> float:
    """What channel c reads at the next sample of sensor k, before its quantum."""
    number = x.next[k]
    if x.dropout[k] > 0.0 and uniform(number, 64 + k, p.seed) < x.dropout[k]:
        return kept(number - 1.0, k, c, x)  # lost: the last one holds
    reading = without_noise(k, c, truth, x)
    if x.noise[c] > 0.0:
        reading = reading + x.noise[c] * gaussian(number, c, p.seed)  # Eq. N3
    return reading


def take(k: int, c_0: int, truth: Vector, p: Parameters, x: State) -> None:
    """The next sample of sensor k, whose channels begin with c_0, into the ring."""
    row = row_of(x.next[k])
    for c in range(c_0, c_0 + int(x.channels[k])):
        x.ring[row, c] = reading_of(k, c, truth[c], p, x)
    x.next[k] = x.next[k] + 1.0


def take_now(t: float, k: int, c_0: int, truth: Vector, p: Parameters, x: State) -> None:
    """A sample of a sensor without a period, unless the last is so near that the ring would not reach back far enough.

    It holds 500 of them over the latency; communication steps shorter than that are not all kept.
    """
    last = x.next[k] - 1.0
    if last < x.first[k] or t - time_of(last, k, x) > x.latency[k] / 500.0 - 1e-9:
        row = row_of(x.next[k])
        x.times[row, k] = t
        take(k, c_0, truth, p, x)


def take_due(t: float, h: float, k: int, c_0: int, truth: Vector, p: Parameters, x: State) -> None:
    """The samples of [t, t + h) of a sensor with a period."""
    while is_due(x.next[k], t, h, x.period[k]):
        take(k, c_0, truth, p, x)
