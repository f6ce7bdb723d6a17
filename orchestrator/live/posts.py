"""Rows of a run as they come, made so few that a page can follow them: the last value, the lowest and the highest."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..fmu.types import TEXT, FmiType, decode
from ..plan.plan import Plan
from ..run.recording.observers import NEVER, Piece
from .messages import Shown, packed_rows

MOST = 400  # signals


class _Table(NamedTuple):
    """What is posted of one table: columns of floating-point numbers, and others with their types."""

    real: np.ndarray
    at: np.ndarray  # their places among the signals
    others: list[tuple[int, int, FmiType]]  # column, place, type


class Posts:
    """An observer. `signals`: what is posted, those of `first` first; numbers and truth values only."""

    def __init__(self, plan: Plan, first: Sequence[str] = ()) -> None:
        known = {
            ".".join(key): (group, column, *_about(plan, key))
            for group, table in enumerate(plan.groups)
            for column, key in enumerate(table.columns)
        }
        known = {name: place for name, place in known.items() if place[2] is None or place[2].code < TEXT}
        names = list(dict.fromkeys([*(name for name in first if name in known), *known]))[:MOST]
        self.signals = [Shown(name, *known[name][3:]) for name in names]
        self._tables = []
        for group in range(len(plan.groups)):
            own = [(known[name][1], at, known[name][2]) for at, name in enumerate(names) if known[name][0] == group]
            real = [(column, at) for column, at, kind in own if kind is None or kind.real]
            columns, places = np.array(real, dtype=np.int64).reshape(-1, 2).T
            others = [(column, at, kind) for column, at, kind in own if kind is not None and not kind.real]
            self._tables.append(_Table(columns, places, others))
        self.values = np.full((3, len(names)), np.nan)
        self.time, self._begins = plan.clock.time(0), True

    def due(self, tick: int) -> int:
        return NEVER

    def see(self, piece: Piece) -> None:
        """Take the rows that are new."""
        self.time = piece.time
        if self._begins:
            self.values[1], self.values[2] = self.values[0], self.values[0]
        self._begins = False
        for table, rows in zip(self._tables, piece.tables, strict=True):
            if not len(rows):
                continue
            if len(table.real):
                self._take(table.at, rows[:, table.real])
            for column, at, kind in table.others:
                found = decode(kind, np.ascontiguousarray(rows[:, column])).astype(float)
                self._take(np.array([at]), found[:, None])

    def _take(self, at: np.ndarray, rows: np.ndarray) -> None:
        low, high = rows.min(axis=0), rows.max(axis=0)
        self.values[0, at] = rows[-1]
        self.values[1, at] = np.fmin(self.values[1, at], low)  # NaN: there was nothing before
        self.values[2, at] = np.fmax(self.values[2, at], high)

    def message(self) -> bytes:
        """What there is since the message before."""
        self._begins = True
        return packed_rows(self.time, self.values)


def _about(plan: Plan, key: tuple[str, str]) -> tuple[FmiType | None, str, str]:
    """Type, unit and description of what is recorded; a signal of the coupling is a plain number."""
    if key in plan.layout.extras:
        extra = plan.layout.extras[key]
        return None, extra.unit, extra.description
    fmu = plan.system.components[key[0]].fmu
    variable = fmu.variables[key[1]]
    return fmu.type_of(key[1]), variable.unit or "", variable.description or ""
