"""A tornado chart: what matters most on top, a bar from a base to what each label makes of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import InputError
from .canvas import legend_above, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST = 20  # bars that can be read
BAR = 0.3  # inches of height for each


def tornado(
    title: str,
    labels: Sequence[str],
    series: Mapping[str, Sequence[float]],
    quantity: str,
    *,
    base: float = 0.0,
    intervals: Mapping[str, tuple[Sequence[float], Sequence[float]]] | None = None,
    beside: bool = False,
    most: int = MOST,
) -> Figure:
    """Horizontal bars from `base` to the values of `series`, (labels,) each, the longest on top; at most `most`.

    Two series of what a quantity becomes at the low and at the high end of each label share a row; with `beside` they
    lie one below the other, as sensitivity indices do. `intervals`: by series, the lower and the upper ends of what
    each value may be, in the unit of the values, drawn as whiskers. `quantity` is the label of the axis,
    `name [unit]`. A value that is not finite has no bar, and its label comes last. Raises InputError for lengths that
    differ, or for nothing to draw.
    """
    if not labels or not series:
        raise InputError(f"{title}: nothing to draw")
    wrong = [name for name, values in series.items() if len(values) != len(labels)]
    wrong += [name for name, ends in (intervals or {}).items() if any(len(end) != len(labels) for end in ends)]
    if wrong:
        raise InputError(f"{title}: {wrong[0]} has another length than the {len(labels)} labels")
    order = longest_first(list(series.values()), base)[:most]
    figure, (axis,) = new_figure(title)
    figure.set_size_inches(8.0, 1.5 + BAR * len(order) * (len(series) if beside else 1))
    draw_bars(axis, order, series, base, intervals or {}, beside)
    axis.set_yticks(np.arange(len(order)), [labels[k] for k in order])
    axis.set_xlabel(quantity)
    if len(order) < len(labels):
        axis.set_ylabel(f"the first {len(order)} of {len(labels)}")
    if len(series) > 1:
        legend_above(axis)
    return figure


def longest_first(series: Sequence[Sequence[float]], base: float) -> list[int]:
    """The places of the labels, that with the longest bar first, and those without any last."""
    lengths = np.abs(np.asarray(series, dtype=float) - base)
    reach = np.max(np.where(np.isfinite(lengths), lengths, -1.0), axis=0)
    return [int(k) for k in np.argsort(-reach, kind="stable")]


def draw_bars(
    axis: Any,
    order: Sequence[int],
    series: Mapping[str, Sequence[float]],
    base: float,
    intervals: Mapping[str, tuple[Sequence[float], Sequence[float]]],
    beside: bool,
) -> None:
    """The bars of each series, the first row on top."""
    rows, count = np.arange(len(order), dtype=float), len(series) if beside else 1
    height = 0.8 / count
    for k, (name, all_values) in enumerate(series.items()):
        values = np.asarray(all_values, dtype=float)[list(order)]
        at = rows + (k - (count - 1) / 2) * height if beside else rows
        axis.barh(at, values - base, 0.9 * height, left=base, label=name, alpha=0.85)
        if name in intervals:
            ends = [np.asarray(end, dtype=float)[list(order)] for end in intervals[name]]
            axis.hlines(at, *ends, color="black", linewidth=1.2)
            for end in ends:
                axis.plot(end, at, "|", color="black", markersize=6)
    axis.axvline(base, color="black", linewidth=0.8)
    axis.set_ylim(len(order) - 0.5, -0.5)
    axis.margins(x=0.05)
    axis.autoscale_view(scaley=False)
