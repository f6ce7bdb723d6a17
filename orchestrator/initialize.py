"""From instantiated FMUs to consistent values at time 0."""

from __future__ import annotations

import math

import numpy as np

from .errors import FmuError, InputError
from .instance import Instance
from .memory import Memory
from .plan import Plan


def initialize(plan: Plan, instances: dict[str, Instance], memory: Memory) -> int:
    """Set parameters and inputs, propagate outputs to inputs until nothing changes, and leave initialization mode.

    Fills the cells of `memory` at time 0 and returns the number of sweeps. Raises FmuError if an FMU refuses, gives a
    value that is not finite, or if the outputs and inputs at time 0 depend on each other in a loop that sweeping does
    not settle; InputError if what the system requires of time 0 is not so.
    """
    system, z = plan.system, memory.z
    for name, component in system.components.items():
        instances[name].set_all({**component.parameters, **component.inputs})
        instances[name].enter_initialization(plan.clock.time(plan.clock.stop))
    for (name, variable), slot in plan.layout.inputs.items():  # of an array some elements may have no driver
        component = system.components[name]
        memory.put((name, variable), slot, component.inputs.get(variable, component.fmu.start(variable)))
    known: set[tuple[str, str]] = set()  # outputs read so far; until then an input keeps its start value
    sweeps = len(system.components) + 2
    for sweep in range(1, sweeps + 1):
        before = z.copy()  # compared as whole numbers: cells of other types can look like NaN
        for name in plan.order:
            for connection in system.connections:
                if connection.target[0] == name and connection.source in known:
                    value = memory.value(connection.source, plan.layout.outputs[connection.source])
                    if memory.kind(connection.source).real:
                        value = connection.gain * float(value) + connection.offset
                    memory.put(connection.target, plan.layout.inputs[connection.target], value)
                    instances[name].set(connection.target[1], value)
            for (owner, variable), slot in plan.layout.outputs.items():
                if owner == name:
                    memory.put((owner, variable), slot, instances[name].get(variable))
                    known.add((owner, variable))
                    if memory.kind((owner, variable)).real and not math.isfinite(z[slot]):
                        raise FmuError(
                            f"component {name}: output {variable} is {z[slot]} at time 0{instances[name].log_text()}"
                        )
        if sweep > 1 and np.array_equal(before.view(np.int64), memory.whole):
            break
    else:
        loop = sorted({".".join(key) for key, slot in plan.layout.inputs.items() if before[slot] != z[slot]})
        raise FmuError(
            f"initialization: the inputs {', '.join(loop)} and the outputs that drive them "
            f"form an algebraic loop that {sweeps} sweeps do not settle; break it with a state or a start value"
        )
    for r in system.requirements:
        value = instances[r.value[0]].get(r.value[1])
        if not r.minimum <= value <= r.maximum:
            unit = system.components[r.value[0]].fmu.variables[r.value[1]].unit or "1"
            raise InputError(
                f"{r.message}: {'.'.join(r.value)} = {value:g} {unit} at time 0, allowed are {r.minimum:g} to "
                f"{r.maximum:g} {unit} ({system.path.name})"
            )
    for instance in instances.values():
        instance.exit_initialization()
    for key, slot in plan.layout.previous.items():
        z[slot] = z[plan.layout.outputs[key]]
    return sweep
