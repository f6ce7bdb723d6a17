"""The way to a peer by UDP."""

from __future__ import annotations

import select
import socket
import time as wall
from collections.abc import Sequence

from ....errors import FmuError
from ....fmu.outside.links import Host, Udp
from .packets import LARGEST, Packet, Signal, from_binary, from_json, to_binary, to_json


class UdpLink:
    """A socket. `port`: the one that it has, where the system chose it."""

    def __init__(self, settings: Udp, sends: Sequence[Signal], takes: Sequence[Signal]) -> None:
        self.settings, self.sends, self.takes = settings, sends, takes
        self.peer: Host | None = settings.send
        self.socket: socket.socket | None = None
        self.port = settings.listen[1]

    def open(self) -> None:
        host, port = self.settings.listen
        try:
            family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
            opened = socket.socket(family, kind)
        except OSError as error:
            raise FmuError(f"UDP cannot listen at {host}:{port}: {error.strerror or error}") from None
        try:
            opened.bind(address)
            opened.setblocking(False)
            if self.settings.send is not None:  # a name is looked up once, not at every packet
                peer = self.settings.send
                self.peer = socket.getaddrinfo(*peer, family=family, type=socket.SOCK_DGRAM)[0][4][:2]  # type: ignore[assignment]
        except OSError as error:
            opened.close()
            raise FmuError(
                f"UDP cannot listen at {host}:{port}: {error.strerror or error}; end the other program, or take "
                f'another port (listen = "{host}:0" takes a free one)'
            ) from None
        self.socket, self.port = opened, int(opened.getsockname()[1])

    def text(self) -> str:
        return f"UDP {self.settings.listen[0]}:{self.port}"

    def send(self, packet: Packet) -> bool:
        if self.socket is None or self.peer is None:
            return False
        token = self.settings.token
        content = to_json(packet, token) if self.settings.format == "json" else to_binary(packet, self.sends, token)
        try:
            self.socket.sendto(content, self.peer)
        except OSError:  # nobody there, or no room: the next one is newer
            return False
        return True

    def receive(self, until: float) -> Packet | None:
        if self.socket is None:
            return None
        while True:
            try:
                content, sender = self.socket.recvfrom(LARGEST + 1)
                break
            except (BlockingIOError, ConnectionError):
                remaining = until - wall.monotonic()
                if remaining <= 0:
                    return None
                select.select([self.socket], [], [], remaining)
        take = from_json if self.settings.format == "json" else from_binary
        packet = take(content, self.takes, self.settings.token)
        if self.settings.send is None:
            self.peer = sender
        return packet

    def close(self) -> None:
        if self.socket is not None:
            self.socket.close()
            self.socket = None
