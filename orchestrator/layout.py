"""Where every number of a run lives: signals in one vector of doubles, results in one table per rate."""

from __future__ import annotations

from dataclasses import dataclass, field
from fnmatch import fnmatchcase

import numpy as np

from .clock import Clock
from .fmi_types import GROUPED
from .fmu import Fmu
from .system import Connection, System
from .transfer import Choice


@dataclass
class Layout:
    """Where every number lives in the run's one vector of doubles."""

    size: int = 0
    outputs: dict[tuple[str, str], int] = field(default_factory=dict)
    inputs: dict[tuple[str, str], int] = field(default_factory=dict)
    previous: dict[tuple[str, str], int] = field(default_factory=dict)  # an output one period ago
    integrals: dict[tuple[str, str], int] = field(default_factory=dict)  # by the input that takes the mean
    # Inputs and outputs of a foreign FMU as it has them, where some differ from ours in unit or direction.
    foreign_inputs: dict[tuple[str, str], int] = field(default_factory=dict)
    foreign_outputs: dict[tuple[str, str], int] = field(default_factory=dict)

    def add(self, table: dict[tuple[str, str], int], key: tuple[str, str]) -> None:
        if key not in table:
            table[key] = self.size
            self.size += 1

    def exchanged(self, name: str) -> tuple[dict[str, int], dict[str, int]]:
        """Slots of the inputs and outputs that a component is given and gives, by variable."""
        sides = ((self.inputs, self.foreign_inputs), (self.outputs, self.foreign_outputs))
        found = [{key[1]: {**ours, **foreign}[key] for key in ours if key[0] == name} for ours, foreign in sides]
        return found[0], found[1]


@dataclass(frozen=True)
class Group:
    """A results table: what is recorded at one period."""

    period: int
    components: tuple[str, ...]
    columns: tuple[tuple[str, str], ...]  # (component, variable)
    slots: np.ndarray


def make_layout(system: System, choices: dict[Connection, Choice]) -> Layout:
    """Outputs and inputs of a component are contiguous, grouped by type, in the order of its description.

    Of an FMI 3 array all elements have a cell where one has: they are set and got together.
    """
    layout = Layout()
    used = {c.source for c in system.connections}
    driven = {c.target for c in system.connections}
    for name, component in system.components.items():
        for variable in _by_type(component.fmu, "output"):
            keys = [(name, element) for element in component.fmu.arrays[variable]]
            if any(key in used or _recorded(system, key) for key in keys):
                layout.add(layout.outputs, (name, variable))
        for variable in _by_type(component.fmu, "input"):
            if any((name, element) in driven for element in component.fmu.arrays[variable]):
                layout.add(layout.inputs, (name, variable))
    for connection, choice in choices.items():
        if choice.transfer in ("linear", "mean"):
            layout.add(layout.previous, connection.source)
        if choice.transfer == "mean":
            layout.add(layout.integrals, connection.target)
    for name, component in system.components.items():
        for ours, foreign in ((layout.inputs, layout.foreign_inputs), (layout.outputs, layout.foreign_outputs)):
            keys = [key for key in ours if key[0] == name]
            crossings = [component.fmu.crossings.get(key[1]) for key in keys]
            if any(crossing and not crossing.exact for crossing in crossings):
                for key in keys:
                    layout.add(foreign, key)
    return layout


def _by_type(fmu: Fmu, causality: str) -> list[str]:
    """Variables that can be exchanged, by type, and otherwise in the order of the description."""
    typed = [(fmu.type_of(name), name) for name in fmu.names(causality)]
    return [name for kind, name in sorted(((k, n) for k, n in typed if k), key=lambda entry: GROUPED[entry[0].name])]


def _recorded(system: System, key: tuple[str, str]) -> bool:
    return any(fnmatchcase(".".join(key), pattern.replace("[", "[[]")) for pattern in system.record)


def make_groups(system: System, clock: Clock, layout: Layout) -> tuple[Group, ...]:
    groups = []
    for period in sorted(set(clock.periods.values())):
        members = tuple(name for name in system.components if clock.periods[name] == period)
        slots = {
            key: slot
            for table in (layout.outputs, layout.inputs)
            for key, slot in table.items()
            if key[0] in members and _recorded(system, key)
        }
        columns = tuple(sorted(slots, key=lambda key: (members.index(key[0]), slots[key])))
        groups.append(Group(period, members, columns, np.array([slots[key] for key in columns], dtype=np.int64)))
    return tuple(groups)
