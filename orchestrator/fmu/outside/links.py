"""What is stated of a peer that takes part from outside: where it is, how it is waited for, what holds when it is
late. How it is met is in `participant/outside/link`."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

Host = tuple[str, int]


@dataclass(frozen=True)
class Waiting:
    """Times are wall times [s]. See `system/schema/keys/outside.py` for what they mean."""

    mode: Literal["free", "lockstep"] = "free"
    timeout: float = 1.0
    first: float = 0.0
    late: Literal["hold", "default", "stop"] = "hold"


@dataclass(frozen=True)
class Udp:
    """Packets to and from another program. `send` None: to whom the last packet came from that was taken."""

    waiting: Waiting
    listen: Host
    send: Host | None = None
    format: Literal["json", "binary"] = "json"
    token: str = field(default="", repr=False)  # not in digests, which are written into results


@dataclass(frozen=True)
class SharedMemory:
    """Two blocks of memory that another process knows by name."""

    waiting: Waiting
    name: str
