"""The complete state of a Python FMU: all that it carries from one call to the next, and its form as bytes."""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np

HEAD, ENTRY = struct.Struct("<?BI"), struct.Struct("<IQ")  # ready, phase, arrays; length of a name, number of values


@dataclass(frozen=True)
class State:
    """`values` of all variables, behind them time and step; `arrays` that are not scratch; see `slave.py`."""

    values: np.ndarray
    arrays: dict[str, np.ndarray]
    ready: bool
    phase: int


def to_bytes(state: State) -> bytes:
    """A state for another process or another day, the same bytes on every machine."""
    arrays = {"values": state.values, **state.arrays}
    parts = [HEAD.pack(state.ready, state.phase, len(arrays))]
    for name, array in arrays.items():
        parts += [ENTRY.pack(len(name.encode()), array.size), name.encode(), array.astype("<f8").tobytes()]
    return b"".join(parts)


def from_bytes(content: bytes) -> State:
    """The state that `to_bytes` wrote; its arrays are flat."""
    ready, phase, count = HEAD.unpack_from(content)
    at = HEAD.size
    arrays = {}
    for _ in range(count):
        letters, size = ENTRY.unpack_from(content, at)
        at += ENTRY.size
        name = content[at : at + letters].decode()
        arrays[name] = np.frombuffer(content, "<f8", size, at + letters).copy()
        at += letters + 8 * size
    return State(arrays.pop("values"), arrays, ready, phase)
