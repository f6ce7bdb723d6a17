"""System -> plan: rates, transfers, order and the list of operations, as data that can be printed and executed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .capabilities import check_capabilities
from .clock import Clock, make_clock, seconds_text
from .errors import InputError
from .layout import Group, Layout, make_groups, make_layout
from .schedule import Schedule
from .system import Connection, System
from .transfer import Choice, choose


@dataclass(frozen=True)
class Plan:
    """What the executor does: `cycle`, over and over until the stop."""

    system: System
    clock: Clock
    order: tuple[str, ...]
    order_reason: str
    choices: dict[Connection, Choice]
    layout: Layout
    groups: tuple[Group, ...]
    samplers: tuple[str, ...]  # components that step at the beginning of their period: all their inputs are sampled
    cycle: np.ndarray
    coefficients: np.ndarray


def make_plan(system: System) -> Plan:
    """Plan a system. Raises InputError where periods, stop time or transfers do not fit."""
    check_capabilities(system)
    clock = make_clock({name: c.period for name, c in system.components.items()}, system.stop)
    samplers = _samplers(system)
    choices = {c: _choice(system, clock, c, samplers) for c in system.connections}
    order, reason = _order(system, clock)
    layout = make_layout(system, choices)
    groups = make_groups(system, clock, layout)
    schedule = Schedule(system, clock, order, choices, layout, groups, samplers)
    cycle = schedule.build()
    coefficients = np.array(schedule.coefficients)
    return Plan(system, clock, order, reason, choices, layout, groups, samplers, cycle, coefficients)


def _discrete(system: System, end: tuple[str, str]) -> bool:
    return bool(system.components[end[0]].fmu.variables[end[1]].variability == "discrete")


def _samplers(system: System) -> tuple[str, ...]:
    """Components with connected inputs, all of which are sampled (FMI variability `discrete`)."""
    into = {name: [c.target for c in system.connections if c.target[0] == name] for name in system.components}
    return tuple(name for name, ends in into.items() if ends and all(_discrete(system, end) for end in ends))


def _choice(system: System, clock: Clock, connection: Connection, samplers: tuple[str, ...]) -> Choice:
    kind = system.components[connection.source[0]].fmu.type_of(connection.source[1])
    if kind is not None and not kind.real:
        if connection.transfer not in ("", "hold"):
            raise InputError(
                f"connection {connection.label}: a {kind.name} is held, '{connection.transfer}' has no meaning for it; "
                f"take 'hold' {connection.where}"
            )
        return Choice("hold", f"a {kind.name} is held")
    source, target = (clock.periods[end[0]] for end in (connection.source, connection.target))
    sampled = [_discrete(system, end) for end in (connection.source, connection.target)]
    choice = choose(connection.transfer, source, target, *sampled)
    sampler = next((end[0] for end in (connection.source, connection.target) if end[0] in samplers), None)
    if choice.transfer != "hold" and sampler:
        if connection.transfer:
            raise InputError(
                f"connection {connection.label}: {sampler} samples its inputs, so '{choice.transfer}' has no meaning; "
                f"take 'hold' {connection.where}"
            )
        return Choice("hold", f"{sampler} samples its inputs and holds its outputs")
    if choice.transfer == "mean" and source > target:
        raise InputError(
            f"connection {connection.label}: 'mean' needs a source that is no slower than the target "
            f"({seconds_text(clock.seconds(source))} against {seconds_text(clock.seconds(target))}); "
            f"take 'linear' or 'hold' {connection.where}"
        )
    return choice


def _order(system: System, clock: Clock) -> tuple[tuple[str, ...], str]:
    """Faster components first; among equals, a source before its target where the graph allows it."""
    if system.order:
        slower = [
            (a, b) for a, b in zip(system.order, system.order[1:], strict=False) if clock.periods[a] > clock.periods[b]
        ]
        if slower:
            raise InputError(
                f"order: {slower[0][0]} is slower than {slower[0][1]} and must come after it ({system.path.name})"
            )
        return system.order, "stated in the system file"
    waiting, done = sorted(system.components, key=lambda name: clock.periods[name]), []
    while waiting:
        rate = [name for name in waiting if clock.periods[name] == clock.periods[waiting[0]]]
        sources = {
            name: {
                c.source[0]
                for c in system.connections
                if c.target[0] == name and c.source[0] in rate and c.source[0] != name
            }
            for name in rate
        }
        ready = [name for name in rate if not sources[name]] or rate
        done.append(ready[0])
        waiting.remove(ready[0])
    return tuple(done), "fast before slow; at one rate a source before its target, cycles cut in the order of the file"
