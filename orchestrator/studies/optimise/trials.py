"""The points that a search asks for: each computed once, by the workers of a sweep, and kept in points.jsonl."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...fmu.types import Value
from ..sweep.design.axis import Range
from ..sweep.design.sampling import Choices
from ..sweep.points import Points
from ..sweep.workers.point import Job
from ..sweep.workers.workers import Workers, computed
from .constraint import Constraint

Values = tuple[Value, ...]


@dataclass(frozen=True)
class Aim:
    """What is sought: the least (`sign` 1) or the greatest (-1) of a figure, under constraints."""

    figure: str
    sign: int
    constraints: tuple[Constraint, ...]


@dataclass(frozen=True)
class Trial:
    """A point that was computed: the cost is to be small, the excesses at most 0; both infinite where it failed."""

    values: Values
    figures: Mapping[str, float]
    cost: float
    excesses: tuple[float, ...]
    error: str = ""

    @property
    def violation(self) -> float:
        """The sum of what breaks constraints."""
        return sum(max(0.0, excess) for excess in self.excesses) if not self.error else math.inf

    @property
    def rank(self) -> tuple[float, float]:
        """The smaller the better: what breaks no constraint comes first."""
        return (self.violation, self.cost)


class Trials:
    """Every point in the order in which it was asked for, whatever the order in which workers finish."""

    def __init__(
        self, job: Job, workers: Workers, points: Points, spaces: Mapping[str, Range | Choices], aim: Aim,
        progress: Callable[[int], None],
    ) -> None:  # fmt: skip
        self.job, self.workers, self.points, self.spaces, self.aim = job, workers, points, spaces, aim
        self.progress = progress
        self.kept = dict(points.records)
        self.found: dict[Values, Trial] = {}

    def values(self, shares: np.ndarray) -> list[Values]:
        """The values at points of the unit cube, (points, parameters)."""
        columns = [space.at(shares[:, k]) for k, space in enumerate(self.spaces.values())]
        return [tuple(row) for row in zip(*columns, strict=True)]

    def at(self, shares: np.ndarray) -> list[Trial]:
        """The trials at points of the unit cube, (points, parameters); new ones are computed together."""
        wanted = self.values(np.atleast_2d(shares))
        new = [values for values in dict.fromkeys(wanted) if values not in self.found]
        begin = len(self.found)
        tasks, records = [], dict[int, Mapping[str, Any]]()
        for k, values in enumerate(new, begin):
            before = self.kept.get(k, {})
            if before.get("values") == list(values) and "figures" in before:
                records[k] = before
            else:
                tasks.append((k, dict(zip(self.spaces, values, strict=True))))
        for done, (k, record) in enumerate(computed(self.workers, self.job, tasks), begin + 1):
            kept = {"values": list(new[k - begin]), **record}
            self.points.add(k, kept)
            records[k] = kept
            self.progress(done)
        for k, values in enumerate(new, begin):
            self.found[values] = self._trial(values, records[k])
        return [self.found[values] for values in wanted]

    def _trial(self, values: Values, record: Mapping[str, Any]) -> Trial:
        figures = {name: math.nan if v is None else float(v) for name, v in record.get("figures", {}).items()}
        cost = self.aim.sign * figures.get(self.aim.figure, math.nan)
        excesses = tuple(c.excess(figures.get(c.figure, math.nan)) for c in self.aim.constraints)
        error = str(record.get("error", ""))
        if not error and not all(map(math.isfinite, (cost, *excesses))):
            error = "a figure of merit is no number"
        if error:
            return Trial(values, figures, math.inf, tuple(math.inf for _ in excesses), error)
        return Trial(values, figures, cost, excesses)

    @property
    def all(self) -> Sequence[Trial]:
        return list(self.found.values())

    def best(self) -> Trial:
        """The best so far, the first of equal ones."""
        return min(self.found.values(), key=lambda trial: trial.rank)
