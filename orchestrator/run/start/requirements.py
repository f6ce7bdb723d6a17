"""What a system requires of the start of a run."""

from __future__ import annotations

from collections.abc import Mapping

from ...errors import InputError
from ...participant.base import Participant
from ...plan.plan import Plan
from ...system.component import Component
from ...system.model import Requirement
from ...units import conversion


def broken_requirements(plan: Plan, instances: Mapping[str, Participant], start: str) -> list[str]:
    """Warnings of those that are not met and let the run go on; `start` is what messages call the start.

    Raises InputError for the first that does not.
    """
    warnings = []
    for requirement in plan.system.requirements:
        if text := _broken(requirement, plan, instances, start):
            if requirement.otherwise == "error":
                raise InputError(text)
            warnings.append(f"warning: {text}")
    return warnings


def _broken(requirement: Requirement, plan: Plan, instances: Mapping[str, Participant], start: str) -> str:
    """What is wrong and where; empty if nothing is."""
    name, variable = requirement.value
    components = plan.system.components
    value = instances[name].get(variable)
    bounds = (requirement.minimum, requirement.maximum)
    least, most = (_limit(bound, requirement, components, instances) for bound in bounds)
    if least <= value <= most:
        return ""
    stated = components[name].fmu.variables[variable].unit
    unit = f" {stated}" if stated not in (None, "", "1") else ""
    whose = [f" ({'.'.join(bound)})" if isinstance(bound, tuple) else "" for bound in bounds]
    return (
        f"{requirement.message}: {name}.{variable} = {value:g}{unit} at {start}, "
        f"allowed are {least:g}{whose[0]} to {most:g}{whose[1]}{unit} ({plan.system.path.name})"
    )


def _limit(
    bound: float | tuple[str, str],
    requirement: Requirement,
    components: Mapping[str, Component],
    instances: Mapping[str, Participant],
) -> float:
    """A bound as a number, in the unit of the value that it bounds."""
    if not isinstance(bound, tuple):
        return bound
    own, wanted = (components[name].fmu.unit(variable) for name, variable in (bound, requirement.value))
    gain, offset = conversion(own, wanted, "require")
    return gain * float(instances[bound[0]].get(bound[1])) + offset
