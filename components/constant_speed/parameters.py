"""Parameters of the drive that holds its speed."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter


@dataclass(frozen=True)
class Parameters:
    """An ideal speed source."""

    omega_b_set: float = parameter(
        15.7, "rad/s", "brush speed, whatever the load", "Table 3", minimum=-1e3, maximum=1e3
    )
    V_nominal: float = parameter(
        12.0, "V", "voltage at which the speed is omega_b_set; it changes in proportion", "assumed", 0.1, 1e3
    )
    J_b: float = parameter(
        0.6, "kg.m2", "brush inertia: filaments 0.55, hub 0.05", "assumed", minimum=0.0, maximum=100.0
    )


NOMINAL = Parameters()
