"""What a kind of observer is: it is opened, given rows one after the other, and closed, all in a thread of its own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import msgspec

from .layout import Layout, Rows, Table

encoded = msgspec.json.Encoder().encode  # what is not finite becomes null


class Sink(Protocol):
    """`room`: bytes of rows that may wait for it; `patience` [s]: how long one that takes nothing is waited for when
    the run has ended. What it raises ends it alone."""

    room: int
    patience: float

    def open(self, layout: Layout) -> str:
        """Begin; where it can be seen, for a person, or nothing."""

    def write(self, rows: Rows) -> int:
        """Take rows. How many of them it could not take, such as datagrams that the system refused."""

    def close(self) -> None:
        """Bring to an end what was begun; also if `open` or `write` has raised."""


FILE_ROOM, FILE_PATIENCE = 256_000_000, 60.0  # a file is to be whole
LIVE_ROOM, LIVE_PATIENCE = 16_000_000, 2.0


def json_schema(table: Table, columns: list[int], title: str) -> dict[str, Any]:
    """The JSON schema of a row of a component, with unit and description of each signal."""
    properties: dict[str, Mapping[str, str]] = {}
    for k in columns:
        column = table.columns[k]
        unit = f" [{column.unit}]" if column.unit else ""
        properties[column.variable] = {"type": column.kind, "description": f"{column.description}{unit}".strip()}
    return {"type": "object", "title": title, "properties": properties}
