"""The list of operations over one hyperperiod, or over what is left of a run behind the last one.

A component's step from t to t + H is done at the instant t + H, faster components first, so that a slow component
can receive the mean of what fast ones did over the same interval. Gauss-Seidel forms an input just before its step,
from the latest values; Jacobi forms it at the beginning of the step, from values of that instant (means excepted:
they need the whole interval).

Two kinds of components are the exception, their step from t to t + H is done at t: one all of whose connected inputs
are sampled (a discrete controller), whose outputs are in force from then on; and one whose outputs are interpolated,
so that those who receive them know both ends.

A step that would end behind the span ends with it: the last one before a stop that is no multiple of its period.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...clock import seconds_text
from ...errors import InputError
from ...loop.operations import (
    COLUMNS,
    LEDGER,
    PACE,
    RECORD,
)
from ...system.connection import Connection
from ...system.event import set_inputs
from ..design import Design
from .repeats import without_repeats
from .settling import Settling
from .steps import Steps
from .values import Row

LARGEST = 5_000_000  # operations; 320 MB


class Schedule(Steps):
    """Collects operations and their coefficients."""

    def __init__(self, design: Design) -> None:
        super().__init__(design)
        self.ran: set[str] = set()  # components that step first and have done so at the present instant
        self.early = set(design.early)
        self.settling = Settling(self)

    def build(self, span: int) -> np.ndarray:
        """The operations of the next `span` ticks, (m, 8). Raises InputError if there would be too many."""
        self.span = span
        steps = {name: self.steps_of(name) for name in self.design.order}
        total = 4 * sum(steps.values())
        total += sum(steps[c.source[0]] + steps[c.target[0]] for c in self.system.connections)
        if total > LARGEST:
            raise InputError(
                f"the periods repeat only every {seconds_text(self.clock.seconds(span))}: "
                f"more than {LARGEST} operations; choose periods with a common multiple"
            )
        rows = [*self.rows(), *self.last_deadline()]
        cells = {self.index[name]: tuple(map(dict.values, self.layout.exchanged(name))) for name in self.index}
        given, taken = ({k: list(sides[n]) for k, sides in cells.items()} for n in (0, 1))
        changed = [self.layout.inputs[key] for key in set_inputs(self.system.events)]
        return np.array(without_repeats(rows, given, taken, changed), dtype=np.int64).reshape(-1, len(COLUMNS))

    def rows(self) -> Iterator[Row]:
        """The operations in their order."""
        yield from self.begin(0)
        for tick in self.instants():
            yield from self.finish(tick)
            yield from self.deadline(tick)
            if tick < self.span:
                yield from self.begin(tick)

    def deadline(self, tick: int) -> Iterator[Row]:
        """Wait for the clock on the wall at an instant that has a deadline, where steps are made once."""
        every, algorithm = self.design.deadlines, self.design.algorithm
        if every and self.at_instant(tick, every) and not algorithm.saves_states and not algorithm.steps_vary:
            yield (PACE, tick, -1, tick, 0, 0, 0, 0)

    def last_deadline(self) -> Iterator[Row]:
        """The same at the end of a macro step, where steps are done again or vary; the loop knows the instant."""
        algorithm = self.design.algorithm
        if self.design.deadlines and (algorithm.saves_states or algorithm.steps_vary):
            yield (PACE, self.span, -1, 0 if algorithm.steps_vary else self.span, 0, 0, 0, 0)

    def instants(self) -> list[int]:
        """The instants of the span at which any step ends, rising."""
        ends = {
            min(k * self.clock.periods[name], self.span)
            for name in self.design.order
            for k in range(1, self.steps_of(name) + 1)
        }
        return sorted(ends)

    def steps_of(self, name: str) -> int:
        """How many steps a component makes in the span."""
        return -(-self.span // self.clock.periods[name])

    def due(self, tick: int) -> list[str]:
        return [name for name in self.design.order if self.at_instant(tick, self.clock.periods[name])]

    def finish(self, tick: int) -> Iterator[Row]:
        """The steps that end now, and what is recorded of this instant."""
        yield from self.steps(tick)
        yield from self.record(tick)

    def steps(self, tick: int) -> Iterator[Row]:
        """The steps that end now."""
        due = [name for name in self.due(tick) if name not in self.early]
        done: set[str] = set()
        self.settling.begin()
        yield from self._ahead(tick, due)
        together = [name for name in due if name in self.design.exchange]
        for name in due:
            members = together if together and name == together[-1] else [] if name in together else [name]
            for member in members:
                yield from self._inputs(tick, member, done)
            for member in members:
                yield from self.advance(tick, member, self.begin_of(member, tick - 1), prepared=True)
                self.settling.stepped(member)
                done.add(member)

    def _ahead(self, tick: int, due: list[str]) -> Iterator[Row]:
        """Parts of steps of components that have events, to an instant of others, who can be stopped so far."""
        events = self.design.events
        if events is None or not any(name in events.stopped and name not in events.ahead for name in due):
            return
        starts = {name: self.begin_of(name, tick - 1) for name in self.design.order if name in events.ahead}
        for name, start in starts.items():
            yield from self.prepare(tick, name, start)
        for name, start in starts.items():
            yield from self.advance(tick, name, start, part=True, prepared=True, until=tick)

    def record(self, tick: int) -> Iterator[Row]:
        """The energies of the bonds and the tables of this instant."""
        yield from self.energies(tick)
        yield from self.settle(tick)
        for c in self.design.inside:  # as they are now, to be recorded
            if self.at_instant(tick, self.clock.periods[c.target[0]]):
                yield self.sent(c, tick, self.layout.outputs[c.source])
        if self.design.events:
            looks = any(self.at_instant(tick, self.clock.periods[name]) for name in self.design.events.watched)
            yield from self.events(tick, looks)
            for name in self.due(tick):
                yield from self.sampled(tick, name)
        yield from self.tables(tick)

    def settle(self, tick: int) -> Iterator[Row]:
        """The values of this instant, once all steps to it are done: see `Instants`."""
        yield from self.settling.all_of(tick, frozenset(name for name in self.due(tick) if name not in self.early))

    def energies(self, tick: int) -> Iterator[Row]:
        """What the coupling made at the bonds that are complete now."""
        for bond in self.design.bonds:
            if self.at_instant(tick, bond.period):
                yield (LEDGER, tick, -1, bond.flow_side, bond.made, bond.effort_side, bond.total, 0)

    def tables(self, tick: int) -> Iterator[Row]:
        """A row of every table that has one now."""
        for k, group in enumerate(self.design.groups):
            if self.at_instant(tick, group.period) and len(group.slots):
                yield (RECORD, tick, -1, k, 0, 0, 0, 0)

    def begin(self, tick: int) -> Iterator[Row]:
        """What steps at this instant, and with Jacobi the inputs of the steps that begin now."""
        due = self.due(tick)
        self.ran = set()
        for name in due:
            yield from self.rescaled(tick, name)
        for early in (self.design.samplers, self.design.leaders):
            for name in due:
                if name in early:
                    for connection in self.design.into(name):
                        yield from self._form(connection, tick, self._seen_early(connection.source[0], tick), tick)
                    yield from self.advance(tick, name, tick)
                    self.ran.add(name)
        for name in due:
            if name not in self.early:
                for c in self.design.into(name):
                    if self.formed_at_beginning(c):
                        yield from self._form(c, tick, self._seen_early(c.source[0], tick), tick)

    def formed_at_beginning(self, c: Connection) -> bool:
        """Whether an input is formed at the beginning of the step, not at its end."""
        return self.design.choices[c].transfer != "mean"

    def goes_ahead(self, name: str) -> bool:
        """Whether a component comes first to the instants of others."""
        return self.design.events is not None and name in self.design.events.ahead

    def _seen_early(self, source: str, tick: int) -> int:
        """The last sample of a source, as known while steps begin at `tick`."""
        period = self.clock.periods[source]
        if source in self.design.leaders:
            end = (tick // period + 1) * period if source in self.ran else -(-tick // period) * period
            return min(end, self.span)
        return tick // period * period

    def _inputs(self, tick: int, name: str, done: set[str]) -> Iterator[Row]:
        """Form and set the inputs of the step that ends now; `done` have done theirs."""
        start = self.begin_of(name, tick - 1)
        now = [c for c in self.design.into(name) if not self.formed_at_beginning(c)]
        latest = [c for c in now if c.source[0] in done and self.design.choices[c].transfer != "mean"]
        yield from self.settling.sources_of(tick, frozenset(done), latest)
        for c in now:
            h = self.clock.periods[c.source[0]]
            if c.source[0] in self.design.leaders:
                sample = min(-(-tick // h) * h, self.span)
            else:
                sample = tick if c.source[0] in done else (tick - 1) // h * h
            yield from self._form(c, tick, sample, start)
        self.settling.formed(now)
        yield from self.prepare(tick, name, start)
