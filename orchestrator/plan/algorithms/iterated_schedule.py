"""The operations of a macro step that is repeated until its inputs agree with what their sources gave."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from ...loop.operations import COPY, ITERATE, MIX, PUSH, RECORD, REPEAT, RESTORE, REWIND, SAVE
from ...loop.solvers.iteration import AITKEN, NEWTON
from ...system.connection import Connection
from ..design import Design
from ..schedule.formulas import ITERATED
from ..schedule.schedule import Schedule
from ..schedule.values import Row

if TYPE_CHECKING:
    from .iterated import IteratedSettings


class IteratedSchedule(Schedule):
    """Predict, save, pass, judge; restore and repeat."""

    def __init__(self, design: Design, settings: IteratedSettings) -> None:
        super().__init__(design)
        self.settings = settings
        self.unknowns, self.images = self.layout.unknowns, self.layout.images
        self.begun: set[int] = set()  # images that have their first part
        self.driven: dict[str, list[Connection]] = {}  # iterated connections by their sources
        for c, choice in design.choices.items():
            if choice.transfer in ITERATED:
                self.driven.setdefault(c.source[0], []).append(c)

    def rows(self) -> Iterator[Row]:
        layout, end = self.layout, self.span
        whole = end == self.clock.hyperperiod
        self.unknowns, self.images = (
            (layout.unknowns, layout.images) if whole else (layout.last_unknowns, layout.last_images)
        )
        self.begun.clear()
        unknowns, images = list(self.unknowns.values()), list(self.images.values())
        signals = layout.extras["coupling", "iterations"].slot  # all but what the iteration itself counts
        counted = signals if whole else layout.last_counted
        first = counted + 2
        rows: list[Row] = [*self.events(0), *self._predict()]
        rows += ((SAVE, 0, c, 0, 0, 0, 0, 0) for c in self.index.values())
        rows.append((SAVE, 0, -1, signals, 0, 0, 0, 0))
        again = len(rows)
        one_pass = list(super().rows())
        final = [row for row in one_pass if row[0] == RECORD and row[1] == end]  # these show how the iteration went
        rows += [row for row in one_pass if row not in final]
        recorded = Counter(row[3] for row in rows if row[0] == RECORD)
        back: list[Row] = [(RESTORE, end, c, 0, 0, 0, 0, 0) for c in self.index.values()]
        back.append((RESTORE, end, -1, signals, 0, 0, 0, 0))
        back += [(REWIND, end, -1, group, count, 0, 0, 0) for group, count in recorded.items()]
        back.append((REPEAT, end, -1, again, 0, 0, 0, 0))
        on, image = len(rows) + 1 + len(back), images[0] if images else first
        yield from rows
        yield (ITERATE, end, -1, on, first, image, len(unknowns), self._settings())
        yield from back
        if not whole:
            yield from ((PUSH, end, -1, counted + k, signals + k, 0, 0, 0) for k in (0, 1))
        yield from final

    def _settings(self) -> int:
        """Tolerance, largest number of iterations, method, and the nominal value of every unknown."""
        s = self.settings
        nominal = [self.nominal(key) for key, _ in self.unknowns]
        method = NEWTON if s.method == "newton" else AITKEN
        return self.constants.at(s.tolerance, float(s.max_iterations), float(method), *nominal)

    def _predict(self) -> Iterator[Row]:
        """The first pass takes every input as its source left it."""
        for c, choice in self.design.choices.items():
            if choice.transfer in ITERATED:
                k, a = self.constants.at(c.gain, c.offset), self.layout.outputs[c.source]
                for j in range(self.steps_of(c.target[0])):
                    slot = self.unknowns.get((c.target, j))
                    if slot is not None:
                        yield (COPY, 0, self.index[c.target[0]], a, slot, 0, 0, k)

    def begin(self, tick: int) -> Iterator[Row]:
        """Samplers step; of the others the inputs that are held whatever the algorithm take their values."""
        for name in self.due(tick):
            if name in self.design.samplers:
                yield from self._take(tick, name, tick)
                yield from self.advance(tick, name, tick)
        for name in self.due(tick):
            if name not in self.design.samplers:
                for c in self.design.into(name):
                    if not self.system.is_real(c):
                        yield self.sent(c, tick, self.layout.outputs[c.source])
                        yield from self.broken(c, tick, tick)

    def finish(self, tick: int) -> Iterator[Row]:
        """The steps that end now, what they give to the images, and the values of this instant."""
        self.settling.begin()
        together = [name for name in self.due(tick) if name in self.design.exchange]
        for name in self.due(tick):
            members = together if together and name == together[-1] else [] if name in together else [name]
            for member in members:
                if member not in self.design.samplers:
                    start = self.begin_of(member, tick - 1)
                    yield from self._take(tick, member, start)
                    yield from self.prepare(tick, member, start)
            for member in members:
                if member not in self.design.samplers:
                    start = self.begin_of(member, tick - 1)
                    yield from self.advance(tick, member, start, prepared=True)
                    yield from self._collect(tick, member, start)
                    self.settling.stepped(member)
        yield from self.record(tick)

    def _take(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """The inputs of one step: unknowns, and what samplers hold or take."""
        for c in self.design.into(name):
            b = self.layout.inputs[c.target]
            if self.design.choices[c].transfer in ITERATED:
                step = (c.target, start // self.clock.periods[name])
                a = self.unknowns.get(step, self.images[step])  # what this pass knows already
                yield (COPY, tick, self.index[name], a, b, 0, 0, self.constants.at(1.0, 0.0))
            elif name in self.design.samplers or self.system.is_real(c):
                yield self.sent(c, tick, self.layout.outputs[c.source])
            else:
                continue
            yield from self.broken(c, tick, start)

    def _collect(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """What the step from `start` to `tick` adds to the images of the inputs that it drives."""
        for c in self.driven.get(name, []):
            transfer, H = self.design.choices[c].transfer, self.clock.periods[c.target[0]]
            for j in range(start // H, -(-tick // H)):
                end = min((j + 1) * H, self.span)
                if transfer != "iterated" and end > tick:
                    continue  # a later step of the source reaches the end of that one
                parts = _mean(start, tick, j * H, end) if transfer == "iterated" else _end(start, tick, end)
                late, early = map(float, parts)
                image = self.images[c.target, j]
                kept = 1.0 if image in self.begun else 0.0
                self.begun.add(image)
                a = self.layout.outputs[c.source]
                p = a if transfer == "end" else self.layout.start(c.source)
                if c.counted:  # its rise, in proportion
                    a, p = self.layout.outputs[c.counted], self.layout.counted_from(c.counted)
                    late = c.per_second * (late + early) / float(self.clock.seconds(tick - start))
                    early = -late
                weights = (kept, c.gain * late, c.gain * early, 0.0 if kept else c.offset)
                yield (MIX, tick, self.index[c.target[0]], a, image, p, 0, self.constants.at(*weights))


def _mean(start: int, tick: int, begin: int, end: int) -> tuple[Fraction, Fraction]:
    """Weights of the end and of the beginning of a source's step in the mean from `begin` to `end`."""
    h, H = tick - start, end - begin
    x, y = (Fraction(t - start, h) for t in (max(start, begin), min(tick, end)))
    late = Fraction(h, H) * (y * y - x * x) / 2
    return late, Fraction(h, H) * (y - x) - late


def _end(start: int, tick: int, end: int) -> tuple[Fraction, Fraction]:
    """The same in the value at `end`."""
    late = Fraction(end - start, tick - start)
    return late, 1 - late
