"""Events of an isolated FMU, on its own side: what its master does at an instant, and what it must know then."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from ...fmu.fmu import Fmu
from ..base import CallError
from ..here.clock_calls import ClockCalls
from ..here.loaded import LoadedInstance
from ..messages import Logging
from ..opening import load_in_events


def eventful(
    fmu: Fmu, name: str, clocks: Mapping[str, str], logging: Logging, tolerance: float | None
) -> LoadedInstance:
    """An instance whose events are handled; `clocks`: intervals that are chosen for it [s]."""
    return load_in_events(
        fmu, name, logging, tolerance, {clock: Fraction(seconds) for clock, seconds in clocks.items()}
    )


# By the name of a method: how it is done with arguments from JSON.
EVENTS: Mapping[str, Callable[..., Any]] = {
    "enter_event_mode": lambda instance: instance.enter_event_mode(),
    "leave_event_mode": lambda instance: instance.leave_event_mode(),
    "happen": lambda instance, now: instance.happen(Fraction(now)),
    "activate": lambda instance, clocks: instance.activate(clocks),
    "ticking": lambda instance, clocks: instance.ticking(clocks),
    "run_next": lambda instance: instance.run_next(),
    "update": lambda instance: instance.update(),
    "known": lambda instance: None,
}


def at_event(instance: LoadedInstance | None, what: str, active: Sequence[str], *arguments: Any) -> Any:
    """A call at an event: its answer, the clocks that tick, the partitions that wait, and the next instant [s].

    `active`: the clocks that tick, as the master knows them.
    """
    if not isinstance(instance, ClockCalls):
        raise CallError(f"{what.replace('_', ' ')} cannot be called of an instance without events")
    instance.active = frozenset(active)
    found = EVENTS[what](instance, *arguments)
    due = instance.events.next_instant()
    waiting = list(getattr(instance, "waiting", ()))
    return [found, sorted(instance.active), waiting, None if due is None else str(due)]
