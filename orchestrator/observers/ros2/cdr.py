"""Values as CDR, the encoding of ROS 2: little-endian, each number at a multiple of its size behind the head.

OMG, Common Object Request Broker Architecture, General Inter-ORB Protocol, 15.3 (CDR transfer syntax), version 1.
"""

from __future__ import annotations

import struct

HEAD = b"\x00\x01\x00\x00"  # CDR_LE, no options
NUMBERS = {"d": 8, "q": 8, "i": 4, "I": 4, "?": 1}


class Writer:
    """Bytes of one message, in the order of its fields."""

    def __init__(self) -> None:
        self._bytes = bytearray()

    def number(self, code: str, value: float | int | bool) -> Writer:
        """`code`: of struct; d float64, q int64, i int32, I uint32, ? bool."""
        size = NUMBERS[code]
        self._bytes += b"\0" * (-len(self._bytes) % size) + struct.pack(f"<{code}", value)
        return self

    def text(self, value: str) -> Writer:
        data = value.encode() + b"\0"
        self.number("I", len(data))
        self._bytes += data
        return self

    def header(self, nanoseconds: int, frame: str) -> Writer:
        """std_msgs/Header; seconds are 32 bits."""
        seconds, rest = divmod(nanoseconds, 1_000_000_000)
        return self.number("i", seconds).number("I", rest).text(frame)

    def doubles(self, values: tuple[float, ...]) -> Writer:
        for value in values:
            self.number("d", value)
        return self

    @property
    def message(self) -> bytes:
        return HEAD + bytes(self._bytes)
