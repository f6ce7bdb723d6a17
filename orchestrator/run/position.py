"""How far a run is, as its session and its checkpoints count it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class Position:
    """How far a run is."""

    cycle: int = 0  # whole cycles done
    operation: int = 0  # the first one of the next cycle that is still to be done; not 0 after Ctrl-C
    time: float = 0.0  # s
    wall: float = 0.0  # s that the loop took
