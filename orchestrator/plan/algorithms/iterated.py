"""The operations of one macro step that is repeated until the coupling is consistent.

The macro step is the hyperperiod. Its unknowns are the inputs of every single step in it. A pass takes them as given,
lets every component do its steps, and collects the image of each unknown: the mean, over its step, of what its source
gave, a straight line over each step of the source.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np

from ...clock import Clock, seconds_text
from ...errors import InputError
from ...loop.iteration import AITKEN, COUNT, NEWTON, RESIDUAL, WORST, workspace
from ...loop.operations import COPY, ITERATE, MIX, RECORD, REPEAT, RESTORE, REWIND, SAVE
from ...system.model import Connection, System
from ..capabilities import require_state
from ..design import Design
from ..schedule.formulas import ITERATED, Choice
from ..schedule.layout import Key, Layout
from ..schedule.schedule import Row, Schedule
from .base import Algorithm, LoopArrays
from .settings import setting

if TYPE_CHECKING:
    from ..plan import Plan

LARGEST_NEWTON = 100  # unknowns: each costs a pass


@dataclass(frozen=True)
class IteratedSettings:
    """`[iteration]`: the residual of an input is relative to its size, or to its nominal value where that is larger."""

    method: Literal["aitken", "newton"] = setting("aitken", "fixed point with Aitken's relaxation, or Newton")
    inputs: Literal["mean", "end"] = setting(
        "mean", "over a step: the mean of the source over it (second order), or its value at the end (first order)"
    )
    sweep: Literal["jacobi", "gauss-seidel"] = setting(
        "jacobi", "a pass takes what the one before it gave, or where it is known what this one gave"
    )
    tolerance: float = setting(1e-8, "residual at which the inputs of a step are consistent [1]")
    max_iterations: int = setting(50, "passes of one step, those for a Jacobian aside, before the run fails [1]")


class Iterated(Algorithm):
    """Every macro step is repeated from saved states until its inputs agree with what their sources gave."""

    name = "iterated"
    heading = "iteration"
    Settings = IteratedSettings
    saves_states = True
    repeats_rows = True
    units: ClassVar[Mapping[str, str]] = {"iterations": "1", "residual": "1"}
    settings: IteratedSettings

    def explanation(self) -> str:
        s = self.settings
        wanted = "the mean of both ends of its step" if s.inputs == "mean" else "the value at the end of its step"
        order = "; a pass takes the latest values" if s.sweep == "gauss-seidel" else ""
        return (
            f"each macro step repeated from saved states ({s.method}, at most {s.max_iterations} times) until every "
            f"input is {wanted} within {s.tolerance:g}{order}"
        )

    def check(self, system: System) -> None:
        """Every FMU can go back."""
        for component in system.components.values():
            require_state(component, f"algorithm '{self.name}'")

    def transfer(
        self, system: System, clock: Clock, c: Connection, samplers: tuple[str, ...], leaders: tuple[str, ...]
    ) -> Choice:
        sampler = next((end[0] for end in (c.source, c.target) if end[0] in samplers), None)
        if sampler and c.transfer in ("", "hold"):
            return Choice("hold", f"{sampler} samples its inputs and holds its outputs")
        held = "the mean over their step" if self.settings.inputs == "mean" else "the value at the end of their step"
        if sampler or c.transfer not in ("", "mean" if self.settings.inputs == "mean" else ""):
            raise InputError(
                f"connection {c.label}: algorithm 'iterated' holds inputs at {held}, so "
                f"'{c.transfer}' has no meaning; leave it out {c.where}"
            )
        if self.settings.inputs == "mean":
            return Choice(
                "iterated", "the mean of the source over the step, both ends known by iteration: second order"
            )
        if clock.periods[c.target[0]] % clock.periods[c.source[0]] == 0:
            return Choice("end", "the source at the end of the step, known by iteration: first order")
        return Choice("end on line", "the source at the end of the step, on the line over its own: first order")

    def extend(self, system: System, clock: Clock, order: tuple[str, ...], choices: Mapping[Connection, Choice],
               layout: Layout) -> None:  # fmt: skip
        """Iterations, residual, unknowns, images. Raises InputError if Newton has many unknowns."""
        layout.extra("iterations", "1", "passes, but those for a Jacobian, that the step took", clock.hyperperiod)
        layout.extra("residual", "1", "largest relative residual of an input at the end", clock.hyperperiod)
        steps: list[tuple[Key, int]] = []
        known: list[tuple[Key, int]] = []
        for c, choice in choices.items():
            if choice.transfer in ITERATED:
                for j in range(clock.hyperperiod // clock.periods[c.target[0]]):
                    (known if self._known(clock, order, c, j) else steps).append((c.target, j))
        if self.settings.method == "newton" and len(steps) > LARGEST_NEWTON:
            raise InputError(
                f"iteration: Newton with {len(steps)} unknowns (inputs times steps in "
                f"{seconds_text(clock.seconds(clock.hyperperiod))}), more than {LARGEST_NEWTON}; "
                f'take method = "aitken" ({system.path.name})'
            )
        for table, words in ((layout.unknowns, "unknown"), (layout.images, "image of")):
            for (component, variable), j in steps:
                table[(component, variable), j] = layout.slot(f"{words} {component}.{variable}, step {j + 1}")
        for (component, variable), j in known:
            words = f"what {component}.{variable} is sent, step {j + 1}"
            layout.images[(component, variable), j] = layout.slot(words)

    def _known(self, clock: Clock, order: tuple[str, ...], c: Connection, j: int) -> bool:
        """Whether a pass knows all that step j of an input needs when that step is done."""
        end = (j + 1) * clock.periods[c.target[0]]
        before = order.index(c.source[0]) < order.index(c.target[0])
        return self.settings.sweep == "gauss-seidel" and before and end % clock.periods[c.source[0]] == 0

    def schedule(self, design: Design) -> Schedule:
        return IteratedSchedule(design, self.settings)

    def arrays(self, plan: Plan) -> LoopArrays:
        work = workspace(len(plan.layout.unknowns), self.settings.method == "newton")
        return super().arrays(plan)._replace(work=work, saved=np.zeros(plan.layout.size))

    def figures(self, values: Callable[[str], np.ndarray]) -> dict[str, Any]:
        count, residual, s = values("iterations"), values("residual"), self.settings
        found = {
            "method": s.method, "tolerance": s.tolerance, "iterations": int(np.sum(count)),
            "iterations_max": int(np.max(count)), "residual_max": float(np.max(residual)),
        }  # fmt: skip
        return {"iteration": found, "iterations_max": found["iterations_max"]}

    def failure(self, plan: Plan, arrays: LoopArrays, at: float) -> str:
        s, work = self.settings, arrays.work
        names = [".".join(key) for key, _ in plan.layout.unknowns]
        return (
            f"the coupling did not converge in the step to t = {at:.9g} s: residual {work[RESIDUAL]:.3g} of "
            f"{names[int(work[WORST])]} after {int(work[COUNT])} iterations "
            f"({s.method}, tolerance {s.tolerance:g}); take smaller periods"
            + (', or method = "newton" under [iteration]' if s.method == "aitken" else "")
        )


class IteratedSchedule(Schedule):
    """Predict, save, pass, judge; restore and repeat."""

    def __init__(self, design: Design, settings: IteratedSettings) -> None:
        super().__init__(design)
        self.settings = settings
        self.begun: set[int] = set()  # images that have their first part
        self.driven: dict[str, list[Connection]] = {}  # iterated connections by their sources
        for c, choice in design.choices.items():
            if choice.transfer in ITERATED:
                self.driven.setdefault(c.source[0], []).append(c)

    def rows(self) -> Iterator[Row]:
        layout, end = self.layout, self.clock.hyperperiod
        unknowns, images = list(layout.unknowns.values()), list(layout.images.values())
        signals = layout.extras["coupling", "iterations"].slot  # all but what the iteration itself counts
        first = signals + 2
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
        s = self.settings
        nominal = [self.nominal(key) for key, _ in self.layout.unknowns]
        method = NEWTON if s.method == "newton" else AITKEN
        return self.constants.at(s.tolerance, float(s.max_iterations), float(method), *nominal)

    def _predict(self) -> Iterator[Row]:
        """The first pass takes every input as its source left it."""
        for c, choice in self.design.choices.items():
            if choice.transfer in ITERATED:
                k, a = self.constants.at(c.gain, c.offset), self.layout.outputs[c.source]
                for j in range(self.clock.hyperperiod // self.clock.periods[c.target[0]]):
                    slot = self.layout.unknowns.get((c.target, j))
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
            if self.design.choices[c].transfer in ITERATED:
                step = (c.target, start // self.clock.periods[name])
                a = self.layout.unknowns.get(step, self.layout.images[step])  # what this pass knows already
                yield (COPY, tick, self.index[name], a, b, 0, 0, self.constants.at(1.0, 0.0))
            elif name in self.design.samplers or self._real(c):
                yield self.held(c.target, tick, self.layout.outputs[c.source], b, c.gain, c.offset)

    def _real(self, c: Connection) -> bool:
        return self.system.components[c.source[0]].fmu.is_real(c.source[1])

    def _collect(self, tick: int, name: str, start: int) -> Iterator[Row]:
        """What the step from `start` to `tick` adds to the images of the inputs that it drives."""
        for c in self.driven.get(name, []):
            transfer, H = self.design.choices[c].transfer, self.clock.periods[c.target[0]]
            for j in range(start // H, -(-tick // H)):
                if transfer != "iterated" and (j + 1) * H > tick:
                    continue  # a later step of the source reaches the end of that one
                parts = self._mean(start, tick, j, H) if transfer == "iterated" else self._end(start, tick, j, H)
                late, early = map(float, parts)
                image = self.layout.images[c.target, j]
                kept = 1.0 if image in self.begun else 0.0
                self.begun.add(image)
                weights = (kept, c.gain * late, c.gain * early, 0.0 if kept else c.offset)
                a = self.layout.outputs[c.source]
                p = a if transfer == "end" else self.layout.start(c.source)
                yield (MIX, tick, self.index[c.target[0]], a, image, p, 0, self.constants.at(*weights))

    def _mean(self, start: int, tick: int, j: int, H: int) -> tuple[Fraction, Fraction]:
        """Weights of the end and of the beginning of a source's step in the mean over step j of length H."""
        h = tick - start
        x, y = (Fraction(t - start, h) for t in (max(start, j * H), min(tick, (j + 1) * H)))
        late = Fraction(h, H) * (y * y - x * x) / 2
        return late, Fraction(h, H) * (y - x) - late

    def _end(self, start: int, tick: int, j: int, H: int) -> tuple[Fraction, Fraction]:
        """The same in the value at the end of step j."""
        late = Fraction((j + 1) * H - start, tick - start)
        return late, 1 - late
