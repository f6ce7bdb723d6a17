"""Fit the parameters that the paper does not give to its Table 3, with runs of the FMUs themselves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import RunError
from ..files import prepare_folder, write_file
from ..plan.plan import make_plan
from ..results.summary.summary import summarize
from ..results.tables import require_complete
from ..run.planned import planned
from ..run.simulation import simulate
from ..studies.fit.solver import Free, minimise, values_at
from ..system.assemble import assemble
from ..system.file.shipped import SYSTEMS
from ..system.model import System
from .specification import Specification, read_specification

BUNDLE = "bristles_per_filament"
EVALUATIONS = 40  # iterations of the least-squares solver per rung of the ladder


@dataclass(frozen=True)
class Figure:
    """A figure of merit of a fit: a target with the bound within which it is to be met, or a limit."""

    name: str
    value: float
    wanted: float
    limit: bool = False

    @property
    def deviation(self) -> float:
        """Of the value from the one that is wanted, relative."""
        return self.value / self.wanted - 1.0


@dataclass(frozen=True)
class Fit:
    """The result for one rung: values by name, the figures they give, and which bounds they miss."""

    values: dict[str, float]
    figures: list[Figure]
    missed: list[str]


def calibrate(
    out: Path | None, fmus: Path | None, report: Callable[[Fit], None] = lambda _fit: None
) -> tuple[Fit, Path]:
    """Descend the ladder, fit at each rung from the fit above, write the file of the lowest that meets every bound.

    `report` hears of each rung's fit. Returns the best and its file. Deterministic: no random numbers. Raises RunError
    if no rung meets every bound; the file is then left as it is.
    """
    specification = read_specification()
    target_file = out or SYSTEMS / specification.write
    prepare_folder(target_file.parent)
    system = planned(assemble(specification.system, {}, fmus=fmus)).system
    ((rung, candidates),) = specification.ladder.items()
    start = {name: entry.start for name, entry in specification.free.items()}
    best = None
    for candidate in candidates:
        fit = fit_rung(system, specification, {rung: candidate, **specification.held}, start)
        report(fit)
        start = {name: fit.values[name] for name in start}
        if not fit.missed:
            best = fit
        elif best is not None:
            break
    if best is None:
        raise RunError(f"no {rung} of {candidates} meets every bound; {target_file} is left as it was")
    text = parameter_file(best, brush_text(system.with_values(best.values, "calibration")))
    write_file(target_file, lambda path: path.write_text(text, encoding="utf-8"))
    return best, target_file


def fit_rung(
    system: System, specification: Specification, fixed: Mapping[str, float], start: Mapping[str, float]
) -> Fit:
    """Bounded nonlinear least squares over the free parameters, as `studies/fit` does it, to figures of merit."""
    free = [Free(name, e.low, e.high, start[name], e.log) for name, e in specification.free.items()]

    def run(values: Mapping[str, float]) -> dict[str, Any]:
        return summarize(require_complete(simulate(make_plan(system.with_values(values, "calibration")))))

    def residuals(values: Mapping[str, float]) -> np.ndarray:
        summary = run({**fixed, **values})
        terms = [(summary[key] / t.reference - 1.0) / t.scale for key, t in specification.targets.items()]
        terms += [max(0.0, summary[key] - limit.at_most) / limit.scale for key, limit in specification.limits.items()]
        return np.array(terms)

    # Contact makes the means a little rough: differences over 1e-3 of each parameter, not over rounding errors.
    solution = minimise(residuals, free, EVALUATIONS, diff_step=[1e-3] * len(free))
    best = {name: float(f"{v:.5g}") for name, v in {**fixed, **values_at(free, solution.x)}.items()}
    summary = run(best)
    missed = [key for key, t in specification.targets.items() if abs(summary[key] / t.reference - 1) > t.bound]
    missed += [key for key, limit in specification.limits.items() if summary[key] > limit.at_most * 1.005]
    figures = [Figure(key, summary[key], t.reference) for key, t in specification.targets.items()]
    figures += [Figure(key, summary[key], limit.at_most, True) for key, limit in specification.limits.items()]
    return Fit(best, figures, missed)


def brush_text(system: System) -> str:
    """What the bristles of a fitted brush would amount to: their number, section [m2] and mass [kg]."""
    brush = system.components["brush"]
    n, N_b, d, L, rho = (
        float(brush.parameters.get(name, brush.fmu.start(name))) for name in ("n", BUNDLE, "d", "L", "rho")
    )
    section = n * N_b * np.pi * d**2 / 4.0
    return (
        f"the paper's Table 3; not a buildable brush: {n:g} x {N_b:g} bristles of {1e3 * d:g} mm are "
        f"{section:.2f} m2 of section and {section * L * rho:.0f} kg"
    )


def parameter_file(fit: Fit, description: str) -> str:
    """The TOML text of the fitted values, with what they reach."""
    lines = ["# Calibrated to the paper's Table 3 by `rovbrush calibrate`; do not edit by hand.", "#"]
    for f in fit.figures:
        reached = f"# {f.name} = {f.value:.4f}"
        lines.append(reached if f.limit else f"{reached}, paper {f.wanted:g} ({100 * f.deviation:+.2f} %)")
    lines += ["", f'description = "{description}"']
    for component in dict.fromkeys(name.split(".")[0] for name in fit.values):
        lines += ["", f"[{component}]"]
        lines += [
            f"{name.split('.')[1]} = {value!r}"
            for name, value in fit.values.items()
            if name.startswith(f"{component}.")
        ]
    return "\n".join(lines) + "\n"
