"""Parameters of the frame that carries several tools, each with unit and source."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter


@dataclass(frozen=True)
class Parameters:
    """Three places for tools; one that carries none has no loads."""

    x_tool: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "m", "place of each tool along x_t, from the frame's point (the vehicle's r_tool)", "assumed",
        -10.0, 10.0,
    )  # fmt: skip
    y_tool: tuple[float, ...] = parameter(
        (-0.15, 0.15, 0.0), "m", "place of each tool along y_t, from the frame's point", "assumed", -10.0, 10.0
    )
    hull_curvature: float = parameter(
        0.0, "1/m", "curvature of the hull across the way, convex positive: 1/R of its frames", "assumed", -10.0, 10.0
    )


NOMINAL = Parameters()
