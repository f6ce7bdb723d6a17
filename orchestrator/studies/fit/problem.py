"""What a fit makes small: data less runs of all experiments over the scale of each signal; and where that is least."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ...errors import InputError, RunError
from .experiment import Experiment
from .solver import Free, differences, minimise, values_at

STEPS = 60  # of the solver in each round
ROUNDS = 4  # in which the scale of each signal is found anew from what is left of it
SETTLED = 0.02  # relative change of all scales at which they are what they are
SHARE = 1e-3  # of a range: what a run changes by is then well above its rounding and its events
LEAST_SCALE = 1e-9  # of what a signal ranges over: data without noise


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
