"""Fit parameters of a system to measured data: run, compare, step until nothing gets better, say how sure it is."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ...errors import InputError, RunError
from ...files import prepare_folder
from ...system.model import System
from ...system.request import UNCHANGED, Changes
from ..sweep.axis import range_of
from ..sweep.design import vary_entries
from ..sweep.replanned import needs_plan
from .data import Match, matches_of
from .estimates import Estimate, correlated, durbin_watson, estimates_of, spread_of, undecided
from .experiment import Experiment, Recipe, make_experiment
from .report import write_fit
from .solver import Free, Values, differences, minimise, values_at

LOSSES = ("linear", "soft_l1", "huber", "cauchy", "arctan")
STEPS = 60  # of the solver in each round
ROUNDS = 4  # in which the scale of each signal is found anew from what is left of it
SETTLED = 0.02  # relative change of all scales at which they are what they are
SHARE = 1e-3  # of a range: what a run changes by is then well above its rounding and its events
LEAST_SCALE = 1e-9  # of what a signal ranges over: data without noise
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

    @property
    def values(self) -> Values:
        """The estimates by name."""
        return {one.name: one.value for one in self.estimates}

    def require_identified(self) -> Fitted:
        """The fit itself. Raises RunError where the data do not decide the parameters."""
        if self.failed:
            raise RunError("; ".join(self.failed))
        return self


class Problem:
    """Experiments, free parameters and scales; `residuals` of values are weighted, one behind the other."""

    def __init__(self, experiments: Sequence[Experiment], free: Sequence[Free], sigma: Mapping[str, float]) -> None:
        self.experiments, self.free = experiments, free
        self.stated = dict(sigma)
        self.sigma = {name: self.stated.get(name, _size(pieces)) for name, pieces in self.data().items()}
        self.evaluations = 0
        self._known: dict[tuple[float, ...], list[list[np.ndarray]]] = {}

    def data(self) -> dict[str, list[np.ndarray]]:
        """What was measured of each signal, in all experiments."""
        names = [one.name for one in self.experiments[0].measured]
        return {name: [e.measured[k].values for e in self.experiments] for k, name in enumerate(names)}

    def runs(self, values: Mapping[str, float]) -> list[list[np.ndarray]]:
        """The signals of all experiments; the last point is known."""
        key = tuple(values.values())
        if key not in self._known:
            self.evaluations += 1
            found = [experiment.run(values) for experiment in self.experiments]
            self._known = {key: found}
        return self._known[key]

    def left(self, values: Mapping[str, float]) -> dict[str, list[np.ndarray]]:
        """Data less run, by signal and experiment."""
        runs = self.runs(values)
        return {name: [piece - run[k] for piece, run in zip(pieces, runs, strict=True)]
                for k, (name, pieces) in enumerate(self.data().items())}  # fmt: skip

    def residuals(self, values: Mapping[str, float]) -> np.ndarray:
        """Weighted: what is left over the scale of its signal."""
        left = self.left(values)
        return np.concatenate([piece / self.sigma[name] for name, pieces in left.items() for piece in pieces])

    def jacobian(self, x: np.ndarray, central: bool = False) -> np.ndarray:
        """Of the residuals, (rows, parameters). Raises InputError for a parameter without effect."""
        here = self.residuals(values_at(self.free, x))
        found = differences(self.residuals, self.free, x, SHARE, None if central else here)
        for entry, column in zip(self.free, found.T, strict=True):
            if not np.any(column):
                raise InputError(
                    f"--vary {entry.name}: it has no effect on what is matched, to the last bit; leave it out, or "
                    "match another signal"
                )
        return found

    def scales(self, values: Mapping[str, float], robust: bool) -> dict[str, float]:
        """The size of what is left of each signal: root mean square, or 1.4826 times the median (Huber 1981)."""
        found = {}
        for name, pieces in self.left(values).items():
            together = np.concatenate(pieces)
            size = 1.4826 * np.median(np.abs(together)) if robust else np.sqrt(np.mean(together**2))
            found[name] = self.stated.get(name, max(float(size), LEAST_SCALE * _size(self.data()[name])))
        return found


def _size(pieces: Sequence[np.ndarray]) -> float:
    """What a signal ranges over, for a start."""
    together = np.concatenate(pieces)
    return float(np.std(together)) or float(np.max(np.abs(together))) or 1.0


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
    found = judged(problem, x, options.loss, system, begin)
    if out is None:
        return found
    return Fitted(**{**found.__dict__, "paths": write_fit(found, out)})


def solve(problem: Problem, loss: str, progress: Callable[[int, int], None]) -> np.ndarray:
    """Where it is best, as the solver sees it; the scales of the signals are found with it."""
    x = np.array([entry.coded(entry.start) for entry in problem.free])
    expected = 12 * (len(problem.free) + 1)

    def residuals(values: Mapping[str, float]) -> np.ndarray:
        progress(min(problem.evaluations, expected), expected)
        return problem.residuals(values)

    free = problem.free
    for _ in range(ROUNDS):
        solution = minimise(residuals, free, STEPS, loss=loss, jac=problem.jacobian)
        x = np.asarray(solution.x)
        if not solution.success and solution.status == 0:
            raise RunError(f"the fit has not settled after {STEPS} steps; begin nearer (--set), or narrow the ranges")
        values = values_at(problem.free, x)
        before, problem.sigma = problem.sigma, problem.scales(values, loss != "linear")
        free = [Free(e.name, e.low, e.high, values[e.name], e.log) for e in problem.free]
        if len(problem.sigma) == 1 or all(abs(problem.sigma[n] / before[n] - 1.0) < SETTLED for n in before):
            break
    return x


def judged(problem: Problem, x: np.ndarray, loss: str, system: System, begin: float) -> Fitted:
    """The estimates at a solution, what they are worth and what must be said of them."""
    free, values = problem.free, values_at(problem.free, x)
    residuals, jacobian = problem.residuals(values), problem.jacobian(x, central=True)
    weights = np.sqrt(_weights(residuals, loss))
    spread = spread_of(free, jacobian * weights[:, None], residuals * weights)
    units = [_unit(system, entry.name) for entry in free]
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


def _unit(system: System, name: str) -> str:
    component, _, variable = name.partition(".")
    fmu = system.components[component].fmu
    return fmu.variables[fmu.expand(variable)[0]].unit or "1"


def free_parameters(system: System, vary: Sequence[str], tell: Callable[[str], None]) -> list[Free]:
    """What is fitted, from the values that the system has. Raises InputError."""
    entries = vary_entries(vary)
    if not entries:
        raise InputError("--vary says what is fitted and in which range, for instance --vary drive.R=0.05:0.2")
    found = []
    for given, text in entries.items():
        name = system.full_name(given)
        form = f"{given}=low:high or {given}=low:high:log"
        if ":" not in str(text) or isinstance(text, list):
            raise InputError(f"--vary {given}={text}: write {form}")
        ends = range_of(system, name, text, form, grid=False)
        if needs_plan(system, name):
            raise InputError(f"--vary {name}: it decides what the run is made of, and is swept rather than fitted")
        system.with_values({name: ends.low}, "--vary")  # unknown names, driven inputs
        system.with_values({name: ends.high}, "--vary")
        component, _, variable = name.partition(".")
        owner = system.components[component]
        scalars = owner.fmu.expand(variable)
        if len(scalars) > 1 or not owner.fmu.is_real(scalars[0]):
            raise InputError(f"--vary {name}: one real number is fitted; name an element, such as {name}[1]")
        start = float({**owner.parameters, **owner.inputs}.get(scalars[0], owner.fmu.start(scalars[0])))
        low, high = float(ends.low), float(ends.high)
        if not low <= start <= high:
            middle = float(np.sqrt(low * high)) if ends.log else 0.5 * (low + high)
            tell(f"{name} is {start:g} in the system, outside of {low:g} to {high:g}; the fit begins at {middle:g}")
            start = middle
        found.append(Free(name, low, high, start, ends.log))
    return found


def require_apart(experiments: Sequence[Experiment], free: Sequence[Free], recipes: Sequence[Recipe]) -> None:
    """Raise InputError for a parameter that one of the experiments sets itself."""
    for experiment, recipe in zip(experiments, recipes, strict=True):
        own = {experiment.plan.system.full_name(name) for name in recipe.values}
        for entry in free:
            if entry.name in own:
                raise InputError(f"--vary {entry.name}: the experiment with {recipe.data.name} sets it; leave one out")


def sigma_of(system: System, given: Mapping[str, float], matches: Sequence[Match]) -> dict[str, float]:
    """Stated scales by full name. Raises InputError."""
    names = {system.full_name(match.name) for match in matches}
    found = {system.full_name(name): value for name, value in given.items()}
    for name, value in found.items():
        if name not in names:
            raise InputError(f"--sigma {name}: it is not among the signals of --match, {', '.join(sorted(names))}")
        if not (np.isfinite(value) and value > 0.0):
            raise InputError(f"--sigma {name}={value}: the standard deviation of a signal is above 0")
    return found
