"""What an observer is told of a run: its tables, their signals, and rows as they come."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import ceil
from typing import Any

import numpy as np

from ..clock import seconds_text
from ..errors import InputError, nearest
from ..loop.texts import Texts
from ..plan.plan import Plan
from ..results.signals import instants, typed
from ..run.recording.observers import Piece
from ..system.file.recorded import matches

KINDS = {"f": "number", "i": "integer", "u": "integer", "b": "boolean"}  # by the kind of an array


@dataclass(frozen=True)
class Column:
    """One signal: `name` in full, and what its values are: number, integer, boolean or string."""

    component: str
    variable: str
    kind: str
    unit: str
    description: str

    @property
    def name(self) -> str:
        return f"{self.component}.{self.variable}"


@dataclass(frozen=True)
class Table:
    """Signals that have their rows at the same instants; `period` in words."""

    period: str
    columns: tuple[Column, ...]

    def parts(self) -> dict[str, list[int]]:
        """The columns of each component."""
        found: dict[str, list[int]] = {}
        for k, column in enumerate(self.columns):
            found.setdefault(column.component, []).append(k)
        return found


@dataclass(frozen=True)
class Layout:
    """All tables. `messages`: what signals make together, as the system file states it; see `schema/messages`."""

    system: str
    description: str
    start: float  # s
    stop: float  # s
    tables: tuple[Table, ...]
    messages: tuple[Mapping[str, Any], ...] = ()

    def nanoseconds(self, times: np.ndarray) -> list[int]:
        """Times [s] as whole nanoseconds; of a run that starts before 0 from its start, as files have no negative
        ones."""
        origin = min(self.start, 0.0)
        return [round((time - origin) * 1e9) for time in times.tolist()]


@dataclass(frozen=True)
class Rows:
    """Some rows of a table: `times` [s], (rows,), and for each of its columns the values in their own type."""

    table: int
    times: np.ndarray
    values: tuple[np.ndarray, ...]

    @property
    def size(self) -> int:
        """Bytes, about."""
        return int(self.times.nbytes + sum(64 * len(v) if v.dtype == object else v.nbytes for v in self.values))

    def each(self, columns: Iterable[int] | None = None) -> Iterable[tuple[Any, ...]]:
        """The values of each row, as Python has them."""
        chosen = self.values if columns is None else [self.values[k] for k in columns]
        return zip(*(values.tolist() for values in chosen), strict=True)


class Selection:
    """The signals of a plan that observers see, and every how many ticks; it makes `Rows` of what a run records.

    Raises InputError for a pattern that names nothing recorded."""

    def __init__(self, plan: Plan, patterns: Iterable[str] = ("*",), every: Fraction | None = None) -> None:
        self.plan = plan
        names = [".".join(key) for group in plan.groups for key in group.columns]
        for pattern in patterns:
            if not any(matches((pattern,), name) for name in names):
                raise InputError(f"no recorded signal '{pattern}'{nearest(pattern, names)}")
        self.picks = [
            [(k, key) for k, key in enumerate(group.columns) if matches(tuple(patterns), ".".join(key))]
            for group in plan.groups
        ]
        self._at = {g: k for k, g in enumerate(g for g, picks in enumerate(self.picks) if picks)}
        self._ticks = 1 if every is None else max(ceil(every / plan.clock.seconds(1)), 1)
        self._next = [0] * len(plan.groups)  # where steps vary: the tick from which on the next row counts
        tick = ("coupling", "tick")
        self._tick = [next((k for k, key in enumerate(group.columns) if key == tick), -1) for group in plan.groups]

    def layout(self) -> Layout:
        system, clock = self.plan.system, self.plan.clock
        tables = []
        for g in self._at:
            text = "steps that vary" if self.plan.adaptive else seconds_text(clock.seconds(self.plan.groups[g].period))
            tables.append(Table(text, tuple(self._column(key) for _, key in self.picks[g])))
        start, stop = (clock.time(tick) for tick in (0, clock.stop))
        messages = tuple(system.reporting.get("messages", ()))
        return Layout(system.name, system.description, start, stop, tuple(tables), messages)

    def _column(self, key: tuple[str, str]) -> Column:
        extra = self.plan.layout.extras.get(key)
        if extra is not None:
            return Column(*key, "number", extra.unit, extra.description)
        fmu = self.plan.system.components[key[0]].fmu
        variable = fmu.variables[key[1]]
        kind = "string"
        if variable.type not in ("String", "Binary"):
            kind = KINDS.get(typed(self.plan, key, np.zeros(1), None).dtype.kind, "number")
        return Column(*key, kind, variable.unit or "", variable.description or "")

    def rows(self, piece: Piece, texts: Texts) -> list[Rows]:
        """What is chosen of the new rows of a run."""
        found = []
        for g, place in self._at.items():
            table = piece.tables[g]
            if not len(table):
                continue
            ticks, chosen = self._chosen(g, piece.first[g], table)
            if len(ticks):
                values = (typed(self.plan, key, table[chosen, k].copy(), texts) for k, key in self.picks[g])
                found.append(Rows(place, instants(self.plan.clock, ticks), tuple(values)))
        return found

    def _chosen(self, group: int, first: int, table: np.ndarray) -> tuple[np.ndarray, Any]:
        """Instants [ticks] and which rows they are."""
        if not self.plan.adaptive:
            ticks = self.plan.instants_of(group, first, len(table))
            chosen = np.flatnonzero(ticks % self._ticks == 0) if self._ticks > 1 else slice(None)
            return ticks[chosen], chosen
        ticks = table[:, self._tick[group]].astype(np.int64)
        if self._ticks == 1:
            return ticks, slice(None)
        kept = []
        for k, tick in enumerate(ticks.tolist()):
            if tick >= self._next[group]:
                kept.append(k)
                self._next[group] = (tick // self._ticks + 1) * self._ticks
        return ticks[kept], np.array(kept, dtype=np.int64)
