"""Figures of a run, as its system file asks for them; every axis is labelled `name [unit]`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ...system.file.figure_kinds import figure_kind
from ..profiles import Profiles, profiles
from ..signals import Signals
from ..tables import Run
from .canvas import captioned, new_figure
from .lines import STYLES, draw

if TYPE_CHECKING:
    from matplotlib.figure import Figure


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
