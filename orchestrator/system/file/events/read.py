"""The events of a system file, checked against components and connections: see `system/event`."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from ....clock import duration, instant, seconds_text
from ....errors import InputError, nearest
from ....fmu.types import Value
from ....toml.file import TomlFile
from ...component import Component
from ...connection import Connection
from ...event import Event, Key
from ...model import System
from ...schema.checked import checked
from ...schema.keys.event import EventTable
from ...values import checked_values, follows_tables
from .crossings import crossing_of
from .faults import fault_of
from .signals import Fail, Signals


def events_of(
    file: TomlFile | None, components: Mapping[str, Component], connections: tuple[Connection, ...],
    entries: list[dict[str, Any]], called: str = "event", before: tuple[Event, ...] = (),
) -> tuple[Event, ...]:  # fmt: skip
    """All events; `file`: where they stand, if that is known; `called`: what one without a name is, beside its place;
    `before`: those that are there already. Raises InputError."""
    signals = Signals(components, {c.target: c for c in connections})
    found: list[Event] = []
    for number, entry in enumerate(entries, 1):
        given = entry.get("name")
        label = f"event {given}" if isinstance(given, str) and given else f"{called} {number}"
        event = _event(file, signals, entry, label, given or f"{called} {number}")
        if event.name in (other.name for other in found):
            raise _failing(file, label)("there are two events of this name; give each its own", "name")
        if same := next((other for other in before if other.name == event.name), None):
            where = f" {same.where}" if same.where else ""
            raise _failing(file, label)(f"the system has an event of this name already{where}; give it another", "name")
        found.append(event)
    return tuple(found)


def events_again(system: System) -> tuple[Event, ...]:
    """The events of a system of which a component has become another one, as they are stated. Raises InputError."""
    stated = [dict(event.stated) for event in system.events]
    return events_of(None, system.components, system.connections, stated)


def _event(file: TomlFile | None, signals: Signals, entry: dict[str, Any], label: str, name: str) -> Event:
    table, fail = checked(EventTable, entry, label, file, "events"), _failing(file, label)
    if [table.at is not None, table.when is not None, table.by_hand].count(True) != 1:
        one = 'a time, at = "2 s", a crossing, when = "motor.i > 20 A", or by_hand = true'
        raise fail(f"it needs either {one}, and only one of them")
    if not table.initial and table.at is None:
        raise fail("initial goes with a time, 'at'; leave it out", "initial")
    if (not table.set) == (table.fault is None):
        raise fail('it needs either values to set, set = { "a.input" = 1.0 }, or fault = "loss" and on = "b.input"')
    for key, given in (("after", table.after is not None), ("repeat", table.repeat)):
        if given and table.when is None:
            other = "with what is done by hand" if table.by_hand else "with a time"
            raise fail(f"{key} goes with a crossing, 'when', and not {other}; leave it out", key)
    for key, stated in (("on", table.on), ("value", table.value), ("seed", table.seed), ("until", table.until),
                        ("for", table.for_)):  # fmt: skip
        if stated is not None and table.fault is None:
            instead = "; a second event can set the values back" if key in ("until", "for") else ""
            raise fail(f"{key} goes with a fault, and there is none; leave it out{instead}", key)
    times = _times(table, fail)
    where = file.at(str(table.name or table.on or next(iter(table.set), "[[events]]")), "events") if file else ""
    done: dict[str, Any] = {"settings": _settings(signals, table, fail)} if table.fault is None else {}
    done |= {"fault": fault_of(signals, table, fail)} if table.fault is not None else {}
    when = crossing_of(signals, table, fail)
    ways: dict[str, Any] = {"when": when, "repeat": table.repeat, "by_hand": table.by_hand, "initial": table.initial}
    return Event(name, stated=entry, where=where, **ways, **times, **done)


def _failing(file: TomlFile | None, label: str) -> Fail:
    """How errors of an event are made, from a message and the word that they are about."""

    def fail(message: str, needle: str = "[[events]]") -> InputError:
        return file.fail(f"{label}: {message}", needle, "events") if file else InputError(f"{label}: {message}")

    return fail


def _times(table: EventTable, fail: Fail) -> dict[str, Any]:
    """The times of an event. Raises InputError for what is no time, and for an end that is not after the beginning."""
    found: dict[str, Fraction | None] = {}
    for key, value, read in (
        ("at", table.at, instant), ("until", table.until, instant), ("after", table.after, duration),
        ("for", table.for_, duration),
    ):  # fmt: skip
        try:
            found[key] = None if value is None else read(value, key)
        except InputError as error:
            raise fail(str(error), key) from None
    at, until, lasting = found["at"], found["until"], found.pop("for")
    if until is not None and lasting is not None:
        raise fail("either 'until' or 'for' says how long it lasts, not both", "until")
    if at is not None and until is not None and until <= at:
        raise fail(f"until = {seconds_text(until)} is not after at = {seconds_text(at)}", "until")
    return {**found, "after": found["after"] or Fraction(0), "lasting": lasting}


def _settings(signals: Signals, table: EventTable, fail: Fail) -> dict[Key, Value]:
    """The scalars that are set. Raises InputError for what cannot be set while a run goes."""
    found: dict[Key, Value] = {}
    for name, value in table.set.items():
        keys = signals.scalars(name)
        if not keys:
            known = signals.names("input", "parameter")
            raise fail(f"set: no variable is called '{name}'{nearest(name, known)}", name)
        owner, variable = keys[0][0], name.partition(".")[2]
        component = signals.components[owner]
        for key in keys:
            if key in signals.drivers:
                label_of = signals.drivers[key].label
                raise fail(
                    f"set: {name} is driven by the connection {label_of}; break that with fault and "
                    f'on = "{".".join(key)}", or remove it',
                    name,
                )
            if key[1] in component.series:
                raise fail(f"set: {name} follows {component.series[key[1]]}; remove that, or write it there", name)
            if not follows_tables(component.fmu.variables[key[1]]):
                kind = component.fmu.variables[key[1]]
                raise fail(
                    f"set: {name} is of causality {kind.causality} and variability {kind.variability}; only inputs and "
                    "tunable parameters can be set while a run goes",
                    name,
                )
        try:
            values = checked_values(component, variable, value, "set")
        except InputError as error:
            raise fail(str(error), name) from None
        found |= {(owner, scalar): v for scalar, v in values.items()}
    return found
