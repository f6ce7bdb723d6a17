"""Components that get a process of their own by themselves: those that cannot be kept apart in the master's."""

from __future__ import annotations

import os
from dataclasses import replace

from ..errors import InputError
from ..fmu.sharing import imports_late, why_alone
from ..system.component import Component
from ..system.model import System


def with_processes(system: System) -> System:
    """The system, in which no two components meet in one process that must not. Raises InputError where this system
    (Windows) has no such processes."""
    components, here = dict(system.components), dict[str, str]()
    for name, component in system.components.items():
        fmu = component.fmu
        if component.elsewhere:
            continue
        if fmu.own.windows:
            reason = f"its library is for {fmu.own.windows}, which wine runs"
            components[name] = apart(component, reason, system)
            continue
        if component.isolation == "process" or not fmu.is_file:
            continue
        first = here.setdefault(fmu.digest, name)
        reason = imports_late(fmu)
        if not reason and first != name and (why := why_alone(fmu)):
            reason = f"{first} is the same FMU, and {why}"
        if reason:
            components[name] = apart(component, reason, system)
    return replace(system, components=components)


def apart(component: Component, reason: str, system: System) -> Component:
    """A component with a process of its own, and why."""
    if not hasattr(os, "fork"):
        raise InputError(
            f"component {component.name}: {component.fmu.path.name} needs a process of its own, which needs Linux or "
            f"macOS: {reason} ({system.path.name})"
        )
    return replace(component, isolation="process", apart=reason)
