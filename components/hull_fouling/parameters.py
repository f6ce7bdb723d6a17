"""Parameters of the hull along a pass, each with unit and source."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter


@dataclass(frozen=True)
class Parameters:
    """Fifty cells along the way of the brush, what grows there, and the brush as far as it decides what is touched."""

    place_start: float = parameter(-0.1, "m", "place where the first cell begins", "assumed", -1e4, 1e4)
    cell_length: float = parameter(0.025, "m", "length of a cell along the pass", "assumed", 1e-4, 100.0)
    track_width: float = parameter(0.3, "m", "length of the brush along its axis", "assumed", 1e-3, 10.0)
    offset: float = parameter(0.0, "m", "place of the brush axis ahead of s along the pass", "assumed", -10.0, 10.0)
    by_speed: bool = parameter(
        False, "1", "the place is s and the way that the hull has passed the tool since the start", "assumed"
    )
    R_brush: float = parameter(0.15, "m", "brush radius", "Table 2", minimum=1e-3, maximum=10.0)
    n: int = parameter(50, "1", "filaments round the brush, each over the whole track", "Table 2", 1, 1000)
    pass_gap: float = parameter(
        1.0, "s", "how long a cell must have been left alone for a touch to be another pass", "assumed", 0.0, 1e6
    )
    fouling_place: tuple[float, ...] = parameter(
        (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7), "m", "places on the pass, rising", "assumed", -1000.0, 1000.0
    )
    fouling_scale: tuple[float, ...] = parameter(
        (1.0,) * 8, "1", "friction scale of the untouched hull at these places, linear in between", "assumed", 0.0, 20.0
    )
    removal_work: tuple[float, ...] = parameter(
        (5e3,) * 8, "J/m2", "shear work per area that removes what grows at these places", "assumed", 1e-3, 1e12
    )


NOMINAL = Parameters()
