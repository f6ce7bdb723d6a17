"""Published numbers that the report compares with, as they came."""

from __future__ import annotations

from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parent / "reference"


def rotating_cantilever() -> np.ndarray:
    """Rows of speed and three frequencies, out of plane, in units of sqrt(EI/(mu L^4)), (k, 4)."""
    return np.loadtxt(FOLDER / "rotating_cantilever.csv", delimiter=",", skiprows=4)


def elastica_tip_load() -> np.ndarray:
    """Rows of P L^2/(E I_zz), w/L, u/L and tip slope [rad], (k, 4)."""
    return np.loadtxt(FOLDER / "elastica_tip_load.csv", delimiter=",", skiprows=3)


def thruster(volt: int) -> tuple[np.ndarray, np.ndarray]:
    """Commands u = (pulse - 1500 us)/400 us and thrust [N] of the thruster at a supply voltage, (k,) each."""
    lines = (FOLDER / "t200_thrust.csv").read_text(encoding="utf-8").splitlines()
    rows = {
        line.split(",")[0]: np.array(line.split(",")[1:], dtype=float) for line in lines if not line.startswith("#")
    }
    return (rows["volt"] - 1500.0) / 400.0, rows[str(volt)]
