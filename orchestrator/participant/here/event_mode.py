"""An FMI 3.0 instance for co-simulation with event mode: its steps may end early, and what happens is handled."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from ...errors import FmuError
from ...fmu.clocks import seconds_of
from ..base import AskedToEndError
from ..lifecycle import DISCARD, State
from ..timetable import Timetable
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

    `timetable`: of its time-based clocks, known from the end of initialization on; `next_event`: the time event that it
    has announced [s].
    """

    event_mode = True
    next_event = math.inf
    timetable: Timetable

    def exit_initialization(self) -> None:
        self.timetable = Timetable(self, self.fmu.own.clocks.values())
        self.timetable.begin(seconds_of(self.span[0] if self.span else 0.0))
        self.call("exit to events", "leave initialization", self.slave.exitInitializationMode)

    def enter_event_mode(self) -> None:
        self.call("enter events", "enter event mode", self.slave.enterEventMode)

    def enter_step_mode(self) -> None:
        self.call("leave events", "enter step mode", self.slave.enterStepMode)

    def evaluate(self) -> None:
        """Compute its discrete states now, where it can do that apart from its outputs."""
        if getattr(self.fmu.own.interface, "providesEvaluateDiscreteStates", False):
            evaluate = self.slave.fmi3EvaluateDiscreteStates
            self.call("update", "evaluate its discrete states", evaluate, self.slave.component)

    def update(self) -> Updated:
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
            self.settle(time)
        while time < end:
            due = self.timetable.due()
            planned = min(self.next_event, math.inf if due is None else float(due))
            reached = Reached(time, False)
            if planned > time:
                reached = self.step_once(time, min(end, planned) - time)
            time = planned if reached.time == time + (planned - time) else reached.time
            if reached.event or time >= planned:
                self.enter_event_mode()
                self.settle(time, due if due is not None and time >= float(due) else None)

    def settle(self, time: float, instant: Fraction | None = None) -> None:
        """Update until nothing more happens at `time` [s], and go back to step mode; `instant`: the same exactly."""
        now = seconds_of(time) if instant is None else instant
        for _ in range(MOST_ROUNDS):
            ticking = self.timetable.ticking(now)
            self.tick(ticking)
            updated = self.update()
            self.timetable.ticked(ticking)
            self.timetable.ask(now, ticking)
            if updated.ends:
                raise AskedToEndError(f"component {self.name} asked to end at {time:.9g} s", DISCARD)
            if not updated.again and not self.timetable.ticking(now):
                self.enter_step_mode()
                return
        raise FmuError(
            f"component {self.name}: {MOST_ROUNDS} rounds of events at t = {time:.9g} s, and it asks for another one"
        )
