"""From instantiated FMUs to consistent values at time 0."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from .errors import FmuError, InputError
from .fmu import Instance
from .plan import Plan
from .start import Block

TOLERANCE = 1e-9  # of a loop's inputs, relative to their size or 1


@dataclass
class Started:
    """How time 0 was found: the sweeps over all connections, and the residual of every algebraic loop."""

    sweeps: int = 0
    loops: dict[str, float] = field(default_factory=dict)


def initialize(plan: Plan, instances: dict[str, Instance], z: np.ndarray) -> Started:
    """Set parameters and inputs, propagate outputs to inputs, solve algebraic loops, leave initialization mode.

    Fills `z` at time 0. Raises FmuError if an FMU refuses, gives a value that is not finite, or if a loop has no
    solution; InputError if what the system requires of time 0 is not so.
    """
    system = plan.system
    for name, component in system.components.items():
        instance = instances[name]
        for variable, value in {**component.parameters, **component.inputs}.items():
            instance.set(variable, value)
        instance.call(
            "set up the experiment", instance.slave.setupExperiment, None, 0.0, plan.clock.time(plan.clock.stop)
        )
        instance.call("enter initialization", instance.slave.enterInitializationMode)
    started = _Propagation(plan, instances, z).settle()
    for r in system.requirements:
        value = instances[r.value[0]].get(r.value[1])
        if not r.minimum <= value <= r.maximum:
            unit = system.components[r.value[0]].fmu.variables[r.value[1]].unit or "1"
            raise InputError(
                f"{r.message}: {'.'.join(r.value)} = {value:g} {unit} at time 0, allowed are {r.minimum:g} to "
                f"{r.maximum:g} {unit} ({system.path.name})"
            )
    for instance in instances.values():
        instance.call("leave initialization", instance.slave.exitInitializationMode)
    for table in (plan.layout.previous, plan.layout.before, plan.layout.begins):
        for key, slot in table.items():
            z[slot] = z[plan.layout.outputs[key]]
    return started


class _Propagation:
    """Values along the connections, block by block."""

    def __init__(self, plan: Plan, instances: dict[str, Instance], z: np.ndarray) -> None:
        self.plan, self.instances, self.z = plan, instances, z
        self.started = Started()

    def settle(self) -> Started:
        """Propagate, and again until nothing changes: what FMUs state of their dependencies may be incomplete."""
        limit = len(self.plan.system.components) + 2
        for sweep in range(1, limit + 1):
            before = self.z.copy()
            for block in self.plan.start:
                if block.loop:
                    self._solve(block)
                else:
                    self._set(block, np.array([self._received(block)]))
            for key, slot in self.plan.layout.outputs.items():
                self.z[slot] = self._get(key)
            self.started.sweeps = sweep
            if (sweep > 1 and np.array_equal(before, self.z)) or not self.plan.start:
                return self.started
        moved = sorted({".".join(k) for k, slot in self.plan.layout.inputs.items() if before[slot] != self.z[slot]})
        raise FmuError(
            f"initialization: the inputs {', '.join(moved)} keep changing though the model descriptions state no "
            f"dependency (InitialUnknowns) that would make them a loop; break the loop with a state or a start value"
        )

    def _get(self, key: tuple[str, str]) -> float:
        value = float(self.instances[key[0]].get(key[1]))
        if not math.isfinite(value):
            raise FmuError(
                f"component {key[0]}: output {key[1]} is {value} at time 0{self.instances[key[0]].log_text()}"
            )
        return value

    def _received(self, block: Block) -> list[float]:
        """What the sources of a block's connections send."""
        return [c.gain * self._get(c.source) + c.offset for c in block.connections]

    def _set(self, block: Block, values: np.ndarray) -> None:
        for c, value in zip(block.connections, values.ravel().tolist(), strict=True):
            self.z[self.plan.layout.inputs[c.target]] = value
            self.instances[c.target[0]].set(c.target[1], value)

    def _solve(self, block: Block) -> None:
        """Find the inputs of a loop that their sources give back."""
        from scipy.optimize import root

        def residual(inputs: np.ndarray) -> np.ndarray:
            self._set(block, inputs)
            given: np.ndarray = np.array(self._received(block)) - inputs
            return given

        def size(inputs: np.ndarray) -> float:
            return float(np.max(np.abs(residual(inputs)) / np.maximum(np.abs(inputs), 1.0)))

        fmus = self.plan.system.components
        if block.label in self.started.loops:
            guess = np.array([self.z[self.plan.layout.inputs[c.target]] for c in block.connections])
        else:
            starts = [fmus[c.target[0]].fmu.variables[c.target[1]].start for c in block.connections]
            guess = np.array([float(start or 0.0) for start in starts])
        found = size(guess)
        if found > TOLERANCE:
            solution = root(residual, guess, method="hybr", options={"xtol": 1e-14}).x
            found = size(solution)
        if not found <= TOLERANCE:
            raise FmuError(
                f"initialization: the algebraic {block.label} has no solution that can be found from the start values: "
                f"residual {found:.3g}, relative to the inputs, allowed {TOLERANCE:g}; break it with a state, or give "
                f"the FMUs start values near the solution"
            )
        self.started.loops[block.label] = found
