"""From instantiated FMUs to consistent values at the start of a run."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from contextlib import contextmanager

import numpy as np

from ...clock import Clock
from ...errors import FmuError
from ...fmu.binary import as_text
from ...fmu.types import Value
from ...participant.base import CallError, Participant
from ...participant.opening import start
from ...plan.happening.scenario import with_values_from_start
from ...plan.plan import Plan
from ...plan.schedule.layout import Key
from ...plan.start import Block
from ...results.tables import Started
from ...system.connection import Connection
from ...system.inputs.free_inputs import left_alone
from ..events.faults import begin_events, broken
from ..memory.memory import Memory
from .loops import TOLERANCE, StartLoop
from .read_back import read_back
from .requirements import broken_requirements


def initialize(plan: Plan, instances: dict[str, Participant], memory: Memory) -> Started:
    """Set parameters and inputs, propagate outputs to inputs, solve algebraic loops, leave initialization mode.

    Fills the cells of `memory` at the start; outputs as they are behind initialization mode, which may change them.
    Raises FmuError if an FMU refuses, gives a value that is not finite, or if a loop has no solution; InputError if
    what the system requires of the start is not so.
    """
    system, z = with_values_from_start(plan.system), memory.z
    begin, end = (plan.clock.time(tick) for tick in (0, plan.clock.stop))
    first = {name: component.first_inputs(begin) for name, component in system.components.items()}
    for name, variables in left_alone(system).items():
        first[name] |= {variable: system.components[name].fmu.start(variable) for variable in variables}
    for name, component in system.components.items():
        instances[name].configure(component.fmu.structure)
        instances[name].set_up(end, begin)
        instances[name].set_all({**component.parameters, **first[name]})
        instances[name].enter_initialization()
    for (name, variable), slot in plan.layout.inputs.items():  # of an array some elements may have no driver
        component = system.components[name]
        value = {**component.parameters, **first[name]}.get(variable, component.fmu.start(variable))
        memory.put((name, variable), slot, value)
    begin_events(plan, memory)
    propagation = Propagation(plan, instances, memory)
    started = propagation.settle()
    for instance in instances.values():
        instance.exit_initialization()
    for instance in instances.values():
        instance.first_event()
    propagation.initialized = True
    propagation.read_outputs()
    propagation.settle_instant()
    started.notes += [note for name, c in system.components.items() for note in read_back(instances[name], c)]
    started.notes += broken_requirements(plan, instances, begin_text(plan.clock))
    for table in (plan.layout.previous, plan.layout.before, plan.layout.begins, plan.layout.samples, plan.layout.parts):
        for key, slot in table.items():
            z[slot] = z[plan.layout.outputs[key]]
    return started


def begin_text(clock: Clock) -> str:
    """The start of a run as messages name it."""
    return f"the start, t = {clock.time(0):.9g} s" if clock.start else "time 0"


class Propagation:
    """Values along the connections, block by block."""

    def __init__(self, plan: Plan, instances: dict[str, Participant], memory: Memory) -> None:
        self.plan, self.instances, self.memory = plan, instances, memory
        self.started = Started()
        self.initialized = False

    def settle(self) -> Started:
        """Propagate, and again until nothing changes: what FMUs state of their dependencies may be incomplete."""
        limit = len(self.plan.system.components) + 2
        for sweep in range(1, limit + 1):
            before = self.memory.whole.copy()
            for block in self.plan.start:
                for c in block.connections:
                    if not block.loop or not self.plan.system.is_real(c):
                        self._set(c, self._received(c))
                if block.loop:
                    self._solve(block)
            self.read_outputs()
            self.started.sweeps = sweep
            if (sweep > 1 and np.array_equal(before, self.memory.whole)) or not self.plan.start:
                return self.started
        cells = self.plan.layout.inputs.items()
        moved = sorted({".".join(key) for key, slot in cells if before[slot] != self.memory.whole[slot]})
        raise FmuError(
            f"initialization: the inputs {', '.join(moved)} keep changing though the model descriptions state no "
            f"dependency (InitialUnknowns) that would make them a loop; break the loop with a state or a start value"
        )

    def read_outputs(self) -> None:
        """All outputs into their cells."""
        for key, slot in self.plan.layout.outputs.items():
            if not self._kept(key):
                self.memory.put(key, slot, self._get(key))

    def settle_instant(self) -> None:
        """What the loop does at every instant: new inputs to outputs that answer at once, which are read again.

        Raises FmuError if an FMU does not allow it, before there is any step.
        """
        plan = self.plan
        blocks = plan.instants.blocks(frozenset(plan.system.components) - set(plan.early))
        for block in blocks:
            with self._advised(block.connections[0].target[0]):
                if block.loop:
                    self._solve(block)
                else:
                    self._set(block.connections[0], self._received(block.connections[0]))
        for name in dict.fromkeys(c.target[0] for block in blocks for c in block.connections):
            with self._advised(name):
                self.read({name})

    @contextmanager
    def _advised(self, name: str) -> Iterator[None]:
        """What to do where a component does not allow to be asked again."""
        try:
            yield
        except CallError as error:
            reasons = self.plan.instants.reasons()[name]
            raise FmuError(
                f"{error}; outputs answer at once to {reasons}, so they are read again where "
                f'these are set; if the FMU forbids that, write direct = "off" under [components.{name}]'
            ) from error

    def read(self, names: Collection[str]) -> None:
        for key, slot in self.plan.layout.outputs.items():
            if key[0] in names and key[1] not in self.plan.system.components[key[0]].at_events:
                self.memory.put(key, slot, self._get(key))

    def _kept(self, key: Key) -> bool:
        """Whether an output can be read in event mode alone now: it is what it was in initialization mode."""
        return self.initialized and key[1] in self.plan.system.components[key[0]].at_events

    def _get(self, key: Key) -> Value:
        value: Value = self.instances[key[0]].get(key[1])
        if self.memory.kind(key).real and not math.isfinite(float(value)):
            raise FmuError(
                f"component {key[0]}: output {key[1]} is {as_text(value)} at {begin_text(self.plan.clock)}"
                f"{self.instances[key[0]].log_text()}"
            )
        return value

    def _received(self, c: Connection) -> Value:
        """What the source of a connection sends."""
        kept = self._kept(c.source)
        value = self.memory.value(c.source, self.plan.layout.outputs[c.source]) if kept else self._get(c.source)
        try:
            received = self.plan.conversions[c].convert(value, c.gain, c.offset)
        except ValueError as error:
            at = begin_text(self.plan.clock)
            raise FmuError(f"connection {c.label}: at {at} {error} {c.where}".rstrip()) from None
        return broken(self.plan, self.memory, c.target, received, self.plan.clock.start)

    def _set(self, c: Connection, value: Value) -> None:
        self.memory.put(c.target, self.plan.layout.inputs[c.target], value)
        self.instances[c.target[0]].set(c.target[1], value)

    def _solve(self, block: Block) -> None:
        """Find the inputs of a loop that their sources give back; those that are held take what they are sent."""
        torn, behind = ([c for c in part if self.plan.system.is_real(c)] for part in (block.torn, block.behind))
        if not torn:
            for c in behind:
                self._set(c, self._received(c))
            return
        loop = StartLoop(torn, behind, self._set, lambda c: float(self._received(c)))
        guess = self.memory.z[[self.plan.layout.inputs[c.target] for c in torn]]  # start values in the first sweep
        wanted = self.plan.system.loops.tolerance
        found, unique = loop.solve(guess, wanted)
        if not unique:
            self._note(
                f"the algebraic {block.label} has more than one solution: its inputs keep the start values that they "
                f"were found with; break it with a state, or remove one of its connections"
            )
        if not found <= max(TOLERANCE, wanted):
            raise FmuError(
                f"initialization: the algebraic {block.label} has no solution that can be found from the start values: "
                f"residual {found:.3g}, relative to the inputs, allowed {max(TOLERANCE, wanted):g}; break it with a "
                f"state, or give the FMUs start values near the solution"
            )
        self.started.loops[block.label] = found

    def _note(self, words: str) -> None:
        if words not in self.started.notes:
            self.started.notes.append(words)


def loop_residuals(plan: Plan) -> dict[str, float]:
    """The residual of every algebraic loop at the start, relative to its inputs; FMUs are loaded only if there is one.

    Raises FmuError or InputError if the start cannot be reached.
    """
    if not any(block.loop for block in plan.start):
        return {}
    instances: dict[str, Participant] = {}
    try:
        for name, component in plan.system.components.items():
            instances[name] = start(component)
        return initialize(plan, instances, Memory(plan)).loops
    finally:
        for instance in instances.values():
            instance.close()
