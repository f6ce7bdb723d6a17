"""Several results over each other: their signals, the differences from the first on its instants, figures of merit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from textwrap import shorten
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import InputError
from ..signals import Signal
from .canvas import caption, columns_figure, legend_above
from .lines import STYLES, draw
from .overview import shorten_label
from .rows import extent
from .shown import shown
from .traces import Traces, traces

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..result import Result

COMPUTER = ("wall_s", "real_time_factor", "start_s", "peak_memory_MB")  # of the machine, not of the run
MOST = 12  # signals in a picture that was not asked for by name


@dataclass(frozen=True)
class Compared:
    """One signal of several results, and what each of the others differs by from the first, on the first's times."""

    name: str
    signals: Sequence[Signal]  # of each result, named by it
    differences: Sequence[Signal]  # of each but the first; NaN where the other has no value

    @property
    def largest(self) -> float:
        """The largest difference over what the signal goes through; infinite where that is nothing."""
        most = max((_largest(d.values) for d in self.differences), default=0.0)
        way = max(extent(s) for s in self.signals)
        return 0.0 if most == 0.0 else most / way if way else np.inf


@dataclass(frozen=True)
class Comparison:
    """What several results have in common and what not. In a notebook its table shows; `plot()` draws it."""

    labels: tuple[str, ...]
    compared: tuple[Compared, ...]  # that differ most first, of signals that were not asked for by name
    equal: tuple[str, ...]  # signals that are the same to the last bit
    missing: tuple[str, ...]  # signals that another result has not
    merits: tuple[Mapping[str, Any], ...]  # name, unit, values (one each, or None), differences from the first
    asked: bool = False
    captions: tuple[str, ...] = ()

    def plot(self) -> Figure:
        """The picture: signals on the left, differences on the right."""
        return draw_comparison(self)

    def _repr_html_(self) -> str:
        from .page import merits_table

        return merits_table(self)

    def __repr__(self) -> str:
        return f"<Comparison of {', '.join(self.labels)}: {len(self.compared)} signals, {len(self.equal)} more equal>"


def compare(
    results: Sequence[Result | str | Path], signals: Sequence[str] = (), labels: Sequence[str] = ()
) -> Comparison:
    """Results, or folders of earlier runs, beside the first of them: `compare([a, b]).plot()`.

    `signals`: names or patterns such as `motor.*`; without, what is connected in the first. `labels`: what each result
    is called. A difference is the other less the first, on the times of the first, interpolated between the other's
    samples (of what is no real number: its last one). Raises InputError for fewer than two results, a signal that
    the first has not, or nothing in common.
    """
    from ..result import Result

    opened = [Result.open(r) if isinstance(r, (str, Path)) else r for r in results]
    if len(opened) < 2:
        raise InputError("a comparison takes two results at least")
    if labels and len(labels) != len(opened):
        raise InputError(f"{len(labels)} labels for {len(opened)} results; give one for each")
    found = [traces(result) for result in opened]
    called = tuple(labels) or _labels(results, found)
    names = found[0].chosen(signals)
    missing = [name for name in names if any(name not in other.names for other in found[1:])]
    all_compared = [_compared(name, found, called) for name in names if name not in missing]
    if not all_compared:
        raise InputError(f"{called[0]} and {called[1]} have no signal in common")
    for one in all_compared:
        units = {signal.unit for signal in one.signals}
        if len(units) > 1:
            raise InputError(f"{one.name} has different units: {', '.join(sorted(units))}")
    equal = [one.name for one in all_compared if one.largest == 0.0] if not signals else []
    kept = [one for one in all_compared if one.name not in equal]
    kept = kept if signals else sorted(kept, key=lambda one: -one.largest)
    captions = tuple(f"{label}: {t.caption}" for label, t in zip(called, found, strict=True) if t.caption)
    return Comparison(called, tuple(kept), tuple(equal), tuple(missing), tuple(merits(opened)), bool(signals), captions)


def merits(results: Sequence[Result]) -> list[Mapping[str, Any]]:
    """Figures of merit that are numbers, but those of the computer: name, unit, values, differences."""
    rows: list[Mapping[str, Any]] = []
    summaries = [result.summary for result in results]
    for key in dict.fromkeys(key for summary in summaries for key in summary):
        values = [summary.get(key) for summary in summaries]
        numbers = [v if isinstance(v, (int, float)) and not isinstance(v, bool) else None for v in values]
        if key in COMPUTER or all(v is None for v in numbers):
            continue
        unit = next((r.units[key] for r in results if key in r.units), "s" if key.endswith("_s") else "")
        first = numbers[0]
        differences = [None if first is None or v is None else v - first for v in numbers[1:]]
        rows.append({"name": key, "unit": unit, "values": numbers, "differences": differences})
    return rows


