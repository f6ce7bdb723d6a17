"""The rows that a run records: a buffer that the loop fills, and where they go when it is full."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from ...errors import InputError, RunError
from ...plan.plan import Plan
from ...results.tables import Stored
from ..memory.memory import Memory
from .behind import WrittenBehind
from .observers import NEVER, Piece
from .read_back import type_of
from .stream import WIDTH, Stream

CHUNK = 4096  # rows that a table of unknown length begins with
IN_MEMORY = 30_000_000  # bytes of tables that are kept in memory where a file is given for more
PIECE = 8_000_000  # bytes that go to the file at once


class Recorder:
    """Buffer and counters as `loop.run` wants them.

    Without `file` all tables stay in memory. With it those that are larger than IN_MEMORY go there, chunk by chunk;
    where the run is `paced` while it goes on. Chunks end where they end whatever the blocks in which the loop is
    called.
    """

    def __init__(self, plan: Plan, memory: Memory, file: Path | None = None, paced: bool = False) -> None:
        self.plan, self.memory, self.file = plan, memory, file
        self.stream: Stream | None = None
        self.per_cycle = [1 if plan.adaptive else -(-plan.clock.hyperperiod // group.period) for group in plan.groups]
        self.columns = [len(group.slots) for group in plan.groups]
        self.slots = np.concatenate([np.zeros(0, dtype=np.int64), *(group.slots for group in plan.groups)])
        self.rows = np.ones(max(len(plan.groups), 1), dtype=np.int64)
        self._seen = [0] * len(plan.groups)
        self._given = False  # whether somebody has tables that lie in the buffer
        self._taken = False  # and keeps them
        wanted = CHUNK if plan.adaptive else -(-plan.clock.stop // plan.clock.hyperperiod)
        texts = any(type_of(plan, key) in WIDTH for group in plan.groups for key in group.columns)
        behind = paced and not plan.adaptive and not texts  # texts are shared with the loop
        self._kind = WrittenBehind if behind else Stream
        self._spare: np.ndarray | None = None  # a buffer whose rows are on their way
        self._reserve(wanted if wanted <= self._cycles_in(IN_MEMORY) else self._cycles_in(PIECE))
        self._first_row()

    def _first_row(self) -> None:
        for (_, columns, cell), group in zip(self.groups.tolist(), self.plan.groups, strict=True):
            self.buffer[cell : cell + columns] = self.memory.z[group.slots]

    def begin_again(self) -> None:
        """The row of time 0 anew, from what is true now; it comes again for who looks on."""
        self.take_back(dict.fromkeys(range(len(self.columns)), 1))
        self._first_row()
        self.rows[:] = 1

    def take_back(self, counts: Mapping[int, int]) -> None:
        """Drop the last rows of tables, so many by table: they come again."""
        if self._taken:
            self.go_back(self.content())
            self._taken = False
        for table, count in counts.items():
            here = min(int(self.rows[table]), count)
            self.rows[table] -= here
            if self.stream is not None:
                self.stream.take_back(table, count - here)
            self._seen[table] = min(self._seen[table], self.before[table] + int(self.rows[table]))

    def _cycles_in(self, size: int) -> int:
        """Cycles whose rows take so many bytes; any number where there is no file."""
        cells = sum(rows * columns for rows, columns in zip(self.per_cycle, self.columns, strict=True))
        return max(size // max(8 * cells, 1), 1) if self.file else 2**62

    def _reserve(self, cycles: int) -> None:
        """A buffer for the row of time 0 and so many cycles."""
        self.held = cycles
        sizes = [(cycles * rows + 1) * columns for rows, columns in zip(self.per_cycle, self.columns, strict=True)]
        firsts, cells = np.cumsum([0, *self.columns]), np.cumsum([0, *sizes])
        table = [(firsts[k], columns, cells[k]) for k, columns in enumerate(self.columns)]
        self.groups = np.array(table, dtype=np.int64).reshape(-1, 3)
        self.buffer = np.zeros(max(int(cells[-1]), 1))
        self.arrays = self.slots, self.groups, self.buffer, self.rows  # others from now on

    def make_room(self, cycles: int) -> int:
        """How many of the next `cycles` cycles can be recorded before the next call of this: at least one.

        Raises RunError if the disk refuses.
        """
        if not self.columns:
            return cycles
        room = self._room()
        if room == 0 and self.plan.adaptive and self.held < self._cycles_in(IN_MEMORY):
            before = self.tables(self.rows.tolist())
            self._reserve(min(2 * self.held, self._cycles_in(IN_MEMORY)))
            self.buffer[: before[0].size] = before[0].ravel()
            room = self._room()
        elif room == 0:
            self.flush(self.rows.tolist())
            if self.stream and self.stream.full:
                raise RunError(self.stream.full)
            room = self._room()
        return min(room, cycles)

    def last_rows(self) -> list[int]:
        """Rows of every table with which there is still room for those of one cycle more, at most."""
        return [(self.held - 1) * count + 1 for count in self.per_cycle[: len(self.columns)]]

    def fresh(self, time: float, tick: int) -> Piece:
        """The rows that were not in an earlier piece."""
        counts, before = self.rows[: len(self.columns)].tolist(), self.before
        first = [min(max(seen, gone), gone + count)
                 for seen, gone, count in zip(self._seen, before, counts, strict=True)]  # fmt: skip
        self._given = True
        tables = [table[begin - gone :] for table, begin, gone in zip(self.tables(counts), first, before, strict=True)]
        self._seen = [gone + count for gone, count in zip(before, counts, strict=True)]
        return Piece(time, tick, first, tables)

    def _room(self) -> int:
        """Cycles that still fit; the row of time 0 is there beside them."""
        return min(
            (
                (self.held * count + 1 - rows) // count
                for count, rows in zip(self.per_cycle, self.rows.tolist(), strict=False)  # one more where none is kept
            ),
            default=NEVER,
        )

    def tables(self, rows: list[int]) -> list[np.ndarray]:
        """The first `rows` rows of every table in the buffer."""
        return [
            self.buffer[first : first + count * columns].reshape(count, columns)
            for (_, columns, first), count in zip(self.groups.tolist(), rows, strict=False)
        ]

    def flush(self, rows: list[int], wait: bool = False) -> None:
        """The first `rows` rows of every table in the buffer to the file, or on their way; the others are dropped."""
        assert self.file is not None
        if self.stream is None:
            self.stream = self._kind(self.file, self.plan, self.memory.texts)
        if wait:
            self.stream.append(self.tables(rows))
        else:
            self.stream.see(Piece(0.0, 0, list(self.before), self.tables(rows)))
        self.rows[:] = 0
        self._turn_over()

    def _turn_over(self) -> None:
        """Another buffer while the rows of this one are on their way."""
        if self._kind is WrittenBehind:
            other, self._spare = self._spare, self.buffer
            fits = other is not None and other.shape == self.buffer.shape
            self.buffer = other if fits else np.zeros_like(self.buffer)  # type: ignore[assignment]
            self.arrays = self.slots, self.groups, self.buffer, self.rows

    @property
    def before(self) -> list[int]:
        """Rows of every table that are no longer in the buffer."""
        return self.stream.taken if self.stream else [0] * len(self.columns)

    def recorded(self, rows: list[int]) -> list[np.ndarray] | Stored:
        """The first `rows` rows of every table, counted from time 0. What the disk refuses is pending in the file."""
        here = [count - gone for count, gone in zip(rows, self.before, strict=True)]
        if self.stream is None and self.held <= self._cycles_in(IN_MEMORY):
            self._given = self._taken = True
            return self.tables(here)
        refused = False
        try:
            self.flush(here, wait=True)
        except RunError:
            refused = True
        assert self.stream is not None  # it is there since the first flush, also where that was refused
        if refused:
            self.stream.pending = [table.copy() for table in self.tables(here)]
        return self.stream

    def content(self) -> dict[str, np.ndarray]:
        """What is in the buffer, and how many rows went before; for `restore`."""
        rows = self.rows.tolist()
        cells = np.concatenate([np.zeros(0), *(table.ravel() for table in self.tables(rows))])
        return {"held": np.array(self.held), "rows": self.rows.copy(), "before": np.array(self.before), "cells": cells}

    def go_back(self, content: Mapping[str, np.ndarray]) -> None:
        """To rows that this recorder has had, as `content` gave them; tables that were given out stay as they are."""
        held = int(content["held"])
        if self._given or held != self.held:
            self._reserve(held)
            self._given = False
        self.rows[:] = content["rows"]
        self._seen = [min(seen, count) for seen, count in zip(self._seen, self.rows.tolist(), strict=False)]
        self._fill(content["cells"])

    def _fill(self, cells: np.ndarray) -> None:
        first = 0
        for table in self.tables(self.rows.tolist()):
            table[...] = cells[first : first + table.size].reshape(table.shape)
            first += table.size

    def restore(self, content: Mapping[str, np.ndarray], file: Path) -> None:
        """Go on where another recorder was; `file` holds the rows that went before, if any did.

        Raises ValueError for what no recorder can have held.
        """
        held, rows = int(content["held"]), content["rows"]
        most = [held * count + 1 for count in self.per_cycle]
        if not 0 < held <= max(self.held, self._cycles_in(IN_MEMORY)) or rows.shape != self.rows.shape:
            raise ValueError("rows are of another size")
        if any(not 0 <= count <= limit for count, limit in zip(rows.tolist(), most, strict=False)):
            raise ValueError("there are more rows than there is room for")
        self._reserve(held)
        self.rows[:] = rows
        self._fill(content["cells"])
        if any(content["before"]):
            if self.file is None:
                raise InputError("this run was recorded to a file; go on with a file to record to")
            before = content["before"].tolist()
            self.stream = self._kind.going_on(file, self.file, self.plan, self.memory.texts, before)
