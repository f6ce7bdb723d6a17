"""A picture of any run: signals in rows, all of the run on the left, on the right a closer look where it matters."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import shorten
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import InputError
from ..signals import Signal
from .canvas import caption, columns_figure, legend_above
from .figures import cut
from .lines import draw
from .rows import Row, is_constant, rows
from .traces import Traces
from .zoom import zoom

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST = 10  # rows that a picture made without asking has
ASKED = 60  # rows that one can have which was asked for
WORDS = 400  # characters below a picture


def overview(found: Traces) -> Figure:
    """The connected signals of a run, of one without connections all that is recorded; what does not move is told."""
    return picture(found, found.usual(), most=MOST, constants=False)


def picture(
    found: Traces,
    names: Sequence[str],
    begin: float | None = None,
    end: float | None = None,
    most: int = ASKED,
    constants: bool = True,
) -> Figure:
    """These signals between two instants [s], `most` rows of them; those that stay constant if `constants`.

    Raises InputError if nothing lies between the instants.
    """
    signals = [cut(found[name], begin, end) for name in names]
    if names and not any(len(s.time) for s in signals):
        raise InputError(f"{found.title}: nothing was recorded {span_text(begin, end)}")
    signals = [s for s in signals if len(s.time)]
    moving = [s for s in signals if constants or not is_constant(s)]
    all_rows = rows(moving or signals)
    shown_rows, left_out = all_rows[:most], [s.name for row in all_rows[most:] for s in row.signals]
    closer = zoom([s for row in shown_rows for s in row.signals], [t for t, _ in found.events])
    figure, axes = columns_figure(found.title, len(shown_rows), 1 if closer is None else 2)
    for row, (whole, *near) in zip(shown_rows, axes, strict=True):
        draw_row(whole, row)
        for axis in near:
            assert closer is not None
            draw_row(axis, row, *closer, legend=False)
            whole.axvspan(*closer, color="tab:orange", alpha=0.15, linewidth=0.0)
    for when, _ in found.events[:MOST]:
        for row_axes in axes:
            row_axes[0].axvline(when, color="black", linewidth=0.5, alpha=0.5)
    still = [s for s in signals if s not in moving] if moving else []
    caption(figure, words(found, still, left_out))
    return figure


def draw_row(axis: Any, row: Row, begin: float | None = None, end: float | None = None, legend: bool = True) -> None:
    """The signals of a row, all of them or between two instants [s]."""
    for signal, style in zip(row.signals, row.styles(), strict=True):
        part = signal if begin is None else cut(signal, *beside(signal, begin, end))
        draw(axis, part.time, part.values, row.short(signal), style, row.read.factor)
    if begin is not None:
        axis.set_xlim(begin, end)
    if legend:
        axis.set_ylabel(shorten_label(row.label), fontsize="small")
        if len(row.signals) > 1:
            legend_above(axis, 80)


def beside(signal: Signal, begin: float, end: float | None) -> tuple[float, float]:
    """The instants of the samples next to a span on both sides, so that a line reaches its ends."""
    last = len(signal.time) - 1
    first = max(int(np.searchsorted(signal.time, begin, side="right")) - 1, 0)
    then = last if end is None else min(int(np.searchsorted(signal.time, end)), last)
    return float(signal.time[first]), float(signal.time[then])


def words(found: Traces, still: Sequence[Signal], left_out: Sequence[str]) -> list[str]:
    """What the picture does not show, and how the run ended."""
    lines = [f"ended early: {found.failure}"] if found.failure else []
    if still:
        lines.append("constant: " + ", ".join(f"{s.name} = {_value(s)}" for s in still))
    if left_out:
        lines.append(f"not drawn (rovbrush plot DIR NAME...): {', '.join(left_out)}")
    return [shorten(line, WORDS, placeholder=" ...") for line in [*lines, found.caption] if line]


def _value(signal: Signal) -> str:
    value = signal.values[0]
    text = f"{value:.6g}" if signal.values.dtype.kind == "f" else str(value)
    return f"{text} {signal.unit}" if signal.unit not in ("", "1") else text


def span_text(begin: float | None, end: float | None) -> str:
    """`between 1 s and 2 s`, or what is given of it."""
    if begin is not None and end is not None:
        return f"between {begin:g} s and {end:g} s"
    return f"after {begin:g} s" if begin is not None else f"before {end:g} s" if end is not None else "at all"


def shorten_label(label: str) -> str:
    """A long name on two lines, so that it fits beside its axis."""
    if len(label) <= 18:
        return label
    owner, dot, rest = label.partition(".")
    return f"{owner}.\n{rest}" if dot else label
