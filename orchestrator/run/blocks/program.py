"""A plan's operations as the loop does them: rows that stand for several, with the addresses of what they call."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ...loop import cells, turns
from ...loop.machine.frame import ARRAYS, Loop
from ...loop.operations import COLUMNS, COPY, ESTIMATE, ITERATE, MOVES, REPEAT, SEGMENT, SOLVE, TURNS
from ...plan.plan import Plan
from ...plan.speed.fused import Fused, Turn, fuse
from ...plan.speed.together import take_turns

if TYPE_CHECKING:
    from ...loop.straight.code import Code
    from ...loop.straight.text import Segments


class Program(NamedTuple):
    """`rows`, `moves` and `turns` as `loop.run` wants them; and which operation of the plan each row begins with, and
    every turn's set, step and get (turns, PARTS) are. `code`: what does them, if it is machine code of their own;
    `segments`: what does some of them."""

    rows: np.ndarray
    moves: np.ndarray
    turns: np.ndarray
    begins: np.ndarray
    parts: np.ndarray
    code: Loop | None = None
    segments: SegmentCode | None = None

    def operation(self, code: int, row: int, part: int) -> int:
        """The operation of the plan at which the loop ended with a code, in a row, and a part of turns."""
        within = code in (cells.BAD_STATUS, cells.NOT_FINITE, cells.UNFIT)
        if self.rows[row, 0] == TURNS and within:
            return int(self.parts.flat[part])
        if self.rows[row, 0] == SEGMENT and within:
            return part
        return int(self.begins[row])


def as_it_is(operations: np.ndarray) -> Program:
    """Every operation by itself."""
    no_moves, no_turns, no_parts = (
        np.zeros((0, columns), dtype=np.int64) for columns in (turns.MOVE_COLUMNS, turns.TURN_COLUMNS, turns.PARTS)
    )
    return Program(operations, no_moves, no_turns, np.arange(len(operations)), no_parts)


def fused(plan: Plan, operations: np.ndarray, components: np.ndarray, blocks: np.ndarray) -> Program:
    """The operations fused; `components` and `blocks` as the loop has them now."""
    able = take_turns(plan)
    found = fuse(operations, [name in able for name in plan.system.components])
    every = [turn for row in found for turn in row.turns]
    transfers = _Transfers(operations)
    rows, before = [], 0
    for row in found:
        if row.code == MOVES:
            rows.append(_row(row, operations, *transfers.add(row.first, row.last)))
        elif row.code == TURNS:
            rows.append(_row(row, operations, before, before + len(row.turns), transfers.count))
            before += len(row.turns)
            for turn in row.turns:
                transfers.add(turn.transfers, turn.first)
                transfers.ends.append(transfers.count)
        else:
            rows.append(operations[row.first].tolist())
    table = _turned(every, operations, components, blocks)
    table[:, turns.MOVED] = transfers.ends
    begins = np.array([row.first for row in found], dtype=np.int64)
    parts = np.array([(turn.set, turn.step, turn.get) for turn in every], dtype=np.int64)
    return Program(
        _led(np.array(rows, dtype=np.int64).reshape(-1, len(COLUMNS)), begins), transfers.table(), table, begins,
        parts.reshape(-1, turns.PARTS),
    )  # fmt: skip


def in_segments(operations: np.ndarray, segments: Segments, code: Code, addresses: np.ndarray) -> Program:
    """The operations with machine code of their own for some; `addresses`: what that wants of the loop's tables."""
    kept = SegmentCode(code, addresses)
    starts, rows, begins, m = {first: (k, last) for k, (first, last) in enumerate(segments)}, [], [], 0
    while m < len(operations):
        begins.append(m)
        if m in starts:
            number, last = starts[m]
            row = Fused(SEGMENT, m, last)
            rows.append(_row(row, operations, code.segment(number), kept.pointers.ctypes.data))
            m = last
        else:
            rows.append(operations[m].tolist())
            m += 1
    led = _led(np.array(rows, dtype=np.int64), np.array(begins, dtype=np.int64))
    return as_it_is(led)._replace(begins=np.array(begins, dtype=np.int64), segments=kept)


