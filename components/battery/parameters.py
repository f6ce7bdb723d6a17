"""Parameters of the battery, each with unit and source."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter

MAKER = "Blue Robotics, battery guide: 14.8 V, 18 Ah"


@dataclass(frozen=True)
class Parameters:
    """Lithium-ion cells, n_parallel beside each other in each of n_series groups; the defaults are the vehicle's."""

    n_series: int = parameter(4, "1", "groups of cells in series", MAKER, minimum=1, maximum=200)
    n_parallel: int = parameter(6, "1", "cells side by side in a group", "18 Ah of cells of 3 Ah", 1, 200)
    Q_cell: float = parameter(10800.0, "A.s", "charge of a full cell, 3 Ah", MAKER, minimum=1.0, maximum=1e7)
    V_cell: tuple[float, ...] = parameter(
        (3.0, 3.42, 3.53, 3.6, 3.65, 3.72, 3.82, 3.92, 4.02, 4.1, 4.2),
        "V",
        "open-circuit voltage of a cell at soc = 0, 0.1 .. 1",
        f"ends: {MAKER}; between them assumed, as nickel-rich cells have it",
        minimum=0.1,
        maximum=10.0,
    )
    R_cell: float = parameter(
        0.02, "Ohm", "ohmic resistance of a cell", "assumed, usual for cells of the format 18650", 0.0, 10.0
    )
    R_leads: float = parameter(0.005, "Ohm", "resistance of leads and plugs", "assumed", minimum=0.0, maximum=10.0)
    R_1_cell: float = parameter(
        0.015, "Ohm", "polarisation resistance of a cell, 0 = none", "assumed", minimum=0.0, maximum=10.0
    )
    tau_1: float = parameter(20.0, "s", "time constant of the polarisation", "assumed", minimum=1e-3, maximum=1e5)
    V_cell_min: float = parameter(3.0, "V", "voltage of a cell below which it counts as empty", MAKER, 0.0, 10.0)
    soc_start: float = parameter(1.0, "1", "state of charge at the start", "assumed", minimum=0.0, maximum=1.0)


NOMINAL = Parameters()
