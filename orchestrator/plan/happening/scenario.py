"""Where the events of a system have their place in a plan: what they touch, and the instants at which they can act.

An event acts at its time on a component that can be brought there: a step of it ends there and another one begins. On
others it acts at their first instant that is not before it, which with macro steps is the beginning of one; where their
length varies they end at a time that is known.
The numbers of events (times, values, thresholds, seeds) are no part of the operations: a run has them in its cells.
"""

from __future__ import annotations

from fractions import Fraction
from math import ceil
from typing import TYPE_CHECKING

from ...clock import Clock
from ...errors import InputError
from ...fmu.kinds import MODEL_EXCHANGE
from ...system.event import Event
from ...system.model import System

if TYPE_CHECKING:
    from ..algorithms.base import Algorithm
    from ..design import Design


def check_scenario(system: System, algorithm: Algorithm) -> None:
    """Raise InputError for what an algorithm cannot do, and for inputs that have come to follow a table."""
    for event in system.events:
        for name, variable in event.settings:
            if series := system.components[name].series.get(variable):
                raise InputError(
                    f"event {event.name} sets {name}.{variable}, which follows {series}; remove one of the two "
                    f"{event.where}".rstrip()
                )
        for key in event.fault.values if event.fault else ():
            source, target = (system.components[name].fmu for name, _ in (system.drivers[key].source, key))
            if source.kind == target.kind == MODEL_EXCHANGE:
                raise InputError(
                    f"event {event.name}: {system.drivers[key].label} is solved inside the group of FMUs for Model "
                    "Exchange, where no fault reaches it; break a signal between the group and another component "
                    f"{event.where}".rstrip()
                )
        if event.fault and event.fault.kind == "noise" and not algorithm.takes_noise:
            raise InputError(
                f"event {event.name}: algorithm '{algorithm.name}' judges a step by doing it twice, and noise differs "
                f"between the two; take another algorithm, or another fault {event.where}".rstrip()
            )


def spacing(clock: Clock, algorithm: Algorithm, name: str) -> int:
    """The ticks between the instants at which events can act on a component, or are seen of it; of steps that vary
    what they are whole numbers of."""
    if algorithm.steps_vary:
        return algorithm.even
    return clock.hyperperiod if algorithm.acts_at_macro_steps else clock.periods[name]


def stopped(plan: Design, name: str) -> bool:
    """Whether a component is brought to the instant of an event, wherever that is."""
    return plan.events is not None and name in plan.events.stopped


def acts_at(plan: Design, name: str, time: Fraction) -> Fraction:
    """When something that happens at a time [s] acts on a component [s]: then, or at its next instant, at the start at
    the earliest."""
    clock = plan.clock
    if stopped(plan, name):
        return max(time, clock.seconds(clock.start))
    due = ceil(Fraction(time) / clock.seconds(1)) - clock.start
    between = spacing(clock, plan.algorithm, name)
    instant = max(0, -(-due // between) * between)
    last = clock.stop if instant >= clock.stop and not plan.algorithm.steps_vary else instant
    return clock.seconds(clock.start + last)


def from_start(system: System) -> list[Event]:
    """Events that are there at the start of a run: what they do holds in its initialization too."""
    found = []
    for event in system.events:
        ends = end_of(event, event.at)
        there = event.at is not None and event.at <= system.start and event.initial
        if there and (ends is None or ends > system.start):
            found.append(event)
    return found


def end_of(event: Event, begin: Fraction | None) -> Fraction | None:
    """When the fault of an event that happens at `begin` [s] ends; None: never."""
    if event.lasting is not None and begin is not None:
        return begin + event.lasting
    return event.until


def with_values_from_start(system: System) -> System:
    """The system with the values that events have set when the run begins."""
    for event in from_start(system):
        for name in event.components if event.settings else ():
            own = {variable: value for (owner, variable), value in event.settings.items() if owner == name}
            system = system.with_component(system.components[name].with_values(own))
    return system
