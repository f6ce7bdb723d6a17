"""An isolated FMU whose events are handled: event mode, clocks and partitions of an instance in another process.

What is done at an instant is done there; what a run looks at again and again is known here too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from ...fmu.fmu import Fmu
from ...fmu.reading.clocks import ClockVariable
from ..messages import Logging
from ..timetable import time_based
from .parent import IsolatedInstance, Peer


class TimesElsewhere(NamedTuple):
    """A timetable that is kept in another process."""

    clocks: Mapping[str, ClockVariable]


class IsolatedEvents(IsolatedInstance):
    """As `here.event_mode.EventModeInstance` and `here.scheduled.ScheduledInstance` are for a run.

    `active`: the clocks that tick in the present round; `waiting`: clocks whose partitions are to be run in it.
    """

    def __init__(
        self, fmu: Fmu, name: str, timeout: float, logging: Logging = "all", tolerance: float | None = None,
        clocks: Mapping[str, Fraction] | None = None, begin: Callable[[Fmu, str], Peer] | None = None,
    ) -> None:  # fmt: skip
        self._active: frozenset[str] = frozenset()
        self.waiting: list[str] = []
        self._next: Fraction | None = None
        self._known = False  # whether `_next` is
        self._clocks = {name: str(interval) for name, interval in (clocks or {}).items()}
        super().__init__(fmu, name, timeout, logging, tolerance, begin)
        self.timetable = TimesElsewhere(time_based(fmu.own.clocks.values()))

    @property
    def clocks(self) -> dict[str, str] | None:
        return self._clocks

    @property
    def events(self) -> Any:
        return self

    @property
    def active(self) -> frozenset[str]:
        return self._active

    @active.setter
    def active(self, clocks: Iterable[str]) -> None:
        self._active = frozenset(clocks)

    def _at_event(self, what: str, *arguments: Any) -> Any:
        found, active, self.waiting, due = self._by_name(what, sorted(self._active), *arguments)
        self._active = frozenset(active)
        self._next, self._known = None if due is None else Fraction(due), True
        return found

    def exit_initialization(self) -> None:
        self._known = False
        super().exit_initialization()

    def restore(self, state: int) -> None:
        self._known = False
        super().restore(state)

    def enter_event_mode(self) -> None:
        """Nothing where it is in event mode already."""
        self._at_event("enter_event_mode")

    def leave_event_mode(self) -> None:
        """Nothing more happens at this instant."""
        self._at_event("leave_event_mode")

    def happen(self, now: Fraction) -> str:
        """What is due for it at an instant [s], in words."""
        return str(self._at_event("happen", str(now)))

    def activate(self, clocks: Sequence[str]) -> None:
        """Activate input clocks, or have their partitions run, in this round."""
        self._at_event("activate", list(clocks))

    def ticking(self, names: Sequence[str]) -> list[bool]:
        """Which clocks tick at this instant."""
        return list(self._at_event("ticking", list(names)))

    def run_next(self) -> tuple[str, list[str]]:
        """Run the partition that is waiting first: its clock, and the output clocks that ticked meanwhile."""
        clock, ticked = self._at_event("run_next")
        return clock, ticked

    def update(self) -> bool:
        """End a round; whether it asks for another one at this instant. Raises AskedToEndError."""
        return bool(self._at_event("update"))

    def next_instant(self) -> Fraction | None:
        """When something is due for it next [s]."""
        if not self._known and not self.dead:
            self._at_event("known")
        return self._next
