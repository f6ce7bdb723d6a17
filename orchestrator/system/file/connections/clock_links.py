"""Connections between clocks: from one that ticks to one that is to tick with it."""

from __future__ import annotations

from collections.abc import Mapping

from ....errors import InputError, nearest
from ....fmu.reading.clocks import ClockVariable
from ...component import Component
from ...connection import Connection

Components = Mapping[str, Component]


def clock_connection(
    components: Components, source: tuple[str, str], target: tuple[str, str], transfer: str, where: str
) -> Connection | None:
    """The connection of two clocks; None where neither end is one. Raises InputError where they cannot be connected."""
    a, b = (_clock(components, end) for end in (source, target))
    if a is None and b is None:
        return None
    label = f"connection {'.'.join(source)} -> {'.'.join(target)}"
    if a is None or b is None:
        end, (name, _) = (source, target) if a is None else (target, source)
        if end[0] not in components or not components[end[0]].fmu.expand(end[1]):
            return None  # that there is no such variable is said where all ends are looked at
        clocks = components[end[0]].fmu.clocks
        raise InputError(
            f"{label}: a clock of {name} is connected with another clock only; {'.'.join(end)} is none"
            f"{nearest(end[1], clocks) if clocks else ''} {where}"
        )
    if transfer:
        raise InputError(f"{label}: a clock ticks, '{transfer}' has no meaning for it; remove that {where}")
    if b.causality != "input":
        raise InputError(
            f"{label}: {'.'.join(target)} is of causality {b.causality}; only an input clock is driven {where}"
        )
    if a.causality == "local":
        raise InputError(f"{label}: {'.'.join(source)} is local to its FMU {where}")
    return Connection((source[0], a.name), (target[0], b.name), where=where)


def _clock(components: Components, end: tuple[str, str]) -> ClockVariable | None:
    return components[end[0]].fmu.clocks.get(end[1]) if end[0] in components else None


def is_clock(components: Components, connection: Connection) -> bool:
    """Whether a connection is one of clocks."""
    return connection.target[1] in components[connection.target[0]].fmu.clocks
