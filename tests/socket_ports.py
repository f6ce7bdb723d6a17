"""Ports for tests: the system chooses."""

from __future__ import annotations

import socket


def free_port() -> int:
    """A UDP port of the loopback at which nobody listened a moment ago."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        return int(taken.getsockname()[1])
