"""An FMI 3.0 instance for scheduled execution: partitions of a model, each activated at the ticks of its clock."""

from __future__ import annotations

import os
from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple
from weakref import ref

from fmpy import fmi3

from ...errors import FmuError
from ..lifecycle import State
from .clock_calls import CHANGED, ClockCalls
from .fmi3 import LOGGER
from .library import Judged
from .message_filter import Row, address_of, filtered


class FMU3Scheduled(Judged, fmi3.FMU3ScheduledExecution):  # type: ignore[misc]
    """fmpy's; it finds the FMI version in the name of the class."""


class Told(NamedTuple):
    """What an FMU says from within a partition: output clocks that ticked, and countdowns that begin [s from now]."""

    ticked: list[str]
    countdowns: dict[str, Fraction]


class ScheduledInstance(ClockCalls):
    """Partitions run one after the other, each to its end: nothing is ever preempted, so there is nothing to lock."""

    waiting: list[str]  # clocks of the partitions that are to be run in this round
    kind = FMU3Scheduled
    between = State.ACTIVATING

    def begin_partitions(self) -> None:
        """Before there is an instance: nothing has run yet."""
        self.waiting = []
        self._ran: dict[str, Fraction] = {}  # s, when each partition ran last
        own = self.fmu.own.clocks.values()
        self._outputs = [clock.name for clock in own if clock.causality == "output"]
        self._countdowns = [clock.name for clock in own if clock.variability == "countdown"]
        self._told: Told = Told([], {})
        self._raised: Exception | None = None

    def _create(self) -> Any:
        slave = self.slave
        self.begin_partitions()
        self._row = Row(id(self), self.log.logging == "all")
        logger = fmi3.fmi3LogMessageCallback(filtered(3, address_of(LOGGER)))
        update = fmi3.fmi3ClockUpdateCallback(partial(_clocks_changed, ref(self)))
        lock, unlock = fmi3.fmi3LockPreemptionCallback(_nothing), fmi3.fmi3UnlockPreemptionCallback(_nothing)
        self._callbacks = logger, update, lock, unlock  # alive as long as the FMU may call them
        folder = f"{self.fmu.folder / 'resources'}{os.sep}"
        return slave.fmi3InstantiateScheduledExecution(
            self.name.encode(), slave.guid.encode(), folder.encode(), False, self.asked_for_all, id(self),
            *self._callbacks,
        )  # fmt: skip

    def clocks_changed(self) -> None:
        """Called by the FMU within a partition: ask its output clocks and countdowns."""
        before, self.state = self.state, State.CLOCKS_TOLD
        try:
            if self._outputs:
                found = zip(self._outputs, self.ticking(self._outputs), strict=True)
                self._told.ticked.extend(name for name, ticks in found if ticks)
            for name in self._countdowns:
                told = self.interval(name)
                if told.qualifier == CHANGED and told.seconds is not None:
                    self._told.countdowns[name] = told.seconds
        except Exception as error:  # an exception does not pass through C
            self._raised = error
        finally:
            if self.state is State.CLOCKS_TOLD:
                self.state = before

    def enter_event_mode(self) -> None:
        """Nothing: it has no modes."""

    def leave_event_mode(self) -> None:
        """Nothing."""

    def happen(self, now: Fraction) -> str:
        """Which partitions are to be run now [s]: see `waiting`; in words."""
        self._now, ticking = now, self.timetable.ticking(now)
        self.timetable.ticked(ticking)
        self.activate(ticking)
        return f"{', '.join(f'{self.name}.{name}' for name in ticking)} ticks" if ticking else ""

    def activate(self, clocks: Sequence[str]) -> None:
        """Have the partitions of these clocks run in this round, by their priority. Raises FmuError for one that has
        run at this instant."""
        for name in clocks:
            if self._ran.get(name) == self._now:
                raise FmuError(
                    f"component {self.name}: clock {name} ticks twice at t = {float(self._now):.9g} s; a partition is "
                    f"activated once at an instant"
                )
            self._ran[name] = self._now
        own = self.fmu.own.clocks
        self.waiting = sorted({*self.waiting, *clocks}, key=lambda name: (own[name].priority or 0, name))

    def run_next(self) -> tuple[str, list[str]]:
        """Run the partition that is waiting first: its clock, and the output clocks that ticked meanwhile."""
        clock = self.waiting.pop(0)
        self.active = frozenset((clock,))
        told = self.run_partition(clock, float(self._now))
        for name, seconds in told.countdowns.items():
            self.timetable.next[name] = self._now + seconds
        self.timetable.ask(self._now, (clock,), countdowns=False)
        self.active = frozenset((clock, *told.ticked))
        return clock, told.ticked

    def update(self) -> bool:
        """End a round; whether a countdown of no length makes another one at this instant."""
        self.active = frozenset()
        return bool(self.timetable.ticking(self._now))

    def next_instant(self) -> Fraction | None:
        """When a clock ticks next [s]."""
        return self.timetable.due()

    def exit_initialization(self) -> None:
        self._begin_clocks()
        self.waiting, self._ran = [], {}
        self.call("exit to activations", "leave initialization", self.slave.exitInitializationMode)

    def run_partition(self, clock: str, time: float) -> Told:
        """Run the partition of a clock that ticks at `time` [s]; what the FMU told meanwhile."""
        self._told, self._raised = Told([], {}), None
        reference = self.clock(clock).reference
        what = f"activate the partition of clock {clock} at t = {time:.9g} s"
        self.call("activate", what, self.slave.fmi3ActivateModelPartition, self.slave.component, reference, time)
        if self._raised is not None:
            raise FmuError(f"component {self.name}: cannot {what}: {self._raised}") from self._raised
        return self._told

    def step(self, time: float, length: float) -> None:
        """All ticks until the end of a step, of an FMU that nobody else is connected with."""
        clocks = list(self.timetable.clocks or self.fmu.own.clocks)
        if clocks and self.state is not State.ACTIVATING:  # which it refuses
            self.run_partition(clocks[0], time)
        while (due := self.timetable.due()) is not None and float(due) <= time + length:
            self.happen(due)
            while self.waiting:
                self.run_next()
            self.update()

    def _ahead(self) -> dict[str, Any]:
        return {**super()._ahead(), "ran": {name: str(instant) for name, instant in self._ran.items()}}

    def _go_back(self, known: dict[str, Any]) -> None:
        super()._go_back({key: known[key] for key in ("periods", "next") if key in known})
        self._ran = {name: Fraction(text) for name, text in known["ran"].items()}


def _clocks_changed(instance: ref[ScheduledInstance], _environment: Any) -> None:
    """An instance is not kept alive by the function that its FMU may call."""
    there = instance()
    if there is not None:
        there.clocks_changed()


def _nothing() -> None:
    """There is nothing that could be preempted."""
