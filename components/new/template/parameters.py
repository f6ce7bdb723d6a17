"""Parameters of the body, each with unit, source and admissible range."""

from __future__ import annotations

from dataclasses import dataclass

from ...declare.interface import parameter


@dataclass(frozen=True)
class Parameters:
    """What stays as it is during a run."""

    m: float = parameter(10.0, "kg", "mass", "assumed", minimum=1e-3, maximum=1e6)
    d: float = parameter(5.0, "N.s/m", "drag of the water per speed", "assumed", minimum=1e-6, maximum=1e6)
    v_start: float = parameter(0.0, "m/s", "speed at the start", "assumed", minimum=-100.0, maximum=100.0)


NOMINAL = Parameters()
