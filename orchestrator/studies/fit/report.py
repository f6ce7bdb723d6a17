"""What a fit leaves: numbers as JSON, data and run as CSV, a parameter set to run with, and pictures."""

from __future__ import annotations

import csv
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...files import write_file, write_json
from ...results.pictures.canvas import legend_above, new_figure
from ..parameter_file import set_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .fit import Fitted


def write_fit(found: Fitted, folder: Path) -> list[Path]:
    """The files of a fit: numbers first. Raises RunError if the disk refuses."""
    paths = [write_file(folder / "fit.json", lambda path: write_json(path, content(found)))]
    paths.append(write_file(folder / "fit.csv", lambda path: write_rows(found, path)))
    text = parameter_set(found, folder)
    paths.append(write_file(folder / "fitted.toml", lambda path: path.write_text(text, encoding="utf-8")))
    picture = draw(found)
    paths.append(write_file(folder / "fit.png", lambda path: picture.savefig(path, format="png")))
    return paths


def content(found: Fitted) -> dict[str, Any]:
    """Ready for JSON."""
    return {
        "system": found.title,
        "parameters": {one.name: {key: value for key, value in asdict(one).items() if key != "name"}
                       for one in found.estimates},
        "correlations": np.asarray(found.correlations).tolist(),
        "signals": {one.name: {key: value for key, value in asdict(one).items() if key != "name"}
                    for one in found.signals},
        "data": [experiment.name for experiment in found.experiments],
        "evaluations": found.evaluations, "seconds": round(found.seconds, 3), "notes": found.notes,
        "not_identified": found.failed,
    }  # fmt: skip


def write_rows(found: Fitted, path: Path) -> None:
    """A row for each measured value: what was measured, and what the run makes of it."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["data", "signal", "unit", "time", "measured", "run"])
        for experiment, runs in zip(found.experiments, found.runs, strict=True):
            for one, run in zip(experiment.measured, runs, strict=True):
                for row in zip(one.times.tolist(), one.values.tolist(), run.tolist(), strict=True):
                    writer.writerow([experiment.name, one.name, one.unit, *map(repr, row)])


def parameter_set(found: Fitted, folder: Path) -> str:
    """The estimates as a parameter set that stands in a folder."""
    data = ", ".join(experiment.name for experiment in found.experiments)
    values = {one.name: (one.value, f"[{one.unit}] standard error {one.error:.2g}") for one in found.estimates}
    return set_text(f"fitted to {data}", found.base, values, folder)


def draw(found: Fitted) -> Figure:
    """For each signal the data with the run over it, and below it what is left, with twice its root mean square."""
    figure, axes = new_figure(f"{found.title}: fit of {', '.join(one.name for one in found.estimates)}",
                              2 * len(found.signals))  # fmt: skip
    for k, signal in enumerate(found.signals):
        above, below = axes[2 * k], axes[2 * k + 1]
        for number, (experiment, runs) in enumerate(zip(found.experiments, found.runs, strict=True)):
            one, color = experiment.measured[k], f"C{number % 10}"
            above.plot(one.times, one.values, ".", color=color, alpha=0.35, markersize=3, label=experiment.name)
            above.plot(one.times, runs[k], "-", color="black", linewidth=1.0, label="run" if number == 0 else None)
            below.plot(one.times, one.values - runs[k], ".", color=color, alpha=0.5, markersize=3)
        for side in (-2.0, 2.0):
            below.axhline(side * signal.rms, color="gray", linestyle="--", linewidth=0.8)
        above.set_ylabel(f"{signal.name} [{signal.unit}]")
        below.set_ylabel(f"data - run [{signal.unit}]")
        legend_above(above)
        for handle in above.get_legend().legend_handles:  # as faint as the points it could not be read
            handle.set_alpha(1.0)
            handle.set_markersize(6)
    axes[-1].set_xlabel("time [s]")
    return figure
