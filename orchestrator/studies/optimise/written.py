"""What an optimisation leaves beside its points: optimise.json, optimum.toml, optimise.png."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...files import plain, write_file, write_json
from ...results.pictures.canvas import legend_above, new_figure
from ..parameter_file import set_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .optimise import Optimum

SET = "optimum.toml"


def write_found(found: Optimum, out: Path) -> tuple[Path, ...]:
    """The files, numbers first; a parameter set where the constraints hold. Raises RunError if the disk refuses."""
    paths = [write_file(out / "optimise.json", lambda path: write_json(path, as_json(found)))]
    if found.best.violation == 0.0:
        paths.append(write_file(out / SET, lambda path: path.write_text(parameter_set(found, out), encoding="utf-8")))
    if any(not trial.error for trial in found.trials):
        figure = convergence(found)
        paths.append(write_file(out / "optimise.png", lambda path: figure.savefig(path, format="png")))
    return tuple(paths)


def as_json(found: Optimum) -> dict[str, Any]:
    """Everything, ready for JSON."""
    units, best = found.request.units, found.best
    return {
        "objective": f"{'minimise' if found.aim.sign > 0 else 'maximise'} {found.aim.figure}",
        "seed": found.request.seed, "runs": len(found.trials), "failed": sum(bool(t.error) for t in found.trials),
        "feasible": best.violation == 0.0,
        "parameters": {a.name: {"value": v, "unit": a.unit} for a, v in zip(found.axes, best.values, strict=True)},
        "at an end of its range": found.at_end(),
        "figures": {name: {"value": value, "unit": units.get(name, "1")} for name, value in best.figures.items()},
        "constraints": [
            {"constraint": c.text(units[c.figure]), "excess": excess}
            for c, excess in zip(found.aim.constraints, best.excesses, strict=True)
        ],
    }  # fmt: skip


def parameter_set(found: Optimum, folder: Path) -> str:
    """The optimum as a parameter set that stands in a folder."""
    word = "least" if found.aim.sign > 0 else "greatest"
    about = f"{word} {found.aim.figure} of {found.request.system.name}, found by rovbrush optimise"
    return set_text(about, found.base, {name: (plain(value), "") for name, value in found.values.items()}, folder)


def convergence(found: Optimum) -> Figure:
    """The objective of every run, and the best so far that satisfies all constraints."""
    figure, (axis,) = new_figure(f"{found.request.system.name}: {found.aim.figure} over the runs")
    runs = range(1, len(found.trials) + 1)
    kinds = {
        "all constraints hold": [t.violation == 0.0 for t in found.trials],
        "a constraint is broken": [0.0 < t.violation < math.inf for t in found.trials],
    }
    for (label, mask), colour in zip(kinds.items(), ("tab:blue", "tab:gray"), strict=True):
        at = [(k, found.aim.sign * t.cost) for k, t, m in zip(runs, found.trials, mask, strict=True) if m]
        if at:
            axis.plot(*zip(*at, strict=True), ".", color=colour, markersize=4, label=label)
    best, course = math.inf, []
    for trial in found.trials:
        best = min(best, trial.cost) if trial.violation == 0.0 else best
        course.append(found.aim.sign * best if best < math.inf else math.nan)
    axis.plot(runs, course, color="tab:red", drawstyle="steps-post", label="best so far")
    axis.set_xlabel("run")
    unit = found.request.units[found.aim.figure]
    axis.set_ylabel(f"{found.aim.figure} [{unit}]")
    good = [found.aim.sign * t.cost for t in found.trials if t.violation == 0.0]
    if good and max(good) > min(good):  # what breaks constraints may lie far away
        room = 0.1 * (max(good) - min(good))
        axis.set_ylim(min(good) - room, max(good) + room)
    legend_above(axis)
    return figure
