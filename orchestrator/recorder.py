"""The rows that a run records: a buffer that the loop fills, one part per table."""

from __future__ import annotations

import numpy as np

from .plan import Plan

CHUNK = 4096  # rows that a table of unknown length begins with


class Recorder:
    """Buffer and counters as `execute.run` wants them. A run with fixed steps has room for all its rows at once."""

    def __init__(self, plan: Plan, z: np.ndarray) -> None:
        self.plan = plan
        self.per_cycle = [1 if plan.adaptive else plan.clock.hyperperiod // group.period for group in plan.groups]
        wanted = [CHUNK if plan.adaptive else plan.clock.stop // group.period + 1 for group in plan.groups]
        columns = [len(group.slots) for group in plan.groups]
        firsts, cells = np.cumsum([0, *columns]), np.cumsum([0, *(r * c for r, c in zip(wanted, columns, strict=True))])
        self.groups = np.array([(firsts[k], columns[k], cells[k]) for k in range(len(columns))], dtype=np.int64)
        self.groups = self.groups.reshape(-1, 3)
        self.slots = np.concatenate([np.zeros(0, dtype=np.int64), *(group.slots for group in plan.groups)])
        self.buffer = np.zeros(max(int(cells[-1]), 1))
        self.rows = np.ones(max(len(plan.groups), 1), dtype=np.int64)
        for k, group in enumerate(plan.groups):
            self.buffer[cells[k] : cells[k] + columns[k]] = z[group.slots]

    @property
    def arrays(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        return self.slots, self.groups, self.buffer, self.rows

    def make_room(self, cycles: int) -> int:
        """How many of the next `cycles` cycles can be recorded before the next call of this: at least one."""
        if self.plan.adaptive:
            missing = (int(self.rows[0]) + cycles) * int(self.groups[0, 1]) - len(self.buffer)
            if missing > 0:
                self.buffer = np.concatenate([self.buffer, np.zeros(max(missing, len(self.buffer)))])
        return cycles

    def tables(self, rows: list[int]) -> list[np.ndarray]:
        """The first `rows` rows of every table."""
        return [
            self.buffer[first : first + count * columns].reshape(count, columns)
            for (_, columns, first), count in zip(self.groups.tolist(), rows, strict=True)
        ]
