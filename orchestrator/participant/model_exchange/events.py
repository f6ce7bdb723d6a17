"""A group of FMUs for Model Exchange among others that have events: what `run.events.happenings.EventMode` asks for."""

from __future__ import annotations

from fractions import Fraction

from ...integration import cells
from ...integration.compiled import address_of
from ...integration.events.rounds import CLOSE, NEVER
from ...integration.memory import call, number, whole
from ..base import AskedToEndError
from ..lifecycle import DISCARD
from .group import Group


class GroupEvents:
    """All members enter event mode together; each round takes what is sent between them along."""

    def __init__(self, group: Group) -> None:
        self.group, self.name = group, group.members[0].name

    def enter_event_mode(self) -> None:
        """Nothing where they are in event mode already."""
        self.group.enter_events()

    @property
    def _next(self) -> float:
        """The time event that members have announced [s]."""
        return number(self.group.pointer + cells.NEXT_EVENT)

    def _due(self, now: float) -> bool:
        return self._next <= now + CLOSE * abs(now)

    def happen(self, now: Fraction) -> str:
        """The time event that is due, in words; empty if none is."""
        who = self.group.members[whole(self.group.pointer + cells.NEXT_WHO)]
        return f"{who.name} has a time event" if self._due(float(now)) else ""

    def update(self) -> bool:
        """One round; whether another one is needed. Raises FmuError, AskedToEndError."""
        group = self.group
        again = call(address_of("round"), group.pointer)
        if again == -1 - cells.ENDING:
            what = f"component {group.at_fault.name} asked to end the simulation at t = {group.time:.9g} s"
            raise AskedToEndError(what, DISCARD)
        group.require_good(max(-1 - again, 0))
        return again > 0 or self._due(group.time)

    def leave_event_mode(self) -> None:
        """Nothing more happens at this instant."""
        self.group.require_good(call(address_of("leave"), self.group.pointer))

    def next_instant(self) -> Fraction | None:
        """When a time event is due [s]."""
        return Fraction(self._next) if self._next < NEVER else None
