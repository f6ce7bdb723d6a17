"""How sure it is: the task at random points of all that may be otherwise; error bars, and what they come from."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.stats import spearmanr

from ...studies.sweep.options import Options
from ...studies.sweep.sweep import sweep
from .task import SWEEP, Task, force_error

LIMIT = 0.1  # of the force that is asked for: a larger error is not held
BAR = (5.0, 50.0, 95.0)  # percentiles: the ends of the error bars, and the middle
NEEDED = ("F_z_mean", "F_z_rms", "contact_share")  # figures of merit that tell whether a point holds


@dataclass(frozen=True)
class Cause:
    """A number that is varied, its range, and the rank correlation of the force error with it, -1 to 1."""

    name: str
    low: float
    high: float
    correlation: float


@dataclass(frozen=True)
class Spread:
    """What the points gave, (points,) each; NaN where a run failed."""

    error: np.ndarray  # rms of the force error over the force
    contact: np.ndarray  # share of the window in contact
    figures: dict[str, np.ndarray]
    causes: list[Cause]
    failures: list[str]
    command: str

    @property
    def held(self) -> np.ndarray:
        """Which points neither lose contact nor miss the force by more than LIMIT, (points,)."""
        return np.asarray((self.contact >= 1.0) & (self.error <= LIMIT))

    def bar(self, values: np.ndarray) -> tuple[float, float, float]:
        """The ends of an error bar and its middle, of the points that did not fail: low, middle, high."""
        low, middle, high = np.nanpercentile(values, BAR)
        return float(low), float(middle), float(high)


def spread(
    task: Task,
    out: Path,
    points: int,
    fmus: Path | None,
    progress: Callable[[int, int], None] = lambda _done, _of: None,
) -> Spread:
    """Run so many points of the sweep on all cores, in a folder of `out` of their own, where it goes on if it can."""
    swept = sweep(SWEEP, out / f"{SWEEP}_{points}", Options(random=points, fmus=fmus), progress=progress)
    table = swept.table
    columns = {name: table.column(name) for name in table.figures}
    error = force_error(columns["F_z_mean"], columns["F_z_rms"], task.force)
    failures = [text for text in table.errors() if text]
    causes = []
    for axis in table.design.axes:
        values = np.array(axis.values, dtype=float)
        found = np.isfinite(error)
        correlation = float(spearmanr(values[found], error[found]).statistic) if np.ptp(values[found]) else 0.0
        causes.append(Cause(axis.name, float(values.min()), float(values.max()), correlation))
    causes.sort(key=lambda cause: -abs(cause.correlation))
    command = f"rovbrush sweep {SWEEP} --random {points}"
    return Spread(error, columns["contact_share"], columns, causes, failures, command)
