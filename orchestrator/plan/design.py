"""What is decided of a run before its operations are listed."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..clock import Clock
from ..fmu.conversions import Conversion
from ..system.connection import Connection
from ..system.inputs.series import Series
from ..system.model import System
from .algorithms.base import Algorithm
from .exchange import CONTINUOUS, exchanged
from .happening.events import Events
from .instants import Instants
from .schedule.bond_energy import BondEnergy
from .schedule.formulas import Choice
from .schedule.layout import Group, Layout
from .start import Block


@dataclass(frozen=True)
class Design:
    """Rates, transfers, order and memory of a run."""

    system: System
    algorithm: Algorithm
    clock: Clock
    order: tuple[str, ...]
    order_reason: str
    choices: dict[Connection, Choice]
    samplers: tuple[str, ...]  # components that step at the beginning of their period: all their inputs are sampled
    leaders: tuple[str, ...]  # components that do so because their outputs are interpolated
    rereads: dict[str, str]  # components whose outputs are read at the beginning of a step too, and why
    layout: Layout
    bonds: tuple[BondEnergy, ...]
    groups: tuple[Group, ...]
    start: tuple[Block, ...]  # the order in which values propagate at time 0
    events: Events | None  # what there is of events; None where there can be none
    instants: Instants  # which held inputs are given the value of their instant
    deadlines: int  # ticks from one instant at which the run waits for the clock on the wall to the next; 0: never

    def into(self, name: str) -> list[Connection]:
        """The connections into a component by which the loop forms inputs; none between FMUs for Model Exchange."""
        return self._into.get(name, [])

    @cached_property
    def exchange(self) -> tuple[str, ...]:
        """The FMUs for Model Exchange, which are stepped as a whole."""
        return exchanged(self.system)

    @cached_property
    def inside(self) -> tuple[Connection, ...]:
        """The connections between these."""
        return tuple(c for c, choice in self.choices.items() if choice.transfer == CONTINUOUS)

    @cached_property
    def _into(self) -> dict[str, list[Connection]]:
        found: dict[str, list[Connection]] = {}
        for c in self.system.connections:
            if self.choices[c].transfer != CONTINUOUS and not self.set_at_events(c):
                found.setdefault(c.target[0], []).append(c)
        return found

    def set_at_events(self, c: Connection) -> bool:
        """Whether the input of a connection is set at events only, by its own clocks or in event mode."""
        return c.target[1] in self.system.components[c.target[0]].at_events

    @cached_property
    def recorded_slots(self) -> np.ndarray:
        """The cells of all recorded signals, of the first table first."""
        return np.concatenate([np.zeros(0, dtype=np.int64), *(group.slots for group in self.groups)])

    @cached_property
    def conversions(self) -> dict[Connection, Conversion]:
        """What becomes of the values of each connection."""
        return {c: self.system.conversion(c) for c in self.system.connections}

    @property
    def early(self) -> tuple[str, ...]:
        """Components whose step is done at its beginning."""
        return (*self.samplers, *self.leaders)


@dataclass
class Constants:
    """The coefficients of operations, each tuple and each table once."""

    values: list[float]
    known: dict[tuple[float, ...], int]
    tables: dict[Series, int] = field(default_factory=dict)

    def at(self, *values: float) -> int:
        """The position at which a tuple of coefficients begins."""
        if values not in self.known:
            self.known[values] = len(self.values)
            self.values.extend(values)
        return self.known[values]

    def table(self, series: Series) -> int:
        """The position at which a table begins."""
        if series not in self.tables:
            self.tables[series] = len(self.values)
            self.values.extend(series.table.tolist())
        return self.tables[series]
