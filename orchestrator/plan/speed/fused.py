"""Operations that the loop does in one go: set, step and get of a component with the transfers before them are a turn,
turns that follow each other are one row, and so are transfers in a row. All else stays as it is.

A pass behind the plan: it changes nothing of what is done, nor the order of it, and where a run can be entered or left
it has a row of its own. A run that goes on within a cycle does the operations themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from ...errors import counted
from ...loop.operations import (
    AT_AN_INSTANT,
    COPY,
    ESTIMATE,
    GET,
    ITERATE,
    MOVE,
    MOVES,
    PUSH,
    REPEAT,
    SET,
    SOLVE,
    STEP,
    TURNS,
)
from ..design import Design
from .together import take_turns

SHOWN = 6  # names in one line, at most
TRANSFERS = (COPY, MOVE, PUSH)
GOES_TO = (ITERATE, REPEAT, ESTIMATE)  # column a is the operation with which they go on


@dataclass
class Turn:
    """Operations, by their numbers: the first of the transfers, and set, step and get; -1 for none."""

    transfers: int
    set: int
    step: int
    get: int

    @property
    def first(self) -> int:
        """Where its set, step and get begin: the transfers end there."""
        return self.set if self.set >= 0 else self.step

    @property
    def last(self) -> int:
        """The first operation behind it."""
        return max(self.step, self.get) + 1


@dataclass
class Fused:
    """One row for the operations from `first` to `last`, that not included; of one that stays as it is `code` is 0."""

    code: int
    first: int
    last: int
    turns: list[Turn] = field(default_factory=list)


def fused_words(plan: Design, rows: np.ndarray, most: int | None) -> list[str]:
    """What the loop does in one go of operations, by their numbers from 1; at most so many lines."""
    names, able = list(plan.system.components), take_turns(plan)
    found = fuse(rows, [name in able for name in names])
    lines = []
    for row in found:
        if row.code == TURNS:
            those = [names[rows[turn.step, 2]] for turn in row.turns]
            said = ", ".join(those if len(those) <= SHOWN else [*those[: SHOWN - 1], f"{len(those) - SHOWN + 1} more"])
            transfers = sum(turn.first - turn.transfers for turn in row.turns)
            before = f", with {counted(transfers, 'transfer')} before they are set" if transfers else ""
            lines.append(f"{f'{row.first + 1}-{row.last}':>13}  turns       {said}{before}")
        elif row.code == MOVES:
            lines.append(f"{f'{row.first + 1}-{row.last}':>13}  moves       {row.last - row.first} transfers")
    if not lines:
        return []
    more = [f"  ... and {len(lines) - most} more (--all shows them)"] if most is not None and most < len(lines) else []
    return ["", f"done in one go (the loop has {counted(len(found), 'row')})", *lines[:most], *more]


def fuse(rows: np.ndarray, able: Sequence[bool]) -> list[Fused]:
    """The rows of a plan's operations; `able`: which components can take turns."""
    listed, entered = rows.tolist(), gone_on_with(rows)
    found: list[Fused] = []
    n = 0
    while n < len(listed):
        behind = _transfers(listed, entered, n)
        turn = _turn(listed, entered, n, behind, able)
        if turn and found and found[-1].code == TURNS and listed[n][1] == listed[n - 1][1] and n not in entered:
            found[-1].turns.append(turn)
            found[-1].last = turn.last
        elif turn:
            found.append(Fused(TURNS, n, turn.last, [turn]))
        else:
            found.append(Fused(MOVES, n, behind) if behind > n + 1 else Fused(0, n, n + 1))
        n = found[-1].last
    return found


def gone_on_with(rows: np.ndarray) -> frozenset[int]:
    """Operations with which others go on."""
    again = rows[np.isin(rows[:, 0], GOES_TO), 3].tolist()
    loops = np.flatnonzero(rows[:, 0] == SOLVE)
    return frozenset([*again, *(loops - rows[loops, 3]).tolist()])


def _transfers(listed: list[list[int]], entered: frozenset[int], n: int) -> int:
    """The first operation behind transfers that begin with operation n and are of one instant."""
    tick, k = listed[n][1], n
    while k < len(listed) and listed[k][0] in TRANSFERS and listed[k][1] == tick and (k == n or k not in entered):
        k += 1
    return k


def _turn(listed: list[list[int]], entered: frozenset[int], n: int, first: int, able: Sequence[bool]) -> Turn | None:
    """The turn whose transfers are from n to `first`, if what follows is one."""
    tick, k, found = listed[n][1], first, {SET: -1, STEP: -1, GET: -1}
    component = listed[k][2] if k < len(listed) else -1
    for code in found:
        here = k < len(listed) and listed[k][:3] == [code, tick, component] and (k == n or k not in entered)
        if here and not (code == GET and listed[k][3] == AT_AN_INSTANT):
            found[code] = k
            k += 1
    if found[STEP] < 0 or not able[component]:
        return None
    return Turn(n, found[SET], found[STEP], found[GET])
