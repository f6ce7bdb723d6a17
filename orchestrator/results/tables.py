"""What a run leaves: its tables, in memory or in a file, and how it ended."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple, Protocol

import numpy as np

from ..errors import RunError
from ..loop.texts import Texts
from ..plan.plan import Plan
from .lateness import Lateness


class Stored(Protocol):
    """Tables in a file; see `stream.py`."""

    rows: list[int]

    def values(self, group: int, column: int) -> np.ndarray:
        """All values of one signal, in its own type."""

    def table(self, group: int) -> np.ndarray:
        """A whole table in cells of the loop, as precise as each signal's own type."""

    def finish(self, path: Any, complete: bool, partly: bool = False, run: Run | None = None) -> None:
        """Say how the run ended, and rename the file, without rows that the disk refused if `partly`; what happened
        in the run goes there too."""


AT_START = "start"  # what happened, of the row in which participants with events are at the start


class EventRow(NamedTuple):
    """What is true in an event: the instant [s], a number in the order of what happens there, 0 before it; what
    happened, in words; cells of all recorded signals, of the first table first."""

    time: float
    number: int
    what: str
    cells: np.ndarray


@dataclass
class Started:
    """How the start was found: the sweeps over all connections, and the residual of every algebraic loop."""

    sweeps: int = 0
    loops: dict[str, float] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)  # what a person must know of it


@dataclass
class Run:
    """One table per rate, and how the run ended. `failure` is empty unless it ended early against its will."""

    plan: Plan
    recorded: list[np.ndarray] | Stored
    failure: str = ""
    end: float = 0.0  # s, the time that was reached
    wall: float = 0.0  # s, in the loop
    start: float = 0.0  # s, from the start of the process to the end of the first block of steps
    started: Started = field(default_factory=Started)
    texts: Texts | None = None  # those whose numbers the tables hold
    calculated: dict[str, Any] = field(default_factory=dict)  # calculated parameters, "component.variable"
    notes: list[str] = field(default_factory=list)  # of the session: what FMUs did beside their work
    messages: list[str] = field(default_factory=list)  # what FMUs logged
    ended: str = ""  # who asked to end the run before its stop, and when
    events: Sequence[EventRow] = ()  # what happened, of a system with events
    lateness: Lateness | None = None  # of a run that kept pace with the clock on the wall

    @property
    def simulated(self) -> float:
        """How long the run was [s], in its own time."""
        return self.end - self.plan.clock.time(0)

    @cached_property
    def tables(self) -> list[np.ndarray]:
        """Per group: (rows, columns), row 0 at the start; of a run that was recorded to a file all of it is read."""
        if isinstance(self.recorded, list):
            return self.recorded
        return [self.recorded.table(g) for g in range(len(self.plan.groups))]

    @property
    def ticks(self) -> list[np.ndarray]:
        """The instants of each table's rows."""
        return [self.ticks_of(g) for g in range(len(self.plan.groups))]

    def ticks_of(self, group: int) -> np.ndarray:
        """The instants of one table's rows."""
        if self.plan.adaptive:
            column = self.plan.groups[0].columns.index(("coupling", "tick"))
            recorded = self.recorded
            cells = recorded[0][:, column] if isinstance(recorded, list) else recorded.values(0, column)
            return cells.astype(np.int64)
        rows = len(self.recorded[group]) if isinstance(self.recorded, list) else self.recorded.rows[group]
        return self.plan.instants_of(group, 0, rows)


def require_complete(run: Run) -> Run:
    """The run itself, or RunError with its failure; for studies that need the whole run."""
    if run.failure:
        raise RunError(run.failure)
    return run
