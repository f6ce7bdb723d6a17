"""Addresses that are stated, and sockets that listen: on this machine alone, unless a token guards them."""

from __future__ import annotations

import errno
import ipaddress
import os
import socket
from dataclasses import dataclass
from urllib.parse import urlsplit

from .errors import InputError, shown

TCP = "tcp://"
BY_FILE = "by --token-file or ROVBRUSH_TOKEN"
SHORTEST_TOKEN = 16  # characters: who hears a proof can try short ones at leisure


@dataclass(frozen=True)
class Address:
    """A host, by name or number, and a port of it."""

    host: str
    port: int

    def __str__(self) -> str:
        return f"{TCP}[{self.host}]:{self.port}" if ":" in self.host else f"{TCP}{self.host}:{self.port}"


def tcp_address(text: str) -> Address:
    """What `tcp://host:port` says. Raises InputError for anything else."""
    try:
        parts = urlsplit(text)
        port = parts.port
    except ValueError:  # a port that is no number, or a bracket too few
        parts, port = None, None
    if parts is None or f"{parts.scheme}://" != TCP or not parts.hostname or not port:
        raise InputError(f"{shown(repr(text))} is no address: tcp://HOST:PORT with a port of 1 to 65535")
    if parts.username is not None or parts.path or parts.query or parts.fragment:
        raise InputError(f"{shown(repr(text))} is no address: nothing may stand beside the host and the port")
    return Address(parts.hostname, port)


def is_loopback(host: str) -> bool:
    """Whether only programs on this machine reach a host."""
    try:
        return host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def listening(host: str, port: int, token: str, how: str = BY_FILE) -> socket.socket:
    """A socket that listens; port 0: any that is free. Raises InputError for a host that others reach where there is no
    token (`how` says where it is given), for a port that is in use or out of range, for a host that is not of this
    machine."""
    if not token and not is_loopback(host):
        raise InputError(
            f"--host {host}: others reach it, and there is no token; give one of at least {SHORTEST_TOKEN} characters "
            f"{how}, or stay on 127.0.0.1"
        )
    if not 0 <= port <= 65535:
        raise InputError(f"--port {port}: a port is 1 to 65535, or 0 for any that is free")
    try:
        family, _, _, _, where = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    except OSError as error:
        raise InputError(f"--host {host}: there is no such host ({error.strerror or error})") from None
    listener = socket.socket(family, socket.SOCK_STREAM)
    try:
        if os.name == "posix":  # elsewhere it would let two listen at once
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(where)
        listener.listen(16)
    except OSError as error:
        listener.close()
        if error.errno == errno.EADDRINUSE:
            raise InputError(f"port {port} of {host} is in use; choose another by --port, or 0 for any") from None
        raise InputError(
            f"cannot listen at {Address(host, port)}: {error.strerror or error}; see --host and --port"
        ) from None
    return listener


def prepared(found: socket.socket) -> socket.socket:
    """A connection on which small messages go at once, and which notices within half a minute that its peer has gone
    without a word."""
    found.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    found.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    for name, value in (("TCP_KEEPIDLE", 10), ("TCP_KEEPINTVL", 5), ("TCP_KEEPCNT", 3)):
        if hasattr(socket, name):
            found.setsockopt(socket.IPPROTO_TCP, getattr(socket, name), value)
    return found
