"""Instances by version and by where they run."""

from __future__ import annotations

from ..fmu.fmu import Fmu
from ..system.model import Component
from .base import Participant
from .fmi2 import Fmi2Instance
from .fmi3 import Fmi3Instance
from .loaded import LoadedInstance
from .messages import Logging
from .mock import MockFmu


def load(fmu: Fmu, name: str, logging: Logging = "all", tolerance: float | None = None) -> LoadedInstance:
    """An instance in this process. Raises FmuError if the FMU refuses."""
    kind = Fmi2Instance if fmu.version == 2 else Fmi3Instance
    return kind(fmu, name, logging, tolerance)


def start(component: Component) -> Participant:
    """The instance of a component, in a process of its own where the system file says so."""
    wanted = component.logging, component.tolerance
    if component.isolation == "process":
        from .isolated.parent import IsolatedInstance

        return IsolatedInstance(component.fmu, component.name, float(component.timeout), *wanted)
    if isinstance(component.fmu, MockFmu):
        from .mock_instance import MockInstance

        return MockInstance(component.fmu, component.name, component.tolerance)
    return load(component.fmu, component.name, *wanted)
