"""Peers that take part in a run from outside, by UDP or shared memory.

from rovbrush.outside import SharedMemoryPeer, UdpPeer
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = ["SharedMemoryPeer", "UdpPeer"]  # noqa: F822 (loaded when it is asked for)


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module("rovbrush.orchestrator.participant.outside.link.other_side"), name)
