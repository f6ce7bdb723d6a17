"""Single signals of a session, read and written without looking them up again."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial

import numpy as np

from ...fmu.kinds import MODEL_EXCHANGE
from ...fmu.types import function_type
from ...loop.versions import exchange, signatures
from ...participant.base import Participant
from ...plan.plan import Plan
from ...plan.schedule.layout import Key
from .memory import Memory

LARGEST = sys.float_info.max


def cell_of(plan: Plan, memory: Memory, key: Key) -> int | None:
    """The cell in which the value of a double is after every step; None for any other signal."""
    extra, layout = plan.layout.extras.get(key), plan.layout
    if extra is not None:
        return extra.slot
    slot = layout.outputs.get(key, layout.inputs.get(key))
    return None if slot is None or memory.kind(key).dtype != np.float64 else slot


def reader_of(plan: Plan, memory: Memory, key: Key) -> Callable[[], float] | None:
    """What reads a double from its cell; None for any other signal."""
    slot = cell_of(plan, memory, key)
    return None if slot is None else partial(memory.z.item, slot)


def writer_of(instance: Participant, variable: str) -> Callable[[float], bool]:
    """What sets a double input and says whether it was in range and the FMU took it; any other input it leaves."""
    fmu = instance.fmu
    kind = fmu.type_of(variable) if variable in fmu.variables else None
    if fmu.kind == MODEL_EXCHANGE:  # whose group must know
        return lambda value: False
    if kind is None or kind.dtype != np.float64 or fmu is not fmu.own or fmu.places[variable].count > 1:
        return lambda value: False
    bounds = (fmu.variables[variable].min, fmu.variables[variable].max)
    low = float(bounds[0]) if bounds[0] is not None else -LARGEST
    high = float(bounds[1]) if bounds[1] is not None else LARGEST
    function = instance.address(f"{instance.prefix}Set{function_type(fmu.version, kind.name)}")
    sign = -1.0 if fmu.places[variable].negated else 1.0
    reference, cell = np.array([fmu.places[variable].reference], dtype=np.uint32), np.zeros(1)
    at, to, pointer = reference.ctypes.data, cell.ctypes.data, instance.pointer
    give = partial(exchange, signatures(fmu.version), function, pointer, at, 1, to, 1)
    arrays = (reference, cell)  # alive as long as their addresses are in use

    def write(value: float) -> bool:
        if not low <= value <= high:
            return False
        arrays[1][0] = sign * value
        return (give() | 1) == 1  # `versions.good`

    return write
