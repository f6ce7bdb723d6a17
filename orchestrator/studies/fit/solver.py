"""Bounded nonlinear least squares over named parameters, some of them by their logarithm."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

Values = dict[str, float]


@dataclass(frozen=True)
class Free:
    """A parameter that is fitted between two bounds, from a start; with `log` in equal ratios."""

    name: str
    low: float
    high: float
    start: float
    log: bool = False

    def coded(self, value: float) -> float:
        """As the solver sees it."""
        return math.log(value) if self.log else value

    def value(self, coded: float) -> float:
        """Of what the solver sees; never beyond a bound by rounding."""
        return min(max(math.exp(coded) if self.log else float(coded), self.low), self.high)

    def slope(self, coded: float) -> float:
        """The derivative of `value`."""
        return self.value(coded) if self.log else 1.0


def values_at(free: Sequence[Free], x: np.ndarray) -> Values:
    """The parameters by name where the solver stands at x, (parameters,)."""
    return {entry.name: entry.value(coded) for entry, coded in zip(free, x.tolist(), strict=True)}


def minimise(
    residuals: Callable[[Mapping[str, float]], np.ndarray], free: Sequence[Free], most: int, **options: Any
) -> Any:
    """What scipy's trust region reflective finds from the starts: see `scipy.optimize.least_squares`.

    `residuals` of named values, (residuals,); `most` steps; `options` as of scipy, `jac` a function of x.
    """
    from scipy.optimize import least_squares

    low, start, high = (np.array([e.coded(v) for e, v in zip(free, ends, strict=True)]) for ends in (
        [e.low for e in free], [e.start for e in free], [e.high for e in free]))  # fmt: skip
    return least_squares(
        lambda x: residuals(values_at(free, x)), np.clip(start, low, high), bounds=(low, high), x_scale="jac",
        max_nfev=most, **options,
    )  # fmt: skip


def differences(
    residuals: Callable[[Mapping[str, float]], np.ndarray],
    free: Sequence[Free],
    x: np.ndarray,
    share: float,
    here: np.ndarray | None = None,
) -> np.ndarray:
    """The Jacobian (residuals, parameters) at x by differences over a `share` of each range, as the solver sees it.

    Forward where the residuals `here` are given, which costs a run for each parameter; else central. Inwards at bounds.
    """
    columns = []
    for k, entry in enumerate(free):
        low, high = entry.coded(entry.low), entry.coded(entry.high)
        step = share * (high - low)
        above, below = min(x[k] + step, high), max(x[k] - step, low)
        if here is not None:
            other = above if above - x[k] >= x[k] - below else below
            columns.append((residuals(_moved(free, x, k, other)) - here) / (other - x[k]))
        else:
            rise = residuals(_moved(free, x, k, above)) - residuals(_moved(free, x, k, below))
            columns.append(rise / (above - below))
    return np.stack(columns, axis=1)


def _moved(free: Sequence[Free], x: np.ndarray, k: int, to: float) -> Values:
    other = x.copy()
    other[k] = to
    return values_at(free, other)
