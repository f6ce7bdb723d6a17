"""Values of components at an instant or for a step: inputs formed, broken and set, outputs got; lengths of steps."""

from __future__ import annotations

from collections.abc import Iterator

from ...fmu.conversions import How
from ...loop.operations import (
    AT_AN_INSTANT,
    COPY,
    FAULT,
    FIT,
    GET,
    LINEAR,
    MEAN,
    MOVE,
    NUMBER,
    QUADRATIC,
    SAMPLE,
    SERIES,
    SET,
)
from ...system.connection import Connection
from ...system.event import broken_inputs, stream_of
from ...system.replace.crossing import Crossing
from ...system.replace.view import crossings_of
from ..design import Constants, Design
from .formulas import linear_ratio, mean_tail, quadratic_weights, value_ratio
from .layout import Key, by_component

Row = tuple[int, ...]  # of an operation: see `loop.operations`


class Values:
    """Operations on values of components, and the coefficients that they need."""

    def __init__(self, design: Design) -> None:
        self.design, self.system, self.clock, self.layout = design, design.system, design.clock, design.layout
        self.index = {name: k for k, name in enumerate(self.system.components)}
        self.constants = Constants([0.0], {})
        self.span = self.clock.hyperperiod  # of the operations that are listed [ticks]; steps end there at the latest
        layout = self.layout
        self.foreign_inputs, self.foreign_outputs = map(by_component, (layout.foreign_inputs, layout.foreign_outputs))
        self.inputs, self.outputs = (by_component(layout.by_the_loop(t)) for t in (layout.inputs, layout.outputs))
        self.faults = broken_inputs(self.system.events)
        self.streams = {n: stream_of(event.fault) for n, event in enumerate(self.system.events) if event.fault}

    def _series(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """The inputs that follow tables, for the step from `start`."""
        component = self.system.components[name]
        for variable, series in component.series.items():
            if variable in component.at_events:
                continue  # a row is an event
            code, length = (SAMPLE, 0) if series.sampled else (SERIES, self.length(name, start))
            b, k = self.layout.inputs[name, variable], self.constants.table(series)
            yield (code, tick, self.index[name], 0, b, start, length, k)

    def _form(self, c: Connection, tick: int, sample: int, start: int) -> Iterator[Row]:
        """Form an input for the step that begins at `start`, from a source last sampled at `sample`; break it."""
        yield self.formed(c, tick, sample, start)
        yield from self.broken(c, tick, start)

    def formed(self, c: Connection, tick: int, sample: int, start: int) -> Row:
        """Form an input for the step that begins at `start`, from a source last sampled at `sample`."""
        transfer, layout = self.design.choices[c].transfer, self.layout
        a, b, target = layout.outputs[c.source], layout.inputs[c.target], self.index[c.target[0]]
        h, H = self.spacing(c.source[0], sample), self.ticks(c.target[0], start)
        ahead = c.source[0] in self.design.leaders and sample - h <= start < sample  # the source has stepped already
        if transfer == "hold" and not ahead:
            return self.sent(c, tick, a)
        p = layout.previous[c.source]
        if not self.system.is_real(c):
            return self.sent(c, tick, p)
        events = self.design.events
        if events and c.source[0] in events.stopped and sample < tick and transfer != "mean":
            a = layout.samples.get(c.source, a)  # its outputs may be of a later instant already
        if transfer == "quadratic":
            weights = quadratic_weights(sample, self.clock.periods[c.source[0]], start, H, h)
            k = self.constants.at(c.gain, c.offset, *weights)
            return (QUADRATIC, tick, target, a, b, p, layout.before[c.source], k)
        if transfer == "mean":
            k = self.constants.at(c.gain, c.offset, *mean_tail(sample, h, start + H, H))
            a, p = layout.samples.get(c.source, a), layout.begins.get(c.source, p)
            return (MEAN, tick, target, a, b, p, layout.integrals[c.target], k)
        ratio = value_ratio(sample, h, start) if transfer == "hold" else linear_ratio(sample, h, start, H)
        return (LINEAR, tick, target, a, b, p, 0, self.constants.at(c.gain, c.offset, ratio))

    def changes(self, c: Connection) -> bool:
        """Whether an input that is formed changes between the samples of its source, or is not the latest of them."""
        return self.design.choices[c].transfer != "hold" or c.source[0] in self.design.leaders

    def now(self, c: Connection, tick: int) -> Iterator[Row]:
        """Give an input what its source has now; break it."""
        yield self.sent(c, tick, self.layout.outputs[c.source])
        yield from self.broken(c, tick, tick)

    def broken(self, c: Connection, tick: int, start: int) -> Iterator[Row]:
        """What events make of an input that was just formed, for a step that begins at `start`, or as it is then."""
        for number in self.faults.get(c.target, ()):
            first, stream = self.layout.faults[number, c.target], self.streams[number]
            b, component = self.layout.inputs[c.target], self.index[c.target[0]]
            yield (FAULT, tick, component, first, b, self.counter(start), stream, 0)

    def held(self, key: Key, tick: int, a: int, b: int, gain: float, offset: float) -> Row:
        """Give slot b the value of slot a, which is of the type of `key`."""
        component = self.index[key[0]]
        if self.system.components[key[0]].fmu.is_real(key[1]):
            return (COPY, tick, component, a, b, 0, 0, self.constants.at(gain, offset))
        return (MOVE, tick, component, a, b, 0, 0, 0)

    def sent(self, c: Connection, tick: int, a: int) -> Row:
        """Give an input the value of slot a, which is one of its source's; converted where their types differ."""
        b, component, found = self.layout.inputs[c.target], self.index[c.target[0]], self.design.conversions[c]
        if found.how is How.REAL:
            return (COPY, tick, component, a, b, 0, 0, self.constants.at(c.gain, c.offset))
        if found.how is How.NUMBER:
            return (NUMBER, tick, component, a, b, int(found.unsigned), 0, self.constants.at(c.gain, c.offset))
        if found.how is How.FIT:
            items = (float(part) for item in found.items for part in (item >> 32, item & 0xFFFFFFFF))
            k = self.constants.at(c.gain, c.offset, *found.bounds, *items)
            return (FIT, tick, component, a, b, int(found.real), len(found.items), k)
        return (MOVE, tick, component, a, b, 0, 0, 0)

    def set_inputs(self, tick: int, name: str) -> Iterator[Row]:
        """Set a component's inputs, those of a foreign FMU as it has them."""
        for key, slot in self.foreign_inputs.get(name, {}).items():
            crossing = self._crossing(key)
            yield self.held(key, tick, self.layout.inputs[key], slot, crossing.gain, crossing.offset)
        yield (SET, tick, self.index[name], 0, 0, 0, 0, 0)

    def read_again(self, tick: int, name: str) -> Iterator[Row]:
        """Set a component's inputs at an instant, and get what its outputs are with them."""
        yield from self.set_inputs(tick, name)
        yield from self.get(tick, name, AT_AN_INSTANT)

    def get(self, tick: int, name: str, when: int) -> Iterator[Row]:
        """Get a component's outputs, and turn those of a foreign FMU into ours."""
        yield (GET, tick, self.index[name], when, 0, 0, 0, 0)
        for key, slot in self.foreign_outputs.get(name, {}).items():
            crossing = self._crossing(key)
            yield self.held(key, tick, slot, self.layout.outputs[key], crossing.back_gain, crossing.back_offset)

    def _crossing(self, key: Key) -> Crossing:
        return crossings_of(self.system.components[key[0]].fmu).get(key[1], Crossing(key[1]))

    def at_instant(self, tick: int, period: int) -> bool:
        """Whether something of this period has an instant now; all have one at the end of the span."""
        return tick % period == 0 or tick == self.span

    def begin_of(self, name: str, tick: int) -> int:
        """Where the step of a component begins that goes on at an instant or begins there."""
        return tick // self.clock.periods[name] * self.clock.periods[name]

    def ticks(self, name: str, start: int) -> int:
        """Length [ticks] of a component's step from `start`, which ends with the span at the latest."""
        return min(self.clock.periods[name], self.span - start)

    def spacing(self, name: str, sample: int) -> int:
        """How long before `sample` the one before it was taken [ticks]."""
        return sample - self.begin_of(name, sample - 1)

    def length(self, name: str, start: int) -> int:
        """Length of a component's step from `start` as the loop is to know it [ticks]."""
        return self.ticks(name, start)

    def counter(self, tick: int) -> int:
        """By what the instant of noise is told from others [ticks from the beginning of the cycle]."""
        return tick

    def duration(self, name: str, start: int) -> float:
        """The same [s]."""
        return float(self.clock.seconds(self.ticks(name, start)))

    def nominal(self, key: Key) -> float:
        """The size of a signal as its FMU states it, otherwise 1."""
        stated = self.system.components[key[0]].fmu.variables[key[1]].nominal
        return abs(float(stated or 0.0)) or 1.0
