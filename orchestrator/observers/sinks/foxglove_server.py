"""A server to which Foxglove connects: a topic for each component, with JSON messages and a JSON schema.

Its protocol knows no password, so that it listens to this machine alone. The oldest messages of a client that reads
too slowly are dropped by the server, for that client.
"""

from __future__ import annotations

from typing import Any

from ...errors import InputError
from ..asked import address_of
from ..layout import Layout, Rows
from ..sink import LIVE_PATIENCE, LIVE_ROOM, encoded, json_schema

LOOPBACK = ("127.0.0.1", "localhost", "::1")
BACKLOG = 4096  # messages that wait for a client


class FoxgloveServer:
    room, patience = LIVE_ROOM, LIVE_PATIENCE

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        self._server: Any = None
        self._context: Any = None
        self._channels: list[list[tuple[Any, list[int], list[str]]]] = []

    def open(self, layout: Layout) -> str:
        import foxglove

        self.layout = layout
        self._context = context = foxglove.Context()  # its channels live as long as it does
        self._server = foxglove.start_server(
            name=layout.system, host=self.host, port=self.port, context=context, message_backlog_size=BACKLOG
        )
        self.port = self._server.port
        for table in layout.tables:
            channels = []
            for component, columns in table.parts().items():
                schema = json_schema(table, columns, f"{layout.system}.{component}")
                channel = foxglove.Channel(f"/{component}", schema=schema, context=context)
                channels.append((channel, columns, [table.columns[k].variable for k in columns]))
            self._channels.append(channels)
        return f"Foxglove: open ws://{self.host}:{self.port}"

    def write(self, rows: Rows) -> int:
        times = self.layout.nanoseconds(rows.times)
        for channel, columns, names in self._channels[rows.table]:
            for time, values in zip(times, rows.each(columns), strict=True):
                channel.log(encoded(dict(zip(names, values, strict=True))), log_time=time)
        return 0

    def close(self) -> None:
        if self._server is not None:
            self._server.stop()


def sink_of(where: str, label: str) -> FoxgloveServer:
    """`port` or `host:port`, of this machine."""
    host, port = address_of(where, label)
    if host not in LOOPBACK:
        raise InputError(
            f"{label}: Foxglove's protocol has no password, so that it is served to this machine alone; take "
            f"foxglove=127.0.0.1:{port} and forward that port, for instance with `ssh -L {port}:127.0.0.1:{port}`"
        )
    return FoxgloveServer(host, port)
