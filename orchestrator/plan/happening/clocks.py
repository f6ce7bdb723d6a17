"""Event mode and clocks of a system: who uses it, what ticks with what, and what contradicts itself before time 0."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from ...clock import seconds_text
from ...errors import InputError
from ...fmu.kinds import CO_SIMULATION, MODEL_EXCHANGE
from ...fmu.reading.clocks import ClockVariable, require_clocks
from ...system.component import Component
from ...system.connection import Connection
from ...system.model import System
from ..exchange import exchanged, has_events

SHOWN = 12  # ticks of a clock that the plan lists


def with_event_mode(system: System, able: bool) -> System:
    """The system in which every component says whether its event mode is used, and every clock that is ours to choose
    has its interval. `able`: whether the algorithm goes along with events.

    Raises InputError or FmuError for clocks that cannot be run so.
    """
    components = {name: _decided(system, component, able) for name, component in system.components.items()}
    if able and has_events(system):
        components |= {name: replace(components[name], in_events=True) for name in exchanged(system)}
    for component in components.values():
        if component.scheduled and not any(c.causality == "input" for c in component.fmu.clocks.values()):
            raise InputError(
                f"component {component.name}: {component.fmu.path.name} has no input clock that would activate a "
                f"partition, so nothing of it would ever run ({system.path.name})"
            )
        if component.in_events and component.fmu.kind != MODEL_EXCHANGE:
            require_clocks(f"component {component.name}: {component.fmu.path.name}", component.fmu.clocks)
    for connection in system.clock_connections:
        components |= _driven(components, connection)
    _check_drivers(system)
    return replace(system, components=components)


def _decided(system: System, component: Component, able: bool) -> Component:
    fmu, name, where = component.fmu, component.name, f"({system.path.name})"
    offered = fmu.version == 3 and fmu.kind == CO_SIMULATION and bool(fmu.interface.hasEventMode)
    needed = component.scheduled or (fmu.version == 3 and fmu.kind == CO_SIMULATION and bool(fmu.clocks))
    why = ""
    if not offered and not component.scheduled:
        why = "it offers none (hasEventMode = false)"
    elif component.event_mode == "off":
        why = 'event_mode = "off"'
    elif not able:
        why = f"algorithm {system.algorithm} does not go along with events; jacobi and gauss-seidel do"
    if why and needed:
        what = "its partitions are" if component.scheduled else f"clock {next(iter(fmu.clocks), '')} is"
        mode = "the run's events" if component.scheduled else "event mode"
        raise InputError(f"component {name}: {what} activated in {mode}, and {why} {where}")
    note = f"{name}: the event mode of {fmu.path.name} is not used: {why}"
    if why and offered and component.event_mode == "offered":
        component = replace(component, notes=(*component.notes, note))
    return replace(component, in_events=(offered or component.scheduled) and not why)


def _driven(components: dict[str, Component], connection: Connection) -> dict[str, Component]:
    """The component at the end of a connection of clocks, with the interval that it takes over, if it takes one.

    Raises InputError for clocks that contradict each other.
    """
    (name, clock), source = connection.target, components[connection.source[0]]
    for end in (source, components[name]):
        if not end.in_events:
            raise InputError(
                f"connection {connection.label}: {end.name} takes no part in events, so its clocks do not tick "
                f"{connection.where}"
            )
    a, b = source.fmu.clocks[connection.source[1]], components[name].fmu.clocks[clock]
    if not b.time_based:
        return {}
    period, own = _interval(source, a), _interval(components[name], b)
    if period is None:
        raise InputError(
            f"connection {connection.label}: {name}.{clock} is a {b.variability} clock, which ticks by its own times; "
            f"{connection.source[0]}.{a.name} ({a.variability}) cannot drive it; a triggered one can be driven "
            f"{connection.where}"
        )
    if own is not None and b.settable and clock not in components[name].clocks:
        own = period
    if own != period or a.shift != b.shift:
        raise InputError(
            f"connection {connection.label}: the clocks contradict each other: {connection.source[0]}.{a.name} ticks "
            f"{_ticks(period, a.shift)}, {name}.{clock} {_ticks(own, b.shift)}; give both the same times, or connect a "
            f"triggered clock {connection.where}"
        )
    return {name: replace(components[name], clocks={**components[name].clocks, clock: period})} if b.settable else {}


def _check_drivers(system: System) -> None:
    """Raise InputError for a clock that two others drive, or one that drives itself."""
    drivers: dict[tuple[str, str], Connection] = {}
    for c in system.clock_connections:
        if c.target in drivers:
            raise InputError(
                f"clock {'.'.join(c.target)} is driven twice: by {drivers[c.target].label} and by {c.label} {c.where}"
            )
        if c.source == c.target:
            raise InputError(f"connection {c.label}: a clock cannot drive itself {c.where}")
        drivers[c.target] = c


def _interval(component: Component, clock: ClockVariable) -> Fraction | None:
    """The period of a clock as it is known before the run."""
    return component.clocks.get(clock.name, clock.known)


def _ticks(period: Fraction | None, shift: Fraction) -> str:
    if period is None:
        return "by what its FMU says"
    return f"every {seconds_text(period)}" + (f" from {seconds_text(shift)} on" if shift else "")


def clock_words(system: System, span: Fraction) -> Iterator[str]:
    """Every clock that takes part, and when it ticks: the ticks of the first `span` [s] where they are known."""
    driven = {c.target: c for c in system.clock_connections}
    for component in system.components.values():
        if not component.in_events:
            continue
        for clock in dict.fromkeys(component.fmu.own.clocks.values()):
            label = f"{component.name}.{clock.name}"
            driver = driven.get((component.name, clock.name))
            period = _interval(component, clock)
            if driver is not None and not clock.time_based:
                yield f"{label} ticks with {'.'.join(driver.source)}"
            elif clock.causality != "input":
                yield f"{label} ticks when {component.name} says so"
            elif not clock.time_based:
                yield f"{label} never ticks: no clock drives it"
            elif period is not None:
                yield f"{label} ticks {_ticks(period, clock.shift)}: {_listed(system.start, period, clock.shift, span)}"
            elif clock.periodic:
                yield f"{label} ticks at a period that {component.name} tells in its initialization"
            else:
                yield f"{label} ticks at times that {component.name} tells as it goes ({clock.variability})"


def _listed(start: Fraction, period: Fraction, shift: Fraction, span: Fraction) -> str:
    """The ticks of the first `span` [s], as exact times."""
    count = max(int((span - shift) / period) + 1, 1)
    shown = [seconds_text(start + shift + k * period) for k in range(min(count, SHOWN))]
    return ", ".join(shown) + (f" ... ({count} of them in {seconds_text(span)})" if count > SHOWN else "")
