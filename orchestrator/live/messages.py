"""What the run and the page's server tell each other: JSON, and numbers of signals as they are in memory."""

from __future__ import annotations

import struct
from typing import Any, Literal

import msgspec
import numpy as np
from msgspec import Struct

JSON, ROWS = b"J", b"R"  # how a message of the run begins
TIME = struct.Struct("<3xd")  # behind it: three bytes of nothing and the time [s], then values, lowest, highest
WAYS = ("start", "pause", "step", "speed", "set", "break", "mend", "happen", "reset", "end")


class Do(Struct, frozen=True, forbid_unknown_fields=True):
    """A command of the viewer who drives. `value`: of what is set, of a fault, or the speed (0: as fast as it goes)."""

    what: Literal["start", "pause", "step", "speed", "set", "break", "mend", "happen", "reset", "end"]
    name: str = ""
    value: float | int | bool | str | None = None
    kind: str = ""  # of a fault
    viewer: str = ""  # who is told what is wrong with it


class Shown(Struct, frozen=True):
    """A signal that is posted."""

    name: str
    unit: str = ""
    description: str = ""


class Input(Struct, frozen=True):
    """What can be set. `kind`: number, whole, switch or text; `low` and `high`: ends of its slider."""

    name: str
    label: str
    unit: str
    description: str
    kind: str
    value: float | int | bool | str
    low: float = 0.0
    high: float = 1.0
    first: bool = False  # among those that the system puts first
    choices: dict[str, float] = {}


class Hello(Struct, frozen=True, tag="hello"):
    """All that does not change in a run. `charts`: numbers of signals for each; `scene`: see `schema/keys/live`."""

    system: str
    description: str
    start: float
    stop: float
    period: float  # s, of a step
    signals: list[Shown]
    inputs: list[Input]
    breakable: list[str]
    happenings: list[str]
    charts: list[list[int]]
    diagram: str
    scene: dict[str, Any] | None = None


class State(Struct, frozen=True, tag="state"):
    """How the run stands; the last one holds. `attempt` grows with every reset."""

    what: Literal["paused", "running", "writing", "ended", "failed"]
    time: float
    attempt: int = 1
    speed: float = 1.0  # as it is wanted; 0: as fast as it goes
    factor: float = 0.0  # real-time factor over the last second or so
    deadlines: int = 0
    missed: int = 0
    worst: float = 0.0  # s
    dropped: int = 0  # messages that the page's server did not take
    values: dict[str, float | int | bool | str] = {}  # of inputs, those that were set
    faults: dict[str, str] = {}  # what is broken now, and how
    why: str = ""  # it ended
    folder: str = ""


class Done(Struct, frozen=True, tag="done"):
    """What was done until now: a line for each, and the scenario that does it again."""

    lines: list[str]
    scenario: str


class Said(Struct, frozen=True, tag="said"):
    """What one viewer is told, or all of them."""

    text: str
    viewer: str = ""


Message = Hello | State | Done | Said
_encoder, _do, _message = msgspec.json.Encoder(), msgspec.json.Decoder(Do), msgspec.json.Decoder(Message)


def packed(message: Message) -> bytes:
    return JSON + _encoder.encode(message)


def unpacked(message: bytes) -> Message:
    """Raises msgspec.ValidationError or DecodeError for what is no message in JSON."""
    found: Message = _message.decode(message[len(JSON) :])
    return found


def asked(message: bytes) -> Do:
    """A command. Raises msgspec.ValidationError or DecodeError for what is none."""
    return _do.decode(message)


def packed_command(do: Do) -> bytes:
    return _encoder.encode(do)


def packed_rows(time: float, values: np.ndarray) -> bytes:
    """`values`: (3, signals), the last ones, the lowest and the highest since the message before."""
    return ROWS + TIME.pack(time) + values.astype("<f4").tobytes()
