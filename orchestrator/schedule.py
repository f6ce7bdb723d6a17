"""The list of operations over one hyperperiod.

A component's step from t to t + H is done at the instant t + H, faster components first, so that a slow component
can receive the mean of what fast ones did over the same interval. Gauss-Seidel forms an input just before its step,
from the latest values; Jacobi forms it at the beginning of the step, from values of that instant (means excepted:
they need the whole interval).

A component all of whose connected inputs are sampled (a discrete controller) is the exception: its step from t to t + H
is done at t, with the values of that instant, and its outputs are in force from then on.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .clock import Clock, seconds_text
from .crossing import Crossing
from .errors import InputError
from .layout import Group, Layout
from .operations import ACCUMULATE, COLUMNS, COPY, GET, LINEAR, MEAN, MOVE, PUSH, RECORD, SET, STEP
from .system import Connection, System
from .transfer import Choice, linear_ratio, mean_tail

LARGEST = 5_000_000  # operations; 320 MB


class Schedule:
    """Collects the operations of one hyperperiod and their coefficients."""

    def __init__(
        self,
        system: System,
        clock: Clock,
        order: tuple[str, ...],
        choices: dict[Connection, Choice],
        layout: Layout,
        groups: tuple[Group, ...],
        samplers: tuple[str, ...],
    ) -> None:
        self.system, self.clock, self.order = system, clock, order
        self.choices, self.layout, self.groups, self.samplers = choices, layout, groups, samplers
        self.index = {name: k for k, name in enumerate(system.components)}
        self.coefficients: list[float] = [0.0]
        self.known: dict[tuple[float, ...], int] = {}

    def build(self) -> np.ndarray:
        """The operations of one hyperperiod, (m, 8). Raises InputError if there would be too many."""
        total = sum(
            self.clock.hyperperiod // self.clock.periods[name] * (4 + len(self.system.connections))
            for name in self.order
        )
        if total > LARGEST:
            raise InputError(
                f"the periods repeat only every {seconds_text(self.clock.seconds(self.clock.hyperperiod))}: "
                f"more than {LARGEST} operations; choose periods with a common multiple"
            )
        instants = sorted(
            {
                k * self.clock.periods[name]
                for name in self.order
                for k in range(1, self.clock.hyperperiod // self.clock.periods[name] + 1)
            }
        )
        rows = list(self._begin(0))
        for tick in instants:
            rows += self._finish(tick)
            if tick < self.clock.hyperperiod:
                rows += self._begin(tick)
        return np.array(rows, dtype=np.int64).reshape(-1, len(COLUMNS))

    def _due(self, tick: int) -> list[str]:
        return [name for name in self.order if tick % self.clock.periods[name] == 0]

    def _finish(self, tick: int) -> Iterator[tuple[int, ...]]:
        """The steps that end now, and what is recorded of this instant."""
        due = [name for name in self._due(tick) if name not in self.samplers]
        for name in due:
            yield from self._step(tick, name, due)
        for k, group in enumerate(self.groups):
            if tick % group.period == 0 and len(group.slots):
                yield (RECORD, tick, -1, k, 0, 0, 0, 0)

    def _begin(self, tick: int) -> Iterator[tuple[int, ...]]:
        """What samples at this instant, and with Jacobi the inputs of the steps that begin now."""
        due = self._due(tick)
        for name in due:
            if name in self.samplers:
                for connection in self._into(name):
                    yield self._form(connection, tick, tick, tick)
                yield from self._advance(tick, name, tick)
        for name in due:
            if self.system.algorithm == "jacobi" and name not in self.samplers:
                for connection in self._into(name):
                    if self.choices[connection].transfer != "mean":
                        yield self._form(connection, tick, tick, tick)

    def _step(self, tick: int, name: str, due: list[str]) -> Iterator[tuple[int, ...]]:
        """Form the inputs that are formed now and do the step that ends now."""
        period = self.clock.periods[name]
        for connection in self._into(name):
            if self.system.algorithm == "gauss-seidel" or self.choices[connection].transfer == "mean":
                source = connection.source[0]
                done = (
                    tick
                    if source in due and due.index(source) < due.index(name)
                    else (tick - 1) // self.clock.periods[source] * self.clock.periods[source]
                )
                yield self._form(connection, tick, done, tick - period)
        yield from self._advance(tick, name, tick - period)

    def _advance(self, tick: int, name: str, start: int) -> Iterator[tuple[int, ...]]:
        """Set inputs, step from `start` over one period, get outputs."""
        component, period = self.index[name], self.clock.periods[name]
        if self._into(name):
            for (owner, variable), slot in self.layout.foreign_inputs.items():
                if owner == name:
                    crossing, ours = self._crossing(name, variable), self.layout.inputs[name, variable]
                    there = self._constant(crossing.gain, crossing.offset)
                    yield (COPY, tick, component, ours, slot, 0, 0, there)
            yield (SET, tick, component, 0, 0, 0, 0, 0)
        yield (STEP, tick, component, period, start, 0, 0, 0)
        outputs = [(key, slot) for key, slot in self.layout.previous.items() if key[0] == name]
        for key, slot in outputs:
            yield (PUSH, tick, component, self.layout.outputs[key], slot, 0, 0, 0)
        if any(key[0] == name for key in self.layout.outputs):
            yield (GET, tick, component, 0, 0, 0, 0, 0)
            for (owner, variable), slot in self.layout.foreign_outputs.items():
                if owner == name:
                    crossing, ours = self._crossing(name, variable), self.layout.outputs[name, variable]
                    back = self._constant(crossing.back_gain, crossing.back_offset)
                    yield (COPY, tick, component, slot, ours, 0, 0, back)
        for connection, choice in self.choices.items():
            if choice.transfer == "mean" and connection.source[0] == name:
                weight = self._constant(period / (2 * self.clock.periods[connection.target[0]]))
                a, p = self.layout.outputs[connection.source], self.layout.previous[connection.source]
                yield (ACCUMULATE, tick, component, a, self.layout.integrals[connection.target], p, 0, weight)

    def _crossing(self, name: str, variable: str) -> Crossing:
        return self.system.components[name].fmu.crossings.get(variable, Crossing(variable))

    def _into(self, name: str) -> list[Connection]:
        return [c for c in self.system.connections if c.target[0] == name]

    def _form(self, c: Connection, tick: int, sample: int, start: int) -> tuple[int, ...]:
        """Form an input for the step that begins at `start`, from a source last sampled at `sample`."""
        transfer = self.choices[c].transfer
        a, b, target = self.layout.outputs[c.source], self.layout.inputs[c.target], self.index[c.target[0]]
        source_period, target_period = self.clock.periods[c.source[0]], self.clock.periods[c.target[0]]
        kind = self.system.components[c.source[0]].fmu.type_of(c.source[1])
        if kind is not None and not kind.real:
            return (MOVE, tick, target, a, b, 0, 0, 0)
        if transfer == "hold":
            return (COPY, tick, target, a, b, 0, 0, self._constant(c.gain, c.offset))
        sample = sample // source_period * source_period
        p = self.layout.previous[c.source]
        if transfer == "linear":
            ratio = linear_ratio(sample, source_period, start, target_period)
            return (LINEAR, tick, target, a, b, p, 0, self._constant(c.gain, c.offset, ratio))
        tail = mean_tail(sample, source_period, start + target_period, target_period)
        return (MEAN, tick, target, a, b, p, self.layout.integrals[c.target], self._constant(c.gain, c.offset, *tail))

    def _constant(self, *values: float) -> int:
        if values not in self.known:
            self.known[values] = len(self.coefficients)
            self.coefficients.extend(values)
        return self.known[values]
