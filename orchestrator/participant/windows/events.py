"""Instances for Windows whose events are handled, of FMI 3.0: event mode, clocks, partitions."""

from __future__ import annotations

from ..here.event_mode import EventModeInstance
from ..here.fmi3 import FMU3Instance
from ..here.scheduled import FMU3Scheduled, ScheduledInstance
from .instance import WindowsInstance
from .memory import RESUME


class WindowsEvents(WindowsInstance, EventModeInstance):
    """With event mode."""

    instantiates, choice, slave_kind = "fmi3InstantiateCoSimulation", 1, FMU3Instance


class WindowsScheduled(WindowsInstance, ScheduledInstance):
    """With partitions: what one of them tells in its middle is asked for then."""

    instantiates, slave_kind = "fmi3InstantiateScheduledExecution", FMU3Scheduled
    _inside = False  # a partition, whose clocks are being asked

    def instantiate(self) -> None:
        self.begin_partitions()
        super().instantiate()

    def _ask(self, operation: int) -> int:
        status = super()._ask(operation)
        while self.page.inside and not self._inside and not self.dead:
            self._inside = True  # what is asked for meanwhile is no end of the call
            try:
                self.clocks_changed()
            finally:
                self._inside = False
            status = super()._ask(RESUME)
        return status
