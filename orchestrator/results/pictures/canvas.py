"""Empty figures as all of ours are, and what stands above and below what is drawn in them."""

from __future__ import annotations

import io
from collections.abc import Sequence
from functools import cache
from textwrap import fill
from typing import TYPE_CHECKING, Any

from ..tables import Run
from .written import as_written

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WIDTH = 8.0  # inches of a figure
CAPTION = 150  # characters in a line below one of that width
ROW = 1.35  # inches of height of each row of an overview


def captioned(figure: Figure, run: Run) -> Figure:
    """The figure with what the run's parameter set says of itself below it."""
    if run.plan.system.parameter_set:
        caption(figure, [f"parameters: {run.plan.system.parameter_set}"])
    return figure


def caption(figure: Figure, lines: Sequence[str]) -> None:
    """Small print below a figure."""
    width = int(CAPTION * figure.get_figwidth() / WIDTH)
    text = "\n".join(fill(line, width) for line in lines if line)
    if text:
        figure.supxlabel(text, x=0.01, ha="left", fontsize=7, color="dimgray")


def new_figure(title: str, rows: int = 1, share: bool = True) -> tuple[Figure, list[Any]]:
    """An empty figure with `rows` axes one above the other, of one horizontal axis if `share`."""
    figure, axes = _empty(title, (WIDTH, 1.2 + 2.6 * rows), rows, 1, sharex=share)
    for (axis,) in axes:
        axis.margins(x=0)
    return figure, [axis for (axis,) in axes]


def columns_figure(title: str, rows: int, columns: int) -> tuple[Figure, list[list[Any]]]:
    """An empty figure of `rows` times `columns` axes, the first column wider; each column has one time axis."""
    ratios = [2.0, *[1.0] * (columns - 1)]
    figure, axes = _empty(
        title, (12.0, 1.3 + ROW * rows), rows, columns, sharex="col", gridspec_kw={"width_ratios": ratios}
    )
    for row in axes:
        for axis in row:
            axis.margins(x=0)
            axis.tick_params(labelsize="small")
            axis.ticklabel_format(useOffset=False)
    for axis in axes[-1]:
        axis.set_xlabel("time [s]")
    return figure, axes


def tiles_figure(title: str, count: int) -> tuple[Figure, list[Any]]:
    """An empty figure of `count` axes that have nothing in common, two beside each other."""
    columns = 1 if count == 1 else 2
    lines = -(-count // columns)
    figure, axes = _empty(title, (5.5 * columns, 1.0 + 2.9 * lines), lines, columns)
    tiles = [axis for row in axes for axis in row]
    for spare in tiles[count:]:
        spare.remove()
    return figure, tiles[:count]


def matrix_figure(title: str, rows: int, columns: int) -> tuple[Figure, list[list[Any]]]:
    """An empty figure of small axes: each row has one vertical axis, each column one horizontal axis."""
    size = (1.6 + 1.7 * max(columns, 3), 1.2 + 1.5 * rows)
    return _empty(title, size, rows, columns, sharex="col", sharey="row")


def legend_above(axis: Any, width: int = 100) -> None:
    """A legend above the axis, where it hides nothing; `width`: characters that a line of it holds."""
    handles, labels = axis.get_legend_handles_labels()
    longest = max(map(len, labels), default=1)
    columns = max(1, min(len(labels), width // (longest + 6)))
    place = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "borderaxespad": 0.2, "frameon": False}
    axis.legend(handles, labels, ncols=columns, fontsize="small", **place)


def _empty(
    title: str, size: tuple[float, float], rows: int, columns: int, **subplots: Any
) -> tuple[Figure, list[list[Any]]]:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure = _figure_class()(figsize=size, dpi=110, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, columns, squeeze=False, **subplots)
    figure.suptitle(title)
    for axis in axes.flat:
        axis.grid(alpha=0.3)
    return figure, [list(row) for row in axes]


@cache
def _figure_class() -> type[Figure]:
    """A figure that notebooks show without `%matplotlib inline`."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    class Picture(Figure):
        """A figure that is shown as PNG, and drawn once for it: matplotlib draws one first to lay it out."""

        def savefig(self, fname: Any, **options: Any) -> None:
            as_png = options == {"format": "png"} or (not options and str(fname).endswith(".png"))
            with as_written(self):
                if as_png and isinstance(self.canvas, FigureCanvasAgg):
                    self.canvas.print_png(fname)  # type: ignore[no-untyped-call, unused-ignore]
                else:
                    super().savefig(fname, **options)

        def _repr_png_(self) -> bytes:
            buffer = io.BytesIO()
            self.savefig(buffer, format="png")
            return buffer.getvalue()

    return Picture
