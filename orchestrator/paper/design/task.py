"""The task: a shipped sweep says which system does it, with which values, and what may be otherwise.

It presses with a force on a hull of some radius, in a current. What may be otherwise are the sweep's ranges.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...results.summary.figures_of_merit import figure_of_merit
from ...studies.sweep.file import SweepFile, sweep_file
from ...system.file.merits import merit
from ..lab import Case, Lab

SWEEP = "monte_carlo"


@dataclass(frozen=True)
class Task:
    """The sweep, and the run of its system with the values that all its points have and none of the ranges."""

    study: SweepFile
    case: Case

    @cached_property
    def figures(self) -> Mapping[str, Any]:
        """Figures of merit of the run: those of the system and those of the sweep."""
        signals, found = self.case.signals, dict(self.case.summary)
        for key, text in self.study.summary.items():
            operation, names = merit(text)
            found[key] = figure_of_merit(operation, [signals[name] for name in names], *self.case.window)
        return found

    @property
    def force(self) -> float:
        """What is asked for [N]."""
        return self.case.parameter("mission.F_n")

    @property
    def radius(self) -> float:
        """Of the hull [m] across the pass; infinite of a plane one."""
        curvature = self.case.parameter("brush.hull_curvature") if self.has("brush.hull_curvature") else 0.0
        return 1.0 / curvature if curvature else np.inf

    @property
    def current(self) -> float:
        """Speed of the water [m/s]."""
        given = self.case.run.plan.system.components["vehicle"].inputs
        return float(np.linalg.norm([float(given[f"v_c[{k}]"]) for k in (1, 2, 3)]))

    def has(self, name: str) -> bool:
        """Whether a component of the system has a variable."""
        component, _, variable = name.partition(".")
        found = self.case.run.plan.system.components.get(component)
        return found is not None and bool(found.fmu.expand(variable))

    def component(self, fmu: str) -> str:
        """The component that an FMU of that name plays; empty if none does."""
        parts = self.case.run.plan.system.components.items()
        return next((name for name, part in parts if part.fmu.path.stem == fmu), "")


def task(lab: Lab) -> Task:
    """The task of the shipped sweep, run."""
    study = sweep_file(SWEEP)
    return Task(study, lab.case(study.system, study.values, study.stop))


def force_error(mean: np.ndarray, rms: np.ndarray, wanted: float) -> np.ndarray:
    """Rms of the error of a force over what is wanted, from its mean and its own rms (magnitudes), ripple and all."""
    return np.asarray(np.sqrt(np.maximum(rms**2 - 2.0 * wanted * np.abs(mean) + wanted**2, 0.0)) / wanted)
