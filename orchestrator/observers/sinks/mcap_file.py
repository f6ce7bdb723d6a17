"""An MCAP file (mcap.dev): a topic for each component, `/motor`, with JSON messages and a JSON schema.

The time of a message is that of the run in nanoseconds.
"""

from __future__ import annotations

import json

from ..asked import file_of
from ..layout import Layout, Rows
from ..sink import encoded, json_schema
from .mcap_writer import McapWriter


class McapFile(McapWriter):
    def __init__(self, path: str) -> None:
        super().__init__(path)
        self._channels: list[list[tuple[int, list[int], list[str]]]] = []  # by table: number, columns, names

    def begin(self, layout: Layout) -> str:
        for table in layout.tables:
            channels = []
            for component, columns in table.parts().items():
                schema = json_schema(table, columns, f"{layout.system}.{component}")
                number = self.writer.register_schema(schema["title"], "jsonschema", json.dumps(schema).encode())
                channel = self.writer.register_channel(f"/{component}", "json", number)
                channels.append((channel, columns, [table.columns[k].variable for k in columns]))
            self._channels.append(channels)
        return ""

    def write(self, rows: Rows) -> int:
        times = self.layout.nanoseconds(rows.times)
        for channel, columns, names in self._channels[rows.table]:
            for time, values in zip(times, rows.each(columns), strict=True):
                self.writer.add_message(channel, time, encoded(dict(zip(names, values, strict=True))), time)
        return 0


def sink_of(where: str, label: str) -> McapFile:
    """A file."""
    return McapFile(str(file_of(where, label)))
