"""What goes to a peer and what comes from it: a packet of numbered values, as a line of JSON or as binary.

    {"seq": 12, "time": 0.24, "step": 0.02, "values": {"force": 1.5, "on": true}}

    binary, little-endian:  4s "RBX1", u16 flags, u16 n, u32 layout, u32 0, u64 seq, f64 time, f64 step, n x f64,
                            and where flags has bit 0 set the 32 bytes of the SHA-256 of the token

`layout` is the CRC-32 of the names, joined by commas. To a peer: `seq` counts the steps from 1 (0: the start, where
`first` waits), `time` and `step` are those of the step that begins [s]. From a peer: `time`, `step` may be left out;
`seq` is its own count, and in lock-step the number of the packet that it answers. What comes is parsed strictly: a
packet with a name too many or too few, with another type, out of range or not finite is refused
whole.
"""

from __future__ import annotations

import hashlib
import hmac
import json
import math
import struct
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

MAGIC, HEAD = b"RBX1", struct.Struct("<4sHHIIQdd")
WITH_TOKEN = 1
LARGEST = 65507  # bytes of a UDP packet
LAST = 2**63 - 1  # of seq
INT32 = 2**31


class PacketError(ValueError):
    """A packet is not what was agreed."""


@dataclass(frozen=True)
class Packet:
    """Values by name, in the types that are declared."""

    seq: int
    time: float
    step: float
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Signal:
    """One declared variable, as a packet has it. `type`: as declared, or "any" on the side of a peer, which knows its
    names only."""

    name: str
    type: str = "Real"
    minimum: float = -math.inf
    maximum: float = math.inf

    def checked(self, value: Any) -> Any:
        """Of its type and in its range. Raises PacketError."""
        kind = type(value)
        if self.type == "any" and kind in (bool, int, float):
            return value
        if self.type == "Boolean":
            if kind is bool:
                return value
        elif kind in (int, float) and (self.type == "Real" or (kind is int and -INT32 <= value < INT32)):
            try:
                found = float(value)
            except OverflowError:
                found = math.inf
            if math.isfinite(found) and self.minimum <= found <= self.maximum:
                return found if self.type == "Real" else value
            raise PacketError(f"{self.name} = {found:g} is out of range")
        raise PacketError(f"{self.name} is not of type {self.type}")

    def of_double(self, value: float) -> Any:
        """From a double. Raises PacketError."""
        if self.type in ("Real", "any") or not math.isfinite(value):
            return self.checked(value)
        if value != int(value) or (self.type == "Boolean" and value not in (0.0, 1.0)):
            raise PacketError(f"{self.name} = {value:g} is not of type {self.type}")
        return self.checked(bool(value) if self.type == "Boolean" else int(value))


def layout_of(signals: Sequence[Signal]) -> int:
    """The number by which both sides know that they mean the same signals in the same order."""
    return zlib.crc32(",".join(signal.name for signal in signals).encode())


def token_bytes(token: str) -> bytes:
    """What a binary packet carries of a token; nothing where there is none."""
    return hashlib.sha256(token.encode()).digest() if token else b""


def to_json(packet: Packet, token: str = "") -> bytes:
    content = {"seq": packet.seq, "time": packet.time, "step": packet.step, "values": dict(packet.values)}
    return json.dumps(content | ({"token": token} if token else {})).encode() + b"\n"


def to_binary(packet: Packet, signals: Sequence[Signal], token: str = "") -> bytes:
    flags = WITH_TOKEN if token else 0
    head = HEAD.pack(MAGIC, flags, len(signals), layout_of(signals), 0, packet.seq, packet.time, packet.step)
    values = (float(packet.values[signal.name]) for signal in signals)
    return head + struct.pack(f"<{len(signals)}d", *values) + token_bytes(token)


def from_json(content: bytes, signals: Sequence[Signal], token: str = "") -> Packet:
    """Raises PacketError for whatever is not exactly such a packet."""
    if len(content) > LARGEST:
        raise PacketError(f"it has {len(content)} bytes")
    try:
        found = json.loads(content.decode("utf-8"), parse_constant=_no_constant, object_pairs_hook=_once)
    except PacketError:
        raise
    except (ValueError, RecursionError):
        raise PacketError("it is no line of JSON") from None
    if not isinstance(found, dict):
        raise PacketError("it is no JSON object")
    if token and not (isinstance(found.get("token"), str) and _same(found["token"].encode(), token.encode())):
        raise PacketError("its token is wrong" if "token" in found else "it has no token")
    if extra := found.keys() - {"seq", "time", "step", "values", "token"}:
        raise PacketError(f"it has an unknown key {min(extra)!r:.40}")
    seq, values = found.get("seq"), found.get("values")
    if type(seq) is not int or not 0 <= seq <= LAST:
        raise PacketError("seq is no whole number from 0 to 2^63 - 1")
    if not isinstance(values, dict) or values.keys() != {signal.name for signal in signals}:
        raise PacketError(f"values are not exactly {', '.join(signal.name for signal in signals) or 'none'}")
    time, step = (_number(found.get(key, 0.0), key) for key in ("time", "step"))
    return Packet(seq, time, step, {signal.name: signal.checked(values[signal.name]) for signal in signals})


def from_binary(content: bytes, signals: Sequence[Signal], token: str = "") -> Packet:
    """Raises PacketError for whatever is not exactly such a packet."""

    if len(content) < HEAD.size or content[:4] != MAGIC:
        raise PacketError("it does not begin with RBX1")
    _, flags, count, layout, zero, seq, time, step = HEAD.unpack_from(content)
    secret = token_bytes(token)
    if flags not in (0, WITH_TOKEN) or zero or len(content) != HEAD.size + 8 * count + (32 if flags else 0):
        raise PacketError(f"it has {len(content)} bytes, which is not what its head says")
    if secret and not (flags and _same(content[-32:], secret)):
        raise PacketError("its token is wrong" if flags else "it has no token")
    if count != len(signals) or layout != layout_of(signals):
        raise PacketError(f"its layout is {layout:08x} of {count}, and {layout_of(signals):08x} is wanted")
    if seq > LAST or not (math.isfinite(time) and math.isfinite(step)):
        raise PacketError("its seq or time is none")
    doubles = struct.unpack_from(f"<{count}d", content, HEAD.size)
    return Packet(seq, time, step, {s.name: s.of_double(v) for s, v in zip(signals, doubles, strict=True)})


def _same(one: bytes, other: bytes) -> bool:
    return hmac.compare_digest(hashlib.sha256(one).digest(), hashlib.sha256(other).digest())


def _number(value: Any, key: str) -> float:
    if type(value) not in (int, float) or abs(value) > 1e300:
        raise PacketError(f"{key} is no number")
    return float(value)


def _no_constant(text: str) -> Any:
    raise PacketError(f"{text} is no number of JSON")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        raise PacketError("a key stands twice")
    return found
