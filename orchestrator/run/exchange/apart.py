"""The FMUs for Model Exchange of a run that are integrated alone, each in a process of its own."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict

from ...participant.base import Participant
from ...plan.exchange import apart, settings_of
from ...plan.plan import Plan
from ...plan.schedule.layout import Key


def alone(plan: Plan, instances: dict[str, Participant], together: bool) -> list[Participant]:
    """Those that have a process, and so a group, of their own; they are told how they are integrated."""
    found = [instances[name] for name in (*apart(plan.system), *(plan.exchange if not together else ()))]
    for instance in found:
        rests = sampled(plan, [key for key in plan.layout.inputs if key[0] == instance.name])
        instance.solve_by(asdict(settings_of(plan.system)), plan.algorithm.saves_states, rests)
    return found


def sampled(plan: Plan, inputs: Iterable[Key]) -> bool:
    """Whether any of these inputs can be set in event mode only."""
    components = plan.system.components
    return any(components[name].fmu.variables[variable].variability != "continuous" for name, variable in inputs)
