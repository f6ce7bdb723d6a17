"""The figure kind `mode_shapes`, the paper's Fig. 2: shapes of a filament from the eigenvalues of the brush FMU."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import InputError, nearest
from ..results.pictures.canvas import new_figure
from ..system.model import System
from .theory.beam import shape

if TYPE_CHECKING:
    from matplotlib.figure import Figure

KEYS = ("component", "modes")
EIGENVALUES = "lambda_r"


def check(entry: Mapping[str, Any], system: System, label: str) -> None:
    """Raise InputError where `component` names no brush or has fewer `modes`."""
    name = str(entry["component"])
    if name not in system.components:
        raise InputError(f"{label}: no component '{name}'{nearest(name, system.components)}")
    known = system.components[name].fmu.expand(EIGENVALUES)
    if entry["modes"] not in range(1, len(known) + 1):
        raise InputError(f"{label}: modes = {entry['modes']!r}; {name} has {len(known)} modes")


def shows(entry: Mapping[str, Any], variables: list[str]) -> list[str]:
    """The eigenvalues of the entry's component."""
    return [name for name in variables if name.startswith(f"{entry['component']}.{EIGENVALUES}[")]


def draw(calculated: Mapping[str, float], entry: Mapping[str, Any]) -> Figure:
    """The first `modes` shapes over x/L; `component` names the brush."""
    figure, (axis,) = new_figure(entry["title"])
    xi = np.linspace(0.0, 1.0, 201)
    for r in range(1, int(entry["modes"]) + 1):
        lam = calculated[f"{entry['component']}.{EIGENVALUES}[{r}]"]
        axis.plot(xi, shape(lam, xi), label=f"mode {r}, lambda = {lam:.4f}")
    axis.set_xlabel("x/L [1]")
    axis.set_ylabel("Y_r [1]")
    axis.legend()
    return figure
