"""Numbers of events that are given elsewhere than in the file that states them: `events.NAME.KEY`.

KEY is a time (`at`, `until`, `for`, `after`), the `value` of a fault, the `threshold` of a crossing, or
`set.COMPONENT.VARIABLE`, what that is set to.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, NamedTuple

from ....clock import duration, instant
from ....errors import InputError, nearest
from ...event import Event
from ...model import System
from .crossings import CROSSING
from .read import events_of

PREFIX, SETS = "events.", "set."
TIMES = ("at", "until", "for", "after")
KEYS = (*TIMES, "value", "threshold")
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")  # all else is text, of which the key knows what it means


class Number(NamedTuple):
    """One number of an event, by its key."""

    event: Event
    key: str

    @property
    def is_time(self) -> bool:
        return self.key in TIMES

    def seconds(self, value: object) -> float:
        """A time as it is given. Raises InputError."""
        return float((instant if self.key in ("at", "until") else duration)(value, self.key))


def is_of_event(system: System, name: str) -> bool:
    """Whether a name is one of an event's number, and not of a component that is called `events`."""
    return name.startswith(PREFIX) and "events" not in system.components


def number_of(system: System, name: str, origin: str) -> Number:
    """The number of a name. Raises InputError for one that is none."""
    events = {event.name: event for event in system.events}
    if not events:
        raise InputError(f"{origin} {name}: the system has no [[events]] ({system.path.name})")
    rest = name.removeprefix(PREFIX)
    found = max((each for each in events if rest.startswith(f"{each}.")), key=len, default=None)
    if found is None:
        given = rest.partition(".")[0]
        raise InputError(f"{origin} {name}: no event is called '{given}'{nearest(given, events)} ({system.path.name})")
    event, key = events[found], rest[len(found) + 1 :]
    has = [*KEYS, *(SETS + target for target in event.stated.get("set", {}))]
    if key not in has:
        raise InputError(f"{origin} {name}: event {found} has no number '{key}'{nearest(key, has)}")
    needs = {"value": event.fault is not None, "threshold": event.when is not None}
    if not needs.get(key, True):
        what = "no fault, whose value that is; its sets are set.COMPONENT.VARIABLE" if key == "value" else "no crossing"
        raise InputError(f"{origin} {name}: event {found} has {what}")
    return Number(event, key)


def with_event_numbers(system: System, values: Mapping[str, object], origin: str) -> System:
    """The system in which events have other numbers; `values`: by name, of which others are passed over.

    Raises InputError for what the file could not say either.
    """
    stated = {event.name: dict(event.stated) for event in system.events}
    changed = False
    for name, value in values.items():
        if is_of_event(system, name):
            number, changed = number_of(system, name, origin), True
            _put(stated[number.event.name], number, value, f"{origin} {name}")
    if not changed:
        return system
    try:
        found = events_of(None, system.components, system.connections, list(stated.values()))
    except InputError as error:
        raise InputError(f"{origin}: {error}") from None
    named = zip(found, system.events, strict=True)
    return replace(system, events=tuple(replace(new, name=old.name, where=old.where) for new, old in named))


def _put(table: dict[str, Any], number: Number, value: object, label: str) -> None:
    given = float(value) if isinstance(value, str) and NUMBER.fullmatch(value.strip()) else value
    if number.key.startswith(SETS):
        table["set"] = {**table["set"], number.key.removeprefix(SETS): given}
    elif number.key == "threshold":
        match = CROSSING.fullmatch(str(table["when"]).strip())
        if match is None:
            raise InputError(f"{label}: {table['when']} crosses no number")
        table["when"] = f"{match['signal']} {match['way']} {given}"
    else:
        table[number.key] = given
