"""Figures of a run, as its system file asks for them; every axis is labelled `name [unit]`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...system.file.figure_kinds import figure_kind
from ..profiles import Profiles, profiles
from ..signals import Signal, Signals
from ..tables import Run
from .canvas import captioned, legend_above, new_figure
from .lines import STYLES, draw
from .shown import shown

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
    """One axis per unit, the signals of that unit in it, in the unit in which people read it."""
    found = [signals[name] for name in entry["signals"]]
    units = list(dict.fromkeys(s.unit for s in found))
    figure, axes = new_figure(entry["title"], len(units))
    for axis, unit in zip(axes, units, strict=True):
        members = [cut(s, entry.get("from"), entry.get("to")) for s in found if s.unit == unit]
        read = shown(unit, [s.values for s in members])
        for k, signal in enumerate(members):
            draw(axis, signal.time, signal.values, signal.name, STYLES[k % len(STYLES)], read.factor)
        axis.set_ylabel(read.label(members[0].name) if len(members) == 1 else f"[{read.unit or '1'}]")
        if "reference" in entry:
            value = read.factor * entry["reference"]
            line = {"linestyle": "--", "color": "black", "linewidth": 0.9}
            axis.axhline(value, label=f"paper: {value:g} {read.unit}", **line)
        if len(members) > 1 or "reference" in entry:
            legend_above(axis)
    axes[-1].set_xlabel("time [s]")
    return figure


def cut(signal: Signal, begin: float | None = None, end: float | None = None) -> Signal:
    """A signal between two instants [s], both of them in it; all of it without."""
    inside = np.ones(len(signal.time), dtype=bool)
    inside &= signal.time >= begin if begin is not None else True
    inside &= signal.time <= end if end is not None else True
    return replace(signal, time=signal.time[inside], values=signal.values[inside])


def along(found: Profiles, title: str) -> Figure:
    """One axis per signal, all its instants in it; a value reaches half way to the next place."""
    names = list(dict.fromkeys(vector.name for vector in found.vectors))
    figure, axes = new_figure(title, len(names))
    place = shown(found.along.unit, [found.along.values])
    for axis, name in zip(axes, names, strict=True):
        members = [vector for vector in found.vectors if vector.name == name]
        read = shown(members[0].unit, [vector.values for vector in members])
        for k, vector in enumerate(members):
            style = STYLES[k % len(STYLES)]
            line = {"drawstyle": "steps-mid", "linewidth": 1.1, "label": vector.when}
            axis.plot(place.factor * found.along.values, read.factor * vector.values, style, **line)
        axis.set_ylabel(read.label(members[0].name))
        if len(members) > 1:
            legend_above(axis)
    axes[-1].set_xlabel(place.label(found.along.name))
    return figure
