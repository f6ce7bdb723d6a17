"""By which transfer each connection gets its values."""

from __future__ import annotations

from ..clock import Clock, seconds_text
from ..errors import InputError
from ..system.connection import Connection
from ..system.event import broken_inputs, set_inputs
from ..system.model import System
from .order import discrete
from .schedule.formulas import BOTH_ENDS, CHANGING, Choice, choose


def held_by_type(system: System, c: Connection) -> Choice | None:
    """`hold` where an end is no floating-point signal. Raises InputError for another transfer."""
    if c.target[1] in system.components[c.target[0]].at_events:
        if c.transfer not in ("", "hold"):
            raise InputError(
                f"connection {c.label}: {'.'.join(c.target)} is set at events only, so '{c.transfer}' has no meaning; "
                f"take 'hold' {c.where}"
            )
        clocks = system.components[c.target[0]].clocks_of(c.target[1])
        when = f"at the ticks of {' and '.join(clocks)}" if clocks else "at the events of its component"
        return Choice("hold", f"sampled {when}")
    return None if system.is_real(c) else _held(system, c)


def _held(system: System, c: Connection) -> Choice:
    """What is no floating-point signal has nothing between its values."""
    name, variable = c.target if system.components[c.source[0]].fmu.is_real(c.source[1]) else c.source
    kind = system.components[name].fmu.variables[variable].type
    if c.transfer not in ("", "hold"):
        raise InputError(
            f"connection {c.label}: a {kind} is held, '{c.transfer}' has no meaning for it; take 'hold' {c.where}"
        )
    return Choice("hold", f"a {kind} is held")


def by_rates(
    system: System, clock: Clock, connection: Connection, samplers: tuple[str, ...], leaders: tuple[str, ...]
) -> Choice:
    """As stated, or by the ratio of the rates. Raises InputError where a stated one has no meaning."""
    source, target = (clock.periods[end[0]] for end in (connection.source, connection.target))
    sampled = [discrete(system, end) for end in (connection.source, connection.target)]
    choice = choose(connection.transfer, source, target, *sampled)
    sampler = next((end[0] for end in (connection.source, connection.target) if end[0] in samplers), None)
    if sampler and (choice.transfer != "hold" or choice.former):
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
    if choice.transfer == "interpolate" and source < target:
        raise InputError(
            f"connection {connection.label}: 'interpolate' needs a source that is no faster than the target "
            f"({seconds_text(clock.seconds(source))} against {seconds_text(clock.seconds(target))}); "
            f"take 'mean' {connection.where}"
        )
    return _with_leaders(connection, choice, leaders)


def _with_leaders(c: Connection, choice: Choice, leaders: tuple[str, ...]) -> Choice:
    """What changes where one end steps first."""
    source, target = c.source[0], c.target[0]
    if source in leaders and not c.transfer and choice.transfer == "hold":
        return Choice("hold", f"{source} steps first: held at its value as the step begins", "interpolate")
    if target in leaders and source not in leaders and choice.transfer == "mean":
        if c.transfer:
            raise InputError(
                f"connection {c.label}: {target} steps before {source} (its outputs are interpolated), so there is no "
                f"'mean' yet; take 'linear' or 'hold' {c.where}"
            )
        return Choice("hold", f"{target} steps first (its outputs are interpolated), so there is no mean yet", "linear")
    return choice


def rereads_of(system: System, choices: dict[Connection, Choice]) -> dict[str, str]:
    """Components whose outputs are read at the beginning of a step too, behind its inputs, and the reason."""
    found: dict[str, str] = {}
    changing: dict[str, list[str]] = {}  # inputs that change between the ends of two steps, by component
    for c, choice in choices.items():
        if choice.transfer in CHANGING:
            changing.setdefault(c.target[0], []).append(c.target[1])
    for name, component in system.components.items():
        tables = [variable for variable, series in component.series.items() if not series.sampled]
        if tables:
            changing.setdefault(name, []).extend(tables)
    for key in (*set_inputs(system.events), *broken_inputs(system.events)):
        changing.setdefault(key[0], []).append(key[1])
    answers = {name: system.components[name].fmu.feedthrough() for name in changing}
    for c, choice in choices.items():
        name, output = c.source
        if choice.transfer in BOTH_ENDS and name in changing and name not in found:
            at_once = next((variable for variable in changing[name] if variable in answers[name][output]), "")
            if at_once:
                found[name] = f"{output} depends at once on {at_once}, which changes between the ends of two steps"
    return found
