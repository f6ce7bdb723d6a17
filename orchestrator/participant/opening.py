"""Instances by version and by where they run."""

from __future__ import annotations

from ..fmu.fmu import Fmu
from ..system.model import Component
from .base import Participant
from .fmi2 import Fmi2Instance
from .fmi3 import Fmi3Instance
from .loaded import LoadedInstance
from .mock import MockFmu


def load(fmu: Fmu, name: str) -> LoadedInstance:
    """An instance in this process. Raises FmuError if the FMU refuses."""
    return Fmi2Instance(fmu, name) if fmu.version == 2 else Fmi3Instance(fmu, name)


def start(component: Component) -> Participant:
    """The instance of a component, in a process of its own where the system file says so."""
    if component.isolation == "process":
        from .isolated.parent import IsolatedInstance

        return IsolatedInstance(component.fmu, component.name, float(component.timeout))
    if isinstance(component.fmu, MockFmu):
        from .mock_instance import MockInstance

        return MockInstance(component.fmu, component.name)
    return load(component.fmu, component.name)
