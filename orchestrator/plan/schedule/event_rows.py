"""The operations of an event: components brought to its instant, and values along the connections there."""

from __future__ import annotations

from collections.abc import Collection, Iterator

import numpy as np

from ...loop.operations import AT_ITS_END, COLUMNS, PAUSE, STEP_ON
from ...system.connection import Connection
from ..happening.events import EventRows, Known, Starts
from .schedule import Schedule
from .values import Row


def event_rows(schedule: Schedule, cycle: np.ndarray) -> EventRows:
    """What is done at the events of a cycle that was listed last."""
    events = schedule.design.events
    starts = Starts(cycle, len(schedule.index), schedule.span)
    if events is None:
        return EventRows(starts)
    bring = {name: _table(_bring(schedule, name)) for name in events.stopped}
    form = {name: rows for name in events.stopped if (rows := _form(schedule, name))}
    together = _together(schedule, cycle, starts)
    return EventRows(starts, bring, form, {known: _table(_after(schedule, known)) for known in together})


def _table(rows: Iterator[Row]) -> np.ndarray:
    return np.array(list(rows), dtype=np.int64).reshape(-1, len(COLUMNS))


def _bring(schedule: Schedule, name: str) -> Iterator[Row]:
    """A step of a component from where it is. Inputs that it holds and that are formed where its step ends have not
    been formed yet when the event comes before all that: their cells are those of the step before."""
    for c in _unformed(schedule, name):
        if not schedule.changes(c):
            yield from schedule.now(c, 0)
    yield from schedule.advance(0, name, 0, part=True)


def _unformed(schedule: Schedule, name: str) -> Iterator[Connection]:
    """Into a component, what is formed where its step ends; means are formed of whole steps alone."""
    for c in schedule.design.into(name):
        if not schedule.formed_at_beginning(c) and schedule.design.choices[c].transfer != "mean":
            yield c


def _form(schedule: Schedule, name: str) -> dict[int, np.ndarray]:
    """By where a step of a component begins, the inputs of it that change between the samples of their sources."""
    found: dict[int, np.ndarray] = {}
    leaders, clock = schedule.design.leaders, schedule.clock
    own = [c for c in _unformed(schedule, name) if schedule.changes(c)]
    for start in range(0, schedule.span if own else 0, clock.periods[name]):
        rows: list[Row] = []
        for c in own:
            h, end = clock.periods[c.source[0]], min(start + clock.periods[name], schedule.span)
            sample = min(-(-end // h) * h, schedule.span) if c.source[0] in leaders else start // h * h
            rows.append(schedule.formed(c, start + 1, sample, start))  # from the samples of planned instants
            rows += schedule.broken(c, 0, 0)
        found[start] = _table(iter(rows))
        found[start][:, 1] = 0
    return found


def _together(schedule: Schedule, cycle: np.ndarray, starts: Starts) -> list[Known]:
    """All sets of components that can be at the instant of an event together, or behind it."""
    events, names = schedule.design.events, list(schedule.index)
    assert events is not None
    found: dict[Known, None] = {frozenset(events.stopped): None}
    whole = frozenset(name for name in names if name not in schedule.early)
    found[whole] = None
    for row in np.flatnonzero((cycle[:, 0] == STEP_ON) | (cycle[:, 0] == PAUSE)).tolist():
        if cycle[row, 0] == STEP_ON and names[cycle[row, 2]] not in events.sources:
            continue
        behind = starts.behind(row)
        for instant in {int(cycle[row, 1]), *behind}:
            found[at_instant(behind, names, instant, events.stopped, schedule.early)] = None
    return list(found)


def at_instant(
    starts: list[int], names: Collection[str], instant: int, stopped: Collection[str], early: Collection[str]
) -> Known:
    """Who is at an instant [ticks] or behind it, by where their next steps begin, or is brought there."""
    there = (name for name, start in zip(names, starts, strict=True) if start >= instant and name not in early)
    return frozenset(stopped) | frozenset(there)


def _after(schedule: Schedule, known: Known) -> Iterator[Row]:
    """All held values among some components, set, and what they make of them."""
    design, layout = schedule.design, schedule.layout
    direct = set(design.instants.held)
    for c, choice in design.choices.items():
        meet = {c.source[0], c.target[0]} <= known and not design.set_at_events(c)
        if choice.transfer == "hold" and meet and c not in direct:
            yield from schedule.now(c, 0)
    yield from schedule.settling.afresh(0, known)
    for name in design.order:
        if name in known and (schedule.inputs.get(name)):
            yield from schedule.set_inputs(0, name)
    for name in design.order:
        if name in known and name in schedule.outputs:
            yield from schedule.get(0, name, AT_ITS_END)
    for c in design.inside:
        if c.target[0] in known:
            yield schedule.sent(c, 0, layout.outputs[c.source])
