"""System -> plan: rates, transfers, order and the list of operations, as data that can be printed and executed."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from functools import cached_property

import numpy as np

from ..clock import require_span
from ..system.inputs.series import check_series
from ..system.model import System
from .algorithms.registry import algorithm_of
from .at_once import Together, together_of
from .capabilities import check_capabilities, check_last_step
from .deadlines import deadlines_of
from .design import Design
from .exchange import check_solver, continuous, with_one_period
from .happening.clocks import with_event_mode
from .happening.events import EventRows, events_of
from .happening.scenario import check_scenario
from .instants import Instants
from .order import check_leaders, leaders_of, order_of
from .processes import with_processes
from .schedule.bond_energy import bond_energies, check_names
from .schedule.event_rows import event_rows
from .schedule.layout import make_groups, make_layout
from .start import start_order
from .transfers import held_by_type, rereads_of


@dataclass(frozen=True)
class Plan(Design):
    """What the executor does: `cycle`, over and over, and `last` for what is left before the stop, if anything is."""

    cycle: np.ndarray
    last: np.ndarray
    coefficients: np.ndarray
    at_events: EventRows
    at_last_events: EventRows  # in `last`
    together: Together = field(default_factory=Together)  # who can be stepped at once, where there are workers

    @cached_property
    def places(self) -> dict[str, tuple[int, int]]:
        """Group and column of every recorded variable."""
        return {".".join(key): (g, k) for g, group in enumerate(self.groups) for k, key in enumerate(group.columns)}

    @property
    def adaptive(self) -> bool:
        """Whether the macro steps vary; the clock's hyperperiod is the first of them then."""
        return self.algorithm.steps_vary

    @property
    def cycle_ticks(self) -> int:
        """Ticks of a cycle; 0 where its length is the loop's choice."""
        return 0 if self.adaptive else self.clock.hyperperiod

    def operations(self, cycle: int) -> np.ndarray:
        """What is done in a cycle; the last one may be a shorter one."""
        return self.cycle if self.adaptive or cycle < self.clock.cycles else self.last

    def instants_of(self, group: int, first: int, count: int) -> np.ndarray:
        """The instants [ticks] of some rows of a table, where steps do not vary; the last one is the stop."""
        return np.minimum(self.groups[group].period * np.arange(first, first + count), self.clock.stop)

    def short_steps(self) -> dict[str, int]:
        """The lengths [ticks] of last steps that are shorter than the others, by component."""
        if self.adaptive:
            return {}
        rests = {name: self.clock.stop % period for name, period in self.clock.periods.items()}
        return {name: rest for name, rest in rests.items() if rest}


def make_plan(system: System, deadlines: str | None = None) -> Plan:
    """Plan a system; `deadlines`: one that keeps pace with the clock on the wall, see `deadlines_of`.

    Raises InputError where periods, stop, transfers, settings or what FMUs can do does not fit."""
    system = with_one_period(with_processes(system))
    require_span(system.start, system.stop)
    algorithm = algorithm_of(system)
    system = with_event_mode(system, algorithm.takes_events)
    algorithm.check(system)
    check_scenario(system, algorithm)
    check_solver(system)
    check_capabilities(system)
    clock = algorithm.clock(system)
    if not algorithm.steps_vary:
        check_last_step(system, clock)
    samplers = algorithm.samplers(system)
    check_series(system, clock)
    leaders = leaders_of(system, samplers)
    choices = {
        c: continuous(system, c) or held_by_type(system, c) or algorithm.transfer(system, clock, c, samplers, leaders)
        for c in system.connections
    }
    order, reason = order_of(system, clock)
    check_leaders(choices, leaders, order)
    rereads = rereads_of(system, choices)
    events = events_of(system, (*samplers, *leaders), choices, algorithm.takes_events)
    layout = make_layout(system, choices, rereads, events is not None)
    bonds = bond_energies(system, clock, layout)
    algorithm.extend(system, clock, order, choices, layout)
    check_names(system, layout)
    groups = make_groups(system, clock, layout)
    start = start_order(system)
    instants = Instants(system, choices, (*samplers, *leaders), layout.outputs)
    design = Design(
        system, algorithm, clock, order, reason, choices, samplers, leaders, rereads, layout, bonds, groups, start,
        events, instants, deadlines_of(system, clock, algorithm, deadlines),
    )  # fmt: skip
    schedule = algorithm.schedule(design)
    cycle = schedule.build(clock.hyperperiod)
    at_events = event_rows(schedule, cycle)
    last = schedule.build(clock.rest) if clock.rest and not algorithm.steps_vary else cycle[:0]
    at_last_events = event_rows(schedule, last) if len(last) else at_events
    together = Together()
    if system.workers != "1":
        together, cycle, last = together_of(design, cycle, last)
    decided = {f.name: getattr(design, f.name) for f in fields(Design)}
    return Plan(
        **decided,
        cycle=cycle,
        last=last,
        coefficients=np.array(schedule.constants.values),
        at_events=at_events,
        at_last_events=at_last_events,
        together=together,
    )
