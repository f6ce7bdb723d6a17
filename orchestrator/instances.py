"""Instances by version and by where they run."""

from __future__ import annotations

from .fmi2_instance import Fmi2Instance
from .fmi3_instance import Fmi3Instance
from .fmu.fmu import Fmu
from .instance import Instance
from .loaded import LoadedInstance
from .system.model import Component


def load(fmu: Fmu, name: str) -> LoadedInstance:
    """An instance in this process. Raises FmuError if the FMU refuses."""
    return Fmi2Instance(fmu, name) if fmu.version == 2 else Fmi3Instance(fmu, name)


def start(component: Component) -> Instance:
    """The instance of a component, in a process of its own where the system file says so."""
    if component.isolation == "process":
        from .isolated_instance import IsolatedInstance

        return IsolatedInstance(component.fmu, component.name, float(component.timeout))
    return load(component.fmu, component.name)
