"""Inputs that are set at events and follow tables: a new row is an event of their component, at its exact time.

A clocked input takes at each tick the last row at or before it.
"""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from ...loop.lookup import held_at
from ...plan.plan import Plan
from ...plan.schedule.layout import Key
from ...system.inputs.series import Series
from ..memory.memory import Memory


class Followed(NamedTuple):
    """An input, its cell, and its table, once as the loop has it; `clocked`: it waits for the ticks of its clocks."""

    key: Key
    slot: int
    series: Series
    table: np.ndarray
    clocked: bool


class FollowedTables:
    """All such inputs of a system, as `happenings.Happenings`."""

    def __init__(self, plan: Plan, memory: Memory) -> None:
        self.memory = memory
        self.inputs: list[Followed] = []
        for name, component in plan.system.components.items():
            for variable in component.series.keys() & component.at_events:
                series, slot = component.series[variable], plan.layout.inputs[name, variable]
                clocked = bool(component.clocks_of(variable))
                self.inputs.append(Followed((name, variable), slot, series, series.table, clocked))
        self.done = plan.clock.time(0)  # s; what is due until then has happened

    def next_instant(self) -> Fraction | None:
        due = [Fraction(time) for one in self.inputs if not one.clocked and (time := self._next(one)) is not None]
        return min(due, default=None)

    def _next(self, one: Followed) -> float | None:
        later = one.series.times[np.searchsorted(one.series.times, self.done, side="right") :]
        return float(later[0]) if len(later) else None

    def happen(self, now: Fraction, passed: Collection[str] = ()) -> str:
        time, words = float(now), []
        for one in self.inputs:
            due = self._next(one)
            self.memory.z[one.slot] = held_at(one.table, 0, time)
            if due is not None and due <= time and not one.clocked:
                words.append(f"{'.'.join(one.key)} takes another row of {one.series.origin}")
        self.done = max(self.done, time)
        return "; ".join(words)
