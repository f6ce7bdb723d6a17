"""The channel of an isolated FMU over a socket: the same messages, with the same ends of all waits."""

from __future__ import annotations

import select
import socket
import time
from contextlib import suppress

from ..isolated.channel import Channel, ChannelSilentError

END = b"E"  # the letter of a message that is no answer: the process there has ended, and how


class Wire(Channel):
    """One side of a connection. `longest`: bytes of a message that is taken."""

    def __init__(self, connection: socket.socket, longest: int) -> None:
        self.socket, self.longest = connection, longest
        connection.setblocking(False)
        self.number = 0
        self._came = bytearray()
        self._polls = [select.poll(), select.poll()] if hasattr(select, "poll") else []
        for poll, what in zip(self._polls, (getattr(select, "POLLIN", 0), getattr(select, "POLLOUT", 0)), strict=False):
            poll.register(connection, what)

    def receive(self, end: float | None = None) -> tuple[int, bytes, bytes]:
        number, letter, body = super().receive(end)
        return self.number if letter == END else number, letter, body

    def _read(self) -> bytes:
        return self.socket.recv(1 << 16)

    def _write(self, data: memoryview) -> int:
        return self.socket.send(data)

    def _wait(self, to_write: bool, end: float | None) -> None:
        left = None if end is None else end - time.monotonic()
        if left is not None and left <= 0.0:
            raise ChannelSilentError
        if self._polls:
            ready = bool(self._polls[to_write].poll(None if left is None else 1000.0 * left))
        else:
            ones = [self.socket]
            ready = any(select.select([] if to_write else ones, ones if to_write else [], [], left))
        if not ready:
            raise ChannelSilentError

    def close(self) -> None:
        with suppress(OSError):
            self.socket.close()
