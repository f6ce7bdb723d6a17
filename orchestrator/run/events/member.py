"""A component with event mode or with partitions: what it is given and gives at events."""

from __future__ import annotations

import math
from typing import Any

from ...errors import RunError
from ...fmu.types import Value
from ...plan.plan import Plan
from ...system.connection import Connection
from ..memory.memory import Memory
from .faults import broken


class Member:
    """`sent`: the values of its inputs that it has; `by_hand`: inputs without cells that are still to be set."""

    def __init__(self, plan: Plan, instance: Any, memory: Memory) -> None:
        self.plan, self.instance, self.memory, self.name = plan, instance, memory, instance.name
        component = plan.system.components[self.name]
        self.scheduled, fmu = component.scheduled, component.fmu
        layout = plan.layout
        apart = component.at_events - {c.target[1] for c in plan.inside if c.target[0] == self.name}
        clocked = {v: frozenset(component.clocks_of(v)) for v in component.at_events}
        self.given, self.taken = (
            {v: slot for (name, v), slot in table.items() if name == self.name and v in apart}
            for table in (layout.inputs, layout.outputs)
        )
        self.clocks = clocked
        self.inputs = {v: clocked[v] for v in self.given}
        self.outputs = {v: clocked[v] for v in self.taken}
        self.drivers = {v: plan.system.drivers.get((self.name, v)) for v in self.inputs}
        clocks = dict.fromkeys(fmu.own.clocks.values())
        self.output_clocks = [c.name for c in clocks if c.causality == "output"] if not self.scheduled else []
        self.now = plan.clock.seconds(plan.clock.start)  # s, the instant of the event that goes on
        self.by_hand: dict[str, Value] = {}  # inputs without cells that are still to be set
        self.sent: dict[str, Value] = {v: memory.value((self.name, v), self.given[v]) for v in self.inputs}

    def form_inputs(self) -> None:
        """What the sources of its inputs send now, into their cells."""
        for variable, driver in self.drivers.items():
            if driver is not None:
                self.memory.put((self.name, variable), self.given[variable], self._received(driver))

    def _now(self, variable: str) -> Value:
        """What an input is sent now, or was given otherwise."""
        driver = self.drivers[variable]
        slot = self.given[variable]
        return self.memory.value((self.name, variable), slot) if driver is None else self._received(driver)

    def _received(self, c: Connection) -> Value:
        value = self.memory.value(c.source, self.plan.layout.outputs[c.source])
        try:
            received = self.plan.conversions[c].convert(value, c.gain, c.offset)
        except ValueError as error:
            raise RunError(f"connection {c.label}: {error} {c.where}".rstrip()) from None
        if not self.plan.layout.faults:
            return received
        return broken(self.plan, self.memory, c.target, received, math.floor(self.now / self.plan.clock.seconds(1)))

    def set_inputs(self) -> bool:
        """Give it those that are new and may be set now; whether there were any."""
        active, changed = self.instance.active, dict[str, Value]()
        for variable, clocks in self.inputs.items():
            if clocks and clocks.isdisjoint(active):
                continue
            value = self.memory.value((self.name, variable), self.given[variable])
            if value != self.sent[variable]:
                changed[variable] = self.sent[variable] = value
        for variable in [v for v in self.by_hand if not self.clocks[v] or not self.clocks[v].isdisjoint(active)]:
            changed[variable] = self.by_hand.pop(variable)
        if changed:
            self.instance.set_all(changed)
        return bool(changed)

    def get_outputs(self) -> bool:
        """Take the outputs that may be read now; whether any has changed."""
        active, changed = self.instance.active, False
        for variable, clocks in self.outputs.items():
            if clocks and clocks.isdisjoint(active):
                continue
            key, slot = (self.name, variable), self.taken[variable]
            value = self.instance.get(variable)
            if isinstance(value, float) and not math.isfinite(value):
                raise RunError(f"component {self.name}: output {variable} became {value}{self.instance.log_text()}")
            before = int(self.memory.whole[slot])
            self.memory.put(key, slot, value)
            changed |= before != int(self.memory.whole[slot])
        return changed

    def waits_for_change(self) -> bool:
        """Whether a discrete input without a clock has another value than it was given."""
        return any(
            not clocks and self._now(variable) != self.sent[variable] for variable, clocks in self.inputs.items()
        )
