"""The list of operations over one hyperperiod.

A component's step from t to t + H is done at the instant t + H, faster components first, so that a slow component
can receive the mean of what fast ones did over the same interval. Gauss-Seidel forms an input just before its step,
from the latest values; Jacobi forms it at the beginning of the step, from values of that instant (means excepted:
they need the whole interval).

Two kinds of components are the exception, their step from t to t + H is done at t: one all of whose connected inputs
are sampled (a discrete controller), whose outputs are in force from then on; and one whose outputs are interpolated,
so that those who receive them know both ends.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...clock import seconds_text
from ...errors import InputError
from ...loop.operations import (
    ACCUMULATE,
    COLUMNS,
    COPY,
    GET,
    LEDGER,
    LINEAR,
    MEAN,
    MOVE,
    PUSH,
    QUADRATIC,
    RECORD,
    SAMPLE,
    SERIES,
    SET,
    STEP,
    WORK,
)
from ...system.model import Connection
from ...system.replace.crossing import Crossing
from ...system.replace.view import crossings_of
from ..design import Constants, Design
from .bond_energy import Side
from .formulas import linear_ratio, mean_tail, quadratic_weights, value_ratio
from .layout import Key, by_component

LARGEST = 5_000_000  # operations; 320 MB
Row = tuple[int, ...]


class Schedule:
    """Collects the operations of one hyperperiod and their coefficients."""

    def __init__(self, design: Design) -> None:
        self.design, self.system, self.clock, self.layout = design, design.system, design.clock, design.layout
        self.index = {name: k for k, name in enumerate(self.system.components)}
        self.constants = Constants([0.0], {})
        self.ran: set[str] = set()  # components that step first and have done so at the present instant
        self.early = set(design.early)
        layout = self.layout
        self.foreign_inputs, self.foreign_outputs = map(by_component, (layout.foreign_inputs, layout.foreign_outputs))
        self.outputs, self.previous = by_component(layout.outputs), by_component(layout.previous)
        self.before, self.begins = by_component(layout.before), by_component(layout.begins)
        self.averaged: dict[str, list[Connection]] = {}  # connections of which the mean is taken, by their sources
        for c, choice in design.choices.items():
            if choice.transfer == "mean":
                self.averaged.setdefault(c.source[0], []).append(c)
        self.sides: dict[str, list[Side]] = {}  # of bonds
        for bond in design.bonds:
            for side in bond.sides:
                self.sides.setdefault(side.component, []).append(side)

    def build(self) -> np.ndarray:
        """The operations of one hyperperiod, (m, 8). Raises InputError if there would be too many."""
        total = sum(
            self.clock.hyperperiod // self.clock.periods[name] * (4 + len(self.system.connections))
            for name in self.design.order
        )
        if total > LARGEST:
            raise InputError(
                f"the periods repeat only every {seconds_text(self.clock.seconds(self.clock.hyperperiod))}: "
                f"more than {LARGEST} operations; choose periods with a common multiple"
            )
        return np.array(list(self.rows()), dtype=np.int64).reshape(-1, len(COLUMNS))

    def rows(self) -> Iterator[Row]:
        """The operations in their order."""
        yield from self.begin(0)
        for tick in self.instants():
            yield from self.finish(tick)
            if tick < self.clock.hyperperiod:
                yield from self.begin(tick)

    def instants(self) -> list[int]:
        """The instants of one hyperperiod at which any step ends, rising."""
        ends = {
            k * self.clock.periods[name]
            for name in self.design.order
            for k in range(1, self.clock.hyperperiod // self.clock.periods[name] + 1)
        }
        return sorted(ends)

    def due(self, tick: int) -> list[str]:
        return [name for name in self.design.order if tick % self.clock.periods[name] == 0]

    def finish(self, tick: int) -> Iterator[Row]:
        """The steps that end now, and what is recorded of this instant."""
        yield from self.steps(tick)
        yield from self.record(tick)

    def steps(self, tick: int) -> Iterator[Row]:
        """The steps that end now."""
        due = [name for name in self.due(tick) if name not in self.early]
        done: set[str] = set()
        for name in due:
            yield from self._step(tick, name, done)
            done.add(name)

    def record(self, tick: int) -> Iterator[Row]:
        """The energies of the bonds and the tables of this instant."""
        yield from self.energies(tick)
        yield from self.tables(tick)

    def energies(self, tick: int) -> Iterator[Row]:
        """What the coupling made at the bonds that are complete now."""
        for bond in self.design.bonds:
            if tick % bond.period == 0:
                yield (LEDGER, tick, -1, bond.flow_side, bond.made, bond.effort_side, bond.total, 0)

    def tables(self, tick: int) -> Iterator[Row]:
        """A row of every table that has one now."""
        for k, group in enumerate(self.design.groups):
            if tick % group.period == 0 and len(group.slots):
                yield (RECORD, tick, -1, k, 0, 0, 0, 0)

    def begin(self, tick: int) -> Iterator[Row]:
        """What steps at this instant, and with Jacobi the inputs of the steps that begin now."""
        due = self.due(tick)
        self.ran = set()
        for early in (self.design.samplers, self.design.leaders):
            for name in due:
                if name in early:
                    for connection in self.design.into(name):
                        yield self._form(connection, tick, self._seen_early(connection.source[0], tick), tick)
                    yield from self.advance(tick, name, tick)
                    self.ran.add(name)
        for name in due:
            if name not in self.early:
                for c in self.design.into(name):
                    if self.formed_at_beginning(c):
                        yield self._form(c, tick, self._seen_early(c.source[0], tick), tick)

    def formed_at_beginning(self, c: Connection) -> bool:
        """Whether an input is formed at the beginning of the step, not at its end."""
        return self.design.choices[c].transfer != "mean"

    def _seen_early(self, source: str, tick: int) -> int:
        """The last sample of a source, as known while steps begin at `tick`."""
        period = self.clock.periods[source]
        if source in self.design.leaders:
            return (tick // period + 1) * period if source in self.ran else -(-tick // period) * period
        return tick // period * period

    def _step(self, tick: int, name: str, done: set[str]) -> Iterator[Row]:
        """Form the inputs that are formed now and do the step that ends now; `done` have done theirs."""
        period = self.clock.periods[name]
        for c in self.design.into(name):
            if not self.formed_at_beginning(c):
                h = self.clock.periods[c.source[0]]
                if c.source[0] in self.design.leaders:
                    sample = -(-tick // h) * h
                else:
                    sample = tick if c.source[0] in done else (tick - 1) // h * h
                yield self._form(c, tick, sample, tick - period)
        yield from self.advance(tick, name, tick - period)

    def advance(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """Set inputs, step from `start` over one period, get outputs."""
        component, period, layout = self.index[name], self.clock.periods[name], self.layout
        yield from self._series(tick, name, start)
        if self.design.into(name) or self.system.components[name].series:
            for key, slot in self.foreign_inputs.get(name, {}).items():
                crossing = self._crossing(key)
                yield self.held(key, tick, layout.inputs[key], slot, crossing.gain, crossing.offset)
            yield (SET, tick, component, 0, 0, 0, 0, 0)
        pushes = [(layout.previous[key], slot) for key, slot in self.before.get(name, {}).items()]
        pushes += [(layout.outputs[key], slot) for key, slot in self.previous.get(name, {}).items()]
        rows = [(PUSH, tick, component, a, b, 0, 0, 0) for a, b in pushes]
        if name in self.design.rereads:
            yield from rows
            yield from self._get(tick, name, 1)
            for key, slot in self.begins.get(name, {}).items():
                yield (PUSH, tick, component, layout.outputs[key], slot, 0, 0, 0)
            rows = []
        yield (STEP, tick, component, self.length(name), start, 0, 0, 0)
        yield from rows
        if name in self.outputs:
            yield from self._get(tick, name, 0)
        for c in self.averaged.get(name, []):
            weight = self.constants.at(period / (2 * self.clock.periods[c.target[0]]))
            a, p = layout.outputs[c.source], layout.start(c.source)
            yield (ACCUMULATE, tick, component, a, layout.integrals[c.target], p, 0, weight)
        yield from self.works(tick, name)

    def _get(self, tick: int, name: str, begin: int) -> Iterator[Row]:
        """Get a component's outputs, and turn those of a foreign FMU into ours; `begin`: as its step begins."""
        yield (GET, tick, self.index[name], begin, 0, 0, 0, 0)
        for key, slot in self.foreign_outputs.get(name, {}).items():
            crossing = self._crossing(key)
            yield self.held(key, tick, slot, self.layout.outputs[key], crossing.back_gain, crossing.back_offset)

    def _crossing(self, key: Key) -> Crossing:
        return crossings_of(self.system.components[key[0]].fmu).get(key[1], Crossing(key[1]))

    def held(self, key: Key, tick: int, a: int, b: int, gain: float, offset: float) -> Row:
        """Give slot b the value of slot a, which is of the type of `key`."""
        component = self.index[key[0]]
        if self.system.components[key[0]].fmu.is_real(key[1]):
            return (COPY, tick, component, a, b, 0, 0, self.constants.at(gain, offset))
        return (MOVE, tick, component, a, b, 0, 0, 0)

    def _series(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """The inputs that follow tables, for the step from `start`."""
        for variable, series in self.system.components[name].series.items():
            code, length = (SAMPLE, 0) if series.sampled else (SERIES, self.length(name))
            b, k = self.layout.inputs[name, variable], self.constants.table(series)
            yield (code, tick, self.index[name], 0, b, start, length, k)

    def length(self, name: str) -> int:
        """Length of a component's step [ticks]."""
        return self.clock.periods[name]

    def nominal(self, key: Key) -> float:
        """The size of a signal as its FMU states it, otherwise 1."""
        stated = self.system.components[key[0]].fmu.variables[key[1]].nominal
        return abs(float(stated or 0.0)) or 1.0

    def works(self, tick: int, name: str) -> Iterator[Row]:
        """The work of the step that was just done, at every bond of the component."""
        for side in self.sides.get(name, []):
            weights = (-side.sign, side.sign, 1.0)
            if not side.counter:
                weights = (side.sign / 2, side.sign / 2, self.duration(name))
            a = self.layout.outputs[side.own]
            p = self.layout.previous[side.own] if side.counter else self.layout.start(side.own)
            yield (WORK, tick, -1, a, side.work, p, side.held, self.constants.at(*weights))

    def duration(self, name: str) -> float:
        """Length of a component's step [s]."""
        return float(self.clock.seconds(self.clock.periods[name]))

    def _form(self, c: Connection, tick: int, sample: int, start: int) -> Row:
        """Form an input for the step that begins at `start`, from a source last sampled at `sample`."""
        transfer, layout = self.design.choices[c].transfer, self.layout
        a, b, target = layout.outputs[c.source], layout.inputs[c.target], self.index[c.target[0]]
        h, H = self.clock.periods[c.source[0]], self.clock.periods[c.target[0]]
        ahead = c.source[0] in self.design.leaders and sample - h <= start < sample  # the source has stepped already
        if transfer == "hold" and not ahead:
            return self.held(c.target, tick, a, b, c.gain, c.offset)
        p = layout.previous[c.source]
        if not self.system.components[c.source[0]].fmu.is_real(c.source[1]):
            return self.held(c.target, tick, p, b, c.gain, c.offset)
        if transfer == "quadratic":
            weights = quadratic_weights(sample, h, start, H)
            k = self.constants.at(c.gain, c.offset, *weights)
            return (QUADRATIC, tick, target, a, b, p, layout.before[c.source], k)
        if transfer == "mean":
            k = self.constants.at(c.gain, c.offset, *mean_tail(sample, h, start + H, H))
            return (MEAN, tick, target, a, b, layout.start(c.source), layout.integrals[c.target], k)
        ratio = value_ratio(sample, h, start) if transfer == "hold" else linear_ratio(sample, h, start, H)
        return (LINEAR, tick, target, a, b, p, 0, self.constants.at(c.gain, c.offset, ratio))
