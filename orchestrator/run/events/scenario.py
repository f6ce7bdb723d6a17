"""The events of a system while a run goes: what has happened, what is still to come, and what it does.

All that an event changes are cells of the run: the plan stays as it is.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from fractions import Fraction
from math import inf
from typing import Any, NamedTuple

from ...fmu.types import Value
from ...loop.cells import ABSENT, CROSSED, MODE, SIDE, THRESHOLD
from ...plan.happening.scenario import acts_at, end_of, from_start
from ...plan.happening.scenario_text import quantity, what
from ...plan.plan import Plan
from ...system.event import Event, Key
from ..memory.memory import Memory
from .faults import begin_fault, end_fault


class Due(NamedTuple):
    """What is to be done: at which time [s], of which event (by number), to which component."""

    time: Fraction
    number: int
    component: str
    ends: bool  # a fault ends; otherwise the event begins


class Scenario:
    """`happenings.Happenings` of a system. `pending`: what is known to come; `seen`: events that wait for one crossing
    and have had it."""

    def __init__(self, plan: Plan, memory: Memory) -> None:
        self.plan, self.memory = plan, memory
        self.events = list(plan.system.events)  # of those that are given by hand other numbers
        self.stop = plan.clock.seconds(plan.clock.start + plan.clock.stop)
        self.pending: list[Due] = []
        self.seen: set[int] = set()
        self.words: list[str] = []  # what is there from the start
        self.acted = False  # whether anything was done at the last instant
        self.to_set: dict[Key, tuple[Value, Fraction]] = {}  # by hand: the value, and when [s]
        broken = {key for event in self.events if event.fault for key in event.fault.values}
        self._breakable = sorted(plan.layout.inputs[key] for key in broken)
        self._before: tuple[float, dict[int, int]] = -inf, {}  # an instant, and what these cells were before it
        early = from_start(plan.system)
        for number, event in enumerate(self.events):
            if event in early:
                for name in event.components:
                    self.words.append(f"{event.name}: {what(plan.system, event, name)}, from the start")
                self._ends(number, event.at)
            elif event.at is not None and (event.at > plan.system.start or not event.initial):
                self._happens(number, event.at)
        self._look(())

    def next_instant(self) -> Fraction | None:
        waiting = [entry.time for entry in self.pending] + [time for _, time in self.to_set.values()]
        return min(waiting, default=None)

    def happen(self, now: Fraction, passed: Collection[str] = ()) -> str:
        words, self.words, self.acted = self.words, [], False
        if now >= self.stop:  # no step is behind it
            return "; ".join(words)
        self._look(passed)
        if self._before[0] != float(now):
            self._before = float(now), {cell: int(self.memory.whole[cell]) for cell in self._breakable}
        for number, cell in self.plan.layout.watches.items():
            if self.memory.z[cell + CROSSED] > 0.0:
                self.memory.z[cell + CROSSED] = 0.0
                words += self._crossed(number, now, cell)
        due = sorted(entry for entry in self.pending if entry.time <= now or float(entry.time) == float(now))
        self.pending = [entry for entry in self.pending if entry not in due]
        self.acted = bool(due)
        for entry in due:
            event = self.events[entry.number]
            if entry.ends:
                end_fault(self.plan, self.memory, entry.number, entry.component, event)
            else:
                self._begin(entry)
            said = what(self.plan.system, event, entry.component)
            words.append(f"{event.name}: {said}{': ends' if entry.ends else ''}")
        words += self._set()
        return "; ".join(words)

    def _set(self) -> list[str]:
        """Set what is set by hand; in words."""
        values, self.to_set = self.to_set, {}
        self.acted |= bool(values)
        for key, (value, _) in values.items():
            self.memory.put(key, self.plan.layout.inputs[key], value)
        system = self.plan.system
        return [f"{'.'.join(key)} = {quantity(system, key, value)}, by hand" for key, (value, _) in values.items()]

    def by_hand(self, number: int, now: Fraction, ends: bool) -> bool:
        """Have an event happen now [s], or its fault end; whether that does anything."""
        event = self.events[number]
        if not ends:
            self._happens(number, now)
            return True
        faults = (self.plan.layout.faults[number, key] for key in event.inputs)
        there = any(self.memory.z[cell + MODE] != ABSENT for cell in faults)
        if there:
            self.pending = [entry for entry in self.pending if entry.number != number]
            self.pending += [Due(now, number, name, True) for name in event.components]
        return there

    def _look(self, passed: Collection[str]) -> None:
        """As the operations WATCH do it, at the signals of all components that are not behind the instant."""
        z, whole = self.memory.z, self.memory.whole
        for number, cell in self.plan.layout.watches.items():
            crossing = self.events[number].when
            assert crossing is not None
            if crossing.signal[0] in passed:
                continue
            slot = self.plan.layout.outputs[crossing.signal]
            value = float(z[slot]) if self.memory.kind(crossing.signal).real else float(whole[slot])
            beyond = value > z[cell + THRESHOLD] if crossing.rising else value < z[cell + THRESHOLD]
            side = 1.0 if beyond else -1.0
            if z[cell + SIDE] < 0.0 < side:
                z[cell + CROSSED] += 1.0
            z[cell + SIDE] = side

    def _crossed(self, number: int, now: Fraction, cell: int) -> list[str]:
        event = self.events[number]
        assert event.when is not None
        if not event.repeat:
            self.seen.add(number)
            self.memory.z[cell + THRESHOLD] = inf if event.when.rising else -inf
        self._happens(number, now + event.after)
        return [f"{event.name}: {event.when.text}"]

    def _happens(self, number: int, time: Fraction) -> None:
        """Have an event act on all that it touches, each at its instant."""
        event = self.events[number]
        ends = end_of(event, time)
        for name in event.components:
            at = acts_at(self.plan, name, time)
            if at < self.stop and (ends is None or acts_at(self.plan, name, ends) > at):
                self.pending.append(Due(at, number, name, False))
        self._ends(number, time)

    def _ends(self, number: int, time: Fraction | None) -> None:
        """Have the fault of an event that happens at a time [s] end where it does, and not where it did before."""
        event = self.events[number]
        ends = end_of(event, time)
        if ends is None or time is None:
            return
        self.pending = [entry for entry in self.pending if (entry.number, entry.ends) != (number, True)]
        for name in event.components:
            at = acts_at(self.plan, name, ends)
            if acts_at(self.plan, name, time) < at < self.stop:
                self.pending.append(Due(at, number, name, True))

    def give(self, number: int, event: Event | None, withdrawn: Fraction | None = None) -> None:
        """Have an event happen at a time to come as `event` states it, which touches the same inputs.

        `withdrawn`: what it was given for that time [s] does not happen; None for `event`: nothing does instead.
        """
        if withdrawn is not None:
            self.pending = [entry for entry in self.pending if entry.number != number or entry.time < withdrawn]
        if event is not None:
            assert event.at is not None
            self.events[number] = event
            self._happens(number, event.at)

    def end(self, number: int, time: Fraction) -> None:
        """Have the fault of an event that has been given end at a time to come [s]."""
        self.events[number] = replace(self.events[number], until=time, lasting=None)
        self._ends(number, self.events[number].at)

    def _begin(self, due: Due) -> None:
        event = self.events[due.number]
        if event.fault:
            begin_fault(self.plan, self.memory, due.number, due.component, event, self._before[1])
        for key, value in event.settings.items():
            if key[0] == due.component:
                self.memory.put(key, self.plan.layout.inputs[key], value)

    def content(self) -> dict[str, Any]:
        """What a checkpoint keeps of it, ready for JSON; the faults themselves are cells of the run."""
        pending = [[str(entry.time), *entry[1:]] for entry in self.pending]
        time, cells = self._before
        before = [time if time > -inf else None, [[cell, value] for cell, value in cells.items()]]
        return {"pending": pending, "seen": sorted(self.seen), "words": list(self.words), "before": before}

    def restore(self, content: Mapping[str, Any]) -> None:
        """Go on where another one was. Raises ValueError, TypeError or LookupError for what none can have held."""
        self.pending = [Due(Fraction(time), *entry) for time, *entry in content["pending"]]
        if not all(e.component in self.events[e.number].components for e in self.pending):
            raise ValueError("its events are others")
        self.seen, self.words = set(content["seen"]), list(content["words"])
        time, cells = content["before"]
        self._before = -inf if time is None else float(time), {int(cell): int(value) for cell, value in cells}
