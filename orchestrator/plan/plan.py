"""System -> plan: rates, transfers, order and the list of operations, as data that can be printed and executed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..clock import make_clock
from ..system.model import System
from ..system.series import check_series
from .algorithms.ecco import AdaptiveSchedule, adaptive_clock, add_times
from .algorithms.iterated import IteratedSchedule, add_unknowns
from .bond_energy import bond_energies, check_names
from .capabilities import check_capabilities
from .design import Design
from .layout import make_groups, make_layout
from .order import check_leaders, leaders_of, order_of, samplers_of
from .schedule import Schedule
from .start import start_order
from .transfers import choices_of, rereads_of


@dataclass(frozen=True)
class Plan(Design):
    """What the executor does: `cycle`, over and over until the stop."""

    cycle: np.ndarray
    coefficients: np.ndarray

    @property
    def adaptive(self) -> bool:
        """Whether the macro steps vary; the clock's hyperperiod is the first of them then."""
        return self.system.algorithm == "ecco"


def make_plan(system: System) -> Plan:
    """Plan a system. Raises InputError where periods, stop, transfers or what FMUs can do does not fit."""
    check_capabilities(system)
    if system.algorithm == "ecco":
        clock = adaptive_clock(system)
    else:
        clock = make_clock({name: c.period for name, c in system.components.items()}, system.stop)
    samplers = samplers_of(system) if system.algorithm != "ecco" else ()
    check_series(system, clock)
    leaders = leaders_of(system, samplers)
    choices = choices_of(system, clock, samplers, leaders)
    order, reason = order_of(system, clock)
    check_leaders(choices, leaders, order)
    rereads = rereads_of(system, choices)
    layout = make_layout(system, choices, rereads)
    bonds = bond_energies(system, clock, layout)
    if system.algorithm == "iterated":
        add_unknowns(system, clock, choices, layout)
    if system.algorithm == "ecco":
        add_times(clock, layout)
    check_names(system, layout)
    groups = make_groups(system, clock, layout)
    start = start_order(system)
    design = Design(system, clock, order, reason, choices, samplers, leaders, rereads, layout, bonds, groups, start)
    schedule = {"iterated": IteratedSchedule, "ecco": AdaptiveSchedule}.get(system.algorithm, Schedule)(design)
    cycle = schedule.build()
    return Plan(**vars(design), cycle=cycle, coefficients=np.array(schedule.constants.values))
