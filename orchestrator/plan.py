"""System -> plan: an explicit list of operations over one hyperperiod, as data that can be printed and executed.

A component's step from t to t + H is done at the instant t + H, faster components first, so that a slow component
can receive the mean of what fast ones did over the same interval. Gauss-Seidel forms an input just before its step,
from the latest values; Jacobi forms it at the beginning of the step, from values of that instant (means excepted:
they need the whole interval).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fnmatch import fnmatchcase

import numpy as np

from .clock import Clock, make_clock, seconds_text
from .errors import InputError
from .system import Connection, System
from .transfer import Choice, choose, linear_ratio, mean_tail

COPY, LINEAR, MEAN, SET, STEP, GET, PUSH, ACCUMULATE, RECORD = range(9)
NAMES = ("copy", "linear", "mean", "set", "step", "get", "push", "accumulate", "record")
COLUMNS = ("code", "tick", "component", "a", "b", "p", "q", "k")
LARGEST = 5_000_000  # operations; 320 MB


@dataclass
class Layout:
    """Where every number lives in the run's one vector of doubles."""

    size: int = 0
    outputs: dict[tuple[str, str], int] = field(default_factory=dict)
    inputs: dict[tuple[str, str], int] = field(default_factory=dict)
    previous: dict[tuple[str, str], int] = field(default_factory=dict)  # an output one period ago
    integrals: dict[tuple[str, str], int] = field(default_factory=dict)  # by the input that takes the mean

    def add(self, table: dict[tuple[str, str], int], key: tuple[str, str]) -> None:
        if key not in table:
            table[key] = self.size
            self.size += 1


@dataclass(frozen=True)
class Group:
    """A results table: what is recorded at one period."""

    period: int
    components: tuple[str, ...]
    columns: tuple[tuple[str, str], ...]  # (component, variable)
    slots: np.ndarray


@dataclass(frozen=True)
class Plan:
    """What the executor does: `prologue` once at time 0, then `cycle` over and over until the stop."""

    system: System
    clock: Clock
    order: tuple[str, ...]
    order_reason: str
    choices: dict[Connection, Choice]
    layout: Layout
    groups: tuple[Group, ...]
    prologue: np.ndarray
    cycle: np.ndarray
    coefficients: np.ndarray


def make_plan(system: System) -> Plan:
    """Plan a system. Raises InputError where periods, stop time or transfers do not fit."""
    clock = make_clock({name: c.period for name, c in system.components.items()}, system.stop)
    choices = {c: _choice(system, clock, c) for c in system.connections}
    order, reason = _order(system, clock)
    layout = _layout(system, choices)
    groups = _groups(system, clock, layout)
    builder = _Builder(system, clock, order, choices, layout, groups)
    prologue, cycle = builder.build()
    return Plan(system, clock, order, reason, choices, layout, groups, prologue, cycle, np.array(builder.coefficients))


def _choice(system: System, clock: Clock, connection: Connection) -> Choice:
    source, target = (clock.periods[end[0]] for end in (connection.source, connection.target))
    sampled = [system.components[name].fmu.variables[v].variability == "discrete" for name, v in (connection.source, connection.target)]
    choice = choose(connection.transfer, source, target, *sampled)
    if choice.transfer == "mean" and source > target:
        raise InputError(
            f"connection {connection.label}: 'mean' needs a source that is no slower than the target "
            f"({seconds_text(clock.seconds(source))} against {seconds_text(clock.seconds(target))}); take 'linear' or 'hold' {connection.where}"
        )
    return choice


def _order(system: System, clock: Clock) -> tuple[tuple[str, ...], str]:
    """Faster components first; among equals, a source before its target where the graph allows it."""
    if system.order:
        slower = [(a, b) for a, b in zip(system.order, system.order[1:], strict=False) if clock.periods[a] > clock.periods[b]]
        if slower:
            raise InputError(f"order: {slower[0][0]} is slower than {slower[0][1]} and must come after it ({system.path.name})")
        return system.order, "stated in the system file"
    waiting, done = sorted(system.components, key=lambda name: clock.periods[name]), []
    while waiting:
        rate = [name for name in waiting if clock.periods[name] == clock.periods[waiting[0]]]
        sources = {name: {c.source[0] for c in system.connections if c.target[0] == name and c.source[0] in rate and c.source[0] != name} for name in rate}
        ready = [name for name in rate if not sources[name]] or rate
        done.append(ready[0])
        waiting.remove(ready[0])
    return tuple(done), "fast before slow; at one rate a source before its target, cycles cut in the order of the file"


def _layout(system: System, choices: dict[Connection, Choice]) -> Layout:
    """Outputs and inputs of a component are contiguous, in the order of its description."""
    layout = Layout()
    used = {c.source for c in system.connections}
    driven = {c.target for c in system.connections}
    for name, component in system.components.items():
        for variable in component.fmu.names("output"):
            key = (name, variable)
            if component.fmu.variables[variable].type == "Real" and (key in used or _recorded(system, key)):
                layout.add(layout.outputs, key)
        for variable in component.fmu.names("input"):
            if (name, variable) in driven:
                layout.add(layout.inputs, (name, variable))
    for connection, choice in choices.items():
        if choice.transfer in ("linear", "mean"):
            layout.add(layout.previous, connection.source)
        if choice.transfer == "mean":
            layout.add(layout.integrals, connection.target)
    return layout


