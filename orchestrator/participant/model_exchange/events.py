"""A group of FMUs for Model Exchange among others that have events: what `run.events.handler.EventMode` asks for."""

from __future__ import annotations

from fractions import Fraction

from .group import Group

NEVER = 1e300  # s
CLOSE = 1e-15  # of a time, by which a time event is there already


class GroupEvents:
    """All members enter event mode together; each round takes what is sent between them along."""

    def __init__(self, group: Group) -> None:
        self.group, self.name = group, group.members[0].name

    def enter_event_mode(self) -> None:
        self.group.enter_events()

    def happen(self, now: Fraction) -> str:
        """The time event that is due, in words; empty if none is."""
        if not self._due(float(now)):
            return ""
        return f"{self.group.next_member} has a time event"

    def _due(self, now: float) -> bool:
        return self.group.next_event <= now + CLOSE * abs(now)

    def update(self) -> bool:
        again = self.group.go_round()
        return again or self._due(self.group.time)

    def leave_event_mode(self) -> None:
        self.group.leave_events()

    def next_instant(self) -> Fraction | None:
        due = self.group.next_event
        return Fraction(due) if due < NEVER else None
