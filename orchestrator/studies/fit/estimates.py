"""How sure a fit is: standard errors, intervals and correlations from the Jacobian, and what the data do not decide.

Linearised about the solution (Seber and Wild, Nonlinear Regression, 1989, section 5.1): the covariance is
s^2 (J'J)^-1 with s^2 the residual sum of squares over rows less parameters, and the intervals are those of Student's t.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .solver import Free

LEVEL = 0.95
ALIKE = 1e-4  # smallest singular value of the Jacobian's normed columns at which parameters are taken for one
NAMED = 0.3  # share of the largest part of a direction from which a parameter is named
STRONG = 0.95  # correlation that is worth a word
EDGE = 1e-3  # of its range: so near to a bound a parameter lies on it


@dataclass(frozen=True)
class Estimate:
    """A parameter: its value, standard error and the ends of the 95 % interval, in its own unit."""

    name: str
    unit: str
    start: float
    value: float
    error: float
    low: float
    high: float
    at_bound: bool


@dataclass(frozen=True)
class Spread:
    """Standard errors as the solver sees parameters, their correlations (n, n), and what cannot be told apart."""

    errors: np.ndarray
    correlations: np.ndarray
    alike: list[str]
    degrees: int  # of freedom


def spread_of(free: Sequence[Free], jacobian: np.ndarray, residuals: np.ndarray) -> Spread:
    """From the weighted Jacobian (rows, parameters) and the weighted residuals (rows,) at the solution."""
    count = len(free)
    degrees = max(len(residuals) - count, 1)
    norms = np.linalg.norm(jacobian, axis=0)
    normed = jacobian / np.where(norms > 0.0, norms, 1.0)
    _, singular, directions = np.linalg.svd(normed, full_matrices=False)
    alike = [_alike(free, direction) for value, direction in zip(singular, directions, strict=True) if value < ALIKE]
    with np.errstate(divide="ignore", invalid="ignore"):
        inverse = directions.T @ np.diag(1.0 / singular**2) @ directions
        covariance = float(residuals @ residuals) / degrees * inverse / np.outer(norms, norms)
        errors = np.sqrt(np.diag(covariance))
        correlations = covariance / np.outer(errors, errors)
    return Spread(errors, correlations, alike, degrees)


def _alike(free: Sequence[Free], direction: np.ndarray) -> str:
    parts = [(entry.name, part) for entry, part in zip(free, direction, strict=True)
             if abs(part) >= NAMED * float(np.max(np.abs(direction)))]  # fmt: skip
    names = " and ".join(name for name, _ in parts)
    shares = ", ".join(f"{name} {part:+.2f}" for name, part in parts)
    return (
        f"{names} cannot be told apart by these data (direction {shares}, each over its slope): set one of them, match "
        f"another signal, or take data with another excitation"
    )


def estimates_of(free: Sequence[Free], units: Sequence[str], x: np.ndarray, spread: Spread) -> list[Estimate]:
    """In the parameters' own units; of one that is fitted by its logarithm the interval is not symmetric."""
    from scipy.stats import t

    factor = float(t.ppf(0.5 + LEVEL / 2.0, spread.degrees))
    found = []
    for entry, unit, at, error in zip(free, units, x.tolist(), spread.errors.tolist(), strict=True):
        ends = at - factor * error, at + factor * error
        low, high = (float(np.exp(min(end, 700.0))) if entry.log else float(end) for end in ends)
        edges = entry.coded(entry.low), entry.coded(entry.high)
        near = min(at - edges[0], edges[1] - at) < EDGE * (edges[1] - edges[0])
        found.append(Estimate(entry.name, unit, entry.start, entry.value(at), error * entry.slope(at), low, high, near))
    return found


def undecided(free: Sequence[Free], estimates: Sequence[Estimate]) -> list[str]:
    """Parameters whose interval is no narrower than the range in which they were looked for."""
    said = []
    for entry, found in zip(free, estimates, strict=True):
        if not found.high - found.low < entry.high - entry.low:
            said.append(
                f"{entry.name} is not decided by the data: its 95 % interval, {found.low:.4g} to {found.high:.4g}, is"
                f" no narrower than its range"
            )
    return said


def correlated(free: Sequence[Free], correlations: np.ndarray) -> list[str]:
    """Pairs whose errors go together."""
    said = []
    for k in range(len(free)):
        for j in range(k):
            if STRONG <= abs(correlations[k, j]) <= 1.0:
                said.append(f"{free[j].name} and {free[k].name} are correlated by {correlations[k, j]:+.3f}")
    return said


def durbin_watson(pieces: Sequence[np.ndarray]) -> float:
    """Of residuals in the order of time (Durbin and Watson 1950): 2 where they know nothing of each other, 0 where each
    is the one before."""
    squares = sum(float(piece @ piece) for piece in pieces)
    steps = sum(float(np.sum(np.diff(piece) ** 2)) for piece in pieces)
    return steps / squares if squares > 0.0 else 2.0
