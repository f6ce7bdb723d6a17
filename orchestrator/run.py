"""What a run leaves in memory."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from .errors import RunError
from .initialize import Started
from .plan import Plan
from .texts import Texts


@dataclass
class Run:
    """One table per rate, and how the run ended. `failure` is empty unless it ended early against its will."""

    plan: Plan
    tables: list[np.ndarray]  # per group: (rows, columns), row 0 at time 0
    failure: str = ""
    end: float = 0.0  # s
    wall: float = 0.0  # s, in the loop
    start: float = 0.0  # s, from the start of the process to the end of the first block of steps
    started: Started = field(default_factory=Started)
    texts: Texts | None = None  # those whose numbers the tables hold
    calculated: dict[str, Any] = field(default_factory=dict)  # calculated parameters, "component.variable"

    @cached_property
    def ticks(self) -> list[np.ndarray]:
        """The instants of each table's rows."""
        if self.plan.adaptive:
            column = self.plan.groups[0].columns.index(("coupling", "tick"))
            return [self.tables[0][:, column].astype(np.int64)]
        return [
            group.period * np.arange(len(table)) for group, table in zip(self.plan.groups, self.tables, strict=True)
        ]


def require_complete(run: Run) -> Run:
    """The run itself, or RunError with its failure; for studies that need the whole run."""
    if run.failure:
        raise RunError(run.failure)
    return run
