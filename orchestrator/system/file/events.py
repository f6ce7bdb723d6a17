"""The events of a system file, checked against components and connections: see `system/event`."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ...clock import duration, instant, seconds_text
from ...errors import InputError, nearest
from ...fmu.attributes import is_number, parse_value
from ...fmu.conversions import conversion_of
from ...fmu.types import Value
from ...toml_file import TomlFile
from ..event import Crossing, Event, Fault, Key
from ..model import Component, Connection, System, checked_values, follows_tables
from ..quantities import in_own_unit
from ..schema.checked import checked
from ..schema.system import EventTable

Fail = Callable[..., InputError]
WITHOUT_UNIT = ("scale",)  # faults whose value is a plain number
CROSSING = re.compile(r"(?P<signal>.*?\S)\s*(?P<way>[<>])\s*(?P<value>[^<>=\s].*)")
CHECKED = ("bias", "scale", "noise")  # faults of floating-point signals alone


@dataclass(frozen=True)
class Signals:
    """What events may name."""

    components: Mapping[str, Component]
    drivers: Mapping[Key, Connection]

    def scalars(self, name: str) -> list[Key]:
        """The scalars behind `component.variable`; none where there is no such variable."""
        owner, _, variable = name.partition(".")
        known = self.components.get(owner)
        return [(owner, scalar) for scalar in (known.fmu.expand(variable) if known else ())]

    def names(self, *causalities: str) -> list[str]:
        return [f"{c.name}.{v}" for c in self.components.values() for v in c.fmu.base_names(*causalities)]

    def causality(self, key: Key) -> str:
        return str(self.components[key[0]].fmu.variables[key[1]].causality)

    def is_real(self, key: Key) -> bool:
        return self.components[key[0]].fmu.is_real(key[1])


def events_of(
    file: TomlFile | None, components: Mapping[str, Component], connections: tuple[Connection, ...],
    entries: list[dict[str, Any]],
) -> tuple[Event, ...]:  # fmt: skip
    """All events; `file`: where they stand, if that is known. Raises InputError."""
    signals = Signals(components, {c.target: c for c in connections})
    found: list[Event] = []
    for number, entry in enumerate(entries, 1):
        given = entry.get("name")
        label = f"event {given if isinstance(given, str) and given else number}"
        event = _event(file, signals, entry, label, given or f"event {number}")
        if event.name in (other.name for other in found):
            raise _failing(file, label)("there are two events of this name; give each its own", "name")
        found.append(event)
    return tuple(found)


def events_again(system: System) -> tuple[Event, ...]:
    """The events of a system of which a component has become another one, as they are stated. Raises InputError."""
    stated = [dict(event.stated) for event in system.events]
    return events_of(None, system.components, system.connections, stated)


def _event(file: TomlFile | None, signals: Signals, entry: dict[str, Any], label: str, name: str) -> Event:
    table, fail = checked(EventTable, entry, label, file, "events"), _failing(file, label)
    if (table.at is None) == (table.when is None):
        raise fail('it needs either a time, at = "2 s", or a crossing, when = "motor.i > 20 A"')
    if (not table.set) == (table.fault is None):
        raise fail('it needs either values to set, set = { "a.input" = 1.0 }, or fault = "loss" and on = "b.input"')
    for key, given in (("after", table.after is not None), ("repeat", table.repeat)):
        if given and table.when is None:
            raise fail(f"{key} goes with a crossing, 'when', and not with a time; leave it out", key)
    for key, stated in (("on", table.on), ("value", table.value), ("seed", table.seed), ("until", table.until),
                        ("for", table.for_)):  # fmt: skip
        if stated is not None and table.fault is None:
            instead = "; a second event can set the values back" if key in ("until", "for") else ""
            raise fail(f"{key} goes with a fault, and there is none; leave it out{instead}", key)
    times = _times(table, fail)
    where = file.at(str(table.name or table.on or next(iter(table.set), "[[events]]")), "events") if file else ""
    done: dict[str, Any] = {"settings": _settings(signals, table, fail)} if table.fault is None else {}
    done |= {"fault": _fault(signals, table, fail)} if table.fault is not None else {}
    when = _crossing(signals, table, fail)
    return Event(name, when=when, repeat=table.repeat, stated=entry, where=where, **times, **done)


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


def _crossing(signals: Signals, table: EventTable, fail: Fail) -> Crossing | None:
    """What `when` says. Raises InputError for a signal or a value that cannot be compared."""
    if table.when is None:
        return None
    text = table.when.strip()
    key = _watched(signals, text.removeprefix("not "))
    if key is not None and _is_boolean(signals, key):
        return Crossing(key, 0.5, not text.startswith("not "), text)
    match = CROSSING.fullmatch(text)
    if match is None:
        need = "a value behind it, such as 'motor.i > 20 A'"
        raise fail(f'when = "{text}" is no crossing: it takes a signal and {need}', "when")
    name = match["signal"]
    key = _watched(signals, name)
    if key is None:
        raise fail(f"when: {_why_not_watched(signals, name)}", "when")
    if _is_boolean(signals, key):
        raise fail(f'when: {name} is a Boolean; write when = "{name}", or "not {name}" where it becomes false', "when")
    fmu, said = signals.components[key[0]].fmu, match["value"].strip()
    try:
        own = in_own_unit(fmu, key[1], said, f"when: {name}")
    except InputError as error:
        raise fail(str(error), "when") from None
    number = _number(own)
    if number is None:
        raise fail(f"when: {said!r} is no number that {name} could cross", "when")
    return Crossing(key, number, match["way"] == ">", text)


def _number(value: object) -> float | None:
    """A finite number; None for whatever else it is."""
    text = str(value)
    number = float(text) if not isinstance(value, bool) and is_number(text) else math.nan
    return number if math.isfinite(number) else None


def _is_boolean(signals: Signals, key: Key) -> bool:
    return str(signals.components[key[0]].fmu.variables[key[1]].type) == "Boolean"


def _watched(signals: Signals, name: str) -> Key | None:
    """The scalar output or local of a name that can be compared."""
    found = signals.scalars(name)
    if len(found) != 1 or signals.causality(found[0]) not in ("output", "local"):
        return None
    kind = signals.components[found[0][0]].fmu.type_of(found[0][1])
    return found[0] if kind is not None and kind.name != "String" else None


def _why_not_watched(signals: Signals, name: str) -> str:
    found = signals.scalars(name)
    if not found:
        return f"no variable is called '{name}'{nearest(name, signals.names('output', 'local'))}"
    if len(found) > 1:
        return f"{name} has {len(found)} elements; name one of them, {'.'.join(found[0])}"
    driver = signals.drivers.get(found[0])
    if driver is not None:
        return f"{name} is an input; take the output that drives it, {'.'.join(driver.source)}"
    kind = signals.components[found[0][0]].fmu.variables[found[0][1]].type
    return f"{name} is of causality {signals.causality(found[0])} and type {kind}; take a numeric output or local"


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


def _fault(signals: Signals, table: EventTable, fail: Fail) -> Fault:
    """The fault, with its value at each input. Raises InputError for a signal or a value that does not fit."""
    if table.on is None:
        raise fail(f'fault = "{table.fault}" needs on = "component.input", the signal that breaks', "fault")
    kind, name = str(table.fault), table.on
    keys = signals.scalars(name)
    if not keys:
        known = [".".join(key) for key in signals.drivers] + signals.names("output")
        raise fail(f"on: no variable is called '{name}'{nearest(name, known)}", "on")
    if table.seed is not None and kind != "noise":
        raise fail('seed goes with fault = "noise"; leave it out', "seed")
    if (table.value is None) != (kind == "hold") and kind != "loss":
        more = "needs no value; leave it out" if kind == "hold" else "needs a value"
        raise fail(f'fault = "{kind}" {more}', "value" if kind == "hold" else "fault")
    values: dict[Key, Value | None] = {}
    for key in keys:
        connections = [c for c in signals.drivers.values() if key in (c.source, c.target)]
        if not connections:
            output = signals.causality(key) == "output"
            mend = "it drives no input, so nothing hears of it" if output else "no connection drives it; set it instead"
            raise fail(f"on: {'.'.join(key)} cannot break: {mend}", "on")
        for c in connections:
            wrong = next((end for end in (key, c.target) if kind in CHECKED and not signals.is_real(end)), None)
            if wrong:
                type_ = signals.components[wrong[0]].fmu.variables[wrong[1]].type
                raise fail(
                    f'fault = "{kind}" is for floating-point signals, and {".".join(wrong)} is a {type_}; take "hold" '
                    'or "loss"',
                    "fault",
                )
            values[c.target] = None if kind == "hold" else _at_input(signals, table, key, c, fail)
    return Fault(kind, (keys[0][0], name.partition(".")[2]), values, table.seed or 0)


def _at_input(signals: Signals, table: EventTable, key: Key, c: Connection, fail: Fail) -> Value:
    """The value of a fault on signal `key` as it is at the input of a connection."""
    kind, fmu = str(table.fault), signals.components[key[0]].fmu
    variable, type_ = fmu.variables[key[1]], fmu.type_of(key[1])
    given: object = table.value
    if given is None:
        given = {"String": "", "Boolean": False}.get(variable.type, 0)
    try:
        if kind not in WITHOUT_UNIT:
            given = in_own_unit(fmu, key[1], given, "value", difference=kind in ("bias", "noise"))
        if not signals.is_real(key):
            value: Value = parse_value(variable, given, "value", type_)
        elif (number := _number(given)) is None:
            unit = " without a unit" if kind in WITHOUT_UNIT else ""
            raise InputError(f'value = {given!r} is no finite number{unit}, which fault = "{kind}" needs')
        else:
            value = number
    except InputError as error:
        raise fail(str(error), "value") from None
    if kind == "noise" and float(value) < 0:
        raise fail(f"value = {value:g} is the standard deviation of the noise and cannot be negative", "value")
    if key == c.target or kind in WITHOUT_UNIT:
        return value
    if kind in ("bias", "noise"):
        return c.gain * float(value) if kind == "bias" else abs(c.gain) * float(value)
    target = signals.components[c.target[0]].fmu
    found = conversion_of(variable, type_, target.variables[c.target[1]], target.type_of(c.target[1]), True)
    try:
        return found.convert(value, c.gain, c.offset)
    except ValueError as error:
        raise fail(f"value: {error} at {'.'.join(c.target)}", "value") from None
