"""The side of the other program: what a peer in Python needs to take part. See `packets.py` and `memory.py` for what
programs in other languages keep to."""

from __future__ import annotations

import socket
import struct
import time as wall
from collections.abc import Mapping, Sequence
from typing import Any, Literal

from .memory import CLOSED, FIRST, HEAD, MAGIC, NAP, attached, blocks_of
from .packets import LARGEST, Packet, Signal, from_binary, from_json, layout_of, to_binary, to_json


class UdpPeer:
    """Packets to a component with `udp`, and from it.

        with UdpPeer("127.0.0.1:9010", gives=["current"], takes=["force"]) as peer:
            peer.send({"current": 0.2})                  # free running: numbered 0, 1, 2 ...
            packet = peer.receive(timeout=1.0)           # lock-step: answer with the number of the packet
            peer.send({"current": 0.1 * packet.values["force"]}, packet.seq)

    `to`: where the component listens. `gives`, `takes`: the outputs and inputs that it declares, in that order.
    `listen`: where this side listens, which is what the component states as `send` if it states it.
    """

    def __init__(
        self, to: str, gives: Sequence[str], takes: Sequence[str] = (), listen: str = "127.0.0.1:0",
        format: Literal["json", "binary"] = "json", token: str = "",
    ) -> None:  # fmt: skip
        self.gives, self.takes = _signals(gives), _signals(takes)
        self.format, self.token, self.count = format, token, 0
        host, _, port = to.rpartition(":")
        family, kind, _, _, address = socket.getaddrinfo(host.strip("[]"), int(port), type=socket.SOCK_DGRAM)[0]
        self.to: Any = address
        self.socket = socket.socket(family, kind)
        own, _, port = listen.rpartition(":")
        self.socket.bind((own.strip("[]"), int(port)))

    @property
    def port(self) -> int:
        return int(self.socket.getsockname()[1])

    def send(self, values: Mapping[str, Any], seq: int | None = None) -> None:
        """All values; `seq`: the number of the packet that they answer, else the next of its own."""
        number = self.count if seq is None else seq
        self.count = number + 1
        packet = Packet(number, 0.0, 0.0, values)
        made = to_json(packet, self.token) if self.format == "json" else to_binary(packet, self.gives, self.token)
        self.socket.sendto(made, self.to)

    def receive(self, timeout: float | None = None) -> Packet | None:
        """The next packet; None where none comes within `timeout` [s], forever if that is None. Raises ValueError for
        one that is not what was agreed."""
        self.socket.settimeout(timeout)
        try:
            content = self.socket.recv(LARGEST + 1)
        except (TimeoutError, BlockingIOError):
            return None
        return (from_json if self.format == "json" else from_binary)(content, self.takes, self.token)

    def close(self) -> None:
        self.socket.close()

    def __enter__(self) -> UdpPeer:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class SharedMemoryPeer:
    """The memory of a component with `shared_memory`, which must run already; used as UdpPeer.

    Raises FileNotFoundError where there is none of that name, ValueError where it has other signals.
    """

    def __init__(self, name: str, gives: Sequence[str], takes: Sequence[str] = ()) -> None:
        self.memory = attached(name)
        self.count = self.seen = 0
        buffer: Any = self.memory.buf
        self.buffer = buffer
        to, back = _signals(takes), _signals(gives)
        wanted = (MAGIC, len(to), len(back), layout_of(to), layout_of(back))
        found = HEAD.unpack(bytes(self.buffer[: HEAD.size]))[:5] if self.memory.size >= FIRST else ()
        if found != wanted:
            self.buffer = None
            self.memory.close()
            raise ValueError(f"shared memory {name!r} has other signals than {', '.join([*gives, *takes])}")
        self._in, self._out = blocks_of(self.buffer, to, back)

    @property
    def closed(self) -> bool:
        """Whether the run has ended."""
        return bool(struct.unpack_from("<Q", self.buffer, CLOSED)[0])

    def send(self, values: Mapping[str, Any], seq: int | None = None) -> None:
        """All values; `seq`: the number of the packet that they answer, else the next of its own."""
        number = self.count if seq is None else seq
        self.count = number + 1
        self._out.write(Packet(number, 0.0, 0.0, values))

    def receive(self, timeout: float | None = None) -> Packet | None:
        """The newest packet that was not read yet; None where none comes within `timeout` [s], and when the run ends.
        Raises ValueError for one that is not what was agreed."""
        until = wall.monotonic() + timeout if timeout is not None else None
        while True:
            self.seen, packet = self._in.read(self.seen)
            if packet is not None:
                return packet
            if self.closed or (until is not None and wall.monotonic() >= until):
                return None
            wall.sleep(NAP)

    def close(self) -> None:
        if self.buffer is not None:
            self._in = self._out = self.buffer = None  # type: ignore[assignment]  # views that keep it open
            self.memory.close()

    def __enter__(self) -> SharedMemoryPeer:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _signals(names: Sequence[str]) -> list[Signal]:
    return [Signal(name, "any") for name in names]
