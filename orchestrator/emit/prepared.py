"""A system made ready to be written as C: planned so that all of it can be seen, its FMUs taken apart."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from math import lcm
from pathlib import Path

import numpy as np

from ..clock import common_tick, seconds_text
from ..errors import InputError
from ..fmu.types import BINARY, TEXT
from ..plan.happening.scenario import with_values_from_start
from ..plan.plan import Plan
from ..run.planned import planned
from ..system.event import set_inputs
from ..system.model import System
from .carried import as_library
from .code.exchange import Key
from .code.exposed import exposed
from .code.names import file_identifier, identifiers, system_identifier
from .code.text import Code, code_of
from .compiling import here
from .refusals import check_plan, check_system
from .units import Unit, units_of


@dataclass(frozen=True)
class Prepared:
    """A plan, the units of its components by their names, and its C."""

    plan: Plan
    units: dict[str, Unit]
    code: Code


def plan_for_c(system: System, to_its_end: bool = False) -> Plan:
    """The plan of a system that shows all outputs, its hyperperiod whole; `to_its_end`: the end of the run too.

    Raises InputError for what C cannot hold.
    """
    check_system(system)
    names = [
        f"{name}.{variable}"
        for name, component in system.components.items()
        for variable in (*component.fmu.names("output"), *component.fmu.names("input"))
        if (kind := component.fmu.type_of(variable)) is not None and kind.code not in (TEXT, BINARY)
    ]
    names += [".".join(key) for key in set_inputs(system.events)]
    kept = [name for name in system.record if "*" not in name and "?" not in name and not is_text(system, name)]
    every = with_values_from_start(replace(system, record=tuple(dict.fromkeys([*names, *kept]))))
    periods = [c.period for c in every.components.values()]
    tick = common_tick(periods)
    whole = tick * lcm(*(int(period / tick) for period in periods))
    plan = planned(every)
    if every.stop - every.start < whole and not plan.adaptive:
        plan = _with_a_whole_cycle(planned(replace(every, stop=every.start + whole)), plan, to_its_end)
    check_plan(plan)
    return plan


def is_text(system: System, name: str) -> bool:
    """Whether a name is that of a text or of bytes, which have no cells in C."""
    component, _, variable = name.partition(".")
    fmu = system.components[component].fmu if component in system.components else None
    kinds = [fmu.type_of(v) for v in fmu.expand(variable)] if fmu is not None else []
    return any(kind is not None and kind.code in (TEXT, BINARY) for kind in kinds)


def _with_a_whole_cycle(longer: Plan, plan: Plan, to_its_end: bool) -> Plan:
    """The plan of a run that is shorter than its hyperperiod: all of it is what is left behind no cycle."""
    clock, own, system = longer.clock, plan.clock, plan.system
    alike = (clock.numerator, clock.denominator) == (own.numerator, own.denominator) and longer.layout == plan.layout
    if not alike and to_its_end:
        raise InputError(
            f"{system.name} ends at {seconds_text(system.stop)}, between two instants of its rates and before they "
            f"meet ({seconds_text(clock.seconds(clock.hyperperiod))}); choose another stop_time for a program"
        )
    if not alike:
        return replace(longer, system=system)
    last = plan.cycle.copy()
    last[:, -1] += len(longer.coefficients)
    return replace(
        longer, system=system, clock=replace(clock, stop=own.stop), last=last,
        coefficients=np.concatenate([longer.coefficients, plan.coefficients]), at_last_events=plan.at_events,
    )  # fmt: skip


@contextmanager
def prepared(system: System, carries: bool = True) -> Iterator[Prepared]:
    """The C of a system, while its folder of work is there; `carries`: libraries in the place of C that is missing.

    Raises InputError, FmuError.
    """
    plan = plan_for_c(system, to_its_end=not carries)
    target = here()
    fmus = {c.fmu.own.digest: c.fmu.own for c in plan.system.components.values()}
    own = [system_identifier(system.name), *plan.system.components]
    stems = (file_identifier(fmu.path.stem) for fmu in fmus.values())
    prefixes = dict(zip(fmus, identifiers(stems, own), strict=True))
    _require_once(plan.system)
    with tempfile.TemporaryDirectory(prefix="rovbrush_emit_") as work:
        units = units_of(plan.system.components, prefixes, Path(work), target)
        for name, unit in units.items():
            if unit.in_c:
                continue
            if not carries:
                raise InputError(
                    f"component {name} has no C to write: take --fmu, which carries its library, or build it in C "
                    f"(`rovbrush build --native`); {unit.why_not}"
                )
            units[name] = as_library(unit, name, own[0])
        yield Prepared(plan, units, code_of(plan, units, exposed(plan), solutions(plan)))


def _require_once(system: System) -> None:
    """Raise InputError for two components of an FMU of which a process can have one instance only."""
    seen: dict[str, str] = {}
    for name, component in system.components.items():
        fmu = component.fmu.own
        if fmu.interface.canBeInstantiatedOnlyOncePerProcess and fmu.digest in seen:
            raise InputError(
                f"components {seen[fmu.digest]} and {name}: a process can have one instance of {fmu.path.name} only "
                f"(canBeInstantiatedOnlyOncePerProcess); an exported system is one process. Export it as an SSP (--ssp)"
            )
        seen[fmu.digest] = name


def solutions(plan: Plan) -> dict[Key, float]:
    """The inputs of loops at the start as `run` finds them; FMUs are loaded only if there is a loop."""
    looped = [c for block in plan.start if block.loop for c in block.torn if plan.system.is_real(c)]
    if not looped:
        return {}
    from ..run.session.session import Session

    with Session(plan) as session:
        return {c.target: float(session.memory.z[plan.layout.inputs[c.target]]) for c in looped}
