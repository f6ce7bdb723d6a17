"""The fault of an event: which signal breaks, how, and by how much at each input that it drives."""

from __future__ import annotations

from ....errors import InputError, nearest
from ....fmu.attributes import parse_value
from ....fmu.conversions import conversion_of
from ....fmu.types import Value
from ...connection import Connection
from ...event import Fault, Key
from ...quantities import in_own_unit
from ...schema.keys.event import EventTable
from .signals import Fail, Signals, number

WITHOUT_UNIT = ("scale",)  # faults whose value is a plain number
CHECKED = ("bias", "scale", "noise")  # faults of floating-point signals alone


def fault_of(signals: Signals, table: EventTable, fail: Fail) -> Fault:
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
        given = {"String": "", "Binary": "", "Boolean": False}.get(variable.type, 0)
    try:
        if kind not in WITHOUT_UNIT:
            given = in_own_unit(fmu, key[1], given, "value", difference=kind in ("bias", "noise"))
        if not signals.is_real(key):
            value: Value = parse_value(variable, given, "value", type_)
        elif (found := number(given)) is None:
            unit = " without a unit" if kind in WITHOUT_UNIT else ""
            raise InputError(f'value = {given!r} is no finite number{unit}, which fault = "{kind}" needs')
        else:
            value = found
    except InputError as error:
        raise fail(str(error), "value") from None
    if kind == "noise" and float(value) < 0:
        raise fail(f"value = {float(value):g} is the standard deviation of the noise and cannot be negative", "value")
    if key == c.target or kind in WITHOUT_UNIT:
        return value
    if kind in ("bias", "noise"):
        return c.gain * float(value) if kind == "bias" else abs(c.gain) * float(value)
    target = signals.components[c.target[0]].fmu
    converted = conversion_of(variable, type_, target.variables[c.target[1]], target.type_of(c.target[1]), True)
    try:
        return converted.convert(value, c.gain, c.offset)
    except ValueError as error:
        raise fail(f"value: {error} at {'.'.join(c.target)}", "value") from None
