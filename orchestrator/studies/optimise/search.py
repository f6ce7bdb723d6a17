"""The search itself: differential evolution over the ranges (Storn and Price 1997), then a local polish (COBYQA)."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from ..sweep.design.axis import Range
from .trials import Trials

LARGE = 1e9  # in place of what is infinite: a failed run breaks every constraint by so much
STEP = 0.05  # of each range: the first step of the polish


def evolve(trials: Trials, population: int, generations: int, seed: int) -> None:
    """Differential evolution; a generation is computed together. Constraints by Lampinen (2002), as in SciPy."""
    from scipy.optimize import NonlinearConstraint, differential_evolution

    dimensions = len(trials.spaces)
    rng = np.random.default_rng(seed)
    cells = np.argsort(rng.random((dimensions, population)), axis=1).T
    first = (cells + rng.random((population, dimensions))) / population  # a Latin hypercube
    constraints: Any = ()
    if trials.aim.constraints:
        constraints = NonlinearConstraint(lambda x: _excesses(trials, x), -np.inf, 0.0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        differential_evolution(
            lambda x: _costs(trials, x), [(0.0, 1.0)] * dimensions, constraints=constraints, init=first,
            maxiter=generations, rng=rng, vectorized=True, updating="deferred", polish=False, tol=1e-6,
        )  # fmt: skip


def polish(trials: Trials, evaluations: int) -> None:
    """From the best point along the parameters that are real; the others stay as they are there."""
    from scipy.optimize import NonlinearConstraint, minimize

    spaces = list(trials.spaces.values())
    free = [k for k, space in enumerate(spaces) if isinstance(space, Range) and not space.whole]
    if not free or evaluations < 2 * len(free) + 2:
        return
    begin = shares_of(trials)

    def whole(x: np.ndarray) -> np.ndarray:
        point = begin.copy()
        point[free] = np.clip(x, 0.0, 1.0)
        return point[:, None]

    constraints: Any = ()
    if trials.aim.constraints:
        constraints = NonlinearConstraint(lambda x: _excesses(trials, whole(x))[:, 0], -np.inf, 0.0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        minimize(
            lambda x: float(_costs(trials, whole(x))[0]), begin[free], method="COBYQA",
            bounds=[(0.0, 1.0)] * len(free), constraints=constraints,
            options={"initial_tr_radius": STEP, "final_tr_radius": 1e-6, "maxfev": evaluations},
        )  # fmt: skip


def shares_of(trials: Trials) -> np.ndarray:
    """The best point in the unit cube, (parameters,)."""
    best, shares = trials.best(), []
    for value, space in zip(best.values, trials.spaces.values(), strict=True):
        if not isinstance(space, Range):
            shares.append((list(space.items).index(value) + 0.5) / len(space.items))
        elif space.items:
            shares.append((space.items.index(int(value)) + 0.5) / len(space.items))
        elif space.log:
            end = space.high + 1 if space.whole else space.high
            shares.append(float(np.log((float(value) + 0.5 * space.whole) / space.low) / np.log(end / space.low)))
        else:
            end = space.high + 1 if space.whole else space.high
            shares.append((float(value) + 0.5 * space.whole - space.low) / (end - space.low))
    found: np.ndarray = np.clip(np.array(shares, dtype=float), 0.0, 1.0)
    return found


def _costs(trials: Trials, shares: np.ndarray) -> np.ndarray:
    """The costs of columns of points, (parameters, points)."""
    return np.array([min(trial.cost, LARGE * LARGE) for trial in trials.at(shares.T)])


def _excesses(trials: Trials, shares: np.ndarray) -> np.ndarray:
    """The excesses over constraints of columns of points, (constraints, points)."""
    return np.array([[min(excess, LARGE) for excess in trial.excesses] for trial in trials.at(shares.T)]).T
