"""An FMI 3.0 instance for scheduled execution: partitions of a model, each activated at the ticks of its clock."""

from __future__ import annotations

import os
from fractions import Fraction
from typing import Any, NamedTuple

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

    kind = FMU3Scheduled
    between = State.ACTIVATING

    def _create(self) -> Any:
        slave = self.slave
        self._row = Row(id(self), self.log.logging == "all")
        own = self.fmu.own.clocks.values()
        self._outputs = [clock.name for clock in own if clock.causality == "output"]
        self._countdowns = [clock.name for clock in own if clock.variability == "countdown"]
        self._told: Told = Told([], {})
        self._raised: Exception | None = None
        logger = fmi3.fmi3LogMessageCallback(filtered(3, address_of(LOGGER)))
        update = fmi3.fmi3ClockUpdateCallback(self._clocks_changed)
        lock, unlock = fmi3.fmi3LockPreemptionCallback(_nothing), fmi3.fmi3UnlockPreemptionCallback(_nothing)
        self._callbacks = logger, update, lock, unlock  # alive as long as the FMU may call them
        folder = f"{self.fmu.folder / 'resources'}{os.sep}"
        return slave.fmi3InstantiateScheduledExecution(
            self.name.encode(), slave.guid.encode(), folder.encode(), False, self.asked_for_all, id(self),
            *self._callbacks,
        )  # fmt: skip

    def _clocks_changed(self, _environment: Any) -> None:
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

    def exit_initialization(self) -> None:
        self.call("exit to activations", "leave initialization", self.slave.exitInitializationMode)

    def activate(self, clock: str, time: float) -> Told:
        """Run the partition of a clock that ticks at `time` [s]; what the FMU told meanwhile."""
        self._told, self._raised = Told([], {}), None
        reference = self.clock(clock).reference
        what = f"activate the partition of clock {clock} at t = {time:.9g} s"
        self.call("activate", what, self.slave.fmi3ActivateModelPartition, self.slave.component, reference, time)
        if self._raised is not None:
            raise FmuError(f"component {self.name}: cannot {what}: {self._raised}") from self._raised
        return self._told

    def step(self, time: float, length: float) -> None:
        raise FmuError(f"component {self.name} makes no steps: its partitions are activated by their clocks")


def _nothing() -> None:
    """There is nothing that could be preempted."""
