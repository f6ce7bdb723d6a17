"""The crossing at which an event happens: `motor.i > 20 A`, `controller.alarm`, `not controller.alarm`."""

from __future__ import annotations

import re

from ....errors import InputError, nearest
from ...event import Crossing, Key
from ...quantities import in_own_unit
from ...schema.keys.event import EventTable
from .signals import Fail, Signals, number

CROSSING = re.compile(r"(?P<signal>.*?\S)\s*(?P<way>[<>])\s*(?P<value>[^<>=\s].*)")


def crossing_of(signals: Signals, table: EventTable, fail: Fail) -> Crossing | None:
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
    found = number(own)
    if found is None:
        raise fail(f"when: {said!r} is no number that {name} could cross", "when")
    return Crossing(key, found, match["way"] == ">", text)


def _is_boolean(signals: Signals, key: Key) -> bool:
    return str(signals.components[key[0]].fmu.variables[key[1]].type) == "Boolean"


def _watched(signals: Signals, name: str) -> Key | None:
    """The scalar output or local of a name that can be compared."""
    found = signals.scalars(name)
    if len(found) != 1 or signals.causality(found[0]) not in ("output", "local"):
        return None
    kind = signals.components[found[0][0]].fmu.type_of(found[0][1])
    return found[0] if kind is not None and kind.name not in ("String", "Binary") else None


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
