"""One experiment: a system whose inputs follow what was measured, and how far a run with other values is from it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import isfinite
from pathlib import Path

import numpy as np

from ...clock import seconds_text
from ...errors import InputError
from ...plan.plan import Plan, make_plan
from ...results.signals import Signals
from ...results.tables import require_complete
from ...run.simulation import simulate
from ...system.assemble import assemble, over
from ...system.model import System
from ...system.request import UNCHANGED, Changes
from .data import Match, Measured, driven_by, measured, read, unused, with_data


@dataclass(frozen=True)
class Recipe:
    """What an experiment is made of: data, the values and the times that are its own."""

    data: Path
    values: Mapping[str, object] = field(default_factory=dict)
    start: str = ""
    stop: str = ""


@dataclass(frozen=True)
class Experiment:
    """A plan that can be run with other values, and what was measured."""

    name: str
    plan: Plan
    measured: tuple[Measured, ...]

    def run(self, values: Mapping[str, float]) -> list[np.ndarray]:
        """The measured signals at the times of the data, straight between the rows of the run. Raises RunError."""
        plan = replace(self.plan, system=self.plan.system.with_values(values, "--vary"))
        signals = Signals(require_complete(simulate(plan)))
        found = []
        for one in self.measured:
            signal = signals[one.name]
            found.append(np.interp(one.times, signal.time, np.asarray(signal.values, dtype=float)))
        return found


def make_experiment(
    name: str, recipe: Recipe, matches: Sequence[Match], values: Mapping[str, object], fmus: Path | None,
    changes: Changes = UNCHANGED, tell: Callable[[str], None] = lambda _line: None,
) -> Experiment:  # fmt: skip
    """Read, check and plan. A run that is given no stop ends with the data. Raises InputError, FmuError."""
    columns = read(recipe.data)
    system = assemble(name, {**values, **recipe.values}, recipe.stop, fmus, changes, start=recipe.start)
    for match in matches:
        if match.column not in columns:
            measured(system, match, columns, recipe.data, (0.0, 0.0), tell)  # which says so
    if not recipe.stop:
        times = [time for m in matches for _, time, _ in columns[m.column].rows if isfinite(time)]
        system = _ending_with(system, max(times, default=0.0), recipe.data)
    span = float(system.start), float(system.stop)
    seen = tuple(measured(system, match, columns, recipe.data, span, tell) for match in matches)
    inputs = driven_by(system, columns, matches, recipe.data)
    for line in unused(system, columns, inputs, matches, recipe.data):
        tell(line)
    system = with_data(system, columns, inputs, recipe.data)
    plan = make_plan(replace(system, record=tuple(one.name for one in seen), reporting=_nothing(system)))
    recorded = {".".join(key) for group in plan.groups for key in group.columns}
    for one in seen:
        if one.name not in recorded:
            raise InputError(f"--match {one.name}: it is not recorded; outputs, locals and parameters can be compared")
    return Experiment(recipe.data.name, plan, seen)


def _ending_with(system: System, last: float, path: Path) -> System:
    """The run to the last time of the data."""
    if last <= float(system.start):
        raise InputError(
            f"--data {path.name}: the data end at {last:g} s, where the run begins ({seconds_text(system.start)}); "
            "shift their times, or give --start"
        )
    return over(system, "", repr(last), ("--start", f"the last time of {path.name}"))


def _nothing(system: System) -> dict[str, object]:
    """No figures of merit: they may need signals that are not recorded here."""
    return {**system.reporting, "summary": {}, "balance": {}, "figures": []}