class SegmentCode:
    """Machine code of segments, as long as it is needed, and the addresses that it works with."""

    def __init__(self, code: Code, addresses: np.ndarray) -> None:
        from ...loop.straight.functions import AMONG
        from ...loop.straight.writer import POINTERS

        self.code, self.addresses = code, addresses
        self._among = [AMONG[name] for name in POINTERS]
        self.pointers = np.zeros(len(POINTERS), dtype=np.int64)

    def use(self, arrays: tuple[np.ndarray, ...]) -> None:
        """Work with these arrays of the loop from now on."""
        places = [array.ctypes.data for array in (*arrays, self.addresses)]
        assert len(places) == len(ARRAYS) + 1
        self.pointers[:] = [places[k] for k in self._among]


class _Transfers:
    """Collects rows of `moves`."""

    def __init__(self, operations: np.ndarray) -> None:
        self.operations, self.count = operations, 0
        self.ends: list[int] = []
        self._chosen: list[np.ndarray] = []

    def add(self, first: int, last: int) -> tuple[int, int]:
        """Some operations; from where to where their transfers are."""
        begin, self.count = self.count, self.count + last - first
        if last > first:
            self._chosen.append(np.arange(first, last))
        return begin, self.count

    def table(self) -> np.ndarray:
        """All of them."""
        chosen = self.operations[np.concatenate([np.zeros(0, dtype=np.int64), *self._chosen])]
        found = np.zeros((self.count, turns.MOVE_COLUMNS), dtype=np.int64)
        found[:, turns.FROM], found[:, turns.TO] = chosen[:, 3], chosen[:, 4]
        found[:, turns.COEFFICIENT] = np.where(chosen[:, 0] == COPY, chosen[:, 7], -1)
        return found


def _row(row: Fused, operations: np.ndarray, a: int, b: int, p: int = 0) -> list[int]:
    return [row.code, int(operations[row.first, 1]), -1, a, b, p, 0, 0]


def _led(rows: np.ndarray, begins: np.ndarray) -> np.ndarray:
    """Rows that go on with others know their new numbers."""
    to = np.isin(rows[:, 0], (ITERATE, REPEAT, ESTIMATE))
    rows[to, 3] = np.searchsorted(begins, rows[to, 3])
    for m in np.flatnonzero(rows[:, 0] == SOLVE):
        rows[m, 3] = m - np.searchsorted(begins, begins[m] - rows[m, 3])
    return rows


def _turned(every: list[Turn], operations: np.ndarray, components: np.ndarray, blocks: np.ndarray) -> np.ndarray:
    """`turns`, but for where transfers end."""
    found = np.zeros((len(every), turns.TURN_COLUMNS), dtype=np.int64)
    if not every:
        return found
    steps = operations[[turn.step for turn in every]]
    c = components[steps[:, 2]]
    found[:, turns.COMPONENT], found[:, turns.LENGTH], found[:, turns.START] = steps[:, 2], steps[:, 3], steps[:, 4]
    found[:, turns.INSTANCE], found[:, turns.DO_STEP] = c[:, cells.INSTANCE], c[:, cells.DO_STEP]
    found[:, turns.FMI], found[:, turns.FINAL] = c[:, cells.FMI], c[:, cells.FINAL]
    for side, first, last, target in (
        ("set", cells.FIRST_IN, cells.LAST_IN, turns.SET), ("get", cells.FIRST_OUT, cells.LAST_OUT, turns.GET)
    ):  # fmt: skip
        asked = np.array([getattr(turn, side) >= 0 for turn in every]) & (c[:, first] < c[:, last])
        block = blocks[c[asked, first]]
        columns = (cells.FUNCTION, cells.REFERENCES, cells.COUNT, cells.VALUES, cells.SIZE, cells.FIRST_SLOT)
        for k, column in enumerate(columns if side == "get" else columns[:-1]):
            found[asked, target + k] = block[:, column]
    return found
