"""An empty figure as all of ours are, and what stands below it."""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING, Any

from ..tables import Run

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CAPTION = 150  # characters in a line of it


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


def legend_above(axis: Any, width: int = 100) -> None:
    """A legend above the axis, where it hides nothing; `width`: characters that a line of it holds."""
    handles, labels = axis.get_legend_handles_labels()
    longest = max(map(len, labels), default=1)
    columns = max(1, min(len(labels), width // (longest + 6)))
    place = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "borderaxespad": 0.2, "frameon": False}
    axis.legend(handles, labels, ncols=columns, fontsize="small", **place)
