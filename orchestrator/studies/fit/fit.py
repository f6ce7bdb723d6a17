"""Fit parameters of a system to measured data: run, compare, step until nothing gets better, say how sure it is."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from ...errors import InputError, RunError
from ...files import prepare_folder
from ...system.model import System
from ...system.request import UNCHANGED, Changes
from .data import matches_of
from .estimates import Estimate, correlated, durbin_watson, estimates_of, spread_of, undecided
from .experiment import Experiment, Recipe, make_experiment
from .parameters import free_parameters, require_apart, sigma_of, unit_of
from .problem import Problem, solve
from .report import write_fit
from .solver import Values, values_at

LOSSES = ("linear", "soft_l1", "huber", "cauchy", "arctan")
WATCHED = (1.5, 2.5)  # Durbin-Watson: beyond these, residuals that follow each other


@dataclass(frozen=True)
class Options:
    """Of a fit: ranges `name=low:high[:log]`, what is compared, values that are set, scales by signal, the loss."""

    vary: Sequence[str] = ()
    match: Sequence[str] = ()
    values: Mapping[str, object] = field(default_factory=dict)
    sigma: Mapping[str, float] = field(default_factory=dict)
    loss: str = "linear"
    fmus: Path | None = None
    changes: Changes = UNCHANGED


@dataclass(frozen=True)
class Compared:
    """A signal over all experiments: rows, the scale that its residuals were divided by, and what is left."""

    name: str
    unit: str
    rows: int
    sigma: float
    rms: float
    durbin_watson: float


@dataclass(frozen=True)
class Fitted:
    """The result of a fit; `correlations` (parameters, parameters); `runs` by experiment, one array per signal."""

    title: str
    estimates: list[Estimate]
    correlations: np.ndarray
    signals: list[Compared]
    experiments: tuple[Experiment, ...]
    runs: list[list[np.ndarray]]
    evaluations: int
    seconds: float
    notes: list[str]
    failed: list[str]  # why the estimates cannot be relied on
    paths: list[Path]
    base: str = ""  # the parameter set that was asked for; the system's own, if none

    @property
    def values(self) -> Values:
        """The estimates by name."""
        return {one.name: one.value for one in self.estimates}

    def require_identified(self) -> Fitted:
        """The fit itself. Raises RunError where the data do not decide the parameters."""
        if self.failed:
            raise RunError("; ".join(self.failed))
        return self


def fit(
    name: str, recipes: Sequence[Recipe], options: Options, out: Path | None = None,
    tell: Callable[[str], None] = lambda _line: None, progress: Callable[[int, int], None] = lambda _done, _of: None,
) -> Fitted:  # fmt: skip
    """Fit parameters of a system to the data of one or more experiments; with `out` write files there.

    `tell` hears what the user must know, `progress` how many runs were made, of about how many. Deterministic. Raises
    InputError before the first run for what cannot be fitted, RunError where a run fails. See `require_identified`.
    """
    begin = time.perf_counter()
    if options.loss not in LOSSES:
        raise InputError(f"--loss {options.loss}: take one of {', '.join(LOSSES)}")
    if not recipes:
        raise InputError("--data names the CSV files that were measured; give at least one")
    matches = matches_of(options.match)
    experiments = tuple(
        make_experiment(name, recipe, matches, options.values, options.fmus, options.changes, tell)
        for recipe in recipes
    )  # fmt: skip
    system = experiments[0].plan.system
    free = free_parameters(system, options.vary, tell)
    require_apart(experiments, free, recipes)
    problem = Problem(experiments, free, sigma_of(system, options.sigma, matches))
    rows = sum(len(one.values) for experiment in experiments for one in experiment.measured)
    if rows <= len(free):
        raise InputError(f"{rows} measured values cannot decide {len(free)} parameters; measure more, or vary fewer")
    if out is not None:
        prepare_folder(out)
    x = solve(problem, options.loss, progress)
    found = replace(judged(problem, x, options.loss, system, begin), base=options.changes.parameters)
    if out is None:
        return found
    return replace(found, paths=write_fit(found, out))


def judged(problem: Problem, x: np.ndarray, loss: str, system: System, begin: float) -> Fitted:
    """The estimates at a solution, what they are worth and what must be said of them."""
    free, values = problem.free, values_at(problem.free, x)
    residuals, jacobian = problem.residuals(values), problem.jacobian(x, central=True)
    weights = np.sqrt(_weights(residuals, loss))
    spread = spread_of(free, jacobian * weights[:, None], residuals * weights)
    units = [unit_of(system, entry.name) for entry in free]
    estimates = estimates_of(free, units, x, spread)
    signals = []
    for k, (name, pieces) in enumerate(problem.left(values).items()):
        together = np.concatenate(pieces)
        unit = problem.experiments[0].measured[k].unit
        rms = float(np.sqrt(np.mean(together**2)))
        signals.append(Compared(name, unit, len(together), problem.sigma[name], rms, durbin_watson(pieces)))
    notes = [
        f"{one.name} lies on a bound of its range, {one.value:.6g} {one.unit}" for one in estimates if one.at_bound
    ]
    notes += correlated(free, spread.correlations)
    notes += [
        f"what is left of {one.name} follows itself (Durbin-Watson {one.durbin_watson:.2f}, 2 for noise alone): the "
        "model lacks something or the noise has a memory, and the intervals are too narrow"
        for one in signals if not WATCHED[0] <= one.durbin_watson <= WATCHED[1]
    ]  # fmt: skip
    failed = spread.alike or undecided(free, estimates)
    return Fitted(
        system.name, estimates, spread.correlations, signals, tuple(problem.experiments), problem.runs(values),
        problem.evaluations, time.perf_counter() - begin, notes, failed, [],
    )  # fmt: skip


def _weights(residuals: np.ndarray, loss: str) -> np.ndarray:
    """rho'(z) of scipy's losses at z = r^2: what a row counts for at the solution."""
    z = residuals**2
    weights = {
        "linear": np.ones_like(z), "soft_l1": 1.0 / np.sqrt(1.0 + z), "huber": np.maximum(z, 1.0) ** -0.5,
        "cauchy": 1.0 / (1.0 + z), "arctan": 1.0 / (1.0 + z**2),
    }  # fmt: skip
    found: np.ndarray = weights[loss]
    return found
