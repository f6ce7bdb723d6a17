"""The socket to an autopilot: it listens at a UDP port, answers whom the lock-step is with, and always ends a wait."""

from __future__ import annotations

import socket
import time
from contextlib import suppress
from ipaddress import ip_address

from ...ardupilot.frames import REPEAT_AFTER, Frames, Verdict
from ...ardupilot.packet import NoServoPacketError, ServoPacket, parse
from ...errors import InputError, RunError
from ...waiting import ended_by_signals
from .waits import Waits

LOOPBACK, PORT = "127.0.0.1", 9002  # where an autopilot's JSON backend sends to, if it is not told otherwise
LARGEST = 2048  # bytes read of a datagram; what is longer is no servo packet
SLICE = 0.2  # s of a wait, between which Windows hears a Ctrl-C


class Link:
    """One autopilot at `host`:`port`, whose frames come at `rate` [Hz]; a wait ends after `timeout` [s] of wall time.

    Beyond loopback only packets of the address `peer` are read. Raises InputError where the port cannot be had.
    """

    def __init__(
        self, rate: int, port: int = PORT, host: str = LOOPBACK, peer: str = "", timeout: float = 30.0,
        repeat_after: float = REPEAT_AFTER,
    ) -> None:  # fmt: skip
        self.frames, self.waits = Frames(rate, repeat_after), Waits()
        self.timeout, self.peer = timeout, peer
        self._line = b""
        self._socket = listening(host, port)
        self.host, self.port = self._socket.getsockname()[:2]

    def begin(self) -> ServoPacket:
        """The first frame. Raises RunError where none comes in time."""
        return self._next(0.0)

    def exchange(self, line: bytes) -> ServoPacket:
        """Answer the last frame with a state line and give the next one.

        Raises RunError where it does not come in time, or at another rate.
        """
        self._line = line
        return self._next(self._tell())

    def close(self) -> None:
        """Give the port back."""
        self._socket.close()

    def text(self) -> str:
        """What came and how long it took, in words."""
        return f"{self.frames.counts.text()}; the answers took: {self.waits.text()}"

    def _tell(self) -> float:
        """Send the state line, and give the time [s] of that."""
        now = time.monotonic()
        with suppress(OSError):  # a network that is down for a moment: the autopilot asks again
            self._socket.sendto(self._line, self.frames.sender)
        self.frames.told(now)
        return now

    def _next(self, told: float) -> ServoPacket:
        deadline = time.monotonic() + self.timeout
        while True:
            packet, sender, now = self._receive(deadline)
            verdict = self.frames.judge(packet, sender, now)
            if verdict is Verdict.AGAIN:
                self._tell()
            elif verdict is Verdict.NEW:
                if told:
                    self.waits.add(now - told)
                return packet

    def _receive(self, deadline: float) -> tuple[ServoPacket, tuple[str, int], float]:
        """The next servo packet, its sender and the time [s] at which it came."""
        while True:
            left = deadline - time.monotonic()
            if left <= 0.0:
                raise RunError(self._silence())
            self._socket.settimeout(min(left, SLICE))
            try:
                with ended_by_signals():
                    content, sender = self._socket.recvfrom(LARGEST)
            except (TimeoutError, ConnectionError):  # Windows tells here that nobody listened to the last line
                continue
            if self.peer and sender[0] != self.peer:
                self.frames.counts.strangers += 1
                continue
            try:
                return parse(content), sender, time.monotonic()
            except NoServoPacketError as error:
                self.frames.garbage(str(error))

    def _silence(self) -> str:
        counts = self.frames.counts
        also = ""
        if counts.garbage:
            also = f"; {counts.garbage} packets were no servo packets (the last: {self.frames.last_garbage})"
        if counts.strangers:
            also += f"; {counts.strangers} packets came from somebody else"
        where = f"UDP {self.host}:{self.port}"
        if self.frames.last < 0:
            return (
                f"no autopilot was heard at {where} for {self.timeout:g} s{also}; start one, for example "
                f"`sim_vehicle.py -v ArduSub -f vectored_6dof --model JSON:{self.host}`, or give it a longer timeout"
            )
        sender = "{}:{}".format(*self.frames.sender)
        return (
            f"the autopilot at {sender} stopped answering: nothing came to {where} for {self.timeout:g} s "
            f"after its frame {self.frames.last} ({counts.text()}){also}"
        )


def listening(host: str, port: int) -> socket.socket:
    """A socket there. Raises InputError where the port cannot be had."""
    family = socket.AF_INET6 if ip_address(host).version == 6 else socket.AF_INET
    opened = socket.socket(family, socket.SOCK_DGRAM)
    try:
        opened.bind((host, port))
    except OSError as error:
        opened.close()
        raise InputError(
            f"cannot listen at UDP {host}:{port} ({error.strerror}); another run or simulator may do so: end it, or "
            f"choose another port here and for the autopilot (sim_vehicle.py -I1 takes {PORT + 10})"
        ) from error
    return opened
