"""What a participant that is no FMU does, made of what it declares: one row for each kind of settings."""

from __future__ import annotations

from ...ardupilot.interface import Options
from ...fmu.outside.declared import DeclaredFmu
from ...fmu.outside.model import Model


def model_of(fmu: DeclaredFmu, name: str) -> Model:
    """The model of a new instance. Raises FmuError or InputError where it cannot be made."""
    if fmu.model is not None:
        return fmu.model(fmu.starts())
    if isinstance(fmu.settings, Options):
        from ..ardusub.model import AutopilotModel

        return AutopilotModel(fmu.starts(), fmu.settings)
    raise TypeError(f"component {name}: nobody knows what to make of {type(fmu.settings).__name__}")
