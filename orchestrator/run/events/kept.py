"""What a checkpoint keeps of the events of FMUs beside rows and the FMUs' own states: what was sent, what is due."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from ...fmu.types import Value
from .handler import EventHandler

BYTES = "bytes"  # the key of bytes in JSON, as hexadecimal


def content_of(handler: EventHandler) -> dict[str, Any]:
    """Ready for JSON."""
    members = handler.clocked.members.items()
    return {
        "ends_at": handler.ends_at, "same": handler.same, "followed": handler.followed.done,
        "sent": {name: _plain(member.sent) for name, member in members},
        "now": {name: str(member.now) for name, member in members},
        "by_hand": {name: _plain(member.by_hand) for name, member in members},
        "late": [[*target, *source] for target, source in handler.clocked.late.items()],
    }  # fmt: skip


def restore(handler: EventHandler, content: Mapping[str, Any]) -> None:
    """Go on where another one was. Raises ValueError, TypeError or LookupError for what none can have held."""
    handler.ends_at, handler.same = int(content["ends_at"]), int(content["same"])
    handler.followed.done = float(content["followed"])
    for name, member in handler.clocked.members.items():
        sent = _values(content["sent"][name])
        if sent.keys() != member.sent.keys():
            raise ValueError("its events are others")
        member.sent, member.by_hand = sent, _values(content["by_hand"][name])
        member.now = Fraction(content["now"][name])
    handler.clocked.late = {(a, b): (c, d) for a, b, c, d in content["late"]}
    handler.by_hand.words = []


def _plain(values: Mapping[str, Value]) -> dict[str, Any]:
    return {name: {BYTES: value.hex()} if isinstance(value, bytes) else value for name, value in values.items()}


def _values(plain: Mapping[str, Any]) -> dict[str, Value]:
    return {name: bytes.fromhex(v[BYTES]) if isinstance(v, dict) else v for name, v in plain.items()}