def _recorded(system: System, key: tuple[str, str]) -> bool:
    return any(fnmatchcase(".".join(key), pattern.replace("[", "[[]")) for pattern in system.record)


def _groups(system: System, clock: Clock, layout: Layout) -> tuple[Group, ...]:
    groups = []
    for period in sorted(set(clock.periods.values())):
        members = tuple(name for name in system.components if clock.periods[name] == period)
        slots = {key: slot for table in (layout.outputs, layout.inputs) for key, slot in table.items() if key[0] in members and _recorded(system, key)}
        columns = tuple(sorted(slots, key=lambda key: (members.index(key[0]), slots[key])))
        groups.append(Group(period, members, columns, np.array([slots[key] for key in columns], dtype=np.int64)))
    return tuple(groups)


class _Builder:
    """Collects operations and their coefficients."""

    def __init__(self, system: System, clock: Clock, order: tuple[str, ...], choices: dict[Connection, Choice], layout: Layout, groups: tuple[Group, ...]) -> None:
        self.system, self.clock, self.order, self.choices, self.layout, self.groups = system, clock, order, choices, layout, groups
        self.index = {name: k for k, name in enumerate(system.components)}
        self.coefficients: list[float] = [0.0]
        self.known: dict[tuple[float, ...], int] = {}

    def build(self) -> tuple[np.ndarray, np.ndarray]:
        total = sum(self.clock.hyperperiod // self.clock.periods[name] * (4 + len(self.system.connections)) for name in self.order)
        if total > LARGEST:
            raise InputError(f"the periods repeat only every {seconds_text(self.clock.seconds(self.clock.hyperperiod))}: more than {LARGEST} operations; choose periods with a common multiple")
        prologue = list(self._begin(0, self.order))
        instants = sorted({k * self.clock.periods[name] for name in self.order for k in range(1, self.clock.hyperperiod // self.clock.periods[name] + 1)})
        cycle = [row for tick in instants for row in self._instant(tick)]
        return _table(prologue), _table(cycle)

    def _instant(self, tick: int) -> Iterator[tuple[int, ...]]:
        due = [name for name in self.order if tick % self.clock.periods[name] == 0]
        for name in due:
            yield from self._step(tick, name, due)
        yield from self._begin(tick, due)
        for k, group in enumerate(self.groups):
            if tick % group.period == 0 and len(group.slots):
                yield (RECORD, tick, -1, k, 0, 0, 0, 0)

    def _begin(self, tick: int, due: list[str] | tuple[str, ...]) -> Iterator[tuple[int, ...]]:
        """Jacobi: the inputs of the steps that begin now."""
        if self.system.algorithm == "jacobi":
            for name in due:
                for connection in self._into(name):
                    if self.choices[connection].transfer != "mean":
                        yield self._form(connection, tick, tick, tick)

    def _step(self, tick: int, name: str, due: list[str]) -> Iterator[tuple[int, ...]]:
        component, period = self.index[name], self.clock.periods[name]
        for connection in self._into(name):
            if self.system.algorithm == "gauss-seidel" or self.choices[connection].transfer == "mean":
                source = connection.source[0]
                done = tick if source in due and due.index(source) < due.index(name) else (tick - 1) // self.clock.periods[source] * self.clock.periods[source]
                yield self._form(connection, tick, done, tick - period)
        if self._into(name):
            yield (SET, tick, component, 0, 0, 0, 0, 0)
        yield (STEP, tick, component, period, 0, 0, 0, 0)
        outputs = [(key, slot) for key, slot in self.layout.previous.items() if key[0] == name]
        for key, slot in outputs:
            yield (PUSH, tick, component, self.layout.outputs[key], slot, 0, 0, 0)
        if any(key[0] == name for key in self.layout.outputs):
            yield (GET, tick, component, 0, 0, 0, 0, 0)
        for connection, choice in self.choices.items():
            if choice.transfer == "mean" and connection.source[0] == name:
                weight = self._constant(period / (2 * self.clock.periods[connection.target[0]]))
                a, p = self.layout.outputs[connection.source], self.layout.previous[connection.source]
                yield (ACCUMULATE, tick, component, a, self.layout.integrals[connection.target], p, 0, weight)

    def _into(self, name: str) -> list[Connection]:
        return [c for c in self.system.connections if c.target[0] == name]

    def _form(self, c: Connection, tick: int, sample: int, start: int) -> tuple[int, ...]:
        """The operation that forms an input for the step that begins at `start` from a source last sampled at `sample`."""
        transfer = self.choices[c].transfer
        a, b, target = self.layout.outputs[c.source], self.layout.inputs[c.target], self.index[c.target[0]]
        source_period, target_period = self.clock.periods[c.source[0]], self.clock.periods[c.target[0]]
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


def _table(rows: list[tuple[int, ...]]) -> np.ndarray:
    return np.array(rows, dtype=np.int64).reshape(-1, len(COLUMNS))
