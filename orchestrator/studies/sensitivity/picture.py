"""The picture of a sensitivity study: a tornado for each figure of merit, with the intervals of its indices."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...results.pictures.canvas import legend_above, tiles_figure
from ...results.pictures.tornado import draw_bars

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .sensitivity import Sensitivity

FIGURES = 12  # of merit that a picture holds
BARS = 8  # parameters of one, what matters most on top
CALLED = {"ST": "total", "S1": "first order", "mu_star": "mu*"}


def draw(found: Sensitivity) -> Figure | None:
    """The indices with 95 % intervals as whiskers; None where nothing could be estimated."""
    drawn = [indices for indices in found.indices if indices.of][:FIGURES]
    if not drawn:
        return None
    figure, axes = tiles_figure(f"{found.swept.table.title}: what matters", len(drawn))
    for axis, indices in zip(axes, drawn, strict=True):
        keys = [key for key in CALLED if key in indices.of]
        series = {CALLED[key]: [one.value for one in indices.of[key]] for key in keys}
        ends = {CALLED[key]: ([e.low for e in indices.of[key]], [e.high for e in indices.of[key]]) for key in keys}
        order = indices.order()[:BARS]
        draw_bars(axis, order, series, 0.0, ends, beside=True)
        axis.set_yticks(np.arange(len(order)), [found.parameters[k] for k in order], fontsize="small")
        what = "share of its variance [1]" if found.method == "sobol" else f"what a range changes, mu* [{indices.unit}]"
        axis.set_xlabel(f"{indices.figure}: {what}", fontsize="small")
        if len(series) > 1:
            legend_above(axis)
    return figure
