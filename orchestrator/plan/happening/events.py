"""Events between the instants of a plan: who can have them, who is brought to their instant, and who comes late.

An event acts at the first instant of the component that it touches which is not before it: exactly where that FMU can
vary its step, otherwise when its step is done.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from ...clock import Clock, seconds_text
from ...loop.operations import STEP_ON
from ...system.connection import Connection
from ...system.model import System
from ..exchange import exchanged
from ..schedule.formulas import Choice

Known = frozenset[str]


@dataclass(frozen=True)
class Events:
    """`sources`: components that end a step where they have an event; `stopped`: those that are brought to the instant
    of an event within their step; `late`: all others, and why they are not."""

    sources: tuple[str, ...]
    stopped: tuple[str, ...]
    late: Mapping[str, str]
    watched: tuple[str, ...] = ()  # components at whose instants it is seen whether something has happened by them
    ahead: tuple[str, ...] = ()  # sources that come first to the instants of faster ones, by parts of their steps
    passed: Mapping[str, str] = field(default_factory=dict)  # sources that others pass, and which and why


class Starts:
    """Where in a cycle the steps of each of `count` components begin that an event can stop or end.

    `end` [ticks]: where the cycle ends.
    """

    def __init__(self, rows: np.ndarray, count: int, end: int) -> None:
        steps = np.flatnonzero(rows[:, 0] == STEP_ON)
        own = [steps[rows[steps, 2] == component] for component in range(count)]
        self._rows = [at.tolist() for at in own]
        self._starts = [[*rows[at, 4].tolist(), end] for at in own]

    def behind(self, row: int) -> list[int]:
        """For each component where its first step begins that is not done before operation `row` [ticks]."""
        return [starts[bisect_left(at, row)] for at, starts in zip(self._rows, self._starts, strict=True)]


@dataclass(frozen=True)
class EventRows:
    """Operations that are done at an event, beside those of a cycle.

    `bring`: a step of each component that is stopped, as from the start of the cycle; `form`: what its inputs that
    change between samples are for the step that begins at an instant [ticks of the cycle]; `after`: values along all
    held connections among components that are at one instant, by which these are; `starts`: where steps begin.
    """

    starts: Starts
    bring: Mapping[str, np.ndarray] = field(default_factory=dict)
    form: Mapping[str, Mapping[int, np.ndarray]] = field(default_factory=dict)
    after: Mapping[Known, np.ndarray] = field(default_factory=dict)


def events_of(
    system: System, early: tuple[str, ...], choices: Mapping[Connection, Choice], able: bool
) -> Events | None:
    """What there is of events; None where there can be none. `able`: whether the algorithm goes along with them; where
    it does not, FMUs have none, and those that the system states act at macro steps."""
    sources = tuple(name for name, component in system.components.items() if component.in_events)
    if not sources and not (system.events and able):
        return None
    means = {c.target[0]: c.target[1] for c, choice in choices.items() if choice.transfer == "mean"}
    late: dict[str, str] = {}
    for name, component in system.components.items():
        if name in early:
            late[name] = "its step is done at its beginning"
        elif not component.fmu.can_vary_step:
            late[name] = "its step cannot vary"
        elif name in means and name not in sources:
            late[name] = f"{means[name]} is the mean over its whole step"
    watched = {c.source[0] for c in system.connections if _may_be_event(system, c)}
    watched |= {c.target[0] for c in system.clock_connections if c.target[0] in late}
    watched |= {name for name, c in system.components.items() if name in late and c.series.keys() & c.at_events}
    stopped = tuple(name for name in system.components if name not in late)
    ahead, passed = _first(system, sources, stopped, means)
    return Events(sources, stopped, late, tuple(n for n in system.components if n in watched), ahead, passed)


def _first(
    system: System, sources: Collection[str], stopped: Collection[str], means: Mapping[str, str]
) -> tuple[tuple[str, ...], dict[str, str]]:
    """The sources that are to come first to the instants of others, and those that cannot: others pass them."""
    together, ahead, passed = exchanged(system), list[str](), dict[str, str]()
    for name in sources:
        members = together if name in together else (name,)
        component = system.components[name]
        if component.scheduled or name not in stopped:
            continue
        apart = [other for other in stopped if other not in members]
        faster = [other for other in apart if (system.components[other].period / component.period).denominator != 1]
        reached = _reached(system, members) if faster else set()
        faster = [other for other in faster if other in reached]
        if not faster:
            continue
        averaged = [f"{member}.{means[member]}" for member in members if member in means]
        if averaged:
            passed[name] = f"{', '.join(faster)}, as {averaged[0]} is the mean over its whole step"
        else:
            ahead.append(name)
    return tuple(ahead), passed


def _reached(system: System, names: Collection[str]) -> set[str]:
    """Components to which signals, clocks or events that wait for signals lead from some, near and far."""
    found, waiting = set[str](), list(names)
    links: dict[str, set[str]] = {}
    for c in (*system.connections, *system.clock_connections):
        links.setdefault(c.source[0], set()).add(c.target[0])
    for event in system.events:
        if event.when:
            links.setdefault(event.when.signal[0], set()).update(event.components)
    while waiting:
        new = links.get(waiting.pop(), set()) - found
        found |= new
        waiting += new
    return found


def _may_be_event(system: System, c: Connection) -> bool:
    """Whether a new value at an instant of its source is an event of the target: a discrete input without a clock."""
    target = system.components[c.target[0]]
    sampled = c.target[1] in target.at_events and not target.clocks_of(c.target[1]) and not target.scheduled
    return sampled and not system.components[c.source[0]].in_events


def event_words(events: Events, clock: Clock, order: Sequence[str], together: Collection[str]) -> list[str]:
    """Who has events and how late they act, for the plan; `order`: in which they step, `together`: the group of FMUs
    for Model Exchange."""
    lines = [f"{name} may end a step at an event" for name in events.sources]
    if events.ahead:
        lines.append(f"first to the instants of others, by parts of its steps: {', '.join(events.ahead)}")
    lines += [
        f"{name} is passed by {why}; these see its events at their next instants" for name, why in events.passed.items()
    ]
    for name in events.sources:
        period, before = clock.periods[name], order[: order.index(name)]
        members = together if name in together else (name,)
        earlier = [x for x in before if x in events.stopped and x not in members and clock.periods[x] == period]
        if earlier:
            lines.append(f"{', '.join(earlier)}: before {name} in the order, sees its events at the next instant")
    if events.stopped:
        lines.append(f"brought to the instant of an event: {', '.join(events.stopped)}")
    for name, why in events.late.items():
        delay = seconds_text(clock.seconds(clock.periods[name]))
        lines.append(f"{name} sees events up to {delay} late, at its own instants: {why}")
    return lines
