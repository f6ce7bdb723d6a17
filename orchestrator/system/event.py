"""What happens in a run: events, as the system file states them, checked. Data only.

An event changes inputs and tunable parameters, or breaks a signal on its way to an input. A fault on an output is one
on every input that it drives: what the component itself gives, and its rows, stay as they are.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from ..fmu.types import Value

Key = tuple[str, str]  # component, variable


@dataclass(frozen=True)
class Crossing:
    """A signal that goes beyond a value, from below (rising) or from above."""

    signal: Key
    threshold: float  # in the signal's own unit; 0.5 of a Boolean
    rising: bool
    text: str  # as it is stated


@dataclass(frozen=True)
class Fault:
    """What becomes of a signal: see `system/schema` for the kinds. Of `hold` the values are None."""

    kind: str
    on: Key  # the input, or the output for all inputs that it drives
    values: Mapping[Key, Value | None]  # of each input, in its own unit
    seed: int = 0

    @property
    def replaces(self) -> bool:
        """Whether nothing of the signal is left."""
        return self.kind in ("hold", "loss")


@dataclass(frozen=True)
class Event:
    """One event: `at` a time, `when` a signal crosses a value or `by_hand`, and what it does then. Times in seconds."""

    name: str
    at: Fraction | None = None
    when: Crossing | None = None
    by_hand: bool = False
    initial: bool = True  # what it does at the start holds in the initialization too
    after: Fraction = Fraction(0)
    repeat: bool = False
    settings: Mapping[Key, Value] = field(default_factory=dict)  # scalars
    fault: Fault | None = None
    until: Fraction | None = None
    lasting: Fraction | None = None
    stated: Mapping[str, Any] = field(default_factory=dict)  # as the file has it
    where: str = ""

    @property
    def inputs(self) -> tuple[Key, ...]:
        """The inputs and parameters that it changes."""
        return tuple(self.fault.values if self.fault else self.settings)

    @property
    def components(self) -> tuple[str, ...]:
        """The components that it touches."""
        return tuple(dict.fromkeys(name for name, _ in self.inputs))


def set_inputs(events: Iterable[Event]) -> dict[Key, None]:
    """Inputs and parameters that events give new values."""
    return {key: None for event in events for key in event.settings}


def broken_inputs(events: Iterable[Event]) -> dict[Key, list[int]]:
    """The inputs that events break, each with the numbers of these events."""
    found: dict[Key, list[int]] = {}
    for number, event in enumerate(events):
        for key in event.fault.values if event.fault else ():
            found.setdefault(key, []).append(number)
    return found


def watched(events: Iterable[Event]) -> dict[int, Key]:
    """The signals that events wait for, by the number of the event."""
    return {number: event.when.signal for number, event in enumerate(events) if event.when}


def stream_of(fault: Fault | None) -> int:
    """The stream of a fault's noise: a signed 64-bit number from the name of what it breaks."""
    assert fault is not None
    digest = hashlib.blake2b(".".join(fault.on).encode(), digest_size=8).digest()
    return int.from_bytes(digest, "little", signed=True)
