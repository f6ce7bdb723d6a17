"""Faults in the cells of a run: begun and mended, and what they make of a value in the initialization.

The operations FAULT of the loop do the same with every input that they form: see `loop/run`.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...fmu.types import Value
from ...loop.cells import (
    ABSENT,
    CHANGED,
    GAIN,
    MODE,
    OFFSET_OR_VALUE,
    REPLACED,
    SEED,
    SIGMA,
    THRESHOLD,
)
from ...loop.noise import gaussian
from ...plan.happening.scenario import from_start
from ...plan.plan import Plan
from ...system.event import Event, Key, stream_of
from ..memory.memory import Memory


def begin_events(plan: Plan, memory: Memory) -> None:
    """Bring the numbers of all events into their cells, and begin what is there from the start.

    Inputs must have their start values: `hold` keeps those.
    """
    events = plan.system.events
    for number, cell in plan.layout.watches.items():
        crossing = events[number].when
        assert crossing is not None
        memory.z[cell + THRESHOLD] = crossing.threshold
    early = from_start(plan.system)
    for number, event in enumerate(events):
        if event.fault and event in early:
            for name in event.components:
                begin_fault(plan, memory, number, name, event)


def begin_fault(
    plan: Plan, memory: Memory, number: int, component: str, event: Event, before: Mapping[int, int] | None = None
) -> None:
    """Break the inputs of a component that an event, of this number in the plan, breaks; `before`: what cells were
    before anything happened at this instant, which `hold` keeps."""
    fault = event.fault
    assert fault is not None
    for key, value in fault.values.items():
        if key[0] != component:
            continue
        first, z = plan.layout.faults[number, key], memory.z
        if fault.kind == "hold":
            cell = plan.layout.inputs[key]
            memory.whole[first + OFFSET_OR_VALUE] = (before or {}).get(cell, memory.whole[cell])
        elif fault.kind == "loss":
            assert value is not None
            memory.put(key, first + OFFSET_OR_VALUE, value)
        else:
            assert value is not None
            z[first + GAIN], z[first + OFFSET_OR_VALUE], z[first + SIGMA] = {
                "bias": (1.0, value, 0.0), "scale": (value, 0.0, 0.0), "noise": (1.0, 0.0, value),
            }[fault.kind]  # fmt: skip
            memory.whole[first + SEED] = fault.seed
        z[first + MODE] = REPLACED if fault.replaces else CHANGED


def end_fault(plan: Plan, memory: Memory, number: int, component: str, event: Event) -> None:
    """Mend them."""
    fault = event.fault
    assert fault is not None
    for key in fault.values:
        if key[0] == component:
            memory.z[plan.layout.faults[number, key] + MODE] = ABSENT


def broken(plan: Plan, memory: Memory, key: Key, value: Value, tick: int) -> Value:
    """What the faults of an input make of its value at an instant [ticks from time 0]: in the initialization, and where
    an input is set at events only."""
    z = memory.z
    for number, event in enumerate(plan.system.events):
        first = plan.layout.faults.get((number, key))
        if first is None or z[first + MODE] == ABSENT:
            continue
        if z[first + MODE] == REPLACED:
            value = memory.value(key, first + OFFSET_OR_VALUE)
            continue
        changed = z[first + GAIN] * np.float64(value) + z[first + OFFSET_OR_VALUE]
        if z[first + SIGMA] != 0.0:
            drawn = gaussian(int(memory.whole[first + SEED]), stream_of(event.fault), tick)
            changed += z[first + SIGMA] * drawn
        value = float(changed)
    return value
