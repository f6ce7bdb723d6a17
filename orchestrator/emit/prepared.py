"""A system made ready to be written as C: planned so that all of it can be seen, its FMUs taken apart."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from math import lcm
from pathlib import Path

from ..clock import common_tick
from ..fmu.types import BINARY, TEXT
from ..plan.plan import Plan
from ..run.planned import planned
from ..system.model import System
from .code.exchange import Key
from .code.exposed import exposed
from .code.names import identifiers
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


def plan_for_c(system: System) -> Plan:
    """The plan of a system that shows all outputs, its hyperperiod whole. Raises InputError for what C cannot hold."""
    check_system(system)
    names = [
        f"{name}.{variable}"
        for name, component in system.components.items()
        for variable in (*component.fmu.names("output"), *component.fmu.names("input"))
        if (kind := component.fmu.type_of(variable)) is not None and kind.code not in (TEXT, BINARY)
    ]
    kept = [name for name in system.record if "*" not in name and "?" not in name]
    every = replace(system, record=tuple(dict.fromkeys([*names, *kept])), events=())
    periods = [c.period for c in every.components.values()]
    tick = common_tick(periods)
    whole = tick * lcm(*(int(period / tick) for period in periods))
    if every.stop - every.start < whole:
        every = replace(every, stop=every.start + whole)
    plan = planned(every)
    check_plan(plan)
    return plan


@contextmanager
def prepared(system: System) -> Iterator[Prepared]:
    """The C of a system, while its folder of work is there. Raises InputError, FmuError."""
    plan = plan_for_c(system)
    target = here()
    fmus = {c.fmu.own.digest: c.fmu.own for c in plan.system.components.values()}
    own = [identifiers([system.name])[0], *plan.system.components]
    prefixes = dict(zip(fmus, identifiers((fmu.path.stem for fmu in fmus.values()), own), strict=True))
    with tempfile.TemporaryDirectory(prefix="rovbrush_emit_") as work:
        units = units_of(plan.system.components, prefixes, Path(work), target)
        yield Prepared(plan, units, code_of(plan, units, exposed(plan), solutions(plan)))


def solutions(plan: Plan) -> dict[Key, float]:
    """The inputs of loops at the start as `run` finds them; FMUs are loaded only if there is a loop."""
    looped = [c for block in plan.start if block.loop for c in block.connections if plan.system.is_real(c)]
    if not looped:
        return {}
    from ..run.session import Session

    with Session(plan) as session:
        return {c.target: float(session.memory.z[plan.layout.inputs[c.target]]) for c in looped}
