"""What differs between FMI 2.0 and 3.0 in tests of a single component: whole variables and the way to initialize."""

from __future__ import annotations

from typing import Any

from fmpy.model_description import ModelVariable

from ...fmu.fmu import Fmu
from ...participant.loaded import LoadedInstance


def is_fmi3(fmu: Fmu) -> bool:
    """Is it an FMI 3.0 FMU? Their arrays are single variables, and their types have other names."""
    return fmu.version == 3


def whole_variables(fmu: Fmu) -> dict[str, ModelVariable]:
    """Variables as the description has them: an FMI 3.0 array is one."""
    return {v.name: v for v in fmu.description.modelVariables}


def initialize(instance: LoadedInstance, before: Any, inside: Any) -> None:
    """Set parameters by `before`, enter the initialization mode, set inputs by `inside`, leave it at time 0."""
    slave = instance.slave
    if not is_fmi3(instance.fmu):
        instance.call("set up the experiment", slave.setupExperiment)
    before()
    instance.call("enter initialization", slave.enterInitializationMode)
    inside()
    instance.exit_initialization()