def draw_comparison(found: Comparison) -> Figure:
    """A row for each signal: all results on the left, differences from the first on the right."""
    drawn = found.compared if found.asked else found.compared[:MOST]
    title = " and ".join(found.labels) if len(found.labels) < 4 else f"{len(found.labels)} results"
    figure, axes = columns_figure(title, max(len(drawn), 1), 2)
    for one, (left, right) in zip(drawn, axes, strict=False):
        read = shown(one.signals[0].unit, [s.values for s in one.signals])
        for k, (signal, label) in enumerate(zip(one.signals, found.labels, strict=True)):
            draw(left, signal.time, signal.values, label, STYLES[k % len(STYLES)], read.factor)
        small = shown(one.signals[0].unit, [d.values for d in one.differences])
        for k, (difference, label) in enumerate(zip(one.differences, found.labels[1:], strict=True), 1):
            style, name = STYLES[k % len(STYLES)], f"{label} less {found.labels[0]}"
            draw(right, difference.time, difference.values, name, style, small.factor, f"C{k % 10}")
        left.set_ylabel(shorten_label(read.label(one.name)), fontsize="small")
        right.set_ylabel(f"[{small.unit or '1'}]", fontsize="small")
    legend_above(axes[0][0], 80)
    legend_above(axes[0][1], 60)
    if not drawn:
        axes[0][0].text(0.5, 0.5, "all signals are equal", ha="center", transform=axes[0][0].transAxes)
    caption(figure, remarks(found, len(drawn)))
    return figure


def remarks(found: Comparison, drawn: int) -> list[str]:
    """What is equal, what is not drawn, what another result has not."""
    parts = (
        ("equal to the last bit", found.equal),
        ("not drawn", [one.name for one in found.compared[drawn:]]),
        ("not in all of them", found.missing),
    )
    lines = [f"{what}: {', '.join(names)}" for what, names in parts if names]
    return [shorten(line, 400, placeholder=" ...") for line in (*lines, *found.captions)]


def _labels(given: Sequence[Any], found: Sequence[Traces]) -> tuple[str, ...]:
    """The names of folders, or of systems; made different by a number."""
    paths = [Path(one).resolve() if isinstance(one, (str, Path)) else None for one in given]
    names = [t.title if path is None else path.name for path, t in zip(paths, found, strict=True)]
    if len(set(names)) < len(names) and all(paths):
        names = ["/".join(path.parts[-2:]) for path in paths if path]
    return tuple(f"{name} {k}" if names.count(name) > 1 else name for k, name in enumerate(names, 1))


def _compared(name: str, found: Sequence[Traces], labels: Sequence[str]) -> Compared:
    own = [replace(t[name], name=label) for t, label in zip(found, labels, strict=True)]
    return Compared(name, own, [difference(own[0], other) for other in own[1:]])


def difference(first: Signal, other: Signal) -> Signal:
    """The other less the first, on the times of the first; of texts 1 where they are not the same."""
    time = first.time
    if not len(time) or not len(other.time):
        return replace(other, time=time, values=np.full(len(time), np.nan))
    outside = (time < other.time[0]) | (time > other.time[-1])
    if first.values.dtype.kind == "f" and other.values.dtype.kind == "f":
        same_grid = len(other.time) == len(time) and bool(np.all(other.time == time))
        there = other.values if same_grid else np.interp(time, other.time, other.values)
        found = there.astype(float) - first.values
        found[there == first.values] = 0.0  # infinite ones, too
    else:
        there = other.values[np.clip(np.searchsorted(other.time, time, side="right") - 1, 0, None)]
        numbers = first.values.dtype.kind in "iub" and there.dtype.kind in "iub"
        found = there.astype(float) - first.values.astype(float) if numbers else np.array(there != first.values, float)
    return replace(other, time=time, values=np.where(outside, np.nan, found))


def _largest(values: np.ndarray) -> float:
    finite = values[np.isfinite(values)]
    return float(np.max(np.abs(finite))) if len(finite) else np.inf
