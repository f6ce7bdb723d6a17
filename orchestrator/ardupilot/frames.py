"""The order of frames: which packet goes on with the lock-step, which came twice, late, from somebody else or anew.

The autopilot sends frame k, waits for one state line, sends frame k + 1. Where it hears nothing it sends frame k again
(after 10 s by its description, after 1 s in its source), so that a frame that comes again asks for the last state line.
Counters begin at 0 when it is started; sources as in packet.py, and SIM_JSON.cpp.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Any

from ..errors import RunError
from .packet import ServoPacket

SETTLING = 3  # frames: the firmware begins with 1200 Hz and has followed the time stamps two state lines later
REORDERED = 16  # frames by which a packet may come late; a count of 0 further back is a new beginning
REPEAT_AFTER = 0.5  # s of wall time: sooner, the network has doubled a packet; later, the autopilot asks again
JUMP = 1000  # frames: no lock-step loses so many at once; such a packet is chance
TURN = 2**32


class Verdict(Enum):
    """What a packet is to the lock-step."""

    NEW = "the next frame"
    AGAIN = "the same frame, whose sender waits for the last state line"
    DROPPED = "not for the lock-step"


@dataclass
class Counts:
    """Packets by what became of them."""

    frames: int = 0  # went on with the lock-step
    lost: int = 0  # never arrived, by the counter
    doubled: int = 0
    asked_again: int = 0
    late: int = 0  # older than one that had arrived
    strangers: int = 0  # from somebody else
    garbage: int = 0  # no servo packets
    restarts: int = 0

    def text(self) -> str:
        """`1200 frames, 2 lost, 1 restart`: what there was of each."""
        names = ("lost", "doubled", "asked again", "late", "from strangers", "no servo packets")
        numbers = (self.lost, self.doubled, self.asked_again, self.late, self.strangers, self.garbage)
        parts = [f"{self.frames} frames", f"{self.lost} lost", f"{self.doubled} doubled"]
        parts += [f"{number} {name}" for name, number in list(zip(names, numbers, strict=True))[2:] if number]
        if self.restarts:
            parts.append(f"{self.restarts} restart{'s' if self.restarts > 1 else ''} of the autopilot")
        return ", ".join(parts)


class Frames:
    """The lock-step with one autopilot, whose frames must come at `rate` [Hz]."""

    def __init__(self, rate: int, repeat_after: float = REPEAT_AFTER) -> None:
        self.rate, self.repeat_after = rate, repeat_after
        self.counts = Counts()
        self.sender: Any = None  # its address
        self.last = -1  # count of the last frame, -1 before the first
        self.since_start = 0  # frames since the autopilot was started or first heard
        self.last_garbage = ""  # why the last packet that was none was none
        self._told = -1.0  # s, when the state line was sent that the last frame waits for

    def told(self, now: float) -> None:
        """The state line was sent, at the wall time `now` [s]."""
        self._told = now

    def garbage(self, why: str) -> None:
        """Count a packet that is none; `why` as the tail of a sentence."""
        self.counts.garbage += 1
        self.last_garbage = why

    def judge(self, packet: ServoPacket, sender: Any, now: float) -> Verdict:
        """What a packet is that arrived at the wall time `now` [s]. Raises RunError where its rate is not ours."""
        if self.last < 0:
            return self._begin(packet, sender)
        ahead = (packet.frame_count - self.last + TURN // 2) % TURN - TURN // 2
        anew = packet.frame_count == 0 and (sender != self.sender or ahead < -REORDERED)
        if anew:
            self.counts.restarts += 1
            return self._begin(packet, sender)
        if sender != self.sender:
            self.counts.strangers += 1
            return Verdict.DROPPED
        if ahead < 0:
            self.counts.late += 1
            return Verdict.DROPPED
        if ahead == 0:
            return self._again(now)
        if ahead > JUMP:
            self.garbage(f"frame {packet.frame_count} behind frame {self.last}")
            return Verdict.DROPPED
        self.counts.lost += ahead - 1
        return self._next(packet)

    def _begin(self, packet: ServoPacket, sender: Any) -> Verdict:
        self.sender, self.since_start = sender, 0
        return self._next(packet)

    def _again(self, now: float) -> Verdict:
        if self._told >= 0.0 and now - self._told >= self.repeat_after:
            self.counts.asked_again += 1
            return Verdict.AGAIN
        self.counts.doubled += 1
        return Verdict.DROPPED

    def _next(self, packet: ServoPacket) -> Verdict:
        self.last, self._told = packet.frame_count, -1.0
        self.counts.frames += 1
        self.since_start += 1
        if self.since_start > SETTLING and packet.frame_rate != self.rate:
            raise RunError(wrong_rate(packet.frame_rate, self.rate))
        return Verdict.NEW


def wrong_rate(theirs: int, ours: int) -> str:
    """What to say where the autopilot's frames come at another rate than the participant's period."""
    near = " (it follows our time stamps, and goes by 1 Hz towards its own)" if abs(theirs - ours) == 1 else ""
    return (
        f"the autopilot's frames come at {theirs} Hz{near}, but the period of {1000.0 / ours:g} ms is {ours} Hz; "
        f"set its parameter SIM_RATE_HZ to {ours}"
    )
