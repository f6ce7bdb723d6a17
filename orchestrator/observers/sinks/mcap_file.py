"""An MCAP file (mcap.dev): a topic for each component, `/motor`, with JSON messages and a JSON schema.

The time of a message is that of the run in nanoseconds.
"""

from __future__ import annotations

import json
from typing import Any

from ..asked import file_of
from ..layout import Layout, Rows
from ..sink import FILE_PATIENCE, FILE_ROOM, encoded, json_schema


class McapFile:
    room, patience = FILE_ROOM, FILE_PATIENCE

    def __init__(self, path: str) -> None:
        self.path = path
        self._writer: Any = None
        self._file: Any = None
        self._channels: list[list[tuple[int, list[int], list[str]]]] = []  # by table: number, columns, names

    def open(self, layout: Layout) -> str:
        from mcap.writer import Writer

        self.layout = layout
        self._file = open(self.path, "wb")  # noqa: SIM115 (as long as the run)
        self._writer = Writer(self._file)
        self._writer.start(profile="", library="rovbrush")
        for table in layout.tables:
            channels = []
            for component, columns in table.parts().items():
                schema = json_schema(table, columns, f"{layout.system}.{component}")
                number = self._writer.register_schema(schema["title"], "jsonschema", json.dumps(schema).encode())
                channel = self._writer.register_channel(f"/{component}", "json", number)
                channels.append((channel, columns, [table.columns[k].variable for k in columns]))
            self._channels.append(channels)
        return ""

    def write(self, rows: Rows) -> int:
        times = self.layout.nanoseconds(rows.times)
        for channel, columns, names in self._channels[rows.table]:
            for time, values in zip(times, rows.each(columns), strict=True):
                self._writer.add_message(channel, time, encoded(dict(zip(names, values, strict=True))), time)
        return 0

    def close(self) -> None:
        if self._file is None:
            return
        try:
            if self._writer is not None:
                self._writer.finish()
        finally:
            self._file.close()


def sink_of(where: str, label: str) -> McapFile:
    """A file."""
    return McapFile(str(file_of(where, label)))
