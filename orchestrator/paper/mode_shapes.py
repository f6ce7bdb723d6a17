"""The paper's Fig. 2: the mode shapes of a filament, from the eigenvalues that the brush FMU computed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..results.plots import new_figure
from .beam import shape

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def mode_shapes(calculated: Mapping[str, float], entry: Mapping[str, Any]) -> Figure:
    """The first `modes` shapes over x/L; `component` names the brush."""
    figure, (axis,) = new_figure(entry["title"])
    xi = np.linspace(0.0, 1.0, 201)
    for r in range(1, int(entry["modes"]) + 1):
        lam = calculated[f"{entry['component']}.lambda_r[{r}]"]
        axis.plot(xi, shape(lam, xi), label=f"mode {r}, lambda = {lam:.4f}")
    axis.set_xlabel("x/L [1]")
    axis.set_ylabel("Y_r [1]")
    axis.legend()
    return figure
