"""A peer that takes part from outside: what is sent and taken at each step, and what holds when nothing comes.

Free running, a step takes the newest packet that has come. In lock-step it sends the number of its step and waits for
the packet with the same number, the answer. What is late, lost, reordered or refused is counted, and told at the end.
"""

from __future__ import annotations

import time as wall
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields
from typing import Protocol

from ....errors import FmuError
from ....fmu.outside.declared import DeclaredFmu
from ....fmu.outside.links import Waiting
from ....fmu.outside.model import Model, StepFailedError
from ....waiting import ended_by_signals
from .packets import Packet, PacketError, Signal

MOST = 4096  # packets that one step looks at: a flood must not keep the run


@dataclass
class Counts:
    """Of packets, but `late`: of steps."""

    sent: int = 0
    taken: int = 0
    passed_over: int = 0  # a newer one was there at the same step
    late: int = 0
    lost: int = 0  # numbers that never came
    reordered: int = 0  # came behind a later one
    doubled: int = 0
    refused: int = 0
    not_sent: int = 0
    restarts: int = 0

    def text(self) -> str:
        """`12 sent, 11 taken, 1 late`: all that are not zero, and always what is sent, taken, late and refused."""
        shown = [(f.name, getattr(self, f.name)) for f in fields(self)]
        always = ("sent", "taken", "late", "lost", "reordered", "refused")
        return ", ".join(f"{n} {name.replace('_', ' ')}" for name, n in shown if n or name in always)


class Link(Protocol):
    """The way to a peer."""

    def open(self) -> None:
        """Raises FmuError that says what is in the way."""

    def send(self, packet: Packet) -> bool:
        """Whether it could be sent."""

    def receive(self, until: float) -> Packet | None:
        """The next packet that has come; waits for one until `until` (`time.monotonic`), None where none comes.
        Raises PacketError for one that is not what was agreed."""

    def text(self) -> str:
        """Where it is, for messages."""

    def close(self) -> None: ...


def signals_of(fmu: DeclaredFmu, causality: str) -> list[Signal]:
    """The variables of one direction, in the order in which they are declared."""
    return [
        Signal(name, v.type, *(float(b if b is not None else d) for b, d in ((v.min, "-inf"), (v.max, "inf"))))
        for name, v in fmu.variables.items()
        if v.causality == causality
    ]


class Peer(Model):
    """Its inputs go to a peer, its outputs come from there."""

    def __init__(self, fmu: DeclaredFmu, name: str, link: Link, waiting: Waiting) -> None:
        super().__init__(fmu.starts())
        self.name, self.link, self.waiting = name, link, waiting
        self.inputs = fmu.names("input")
        self.starts = {output: fmu.start(output) for output in fmu.names("output")}
        self.comes = bool(self.starts)
        self.counts, self.why = Counts(), ""  # why the last packet was refused
        self.number = -1  # of the last packet that was sent
        self.last: int | None = None  # of the last packet that was taken
        self.heard = 0.0  # when that came, by `time.monotonic`

    def set_up(self, start: float, stop: float | None) -> None:
        self.link.open()
        self.start = start

    def initialized(self) -> int | None:
        self.heard = wall.monotonic()
        if not self.waiting.first:
            return None
        self._send(self.start, 0.0)
        if self.comes and not self._wait(self.waiting.first):
            raise FmuError(
                f"nothing came at {self.link.text()} within {self.waiting.first:g} s (first){self._refused()}"
            )
        return None

    def step(self, time: float, length: float) -> int | None:
        self.number = max(self.number, 0)
        self._send(time, length)
        if not self.comes:
            return None
        if self.waiting.mode == "lockstep":
            in_time = self._wait(self.waiting.timeout)
        else:
            self._take(lambda packet: False, wall.monotonic())
            in_time = wall.monotonic() - self.heard <= self.waiting.timeout
        if not in_time:
            self._late()
        return None

    def _send(self, time: float, length: float) -> None:
        self.number += 1
        packet = Packet(self.number, time, length, {name: self.values[name] for name in self.inputs})
        if self.link.send(packet):
            self.counts.sent += 1
        else:
            self.counts.not_sent += 1

    def _wait(self, seconds: float) -> bool:
        """Whether what is waited for comes: the answer in lock-step, anything otherwise."""
        lockstep = self.waiting.mode == "lockstep"
        wanted: Callable[[Packet], bool] = lambda packet: packet.seq == self.number if lockstep else True  # noqa: E731
        with ended_by_signals():
            return self._take(wanted, wall.monotonic() + seconds)

    def _take(self, wanted: Callable[[Packet], bool], until: float) -> bool:
        """Take what has come, the newest last; whether a packet was wanted. Waits for one until `until`."""
        newest: Packet | None = None
        found = False
        for packet in self._packets(until):
            if self._counted(packet):
                self.counts.passed_over += newest is not None
                newest = packet
            if wanted(packet):
                found = True
                break
        if newest is not None:
            self.values.update(newest.values)
            self.counts.taken += 1
        return found

    def _packets(self, until: float) -> Iterator[Packet]:
        for _ in range(MOST):
            try:
                packet = self.link.receive(until)
            except PacketError as error:
                self.counts.refused += 1
                self.why = str(error)
                continue
            if packet is None:
                return
            yield packet

    def _counted(self, packet: Packet) -> bool:
        """Whether a packet is newer than the last one. One that begins with 0 again is a peer that was restarted, and
        so is any behind a silence."""
        now = wall.monotonic()
        last, seq = self.last, packet.seq
        if self.waiting.mode == "lockstep":
            if seq != self.number:
                self.counts.reordered += 1  # an answer to a step before: it came late
                return False
        elif last is not None and seq <= last:
            if seq == last:
                self.counts.doubled += 1
                return False
            if seq != 0 and now - self.heard <= self.waiting.timeout:
                self.counts.reordered += 1
                self.counts.lost -= self.counts.lost > 0
                return False
            self.counts.restarts += 1
        elif last is not None:
            self.counts.lost += seq - last - 1
        self.last, self.heard = seq, now
        return True

    def _late(self) -> None:
        """What holds now. Raises StepFailedError where the run is to end."""
        self.counts.late += 1
        self.counts.lost += self.waiting.mode == "lockstep"
        if self.waiting.late == "default":
            self.values.update(self.starts)
        elif self.waiting.late == "stop":
            what = "no answer came" if self.waiting.mode == "lockstep" else "nothing new came"
            raise StepFailedError(f"{what} at {self.link.text()} within {self.waiting.timeout:g} s{self._refused()}")

    def _refused(self) -> str:
        return f"; {self.counts.refused} packets were refused, the last: {self.why}" if self.why else ""

    def notes(self) -> list[str]:
        return [f"component {self.name}, {self.link.text()}: {self.counts.text()}{self._refused()}"]

    def close(self) -> None:
        self.link.close()
