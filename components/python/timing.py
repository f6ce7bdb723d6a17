"""What a component's kernel takes as machine code with no FMI around it: `rovbrush bench` compares the FMUs with it."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Any

from .component import component_class
from .stages import repeated


def seconds_per_step(name: str, values: Mapping[str, Any], period: float, steps: int) -> float:
    """Wall time [s] of one call of the kernel's `step` over `period` [s], as a mean over `steps` calls.

    `values`: parameters and inputs by the names of FMI 2.0 scalars; others keep their start values.
    """
    return started(name, values, period, time.perf_counter)(steps)


def started(
    name: str, values: Mapping[str, Any], period: float, clock: Callable[[], float] = time.thread_time
) -> Callable[[int], float]:
    """A kernel that goes on from call to call: time [s] of a step by `clock`, as a mean over so many."""
    declared = component_class(name)
    component = declared(instance_name=name)
    places = [element for v in declared.variables() for element in v.element_names]
    component.set_real([places.index(key) for key in values], [float(value) for value in values.values()])
    component.enter_initialization_mode()
    component.exit_initialization_mode()
    component.do_step(0.0, period)  # puts the inputs and the step size among the arguments

    def seconds(count: int) -> float:
        begin = clock()
        repeated(component.step_stage, count)
        return (clock() - begin) / count

    return seconds
