"""Where every number of a run lives: signals in one vector of doubles, results in one table per rate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...clock import Clock
from ...fmu.fmu import Fmu
from ...fmu.types import GROUPED
from ...loop.cells import FAULT_CELLS, WATCH_CELLS
from ...loop.solvers.iteration import COLUMN
from ...system.connection import Bond, Connection
from ...system.event import broken_inputs, set_inputs, watched
from ...system.file.recorded import Recorded
from ...system.model import System
from ...system.replace.view import crossings_of
from .formulas import COUNTED, HISTORY, Choice

Key = tuple[str, str]  # component, variable


class Extra(NamedTuple):
    """A signal that the coupling itself makes: its slot, unit, meaning, and the period [ticks] of its table."""

    slot: int
    unit: str
    description: str
    period: int


@dataclass
class Layout:
    """Where every number lives in the run's one vector of doubles."""

    size: int = 0
    outputs: dict[Key, int] = field(default_factory=dict)
    inputs: dict[Key, int] = field(default_factory=dict)
    # Inputs and outputs of a foreign FMU as it has them, where some differ from ours in unit or direction.
    foreign_inputs: dict[Key, int] = field(default_factory=dict)
    foreign_outputs: dict[Key, int] = field(default_factory=dict)
    at_events: set[Key] = field(default_factory=set)  # inputs and outputs that are exchanged there, not by the loop
    previous: dict[Key, int] = field(default_factory=dict)  # an output one period ago
    before: dict[Key, int] = field(default_factory=dict)  # an output two periods ago
    begins: dict[Key, int] = field(default_factory=dict)  # an output read again at the beginning of the step
    # Where events cut steps: an output at its last planned instant, and where the part of a step began.
    samples: dict[Key, int] = field(default_factory=dict)
    parts: dict[Key, int] = field(default_factory=dict)
    part_integrals: dict[Key, int] = field(default_factory=dict)  # of the step that goes on, by the input of the mean
    integrals: dict[Key, int] = field(default_factory=dict)  # by the input that takes the mean
    unknowns: dict[tuple[Key, int], int] = field(default_factory=dict)  # of an iteration: input, step in the cycle
    images: dict[tuple[Key, int], int] = field(default_factory=dict)  # what a pass makes of the unknowns
    last_unknowns: dict[tuple[Key, int], int] = field(default_factory=dict)  # of a shorter last cycle
    last_images: dict[tuple[Key, int], int] = field(default_factory=dict)
    last_counted: int = 0  # how its iteration went, in two cells before its unknowns
    extras: dict[Key, Extra] = field(default_factory=dict)  # recorded whatever the system file says
    faults: dict[tuple[int, Key], int] = field(default_factory=dict)  # first cell: number of the event, input
    watches: dict[int, int] = field(default_factory=dict)  # first cell, by the number of the event
    named: dict[int, str] = field(default_factory=dict)  # any other slot, in words
    loops: dict[int, str] = field(default_factory=dict)  # loops that are solved at an instant, by their first cell
    loop_cells: int = 0  # of the memory of their solver

    def add(self, table: dict[Key, int], key: Key) -> None:
        if key not in table:
            table[key] = self.slot()

    def slot(self, words: str = "") -> int:
        """One more slot."""
        self.size += 1
        if words:
            self.named[self.size - 1] = words
        return self.size - 1

    def extra(self, name: str, unit: str, description: str, period: int) -> int:
        """One more recorded signal, `coupling.name`."""
        self.extras["coupling", name] = Extra(self.slot(), unit, description, period)
        return self.extras["coupling", name].slot

    def loop_memory(self) -> np.ndarray:
        """What the solver of loops begins with: no column of a Jacobian is under way."""
        memory = np.zeros(max(self.loop_cells, 1))
        memory[[first + COLUMN for first in self.loops]] = -1.0
        return memory

    def counted_from(self, key: Key) -> int:
        """The slot of a counter's value at the beginning of the step, or of the part of one, that was done last."""
        return self.parts.get(key, self.previous[key])

    def start(self, key: Key) -> int:
        """The slot of an output's value at the beginning of the step that was done last."""
        return self.begins.get(key, self.parts.get(key, self.previous[key]))

    def exchanged(self, name: str) -> tuple[dict[str, int], dict[str, int]]:
        """Slots of what the loop gives a component and takes, by variable, once all have theirs."""
        return self._exchanged.get(name, ({}, {}))

    @cached_property
    def _exchanged(self) -> dict[str, tuple[dict[str, int], dict[str, int]]]:
        found: dict[str, tuple[dict[str, int], dict[str, int]]] = {}
        for side, (ours, foreign) in enumerate(
            ((self.inputs, self.foreign_inputs), (self.outputs, self.foreign_outputs))
        ):
            for key, slot in self.by_the_loop(ours).items():
                found.setdefault(key[0], ({}, {}))[side][key[1]] = foreign.get(key, slot)
        return found

    def by_the_loop(self, table: Mapping[Key, int]) -> Mapping[Key, int]:
        """The entries of a table without those that are exchanged at events only."""
        return {key: slot for key, slot in table.items() if key not in self.at_events} if self.at_events else table


@dataclass(frozen=True)
class Group:
    """A results table: what is recorded at one period."""

    period: int
    components: tuple[str, ...]
    columns: tuple[Key, ...]
    slots: np.ndarray


