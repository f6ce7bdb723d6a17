"""Figures of a run, as its system file asks for them; every axis is labelled `name [unit]`."""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from ..system.file.figure_kinds import figure_kind
from .profiles import Profiles, profiles
from .signals import Signals
from .tables import Run

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COLUMNS, SAMPLES = 700, 4  # of a figure: places side by side, and samples in each that can still be told apart
CAPTION = 150  # characters in a line of it
STYLES = ("-", "--", "-.", ":")  # of signals in one axis: one does not hide the other


def figure(run: Run, entry: Mapping[str, Any]) -> Figure | None:
    """The figure of a `[[figures]]` entry; None if a signal of it was not recorded.

    An entry has `file`, `title` and `signals`, or a `kind` (see `figure_kinds`); optional: `from`, `to` [s] and
    `reference` (a value drawn as a dashed line), or `along` (see `profiles`).
    """
    if "along" in entry:
        found = profiles(run, entry)
        return captioned(along(found, entry["title"]), run) if found else None
    if "kind" in entry:
        drawn: Figure = figure_kind(entry["kind"]).draw(run.calculated, entry)
        return captioned(drawn, run)
    signals = Signals(run)
    return captioned(time_series(signals, entry), run) if all(name in signals for name in entry["signals"]) else None


def captioned(figure: Figure, run: Run) -> Figure:
    """The figure with what the run's parameter set says of itself below it."""
    if run.plan.system.parameter_set:
        said = fill(f"parameters: {run.plan.system.parameter_set}", CAPTION)
        figure.supxlabel(said, x=0.01, ha="left", fontsize=7, color="dimgray")
    return figure


def new_figure(title: str, rows: int = 1, share: bool = True) -> tuple[Figure, list[Any]]:
    """An empty figure with `rows` axes one above the other, of one horizontal axis if `share`."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.0, 1.2 + 2.6 * rows), dpi=110, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, 1, sharex=share, squeeze=False)[:, 0]
    figure.suptitle(title)
    for axis in axes:
        axis.grid(alpha=0.3)
        axis.margins(x=0)
    return figure, list(axes)


def draw(axis: Any, time: np.ndarray, values: np.ndarray, name: str, style: str) -> None:
    """A signal as a line; one of more samples than a figure can show as its mean in a band from least to largest."""
    if len(time) < SAMPLES * COLUMNS or values.dtype.kind not in "fiu":
        axis.plot(time, values, style, linewidth=0.9, label=name)
        return
    firsts = np.linspace(0, len(time), COLUMNS, endpoint=False, dtype=int)
    counts = np.diff([*firsts, len(time)])
    middle = np.add.reduceat(time, firsts) / counts
    (line,) = axis.plot(middle, np.add.reduceat(values, firsts) / counts, style, linewidth=0.9, label=name)
    least, largest = np.minimum.reduceat(values, firsts), np.maximum.reduceat(values, firsts)
    axis.fill_between(middle, least, largest, color=line.get_color(), alpha=0.25, linewidth=0.0)


def time_series(signals: Signals, entry: Mapping[str, Any]) -> Figure:
    """One axis per unit, the signals of that unit in it."""
    found = [signals[name] for name in entry["signals"]]
    units = list(dict.fromkeys(s.unit for s in found))
    figure, axes = new_figure(entry["title"], len(units))
    for axis, unit in zip(axes, units, strict=True):
        members = [s for s in found if s.unit == unit]
        for k, signal in enumerate(members):
            inside = (signal.time >= entry.get("from", signal.time[0])) & (
                signal.time <= entry.get("to", signals.run.end)
            )
            draw(axis, signal.time[inside], signal.values[inside], signal.name, STYLES[k % len(STYLES)])
        axis.set_ylabel(members[0].label if len(members) == 1 else f"[{unit}]")
        if "reference" in entry:
            axis.axhline(
                entry["reference"],
                linestyle="--",
                color="black",
                linewidth=0.9,
                label=f"paper: {entry['reference']:g} {unit}",
            )
        if len(members) > 1 or "reference" in entry:
            axis.legend(loc="best", fontsize="small")
    axes[-1].set_xlabel("time [s]")
    return figure


def along(found: Profiles, title: str) -> Figure:
    """One axis per signal, all its instants in it; a value reaches half way to the next place."""
    names = list(dict.fromkeys(vector.name for vector in found.vectors))
    figure, axes = new_figure(title, len(names))
    for axis, name in zip(axes, names, strict=True):
        members = [vector for vector in found.vectors if vector.name == name]
        for k, vector in enumerate(members):
            style = STYLES[k % len(STYLES)]
            line = {"drawstyle": "steps-mid", "linewidth": 1.1, "label": vector.when}
            axis.plot(found.along.values, vector.values, style, **line)
        axis.set_ylabel(members[0].label)
        if len(members) > 1:
            axis.legend(loc="best", fontsize="small")
    axes[-1].set_xlabel(found.along.label)
    return figure
