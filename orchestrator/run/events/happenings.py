"""What can happen in a run: events of participants, and those beside them."""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from typing import Protocol


class EventMode(Protocol):
    """A participant that has events of its own."""

    name: str

    def enter_event_mode(self) -> None:
        """Before anything of an instant is done; nothing where it is in event mode already."""

    def happen(self, now: Fraction) -> str:
        """What is due for it at an instant [s], its clocks among them; in words, empty if nothing is."""

    def update(self) -> bool:
        """End a round; whether it asks for another one. Raises AskedToEndError."""

    def leave_event_mode(self) -> None:
        """Nothing more happens at this instant."""

    def next_instant(self) -> Fraction | None:
        """When something is due for it next [s]; None if it does not know of anything."""


class Happenings(Protocol):
    """What happens beside the events of participants: those that the system states, tables, what is set by hand."""

    def next_instant(self) -> Fraction | None:
        """When the next one is due [s]; None if none is."""

    def happen(self, now: Fraction, passed: Collection[str] = ()) -> str:
        """Do what is due at an instant [s]; in words, empty if nothing is. `passed`: components that are behind it."""


class ByHand:
    """What was set between two steps, as `Happenings`: it is an event at once."""

    def __init__(self) -> None:
        self.words: list[str] = []

    def next_instant(self) -> Fraction | None:
        return None

    def happen(self, now: Fraction, passed: Collection[str] = ()) -> str:
        said, self.words = "; ".join(self.words), []
        return said
