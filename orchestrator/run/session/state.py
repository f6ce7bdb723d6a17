"""What the state of a run is, listed once: checkpoints write it to disk, snapshots keep it in memory.

It is the cells below; what is told of the position, of inputs set by hand and of events; the rows; and the states of
the FMUs, which each of the two has in its own form.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np

from .session import Session


def cells_of(session: Session) -> dict[str, np.ndarray]:
    """The numbers of a run beside its rows: its own arrays, which are restored in place."""
    space = session.space
    return {
        "z": session.memory.z, "clock": space.clock, "work": space.loop.work, "saved": space.loop.saved,
        **({"moments": space.moments.cells} if space.moments else {}),
    }  # fmt: skip


def told_of(session: Session) -> dict[str, Any]:
    """What a run knows beside numbers, ready for JSON."""
    return {
        "at": asdict(session.at), "set_by_hand": dict(session.set_by_hand), "events": session.events.content(),
    }  # fmt: skip


def put_back(target: Mapping[str, np.ndarray], found: Mapping[str, np.ndarray]) -> None:
    """The cells of a run as they were found. Raises ValueError where they are others."""
    for name, cells in target.items():
        kept = found.get(name)
        if kept is None or kept.shape != cells.shape or kept.dtype != cells.dtype:
            raise ValueError(f"there are other cells '{name}'")
        cells[...] = kept
