"""Fit the parameters that the paper does not give to its Table 3, with runs of the FMUs themselves."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..cli.console import console
from ..errors import RunError
from ..files import prepare_folder, write_file
from ..plan.plan import make_plan
from ..results.summary import summarize
from ..results.tables import require_complete
from ..run.planned import planned
from ..run.simulation import simulate
from ..system.assemble import assemble
from ..system.model import System
from ..system.reader import SYSTEMS

SPECIFICATION = Path(__file__).with_name("calibration.toml")
EVALUATIONS = 40  # iterations of the least-squares solver per rung of the ladder


@dataclass(frozen=True)
class Fit:
    """The result for one rung: values by name, the summary they give, and which bounds they miss."""

    values: dict[str, float]
    summary: dict[str, Any]
    missed: list[str]


def calibrate(out: Path | None, fmus: Path | None) -> Fit:
    """Descend the ladder, fit at each rung from the fit above, write the file of the lowest that meets every bound.

    Deterministic: no random numbers. Raises RunError if no rung does; the file is then left as it is.
    """
    with SPECIFICATION.open("rb") as file:
        specification = tomllib.load(file)
    target_file = out or SYSTEMS / specification["write"]
    prepare_folder(target_file.parent)
    system = planned(assemble(specification["system"], {}, fmus=fmus)).system
    ((rung, candidates),) = specification["ladder"].items()
    start = {name: entry["start"] for name, entry in specification["free"].items()}
    best = None
    for candidate in candidates:
        fit = fit_rung(system, specification, {rung: float(candidate), **specification["held"]}, start)
        report(fit, specification)
        start = {name: fit.values[name] for name in start}
        if not fit.missed:
            best = fit
        elif best is not None:
            break
    if best is None:
        raise RunError(f"no {rung} of {candidates} meets every bound; {target_file} is left as it was")
    text = parameter_file(best, specification)
    write_file(target_file, lambda path: path.write_text(text, encoding="utf-8"))
    console.print(f"wrote {target_file}")
    return best


def fit_rung(
    system: System, specification: Mapping[str, Any], fixed: Mapping[str, float], start: Mapping[str, float]
) -> Fit:
    """Bounded nonlinear least squares (scipy, trust region reflective) over the free parameters."""
    from scipy.optimize import least_squares

    free = specification["free"]
    coded = {name: np.log if entry.get("log") else np.asarray for name, entry in free.items()}
    first = {name: {**entry, "start": start[name]} for name, entry in free.items()}
    edges = np.array([[coded[name](entry[key]) for name, entry in first.items()] for key in ("low", "start", "high")])

    def values(x: np.ndarray) -> dict[str, float]:
        decoded = {
            name: float(np.exp(v)) if free[name].get("log") else float(v) for name, v in zip(free, x, strict=True)
        }
        return {**fixed, **decoded}

    def run(x: np.ndarray) -> dict[str, Any]:
        return summarize(require_complete(simulate(make_plan(system.with_values(values(x), "calibration")))))

    def residuals(x: np.ndarray) -> np.ndarray:
        summary = run(x)
        terms = [(summary[key] / t["reference"] - 1.0) / t["scale"] for key, t in specification["targets"].items()]
        terms += [
            max(0.0, summary[key] - limit["at_most"]) / limit["scale"] for key, limit in specification["limits"].items()
        ]
        return np.array(terms)

    # Contact makes the means a little rough: differences over 1e-3 of each parameter, not over rounding errors.
    solution = least_squares(
        residuals,
        edges[1],
        bounds=(edges[0], edges[2]),
        x_scale="jac",
        diff_step=[1e-3] * len(free),
        max_nfev=EVALUATIONS,
    )
    best = {name: float(f"{v:.5g}") for name, v in values(solution.x).items()}
    summary = summarize(require_complete(simulate(make_plan(system.with_values(best, "calibration")))))
    missed = [key for key, t in specification["targets"].items() if abs(summary[key] / t["reference"] - 1) > t["bound"]]
    missed += [key for key, limit in specification["limits"].items() if summary[key] > limit["at_most"] * 1.005]
    return Fit(best, summary, missed)


def report(fit: Fit, specification: Mapping[str, Any]) -> None:
    """One paragraph per rung."""
    console.print("  ".join(f"{name} = {value:g}" for name, value in fit.values.items()))
    for key, target in specification["targets"].items():
        console.print(
            f"  {key:<14} {fit.summary[key]:10.4f}  target {target['reference']:g}  {deviation(fit, key, target)}"
        )
    for key, limit in specification["limits"].items():
        console.print(f"  {key:<14} {fit.summary[key]:10.4f}  at most {limit['at_most']:g}")
    console.print(f"  misses {', '.join(fit.missed)}" if fit.missed else "  meets every bound")


def deviation(fit: Fit, key: str, target: Mapping[str, Any]) -> str:
    """How far a target is missed, as `(+0.94 %)`."""
    return f"({100 * (fit.summary[key] / target['reference'] - 1):+.2f} %)"


def parameter_file(fit: Fit, specification: Mapping[str, Any]) -> str:
    """The TOML text of the fitted values, with what they reach."""
    lines = ["# Calibrated to the paper's Table 3 by `rovbrush calibrate`; do not edit by hand.", "#"]
    for key, target in specification["targets"].items():
        lines.append(f"# {key} = {fit.summary[key]:.4f}, paper {target['reference']:g} {deviation(fit, key, target)}")
    lines += [f"# {key} = {fit.summary[key]:.4f}" for key in specification["limits"]]
    for component in dict.fromkeys(name.split(".")[0] for name in fit.values):
        lines += ["", f"[{component}]"]
        lines += [
            f"{name.split('.')[1]} = {value!r}"
            for name, value in fit.values.items()
            if name.startswith(f"{component}.")
        ]
    return "\n".join(lines) + "\n"
