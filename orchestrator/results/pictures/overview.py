"""A picture of any run: signals in rows, all of the run on the left, on the right a closer look where it matters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
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
ASKED = 60  # rows that one can have for which signals were named, and a page
WORDS = 400  # characters below a picture


@dataclass(frozen=True)
class Choice:
    """What is drawn of a run."""

    rows: Sequence[Row]
    left_out: Sequence[Row]  # for which there is no room
    still: Sequence[Signal]  # that stay constant, and are told below

    def require_rows(self, found: Traces) -> None:
        """Raise InputError where there is nothing to draw."""
        if not self.rows:
            raise InputError(f"{found.title}: nothing was recorded that could be drawn; `--record` says what is")

    @property
    def others(self) -> list[str]:
        """The signals for which there is no room."""
        return [signal.name for row in self.left_out for signal in row.signals]

    def words(self, found: Traces) -> list[str]:
        """What the picture does not show, and how the run ended."""
        lines = [f"ended early: {found.failure}"] if found.failure else []
        if self.still:
            lines.append("constant: " + ", ".join(f"{s.name} = {_value(s)}" for s in self.still))
        if self.left_out:
            lines.append(f"not drawn (rovbrush plot DIR NAME...): {', '.join(self.others)}")
        return [shorten(line, WORDS, placeholder=" ...") for line in [*lines, found.caption] if line]


def choose(
    found: Traces,
    patterns: Sequence[str] = (),
    begin: float | None = None,
    end: float | None = None,
    page: bool = False,
) -> Choice:
    """What signals such as `motor.*` show between two instants [s]; without any, what is looked at first and moves,
    as far as there is room in a picture, or in a `page`.

    Raises InputError for an unknown signal, or if nothing lies between the instants.
    """
    names = found.chosen(patterns)
    signals = [cut(found[name], begin, end) for name in names]
    if names and not any(len(s.time) for s in signals):
        raise InputError(f"{found.title}: nothing was recorded {span_text(begin, end)}")
    signals = [s for s in signals if len(s.time)]
    still = [] if patterns else [s for s in signals if is_constant(s)]
    if len(still) == len(signals):  # then they are all that there is to see
        still = []
    told = {s.name for s in still}
    every, most = rows(s for s in signals if s.name not in told), ASKED if patterns or page else MOST
    return Choice(every[:most], every[most:], still)


def overview(found: Traces) -> Figure:
    """The connected signals of a run, of one without connections all that is recorded; what does not move is told."""
    return picture(found, choose(found))


def picture(found: Traces, choice: Choice) -> Figure:
    """The rows that were chosen, with a closer look beside them. Raises InputError where there are none."""
    choice.require_rows(found)
    closer = zoom([s for row in choice.rows for s in row.signals], [t for t, _ in found.events])
    figure, axes = columns_figure(found.title, len(choice.rows), 1 if closer is None else 2)
    for row, (whole, *near) in zip(choice.rows, axes, strict=True):
        draw_row(whole, row)
        for axis in near:
            assert closer is not None
            draw_row(axis, row, *closer, legend=False)
            whole.axvspan(*closer, color="tab:orange", alpha=0.15, linewidth=0.0)
    for when, _ in found.events[:MOST]:
        for row_axes in axes:
            row_axes[0].axvline(when, color="black", linewidth=0.5, alpha=0.5)
    caption(figure, choice.words(found))
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
