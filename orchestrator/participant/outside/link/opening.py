"""The peer of a component, by the way that its settings state."""

from __future__ import annotations

from ....fmu.outside.declared import DeclaredFmu
from ....fmu.outside.links import SharedMemory, Udp
from .peer import Peer, signals_of


def peer_model(fmu: DeclaredFmu, name: str) -> Peer:
    """Nothing is opened before the run is set up."""
    sends, takes = signals_of(fmu, "input"), signals_of(fmu, "output")
    settings = fmu.settings
    if isinstance(settings, Udp):
        from .udp import UdpLink

        return Peer(fmu, name, UdpLink(settings, sends, takes), settings.waiting)
    assert isinstance(settings, SharedMemory)
    from .memory import MemoryLink

    return Peer(fmu, name, MemoryLink(settings.name, sends, takes), settings.waiting)
