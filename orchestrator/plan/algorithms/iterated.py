"""The operations of one macro step that is repeated until the coupling is consistent.

The macro step is the hyperperiod. Its unknowns are the inputs of every single step in it. A pass takes them as given,
lets every component do its steps, and collects the image of each unknown: the mean, over its step, of what its source
gave, a straight line over each step of the source.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

from ...clock import Clock, seconds_text
from ...errors import InputError
from ...loop.iteration import AITKEN, NEWTON
from ...loop.operations import COPY, ITERATE, MIX, RECORD, REPEAT, RESTORE, REWIND, SAVE
from ...system.model import Connection, System
from ..design import Design
from ..formulas import Choice
from ..layout import Layout
from ..schedule import Row, Schedule

LARGEST_NEWTON = 100  # unknowns: each costs a pass


def add_unknowns(system: System, clock: Clock, choices: dict[Connection, Choice], layout: Layout) -> None:
    """Slots at the end of the layout: iterations, residual, unknowns, images. Raises InputError if Newton has many."""
    layout.extra("iterations", "1", "passes, but those for a Jacobian, that the step took", clock.hyperperiod)
    layout.extra("residual", "1", "largest relative residual of an input at the end", clock.hyperperiod)
    steps = [
        (c.target, j)
        for c, choice in choices.items()
        if choice.transfer == "iterated"
        for j in range(clock.hyperperiod // clock.periods[c.target[0]])
    ]
    if system.iteration.method == "newton" and len(steps) > LARGEST_NEWTON:
        raise InputError(
            f"iteration: Newton with {len(steps)} unknowns (inputs times steps in "
            f"{seconds_text(clock.seconds(clock.hyperperiod))}), more than {LARGEST_NEWTON}; "
            f'take method = "aitken" ({system.path.name})'
        )
    for table, words in ((layout.unknowns, "unknown"), (layout.images, "image of")):
        for (component, variable), j in steps:
            table[(component, variable), j] = layout.slot(f"{words} {component}.{variable}, step {j + 1}")


class IteratedSchedule(Schedule):
    """Predict, save, pass, judge; restore and repeat."""

    def __init__(self, design: Design) -> None:
        super().__init__(design)
        self.begun: set[int] = set()  # images that have their first part

    def rows(self) -> Iterator[Row]:
        layout, end = self.layout, self.clock.hyperperiod
        unknowns, images = list(layout.unknowns.values()), list(layout.images.values())
        first = unknowns[0] if unknowns else layout.size
        signals = first - 2  # all signals but what the iteration itself counts
        rows: list[Row] = [*self._predict(), *((SAVE, 0, c, 0, 0, 0, 0, 0) for c in self.index.values())]
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
        yield from final

    def _settings(self) -> int:
        """Tolerance, largest number of iterations, method, and the nominal value of every unknown."""
        s = self.system.iteration
        nominal = []
        for (name, variable), _ in self.layout.unknowns:
            stated = self.system.components[name].fmu.variables[variable].nominal
            nominal.append(abs(float(stated or 0.0)) or 1.0)
        method = NEWTON if s.method == "newton" else AITKEN
        return self.constants.at(s.tolerance, float(s.max_iterations), float(method), *nominal)

    def _predict(self) -> Iterator[Row]:
        """The first pass takes every input as its source left it."""
        for c, choice in self.design.choices.items():
            if choice.transfer == "iterated":
                k, a = self.constants.at(c.gain, c.offset), self.layout.outputs[c.source]
                for (key, _), slot in self.layout.unknowns.items():
                    if key == c.target:
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
                    if not self._real(c):
                        yield self.held(
                            c.target, tick, self.layout.outputs[c.source], self.layout.inputs[c.target], 1, 0
                        )

    def finish(self, tick: int) -> Iterator[Row]:
        for name in self.due(tick):
            if name not in self.design.samplers:
                start = tick - self.clock.periods[name]
                yield from self._take(tick, name, start)
                yield from self.advance(tick, name, start)
                yield from self._collect(tick, name, start)
        yield from self.record(tick)

    def _take(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """The inputs of one step: unknowns, and what samplers hold or take."""
        for c in self.design.into(name):
            b = self.layout.inputs[c.target]
            if self.design.choices[c].transfer == "iterated":
                a = self.layout.unknowns[c.target, start // self.clock.periods[name]]
                yield (COPY, tick, self.index[name], a, b, 0, 0, self.constants.at(1.0, 0.0))
            elif name in self.design.samplers or self._real(c):
                yield self.held(c.target, tick, self.layout.outputs[c.source], b, c.gain, c.offset)

    def _real(self, c: Connection) -> bool:
        return self.system.components[c.source[0]].fmu.is_real(c.source[1])

    def _collect(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """What the step from `start` to `tick` adds to the images of the inputs that it drives."""
        h = tick - start
        for c, choice in self.design.choices.items():
            if choice.transfer != "iterated" or c.source[0] != name:
                continue
            H = self.clock.periods[c.target[0]]
            for j in range(start // H, -(-tick // H)):
                x, y = (Fraction(t - start, h) for t in (max(start, j * H), min(tick, (j + 1) * H)))
                late = Fraction(h, H) * (y * y - x * x) / 2
                early = Fraction(h, H) * (y - x) - late
                image = self.layout.images[c.target, j]
                kept = 1.0 if image in self.begun else 0.0
                self.begun.add(image)
                weights = (kept, c.gain * float(late), c.gain * float(early), 0.0 if kept else c.offset)
                a, p = self.layout.outputs[c.source], self.layout.start(c.source)
                yield (MIX, tick, self.index[c.target[0]], a, image, p, 0, self.constants.at(*weights))
