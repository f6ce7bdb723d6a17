"""The events of a system while a run goes: what has happened, what is still to come, and what it does.

The loop returns at an operation ACT where something is due, and goes on behind it. All that an event changes are cells
of the run: the plan stays as it is.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import inf
from typing import Any, NamedTuple

import numpy as np

from ...loop.cells import CROSSED, DUE_AT, NEVER, STEP_TICKS, STOP, THRESHOLD
from ...loop.solvers.step_control import fitted
from ...plan.happening.scenario import end_of, from_start, place
from ...plan.happening.scenario_text import what
from ...plan.plan import Plan
from ...results.tables import EventRow
from ...system.event import Event
from ..memory.memory import Memory
from .faults import begin_fault, end_fault

MOST_ROWS = 100_000  # that are kept of events


class Due(NamedTuple):
    """What is to be done: at which tick from the start, of which event (by number), to which component."""

    tick: int
    number: int
    component: str
    ends: bool  # a fault ends; otherwise the event begins


class Scenario:
    """`rows`: what has happened. `clock` is that of steps that vary, see `loop/cells`."""

    def __init__(self, plan: Plan, memory: Memory, control: np.ndarray, clock: np.ndarray) -> None:
        self.plan, self.memory, self.control, self.clock = plan, memory, control, clock
        self.events = plan.system.events
        self.rows: list[EventRow] = []
        self.left_out = 0  # rows of events that were too many
        self.slots = np.concatenate([np.zeros(0, dtype=np.int64), *(group.slots for group in plan.groups)])
        self.pending: list[Due] = []
        self.seen: set[int] = set()  # events that wait for one crossing and have had it
        early = from_start(plan.system)
        for number, event in enumerate(self.events):
            if event in early:
                for name in event.components:
                    self._note(0, f"{what(self.plan.system, event, name)}, from the start", event)
                self._ends(number, event.at)
            elif event.at is not None and event.at > plan.system.start:
                self._happens(number, event.at)
        self._aim()
        if plan.adaptive:
            clock[STEP_TICKS] = fitted(clock, int(clock[STEP_TICKS]), plan.algorithm.even)

    def act(self, tick: int) -> None:
        """Do what is due at an instant [ticks from the start]."""
        for number, cell in self.plan.layout.watches.items():
            if self.memory.z[cell + CROSSED] > 0.0:
                self.memory.z[cell + CROSSED] = 0.0
                self._crossed(number, tick, cell)
        due = sorted(entry for entry in self.pending if entry.tick <= tick)
        self.pending = [entry for entry in self.pending if entry.tick > tick]
        for entry in due:
            event = self.events[entry.number]
            if entry.ends:
                end_fault(self.plan, self.memory, entry.number, entry.component)
                self._note(tick, f"{what(self.plan.system, event, entry.component)}: ends", event)
            else:
                self._begin(entry)
                self._note(tick, what(self.plan.system, event, entry.component), event)
        self._aim()
        if self.plan.adaptive:  # what comes is not what the last steps were chosen by
            first = self.plan.clock.hyperperiod if due or not self.clock[STEP_TICKS] else int(self.clock[STEP_TICKS])
            self.clock[STEP_TICKS] = fitted(self.clock, first, self.plan.algorithm.even)

    def _crossed(self, number: int, tick: int, cell: int) -> None:
        event = self.events[number]
        assert event.when is not None
        if not event.repeat:
            self.seen.add(number)
            self.memory.z[cell + THRESHOLD] = inf if event.when.rising else -inf
        self._note(tick, event.when.text, event)
        self._happens(number, self.plan.system.start + self.plan.clock.seconds(tick) + event.after)

    def _happens(self, number: int, time: Fraction) -> None:
        """Have an event act on all that it touches, each at its instant."""
        event = self.events[number]
        ends = end_of(event, time)
        for name in event.components:
            tick = self._place(name, time)
            if tick < self.plan.clock.stop and (ends is None or self._place(name, ends) > tick):
                self.pending.append(Due(tick, number, name, False))
        self._ends(number, time)

    def _ends(self, number: int, time: Fraction | None) -> None:
        """Have the fault of an event that happens at a time [s] end where it does, and not where it did before."""
        event = self.events[number]
        ends = end_of(event, time)
        if ends is None or time is None:
            return
        self.pending = [entry for entry in self.pending if (entry.number, entry.ends) != (number, True)]
        for name in event.components:
            tick = self._place(name, ends)
            if self._place(name, time) < tick < self.plan.clock.stop:
                self.pending.append(Due(tick, number, name, True))

    def _place(self, name: str, time: Fraction) -> int:
        return place(self.plan.clock, self.plan.algorithm, name, time)

    def _begin(self, due: Due) -> None:
        event = self.events[due.number]
        if event.fault:
            begin_fault(self.plan, self.memory, due.number, due.component)
        for key, value in event.settings.items():
            if key[0] == due.component:
                self.memory.put(key, self.plan.layout.inputs[key], value)

    def _aim(self) -> None:
        """Where the loop is to return next; steps that vary end there."""
        clock, following = self.plan.clock, min((entry.tick for entry in self.pending), default=NEVER)
        self.control[DUE_AT] = clock.start + following if following < NEVER else NEVER
        if self.plan.adaptive:
            self.clock[STOP] = min(clock.stop, following)

    def _note(self, tick: int, what: str, event: Event) -> None:
        if len(self.rows) >= MOST_ROWS:
            self.left_out += 1
            return
        time = self.plan.clock.time(tick)
        number = self.rows[-1].number + 1 if self.rows and self.rows[-1].time == time else 1
        self.rows.append(EventRow(time, number, f"{event.name}: {what}", self.memory.z[self.slots]))

    def content(self) -> dict[str, Any]:
        """What a checkpoint keeps of it beside `cells`, ready for JSON; the faults themselves are cells of the run."""
        return {
            "rows": [[row.time, row.number, row.what] for row in self.rows],
            "left_out": self.left_out, "pending": [list(entry) for entry in self.pending], "seen": sorted(self.seen),
        }  # fmt: skip

    @property
    def notes(self) -> list[str]:
        """What a person must know of them."""
        more = f"{self.left_out} more events happened than the {MOST_ROWS} of which rows are kept"
        return [f"{more}; let them happen more rarely, by another value or without `repeat`"] * bool(self.left_out)

    @property
    def cells(self) -> np.ndarray:
        """What was recorded in its rows, (rows, signals)."""
        return np.array([row.cells for row in self.rows]).reshape(-1, len(self.slots))

    def restore(self, content: Mapping[str, Any], cells: np.ndarray) -> None:
        """Go on where another one was. Raises ValueError, TypeError or LookupError for what none can have held."""
        found = [(float(time), int(number), str(what)) for time, number, what in content["rows"]]
        if cells.shape != (len(found), len(self.slots)):
            raise ValueError("its events are others")
        self.rows = [EventRow(*row, values) for row, values in zip(found, cells, strict=True)]
        self.pending = [Due(*entry) for entry in content["pending"]]
        if not all(type(e.tick) is int and e.component in self.events[e.number].components for e in self.pending):
            raise ValueError("its events are others")
        self.seen, self.left_out = set(content["seen"]), int(content["left_out"])
        following = min((entry.tick for entry in self.pending), default=NEVER)
        self.control[DUE_AT] = self.plan.clock.start + following if following < NEVER else NEVER
