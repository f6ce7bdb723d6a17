"""Where a run counts the energy of its power bonds: the work at both sides, and what the coupling made of it.

Each component that is an end of a bond counts, behind every step, the work of the other's signal as it received it
times its own output: by the trapezoidal rule, or exactly where the system file names an output that counts the
integral (`impulse` of an effort, `displacement` of a flow). Where both components have stepped, the difference of the
two works is what the coupling made.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import lcm

from ...clock import Clock
from ...errors import InputError
from ...system.connection import Bond
from ...system.model import System
from .layout import Key, Layout


@dataclass(frozen=True)
class Side:
    """One end of a bond: `work` grows by the sign times the held input times the rise, or the mean, of the output."""

    component: str
    held: int  # slot of the received input
    own: Key
    counter: bool  # the output is an integral
    work: int  # slot
    sign: float


@dataclass(frozen=True)
class BondEnergy:
    """One bond: the slots of its two works, of what was made in the last step and in total; its period [ticks]."""

    bond: Bond
    sides: tuple[Side, ...]
    flow_side: int
    effort_side: int
    made: int
    total: int
    period: int


def key_of(name: str) -> Key:
    component, _, variable = name.partition(".")
    return component, variable


def slug(bond: Bond) -> str:
    """The bond's name as part of a signal's name: letters, digits and _ only."""
    return re.sub(r"\W+", "_", bond.name)


def bond_energies(system: System, clock: Clock, layout: Layout) -> tuple[BondEnergy, ...]:
    """Slots and signals of all bonds. Raises InputError for names that collide."""
    found = []
    for bond in system.bonds:
        name, ends = slug(bond), [key_of(bond.effort[0])[0], key_of(bond.flow[0])[0]]
        if ("coupling", f"{name}_made") in layout.extras:
            raise InputError(f"two power bonds are called '{bond.name}'; give each its own name ({system.path.name})")
        period = lcm(*(clock.periods[end] for end in ends))
        effort = layout.extra(
            f"{name}_effort_side", "J", f"energy through {bond.name}, as the side of the effort counts", period
        )
        flow = layout.extra(
            f"{name}_flow_side", "J", f"energy through {bond.name}, as the side of the flow counts", period
        )
        made = layout.extra(f"{name}_made", "J", f"energy that the coupling made at {bond.name} in this step", period)
        total = layout.extra(f"{name}_total", "J", f"energy that the coupling made at {bond.name} so far", period)
        pairs = [(bond.effort[1], bond.displacement or bond.flow[0], bool(bond.displacement), flow)]
        if bond.flow[1]:
            pairs.append((bond.flow[1], bond.impulse or bond.effort[0], bool(bond.impulse), effort))
        sides = tuple(
            Side(key_of(own)[0], layout.inputs[key_of(held)], key_of(own), counter, work, bond.sign)
            for held, own, counter, work in pairs
        )
        found.append(BondEnergy(bond, sides, flow, effort, made, total, period))
    return tuple(found)


def check_names(system: System, layout: Layout) -> None:
    """Raise InputError where a component is called as the signals of the coupling are."""
    if layout.extras and "coupling" in system.components:
        raise InputError(
            f"a component may not be called 'coupling' here: the coupling's own signals are "
            f"recorded under that name ({system.path.name})"
        )
