"""An FMI 3.0 instance for co-simulation with event mode: its steps may end early, and what happens is handled."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from ...errors import FmuError
from ...fmu.reading.clocks import seconds_of
from ..base import AskedToEndError
from ..lifecycle import DISCARD, State
from .clock_calls import ClockCalls

MOST_ROUNDS = 1000  # of an instant at which an FMU alone asks for another one again and again


class Updated(NamedTuple):
    """What an FMU says behind an update of its discrete states."""

    again: bool  # another round at the same instant
    ends: bool  # it asks to end the simulation
    next_event: float | None  # s, the time of its next time event


class Reached(NamedTuple):
    """How far a step went [s], and whether something happened there."""

    time: float
    event: bool


class EventModeInstance(ClockCalls):
    """Instantiated with eventModeUsed and earlyReturnAllowed. Leaving initialization mode leads to event mode.

    `next_event`: the time event that it has announced [s]. What `run.events.happenings.EventMode` asks for is here.
    """

    event_mode = True
    next_event = math.inf

    def exit_initialization(self) -> None:
        self._begin_clocks()
        self.call("exit to events", "leave initialization", self.slave.exitInitializationMode)

    def enter_event_mode(self) -> None:
        """Nothing where it is in event mode already."""
        if self.state is not State.EVENTS:
            self.call("enter events", "enter event mode", self.slave.enterEventMode)

    def leave_event_mode(self) -> None:
        self.call("leave events", "enter step mode", self.slave.enterStepMode)

    def _ahead(self) -> dict[str, Any]:
        return {**super()._ahead(), "event": None if math.isinf(self.next_event) else self.next_event}

    def _go_back(self, known: dict[str, Any]) -> None:
        super()._go_back({key: known[key] for key in ("periods", "next") if key in known})
        self.next_event = math.inf if known["event"] is None else known["event"]

    def happen(self, now: Fraction) -> str:
        """Activate the clocks that tick now [s]; which, and whether a time event is due, in words."""
        self._now, ticking = now, self.timetable.ticking(now)
        self.activate(ticking)
        told = [f"{self.name} has a time event"] if self.next_event <= float(now) else []
        told += [f"{', '.join(f'{self.name}.{name}' for name in ticking)} ticks"] if ticking else []
        return "; ".join(told)

    def activate(self, clocks: Sequence[str]) -> None:
        """Activate input clocks in this round."""
        self.tick(clocks)
        self.active |= frozenset(clocks)

    def update(self) -> bool:
        """End a round; whether it asks for another one at this instant. Raises AskedToEndError."""
        updated = self.update_states()
        self.timetable.ticked(self.active)
        self.timetable.ask(self._now, self.active)
        self.active = frozenset()
        if updated.ends:
            raise AskedToEndError(f"component {self.name} asked to end at {float(self._now):.9g} s", DISCARD)
        return updated.again or bool(self.timetable.ticking(self._now)) or self.next_event <= float(self._now)

    def next_instant(self) -> Fraction | None:
        """When something is due for it next [s]."""
        known = [self.timetable.due(), None if math.isinf(self.next_event) else Fraction(self.next_event)]
        return min((instant for instant in known if instant is not None), default=None)

    def evaluate(self) -> None:
        """Compute its discrete states now, where it can do that apart from its outputs."""
        if getattr(self.fmu.own.interface, "providesEvaluateDiscreteStates", False):
            evaluate = self.slave.fmi3EvaluateDiscreteStates
            self.call("update", "evaluate its discrete states", evaluate, self.slave.component)

    def update_states(self) -> Updated:
        """End this round of the instant: discrete states take their new values, clocks tick no more."""
        again, ends, _, _, defined, time = self.call(
            "update", "update its discrete states", self.slave.updateDiscreteStates
        )
        self.next_event = time if defined else math.inf
        return Updated(again, ends, time if defined else None)

    def step_once(self, time: float, length: float) -> Reached:
        """A step from `time` over `length` [s] that may end before. Raises AskedToEndError where it asks to end."""
        length = self.within(time, length)
        what = f"step from t = {time:.9g} s"
        event, ends, early, last = self.call("step", what, self.slave.doStep, time, length, False)
        reached = last if early else time + length
        if ends:
            raise AskedToEndError(f"component {self.name} asked to end at {reached:.9g} s", DISCARD)
        if not time <= reached <= time + length:
            raise FmuError(
                f"component {self.name}: the {what} over {length:g} s ended at {reached:.17g} s{self.log_text()}"
            )
        return Reached(reached, event)

    def step(self, time: float, length: float) -> None:
        """A step over whatever happens in it, of an FMU that nobody else is connected with."""
        end = time + length
        if self.state is State.EVENTS:
            self.settle(seconds_of(time))
        if length < 0.0:  # the FMU is to refuse that, not we
            self.call("step", f"step from t = {time:.9g} s", self.slave.doStep, time, length, False)
        while time < end:
            due = self.next_instant()
            planned = math.inf if due is None else float(due)
            reached = Reached(time, False)
            if planned > time:
                reached = self.step_once(time, min(end, planned) - time)
            time = planned if reached.time == time + (planned - time) else reached.time
            if reached.event or time >= planned:
                self.settle(due if due is not None and time >= planned else seconds_of(time))

    def settle(self, now: Fraction) -> None:
        """Handle what happens at an instant [s] until nothing does any more, and go back to step mode."""
        self.enter_event_mode()
        for _ in range(MOST_ROUNDS):
            self.happen(now)
            if not self.update():
                self.leave_event_mode()
                return
        raise FmuError(
            f"component {self.name}: {MOST_ROUNDS} rounds of events at t = {float(now):.9g} s, and it asks for another"
        )
