"""The servo packet, which the autopilot sends once per frame: 40 bytes with 16 channels, 72 with 32.

Little-endian: uint16 magic, uint16 frame_rate, uint32 frame_count, uint16 pwm[16 or 32]. The magic tells which
(SERVO_32_ENABLE = 1 asks for 32 channels). Source: ArduPilot, libraries/SITL/examples/JSON/readme.md.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass

MAGIC = {16: 18458, 32: 29569}  # by number of channels
HEAD = struct.Struct("<HHI")
WHOLE = {magic: struct.Struct(f"<HHI{channels}H") for channels, magic in MAGIC.items()}


class NoServoPacketError(ValueError):
    """What arrived is no servo packet; the text says why, as the tail of a sentence."""


@dataclass(frozen=True, slots=True)
class ServoPacket:
    """One frame of the autopilot: its rate [Hz], its number and the pulse of each channel [us]."""

    frame_rate: int
    frame_count: int
    pwm: tuple[int, ...]


def parse(content: bytes) -> ServoPacket:
    """The packet in a datagram. Raises NoServoPacketError for any other size or magic."""
    if len(content) < HEAD.size:
        raise NoServoPacketError(f"{len(content)} bytes, too short for a servo packet")
    magic = HEAD.unpack_from(content)[0]
    whole = WHOLE.get(magic)
    if whole is None:
        raise NoServoPacketError(f"magic {magic}; servo packets have {' or '.join(map(str, WHOLE))}")
    if len(content) != whole.size:
        raise NoServoPacketError(f"{len(content)} bytes with magic {magic}, which goes with {whole.size}")
    _, frame_rate, frame_count, *pwm = whole.unpack(content)
    return ServoPacket(frame_rate, frame_count, tuple(pwm))


def packed(packet: ServoPacket) -> bytes:
    """The datagram of a packet, as an autopilot sends it."""
    magic = MAGIC[len(packet.pwm)]
    return WHOLE[magic].pack(magic, packet.frame_rate, packet.frame_count, *packet.pwm)