def make_layout(
    system: System, choices: dict[Connection, Choice], rereads: dict[str, str], eventful: bool = False
) -> Layout:
    """Outputs and inputs of a component are contiguous, grouped by type, in the order of its description.

    Of an FMI 3 array all elements have a cell where one has: they are set and got together.
    """
    layout, recorded = Layout(), Recorded(system.record)
    used = {c.source for c in system.connections} | {c.counted for c in system.connections if c.counted}
    used |= {key for bond in system.bonds for key in _owns(bond)}
    driven = {c.target for c in system.connections}
    driven |= {(name, variable) for name, c in system.components.items() for variable in c.series}
    driven |= set(changed := set_inputs(system.events))
    seen = set(watched(system.events).values())
    seen |= {(owner, variable) for owner, _, variable in (name.partition(".") for name in system.observed)}
    used |= seen
    for name, component in system.components.items():
        fmu = component.fmu
        locals_ = [v for owner, v in seen if owner == name and fmu.variables[v].causality != "output"]
        others = {e for variable in (*recorded.others(component), *locals_) for e in fmu.arrays[variable]}
        series = component.series.keys() | {variable for owner, variable in changed if owner == name}
        tuned = [v for v in fmu.names("parameter") if series and not series.isdisjoint(fmu.arrays[v])]
        others -= set(tuned)  # they are recorded as what they are given
        read = [v for v, described in fmu.variables.items() if v in others or described.causality == "output"]
        for variable in _by_type(fmu, read):
            keys = [(name, element) for element in fmu.arrays[variable]]
            if variable in others or any(key in used or recorded.has(".".join(key)) for key in keys):
                layout.add(layout.outputs, (name, variable))
        for variable in _by_type(fmu, [*fmu.names("input"), *tuned]):
            if any((name, element) in driven for element in component.fmu.arrays[variable]):
                layout.add(layout.inputs, (name, variable))
    layout.at_events |= {(name, v) for name, component in system.components.items() for v in component.at_events}
    histories = [(c.source, HISTORY.get(choice.transfer, 0)) for c, choice in choices.items()]
    leading = _leading(choices)
    histories += [(c.source, 1) for c in choices if c.source[0] in leading]
    histories += [(c.counted, 1) for c, choice in choices.items() if c.counted and choice.transfer in COUNTED]
    for key, samples in [*histories, *((key, 1) for bond in system.bonds for key in _owns(bond))]:
        if samples > 0:
            layout.add(layout.previous, key)
        if samples > 1:
            layout.add(layout.before, key)
    for key in layout.previous:
        if key[0] in rereads:
            layout.add(layout.begins, key)
        if eventful:
            layout.add(layout.samples, key)
            layout.add(layout.parts, key)
    for connection, choice in choices.items():
        if choice.transfer == "mean":
            layout.add(layout.integrals, connection.target)
            if eventful:
                layout.add(layout.part_integrals, connection.target)
    sides = [
        (by_component(ours), foreign)
        for ours, foreign in ((layout.inputs, layout.foreign_inputs), (layout.outputs, layout.foreign_outputs))
    ]
    for name, component in system.components.items():
        for ours, foreign in sides:
            keys = list(ours.get(name, ()))
            crossings = crossings_of(component.fmu)
            if any(key[1] in crossings and not crossings[key[1]].exact for key in keys):
                for key in keys:
                    layout.add(foreign, key)
    for key, numbers in broken_inputs(system.events).items():
        for number in numbers:
            layout.faults[number, key] = layout.size
            for _ in range(FAULT_CELLS):
                layout.slot(f"fault {system.events[number].name} of {'.'.join(key)}")
    for number in watched(system.events):
        layout.watches[number] = layout.size
        for _ in range(WATCH_CELLS):
            layout.slot(f"crossing of {system.events[number].name}")
    return layout


def by_component(table: Mapping[Key, int]) -> dict[str, dict[Key, int]]:
    """The entries of each component."""
    found: dict[str, dict[Key, int]] = {}
    for key, slot in table.items():
        found.setdefault(key[0], {})[key] = slot
    return found


def _by_type(fmu: Fmu, names: list[str]) -> list[str]:
    """Variables that can be exchanged, by type and sign, and otherwise in the order of the description."""
    typed = [(fmu.type_of(name), name) for name in names]
    known = ((GROUPED[kind.name], fmu.places[name].negated, name) for kind, name in typed if kind)
    return [name for *_, name in sorted(known, key=lambda entry: entry[:2])]


def _leading(choices: dict[Connection, Choice]) -> set[str]:
    """Components that step first: of their other outputs the value at the beginning of their step is needed too."""
    return {c.source[0] for c, choice in choices.items() if choice.transfer == "interpolate"}


def _owns(bond: Bond) -> list[Key]:
    """The outputs whose work a bond counts."""
    names = [bond.impulse or bond.effort[0], bond.displacement or bond.flow[0], bond.effort[0], bond.flow[0]]
    return [(name.partition(".")[0], name.partition(".")[2]) for name in dict.fromkeys(names)]


def make_groups(system: System, clock: Clock, layout: Layout) -> tuple[Group, ...]:
    groups, recorded = [], Recorded(system.record)
    tables = [by_component(layout.outputs), by_component(layout.inputs)]
    for period in sorted({*clock.periods.values(), *(extra.period for extra in layout.extras.values())}):
        members = tuple(name for name in system.components if clock.periods[name] == period)
        slots: dict[Key, int] = {}
        columns: list[Key] = []
        for name in members:
            own = [item for table in tables for item in table.get(name, {}).items() if recorded.has(".".join(item[0]))]
            slots |= own
            columns += [key for key, _ in sorted(own, key=lambda item: item[1])]
        made = {key: extra.slot for key, extra in layout.extras.items() if extra.period == period}
        slots, columns = slots | made, [*columns, *made]
        if not columns:  # nothing of this rate is recorded
            continue
        owners = (*members, *dict.fromkeys(key[0] for key in made))
        groups.append(Group(period, owners, tuple(columns), np.array([slots[key] for key in columns], dtype=np.int64)))
    return tuple(groups)
