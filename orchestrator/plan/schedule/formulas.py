"""Rate transitions: how the samples of an output become the input that is held over a step.

Notation: the target steps from t to t + H; the source was sampled at its own instants, s the last of them, h its
period, f its value there, f' and f'' the values one and two periods before. Errors are those of the held input against
the mean of the true signal over the target's step.

    hold         f                                       O(h + H): the latest value
    linear       f + (f - f') (t + H/2 - s)/h            O((h + H)^2): extrapolated to the middle of the step
    quadratic    mean over the step of the parabola through f, f', f''
                                                         O((h + H)^3)
    interpolate  the line through f' and f at t + H/2, where the source stepped first: s is not before the step's end
                                                         O(h^2 + H^2), and nothing is extrapolated
    mean         (1/H) integral of f from t to t + H     O(h^2): the average of a faster source, trapezoidal rule; what
                 one average extrapolates beyond s is taken back from the next, so no impulse is made or lost
    mean of J    (J(t + H) - J(t))/H                     exact, where an output J rises by the integral of f; beyond s
                 as above
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

HISTORY = {
    "hold": 0,
    "linear": 1,
    "quadratic": 2,
    "interpolate": 1,
    "mean": 1,
    "iterated": 1,
    "end": 0,
    "end on line": 1,
}  # earlier samples that a transfer needs
ITERATED = ("iterated", "end", "end on line")  # the mean of both ends of the step, or the value at its end
COUNTED = ("mean", "iterated")  # transfers that can be exact by a counter of the integral of f
BOTH_ENDS = ("mean", "iterated", "end on line")  # transfers that need the source at the beginning of its step too
CHANGING = (
    "linear",
    "quadratic",
    "interpolate",
    *ITERATED,
)  # transfers that change the input between samples of its source


@dataclass(frozen=True)
class Choice:
    """A transfer and why it was taken."""

    transfer: str
    reason: str
    former: str = ""  # what files without `format = 2` got here when it was not held yet


def choose(stated: str, source_period: int, target_period: int, source_sampled: bool, target_sampled: bool) -> Choice:
    """The transfer of one connection, as stated in the system file or by the ratio of the rates.

    `sampled` (FMI variability `discrete`): a source that is piecewise constant by nature; a target that samples.
    """
    if stated:
        return Choice(stated, "stated in the system file")
    if source_period == target_period:
        return Choice("hold", "same rate")
    if target_sampled:
        return Choice("hold", "a sampled input takes the latest value")
    if source_period < target_period:
        return Choice("mean", "fast to slow: the average over the slow step keeps the impulse and does not alias")
    if source_sampled:
        return Choice("hold", "slow to fast, and a sampled output holds its value by nature")
    return Choice("hold", "slow to fast: held, for nothing else is stated", "linear")


def linear_ratio(sample: int, source_period: int, start: int, target_period: int) -> float:
    """(t + H/2 - s)/h for a source sampled at tick `sample` and a target step that begins at tick `start`."""
    return float(Fraction(2 * (start - sample) + target_period, 2 * source_period))


def mean_tail(sample: int, source_period: int, end: int, target_period: int) -> tuple[float, float]:
    """Weights of f and f' in the part of a mean that lies beyond the last sample, extrapolated linearly.

    The integral from s to e of f + (f - f')(x - s)/h, divided by H, with e the end of the target's step.
    """
    gap, h = end - sample, source_period
    slope = Fraction(gap * gap, 2 * h)
    return float((gap + slope) / target_period), float(-slope / target_period)


def quadratic_weights(
    sample: int, source_period: int, start: int, target_period: int, last_period: int
) -> tuple[float, float]:
    """Weights of f - f' and f - 2 f' + f'' in the mean over the step of the parabola through the three samples.

    f' was taken `last_period` before f, which may be less than the period of the source.
    """
    x0, x1 = (Fraction(t - sample, source_period) for t in (start, start + target_period))
    r = Fraction(last_period, source_period)
    mean = (x0 + x1) / 2
    square = (x0 * x0 + x0 * x1 + x1 * x1) / 3  # the mean of x^2
    second = (square + r * mean) / (1 + r)  # of f'': the mean of x (x + r) / (1 + r)
    first = -(square + (1 + r) * mean) / r  # of f': that of -x (x + 1 + r) / r
    return float(-first - 2 * second), float(second)


def value_ratio(sample: int, source_period: int, at: int) -> float:
    """(at - s)/h: weight of f - f' in the value on the line at one instant."""
    return float(Fraction(at - sample, source_period))
