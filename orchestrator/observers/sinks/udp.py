"""One datagram for each row: a JSON object, `{"time": 0.02, "motor.i": 11.9}` and a line feed, in UTF-8.

Nobody answers: what is lost on the way is not known here. A row that is larger than a datagram is an error.
"""

from __future__ import annotations

import socket

from ...errors import InputError, RunError
from ..asked import address_of
from ..layout import Layout, Rows
from ..sink import LIVE_PATIENCE, LIVE_ROOM, encoded

LARGEST = 65507  # bytes of a datagram of IPv4


class Udp:
    room, patience = LIVE_ROOM, LIVE_PATIENCE

    def __init__(self, host: str, port: int) -> None:
        self.address = host, port
        self._socket: socket.socket | None = None
        self._names: list[list[str]] = []

    def open(self, layout: Layout) -> str:
        family, kind, protocol, _, self.address = socket.getaddrinfo(*self.address, type=socket.SOCK_DGRAM)[0]  # type: ignore[assignment]
        self._socket = socket.socket(family, kind, protocol)
        self._socket.setblocking(False)
        self._names = [["time", *(column.name for column in table.columns)] for table in layout.tables]
        return ""

    def write(self, rows: Rows) -> int:
        assert self._socket is not None
        names, lost = self._names[rows.table], 0
        for time, values in zip(rows.times.tolist(), rows.each(), strict=True):
            data = encoded(dict(zip(names, (time, *values), strict=True))) + b"\n"
            if len(data) > LARGEST:
                raise RunError(f"a row takes {len(data)} bytes, and a datagram has {LARGEST}; send fewer signals")
            try:
                self._socket.sendto(data, self.address)
            except (BlockingIOError, ConnectionRefusedError):
                lost += 1
        return lost

    def close(self) -> None:
        if self._socket is not None:
            self._socket.close()


def sink_of(where: str, label: str) -> Udp:
    """`host:port`."""
    host, port = address_of(where, label)
    if port == 0:
        raise InputError(f"{label}: to which port? 0 is none")
    return Udp(host, port)
