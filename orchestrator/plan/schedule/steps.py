"""The operations of one component's step: its inputs set, stepped, its outputs got, and what is counted of it."""

from __future__ import annotations

from collections.abc import Iterator

from ...loop.operations import (
    ACCUMULATE,
    ACCUMULATE_ON,
    AS_IT_BEGINS,
    AT_ITS_END,
    COPY,
    MIX,
    PACE,
    PAUSE,
    PUSH,
    RISE,
    STEP,
    STEP_ON,
    WATCH,
    WORK,
    WORK_ON,
)
from ...system.connection import Connection
from ...system.event import set_inputs, watched
from ..design import Design
from .bond_energy import Side
from .layout import by_component
from .values import Row, Values


class Steps(Values):
    """Steps of components one at a time, whatever their order."""

    def __init__(self, design: Design) -> None:
        super().__init__(design)
        layout = self.layout
        self.previous = by_component(layout.previous)
        self.before, self.begins = by_component(layout.before), by_component(layout.begins)
        self.samples, self.parts = by_component(layout.samples), by_component(layout.parts)
        self.averaged: dict[str, list[Connection]] = {}  # connections of which the mean is taken, by their sources
        for c, choice in design.choices.items():
            if choice.transfer == "mean":
                self.averaged.setdefault(c.source[0], []).append(c)
        self.watched = watched(self.system.events)
        self.changed = {name for name, _ in set_inputs(self.system.events)}  # components whose inputs events change
        self.sides: dict[str, list[Side]] = {}  # of bonds
        for bond in design.bonds:
            for side in bond.sides:
                self.sides.setdefault(side.component, []).append(side)

    def advance(
        self, tick: int, name: str, start: int, part: bool = False, prepared: bool = False, until: int = 0
    ) -> Iterator[Row]:
        """Set inputs, step from `start` over one period, or to the end of the span, get outputs.

        `part`: only as far as the instant of an event, or `until` an instant of others [ticks]; `prepared`: its inputs
        are set."""
        component, layout = self.index[name], self.layout
        if not prepared:
            yield from self.prepare(tick, name, start)
        pushes = [(layout.previous[key], slot) for key, slot in self.before.get(name, {}).items()]
        known = layout.outputs | layout.samples
        pushes += [(known[key], slot) for key, slot in self.previous.get(name, {}).items()]
        pushes = [] if part else pushes
        pushes += [(layout.outputs[key], slot) for key, slot in self.parts.get(name, {}).items()]
        rows = [(PUSH, tick, component, a, b, 0, 0, 0) for a, b in pushes]
        if name in self.design.rereads:
            yield from rows
            yield from self.get(tick, name, AS_IT_BEGINS)
            for key, slot in self.begins.get(name, {}).items():
                yield (PUSH, tick, component, layout.outputs[key], slot, 0, 0, 0)
            rows = []
        step = STEP_ON if self.design.events else STEP
        if not self.system.components[name].scheduled:  # its partitions are activated by their clocks
            length = until - start if until else self.length(name, start)
            yield (step, tick, component, length, start, 0, 0, 0)
            if self.design.deadlines:
                yield (PACE, tick, component, 0, 0, 0, 0, 0)
        yield from rows
        if name in self.outputs:
            yield from self.get(tick, name, AT_ITS_END)
        for c in self.averaged.get(name, []):
            yield from self._average(c, tick, start, part)
        yield from self.works(tick, name, start)

    def _average(self, c: Connection, tick: int, start: int, part: bool) -> Iterator[Row]:
        """What the step of its source from `start`, or a part of it, adds to the integral of which a mean is made."""
        name, layout = c.source[0], self.layout
        within = tick if start == tick else tick - 1  # of that step of the target
        whole = self.ticks(c.target[0], self.begin_of(c.target[0], within))
        seconds, integral = float(self.clock.seconds(whole)), layout.integrals[c.target]
        cell = layout.part_integrals.get(c.target, integral)
        a, p = layout.outputs[c.source], layout.start(c.source)
        if c.counted:
            code, weight = RISE, c.per_second / seconds
            a, p = layout.outputs[c.counted], layout.counted_from(c.counted)
        elif self.design.events:
            code, weight = ACCUMULATE_ON, 1 / (2 * seconds)
        else:
            code, weight = ACCUMULATE, self.ticks(name, start) / (2 * whole)
        yield (code, tick, self.index[name], a, cell, p, 0, self.constants.at(weight))
        if self.design.events and not part:
            yield (MIX, tick, self.index[name], cell, integral, cell, 0, self.constants.at(1.0, 1.0, 0.0, 0.0))
            yield (COPY, tick, self.index[name], cell, cell, 0, 0, self.constants.at(0.0, 0.0))

    def prepare(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """Set the inputs of the step from `start`."""
        yield from self._series(tick, name, start)
        if self.design.into(name) or self.system.components[name].series or name in self.changed:
            yield from self.set_inputs(tick, name)

    def sampled(self, tick: int, name: str) -> Iterator[Row]:
        """What the outputs are at a planned instant, where events can make parts of steps."""
        for key, slot in self.samples.get(name, {}).items():
            yield (PUSH, tick, self.index[name], self.layout.outputs[key], slot, 0, 0, 0)

    def rescaled(self, tick: int, name: str) -> Iterator[Row]:
        """What means have been given already for a step that is shorter than those before it."""
        period, length = self.clock.periods[name], self.ticks(name, tick)
        if length != period:
            scale = self.constants.at(period / length, 0.0)
            for c in self.design.into(name):
                if self.design.choices[c].transfer == "mean":
                    integral = self.layout.integrals[c.target]
                    yield (COPY, tick, self.index[name], integral, integral, 0, 0, scale)

    def events(self, tick: int, looks: bool = False) -> Iterator[Row]:
        """Look at the signals for which events wait, where they have an instant, and pause if an event is due; `looks`:
        in any case."""
        for number, key in self.watched.items():
            if self.at_instant(tick, self.clock.periods[key[0]]):
                kind = self.system.components[key[0]].fmu.type_of(key[1])
                crossing = self.system.events[number].when
                assert kind is not None and crossing is not None
                whole, rising = int(not kind.real), int(crossing.rising)
                a, b = self.layout.outputs[key], self.layout.watches[number]
                yield (WATCH, tick, self.index[key[0]], a, b, whole, rising, 0)
        if self.system.events or self.design.events:
            yield (PAUSE, tick, -1, int(looks), 0, 0, 0, 0)

    def works(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """The work of the step that was just done, at every bond of the component."""
        for side in self.sides.get(name, []):
            weights = (-side.sign, side.sign, 1.0)
            if not side.counter:
                weights = (side.sign / 2, side.sign / 2, self.duration(name, start))
            a = self.layout.outputs[side.own]
            p = self.layout.counted_from(side.own) if side.counter else self.layout.start(side.own)
            if self.design.events and not side.counter:
                yield (WORK_ON, tick, self.index[name], a, side.work, p, side.held, self.constants.at(*weights))
            else:
                yield (WORK, tick, -1, a, side.work, p, side.held, self.constants.at(*weights))
