"""How far each component has come within its step, where events can stop it: see `cells.LATEST`."""

from __future__ import annotations

import numpy as np

from ...loop.cells import LATEST, REACHED
from ...loop.run import FOREVER


class Moments:
    """Times [s] that the loop shares: `latest` is the instant that no step goes beyond."""

    def __init__(self, cells: np.ndarray, count: int) -> None:
        self.cells = cells  # at the end of the solver's memory
        self.reached = cells[REACHED : REACHED + count]
        self.began = cells[REACHED + count : REACHED + 2 * count]

    @staticmethod
    def size(count: int) -> int:
        """How many cells components need."""
        return REACHED + 2 * count

    def begin(self, start: float) -> None:
        """All are at the start [s]."""
        self.cells[:] = start
        self.latest = FOREVER

    @property
    def latest(self) -> float:
        return float(self.cells[LATEST])

    @latest.setter
    def latest(self, time: float) -> None:
        self.cells[LATEST] = time
