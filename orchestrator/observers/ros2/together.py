"""Messages that several signals make together: poses, wrenches and twists, as a system states them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import cos, sin
from typing import Any, NamedTuple

from ...system.schema.keys.message import FIELDS
from ..layout import Layout
from .cdr import Writer


class Message(NamedTuple):
    """One of them: `parts`, for each field where its numbers come from, (column or None, number)."""

    topic: str
    kind: str
    frame: str
    parts: tuple[tuple[tuple[int | None, float], ...], ...]

    def bytes(self, nanoseconds: int, values: Sequence[Any]) -> bytes:
        """Of a row, `values` by column."""
        found = [tuple(number if k is None else float(values[k]) for k, number in part) for part in self.parts]
        writer = Writer().header(nanoseconds, self.frame)
        if self.kind == "PoseStamped" and len(found[1]) == 3:
            found[1] = quaternion(*found[1])
        for part in found:
            writer.doubles(part)
        return writer.message


def quaternion(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """x, y, z, w of a rotation by yaw about z, then pitch about the new y, then roll about the new x [rad].

    Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control, 2nd ed., Algorithm 2.3 in closed form.
    """
    (cr, sr), (cp, sp), (cy, sy) = ((cos(angle / 2), sin(angle / 2)) for angle in (roll, pitch, yaw))
    return (
        sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )  # fmt: skip


def messages_of(layout: Layout, number: int) -> list[Message]:
    """The messages whose signals are all in a table of a layout, by its number."""
    table = layout.tables[number]
    places = {column.name: k for k, column in enumerate(table.columns)}
    found = []
    for entry in layout.messages:
        fields = FIELDS[entry["type"]]
        given = [entry.get(field, (0.0, 0.0, 0.0)) for field in fields]
        signals = [source for part in given for source in part if isinstance(source, str)]
        if signals and all(name in places for name in signals):
            parts = tuple(tuple(_source(places, source) for source in part) for part in given)
            found.append(Message(entry["topic"], entry["type"], entry.get("frame", "world"), parts))
    return found


def _source(places: Mapping[str, int], source: str | float) -> tuple[int | None, float]:
    return (places[source], 0.0) if isinstance(source, str) else (None, float(source))


def left_out(layout: Layout) -> list[str]:
    """Topics of messages whose signals are in no table together: not recorded, not chosen, or of several rates."""
    made = {message.topic for k in range(len(layout.tables)) for message in messages_of(layout, k)}
    return [entry["topic"] for entry in layout.messages if entry["topic"] not in made]
