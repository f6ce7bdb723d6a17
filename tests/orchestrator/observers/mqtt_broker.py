"""A broker that takes what one client publishes with quality 0 (MQTT 3.1.1, sections 3.1 to 3.3, 3.12 and 3.14)."""

from __future__ import annotations

import socket
import threading
from types import TracebackType

CONNECT, CONNACK, PUBLISH, PINGREQ, PINGRESP, DISCONNECT = 1, 0x20, 3, 12, 0xD0, 14


class Broker:
    def __init__(self) -> None:
        self._server = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._server.getsockname()[1]
        self._found: list[tuple[str, bytes]] = []
        self._change = threading.Condition()
        self._client: socket.socket | None = None
        threading.Thread(target=self._serve, daemon=True).start()

    def published(self, count: int) -> list[tuple[str, bytes]]:
        """Topics and payloads, when so many have come."""
        with self._change:
            assert self._change.wait_for(lambda: len(self._found) >= count, 20.0)
            return list(self._found)

    def _serve(self) -> None:
        try:
            self._client, _ = self._server.accept()
            while True:
                head = self._take(1)[0]
                size = shift = 0
                while True:
                    byte = self._take(1)[0]
                    size |= (byte & 127) << shift
                    shift += 7
                    if byte < 128:
                        break
                self._packet(head >> 4, self._take(size))
        except (OSError, EOFError):
            return

    def _packet(self, kind: int, body: bytes) -> None:
        assert self._client is not None
        if kind == CONNECT:
            self._client.sendall(bytes([CONNACK, 2, 0, 0]))
        elif kind == PINGREQ:
            self._client.sendall(bytes([PINGRESP, 0]))
        elif kind == PUBLISH:
            length = int.from_bytes(body[:2], "big")
            with self._change:
                self._found.append((body[2 : 2 + length].decode(), body[2 + length :]))
                self._change.notify_all()

    def _take(self, size: int) -> bytes:
        assert self._client is not None
        data = b""
        while len(data) < size:
            more = self._client.recv(size - len(data))
            if not more:
                raise EOFError
            data += more
        return data

    def close(self) -> None:
        self._server.close()
        if self._client is not None:
            self._client.close()

    def __enter__(self) -> Broker:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
