"""FMUs for Model Exchange in a plan: one group, stepped as a whole, whose connections are solved in each evaluation."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from math import gcd, lcm

from fmpy.model_description import ModelVariable

from ..clock import duration, seconds_text
from ..errors import InputError, counted
from ..fmu.kinds import MODEL_EXCHANGE
from ..fmu.reading.states import state_names
from ..integration.choice import choose
from ..integration.settings import SolverSettings
from ..integration.stiff.libraries import is_there, why_missing
from ..integration.stiff.offered import why_differences
from ..system.connection import Connection
from ..system.event import set_inputs
from ..system.model import System
from .schedule.formulas import Choice
from .start import Block, blocks_of

CONTINUOUS = "continuous"
MOST_ORDER = 5  # of CVODE's formulas


def exchanged(system: System) -> tuple[str, ...]:
    """The members of the group; one with a process of its own is a group by itself, there, unless it is wine's."""
    return tuple(
        name
        for name, component in system.components.items()
        if component.fmu.kind == MODEL_EXCHANGE and (not component.isolation or component.fmu.own.windows)
    )


def apart(system: System) -> tuple[str, ...]:
    """Those with a process, and so a group, of their own."""
    kinds = {name for name, component in system.components.items() if component.fmu.kind == MODEL_EXCHANGE}
    return tuple(name for name in system.components if name in kinds - {*exchanged(system)})


