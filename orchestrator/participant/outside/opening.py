"""What a participant that is no FMU does, made of what it declares: one row for each kind of settings."""

from __future__ import annotations

from ...ardupilot.interface import Options
from ...fmu.outside.declared import DeclaredFmu
from ...fmu.outside.links import SharedMemory, Udp
from ...fmu.outside.model import Model
from ...fmu.outside.python_file import PythonCode


def model_of(fmu: DeclaredFmu, name: str) -> Model:
    """The model of a new instance. Raises FmuError or InputError where it cannot be made."""
    if fmu.model is not None:
        return fmu.model(fmu.starts())
    if isinstance(fmu.settings, Options):
        from ..ardusub.model import AutopilotModel

        return AutopilotModel(fmu.starts(), fmu.settings)
    if isinstance(fmu.settings, PythonCode):
        from .python.code import python_model

        return python_model(fmu)
    if isinstance(fmu.settings, Udp | SharedMemory):
        from .link.opening import peer_model

        return peer_model(fmu, name)
    raise TypeError(f"component {name}: nobody knows what to make of {type(fmu.settings).__name__}")
