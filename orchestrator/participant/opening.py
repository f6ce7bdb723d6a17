"""Instances by version and by where they run."""

from __future__ import annotations

import os

from ..fmu.fmu import Fmu
from ..fmu.mock import MockFmu
from ..fmu.sharing import why_alone
from ..system.model import Component
from .apart.library import used_before
from .base import Participant
from .here.fmi1 import Fmi1Instance
from .here.fmi2 import Fmi2Instance
from .here.fmi3 import Fmi3Instance
from .here.loaded import LoadedInstance
from .messages import Logging

KINDS: dict[int, type[LoadedInstance]] = {1: Fmi1Instance, 2: Fmi2Instance, 3: Fmi3Instance}


def load(fmu: Fmu, name: str, logging: Logging = "all", tolerance: float | None = None) -> LoadedInstance:
    """An instance in this process. Raises FmuError if the FMU refuses."""
    return KINDS[fmu.version](fmu, name, logging, tolerance)


def why_not_here(component: Component) -> str:
    """Why a component that was to run in this process cannot; empty if it can."""
    fmu = component.fmu
    if isinstance(fmu, MockFmu) or component.isolation == "process" or not hasattr(os, "fork"):
        return ""
    return why_alone(fmu.own) if used_before(fmu.own) else ""


def start(component: Component) -> Participant:
    """The instance of a component, in a process of its own where the system says so, or where it must not meet what
    was in this one before."""
    wanted = component.logging, component.tolerance
    if component.isolation == "process" or why_not_here(component):
        from .isolated.parent import IsolatedInstance

        return IsolatedInstance(component.fmu, component.name, float(component.timeout), *wanted)
    if isinstance(component.fmu, MockFmu):
        from .mock_instance import MockInstance

        return MockInstance(component.fmu, component.name, component.tolerance)
    return load(component.fmu, component.name, *wanted)