def with_one_period(system: System) -> System:
    """The members step together: all take the largest period of which all theirs are multiples."""
    names = exchanged(system)
    periods = [system.components[name].period for name in names]
    if len(set(periods)) < 2:
        return system
    common = Fraction(gcd(*(p.numerator * (lcm(*(q.denominator for q in periods)) // p.denominator) for p in periods)),
                      lcm(*(q.denominator for q in periods)))  # fmt: skip
    components = dict(system.components)
    for name in names:
        component = components[name]
        if component.period != common:
            note = f"{name} is stepped every {seconds_text(common)}, with the other FMUs for Model Exchange"
            components[name] = replace(component, period=common, notes=(*component.notes, note))
    return replace(system, components=components)


def has_events(system: System) -> bool:
    """Whether anything can happen inside the group, by what its FMUs say of themselves and what they are given."""
    given = {c.target for c in system.connections} | set(set_inputs(system.events))
    seen = {event.when.signal[0] for event in system.events if event.when}
    given |= {(name, variable) for name, component in system.components.items() for variable in component.series}
    for name in exchanged(system):
        component = system.components[name]
        fmu = component.fmu
        stated = fmu.description.numberOfEventIndicators or fmu.interface.needsCompletedIntegratorStep
        if stated or name in seen:
            return component.event_mode != "off"
        if any(v.variability == "discrete" and _may_change(name, v, given) for v in fmu.variables.values()):
            return component.event_mode != "off"
    return False


def located(system: System, signal: tuple[str, str]) -> bool:
    """Whether the solver of the group finds where a signal crosses a value: a double of a member as its FMU has it."""
    name, variable = signal
    component = system.components[name]
    if name not in exchanged(system) or not component.in_events or component.fmu is not component.fmu.own:
        return False
    kind, place = component.fmu.type_of(variable), component.fmu.places[variable]
    return kind is not None and kind.real and kind.size == 8 and place.count == 1 and not place.negated


def _may_change(name: str, variable: ModelVariable, given: Collection[tuple[str, str]]) -> bool:
    return (name, variable.name) in given if variable.causality == "input" else variable.causality != "parameter"


def continuous(system: System, c: Connection) -> Choice | None:
    """The transfer between two members. Raises InputError where another one is stated."""
    names = exchanged(system)
    if c.source[0] not in names or c.target[0] not in names:
        if c.transfer == "interpolate" and c.source[0] in names:
            raise InputError(
                f"connection {c.label}: {c.source[0]} is an FMU for Model Exchange, which steps after all others, so "
                f"its outputs cannot be interpolated; take 'linear' or 'hold' {c.where}"
            )
        return None
    if c.transfer:
        raise InputError(
            f"connection {c.label}: both ends are FMUs for Model Exchange, whose connections are solved at all times; "
            f"leave out '{c.transfer}' {c.where}"
        )
    if at_events(system, c):
        return Choice(CONTINUOUS, "sent at events, when it can change")
    return Choice(CONTINUOUS, "solved in each evaluation of the states")


def at_events(system: System, c: Connection) -> bool:
    """Whether a connection between members is sent at events only: what is no floating-point number, or sampled."""
    target = system.components[c.target[0]].fmu.variables[c.target[1]]
    return not system.is_real(c) or target.variability == "discrete"


def links_of(system: System, choices: Mapping[Connection, Choice]) -> tuple[Block, ...]:
    """The connections inside the group, each behind those that it needs, loops as wholes; what is not stated of an
    output may depend on every input."""
    inside = [c for c, choice in choices.items() if choice.transfer == CONTINUOUS]
    solved = [c for c in inside if not at_events(system, c)]
    answers = {name: system.components[name].fmu.feedthrough() for name in exchanged(system)}
    blocks = blocks_of(solved, answers) if solved else ()
    return (*blocks, *(Block((c,), False) for c in inside if at_events(system, c)))


def check_solver(system: System) -> None:
    """Raise InputError where CVODE is asked for, and is not on this machine."""
    if system.solver.method == "cvode" and (exchanged(system) or apart(system)) and not is_there():
        raise InputError(f'[solver] method = "cvode": {why_missing()}, or take "dormand-prince"')


def settings_of(system: System) -> SolverSettings:
    """What the system says of the solver."""
    s = system.solver
    step, longest = (
        None if span is None else float(duration(span, f"solver.{key}"))
        for key, span in (("step", s.step), ("max_step", s.max_step))
    )
    return SolverSettings(s.method, s.tolerance, step, longest, min(s.max_order, MOST_ORDER), s.restart)


def explained(system: System, goes_back: bool) -> list[str]:
    """How each group is integrated, and why; nothing where there is none. `goes_back`: states are saved at every step,
    and may be restored."""
    together = exchanged(system)
    lines = []
    for names in ([together] if together else []) + [(name,) for name in apart(system)]:
        states = sum(len(state_names(system.components[name].fmu)) for name in names)
        chosen = choose(settings_of(system), states)
        who = f"{', '.join(names)}: {'one group' if len(names) > 1 else 'for model exchange'}"
        more = f"; {_jacobian(system, names)}; {_anew(system, goes_back)}" if chosen.method == "cvode" else ""
        lines.append(f"{who}, {counted(states, 'state')}, integrated by {chosen.method} ({chosen.reason}){more}")
    return lines


def _jacobian(system: System, names: Sequence[str]) -> str:
    """What the Jacobian of a group is made of."""
    numbers = {name: m for m, name in enumerate(names)}
    fmus = [system.components[name].fmu for name in names]
    inside = [c for c in system.connections if c.source[0] in numbers and c.target[0] in numbers]
    sources = [c.source for c in inside if not at_events(system, c)]
    why = why_differences(fmus, [(numbers[name], fmus[numbers[name]].own_name(output)) for name, output in sources])
    if why is None:
        through = " through all connections" if sources else ""
        return f"Jacobian of directional derivatives{through}"
    return f"Jacobian of differences, as {names[why[0]]} {why[1]}"


def _anew(system: System, goes_back: bool) -> str:
    """Where CVODE begins anew, beside events and inputs that change: no saved state holds its history."""
    if goes_back:
        return "begun anew at every step, which may be taken back"
    if system.solver.restart:
        return "begun anew at every communication point"
    return (
        "begun anew at checkpoints, so that a run with them is equal to one without within tolerance, not bit by bit "
        "(it is with restart = true under [solver])"
    )
