"""Functions of clocks, events and Model Exchange, which take arrays and write numbers where pointers lead."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from functools import partial

from ...isolated.memory import REFERENCES, VALUES
from ..functions import Shape
from .remote import Passed, Remote

ELEMENT = 8  # bytes of the memory that an element of an array has, whatever its size


def _arrays(remote: Remote, name: str) -> Passed:
    """References, their number, and arrays of as many elements each, of these sizes."""
    sizes, memory, gets = SIZES[name], remote.memory, "Get" in name

    def arrays(_instance: int, references: int, count: int, *pointers: int) -> int:
        if 4 * count > REFERENCES or ELEMENT * count * len(sizes) > VALUES:
            return remote.refuse("clocks")
        ctypes.memmove(memory.references, references, 4 * count)
        places = [memory.values + ELEMENT * count * k for k in range(len(sizes))]
        for place, pointer, size in zip(places, pointers, sizes, strict=True):
            ctypes.memmove(place, pointer, size * count)
        status = remote.call(name, count, count)
        for place, pointer, size in zip(places, pointers, sizes, strict=True) if gets else ():
            ctypes.memmove(pointer, place, size * count)
        return status

    return arrays


def _cells(remote: Remote, name: str, flags: int, sizes: tuple[int, ...]) -> Passed:
    """So many flags, and places where numbers of these sizes go."""
    memory = remote.memory

    def cells(_instance: int, *given: int) -> int:
        memory.put_words(*(int(flag) & 0xFF for flag in given[:flags]))
        places = [memory.values + ELEMENT * k for k in range(len(sizes))]
        for place, pointer, size in zip(places, given[flags:], sizes, strict=True):
            ctypes.memmove(place, pointer, size)  # what an FMU does not write stays as it was
        status = remote.call(name)
        for place, pointer, size in zip(places, given[flags:], sizes, strict=True):
            ctypes.memmove(pointer, place, size)
        return status

    return cells


def _vector(remote: Remote, name: str) -> Passed:
    memory, gets = remote.memory, "Get" in name

    def vector(_instance: int, values: int, count: int) -> int:
        if ELEMENT * count > VALUES:
            return remote.refuse("states")
        ctypes.memmove(memory.values, values, ELEMENT * count)
        memory.put_words(count)
        status = remote.call(name)
        if gets:
            ctypes.memmove(values, memory.values, ELEMENT * count)
        return status

    return vector


def _directional(remote: Remote, name: str) -> Passed:
    memory = remote.memory

    def directional(
        _instance: int, unknowns: int, unknown: int, knowns: int, known: int, seeds: int, *rest: int
    ) -> int:  # FMI 3.0 has numbers of seeds and answers too
        inside, answers, outside = rest if len(rest) == 3 else (known, rest[0], unknown)
        if 4 * (unknown + known) > REFERENCES or ELEMENT * (inside + outside) > VALUES:
            return remote.refuse("states")
        ctypes.memmove(memory.references, unknowns, 4 * unknown)
        ctypes.memmove(memory.references + 4 * unknown, knowns, 4 * known)
        ctypes.memmove(memory.values, seeds, ELEMENT * inside)
        memory.put_words(unknown, known, inside, outside)
        status = remote.call(name)
        ctypes.memmove(answers, memory.values + ELEMENT * inside, ELEMENT * outside)
        return status

    return directional


SIZES: Mapping[str, tuple[int, ...]] = {  # bytes of an element of each array
    "fmi3GetClock": (1,), "fmi3SetClock": (1,), "fmi3GetIntervalDecimal": (8, 4), "fmi3SetIntervalDecimal": (8,),
    "fmi3GetShiftDecimal": (8,), "fmi3SetShiftDecimal": (8,), "fmi3GetIntervalFraction": (8, 8, 4),
    "fmi3SetIntervalFraction": (8, 8), "fmi3GetShiftFraction": (8, 8), "fmi3SetShiftFraction": (8, 8),
}  # fmt: skip
PASSED: Mapping[Shape, Callable[[Remote, str], Passed]] = {
    Shape.SET_GET: _arrays, Shape.PAIRS: _arrays, Shape.TRIPLES: _arrays,
    Shape.UPDATE: partial(_cells, flags=0, sizes=(1, 1, 1, 1, 1, 8)),
    Shape.COMPLETED2: partial(_cells, flags=1, sizes=(4, 4)), Shape.COMPLETED3: partial(_cells, flags=1, sizes=(1, 1)),
    Shape.EVENT_INFO: partial(_cells, flags=0, sizes=(32,)), Shape.COUNT: partial(_cells, flags=0, sizes=(8,)),
    Shape.VECTOR: _vector, Shape.DIRECTIONAL2: _directional, Shape.DIRECTIONAL3: _directional,
}  # fmt: skip
