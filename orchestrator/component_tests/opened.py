"""An FMU of version 2.0 or 3.0, opened for tests of a single component, and an instance of it."""

from __future__ import annotations

from collections import deque
from pathlib import Path
from typing import Any

import fmpy
from fmpy import fmi3

from ..errors import FmuError
from ..fmu import Fmu, Instance, fmi_version
from ..unpack import unpack


def open_fmu(path: Path) -> Fmu:
    """Unpack and read a co-simulation FMU. Raises FmuError if it cannot be used, saying why."""
    folder, digest = unpack(path)
    xml = folder / "modelDescription.xml"
    version = fmi_version(path, xml) if xml.is_file() else "2.0"
    if version == "2.0":
        return Fmu.open(path)
    if version != "3.0":
        raise FmuError(f"FMU {path} is of FMI version {version}; export it for FMI 2.0 or 3.0")
    try:
        description = fmpy.read_model_description(str(folder), validate=True)
    except Exception as error:
        raise FmuError(f"FMU {path}: its modelDescription.xml is not valid: {str(error).strip()}") from error
    if description.coSimulation is None:
        raise FmuError(f"FMU {path} has no co-simulation interface; export it for co-simulation")
    name = f"{description.coSimulation.modelIdentifier}{fmpy.sharedLibraryExtension}"
    if not (folder / "binaries" / fmpy.platform_tuple / name).is_file():
        there = sorted(p.name for p in (folder / "binaries").glob("*")) or ["none"]
        raise FmuError(f"FMU {path} has no binary for {fmpy.platform_tuple}; it has {', '.join(there)}")
    return Fmu(path, folder, digest, description)


class Instance3(Instance):
    """A loaded FMI 3.0 instance, with the same guard between its faults and the tests."""

    def __init__(self, fmu: Fmu, name: str) -> None:
        self.fmu, self.name = fmu, name
        self.messages = deque(maxlen=50)
        self.dead, self.made_by_pythonfmu = False, False
        assert fmu.description.coSimulation is not None
        try:
            self.slave = fmi3.FMU3Slave(
                guid=fmu.description.instantiationToken,
                modelIdentifier=fmu.description.coSimulation.modelIdentifier,
                unzipDirectory=str(fmu.folder),
                instanceName=name,
            )
            self.slave.instantiate(loggingOn=True, logMessage=self._log)
        except Exception as error:
            raise FmuError(
                f"component {name}: {fmu.path.name} cannot be instantiated: {error}{self.log_text()}"
            ) from error

    def close(self, terminate: bool = True) -> None:
        """Terminate and free the instance. The library stays loaded."""
        if self.dead:
            return
        try:
            if terminate:
                self.slave.terminate()
            self.slave.fmi3FreeInstance(self.slave.component)
        except Exception as error:
            self.messages.append(f"closing failed: {error}")
        self.dead = True


def new_instance(fmu: Fmu, name: str) -> Instance:
    """An instance in its own FMI version, not yet initialized."""
    return Instance3(fmu, name) if is_fmi3(fmu) else Instance(fmu, name)


def is_fmi3(fmu: Fmu) -> bool:
    """Is it an FMI 3.0 FMU? Their arrays are single variables, and their types have other names."""
    return str(fmu.description.fmiVersion).startswith("3.")


def initialize(instance: Instance, before: Any, inside: Any) -> None:
    """Set parameters by `before`, enter the initialization mode, set inputs by `inside`, leave it at time 0."""
    slave = instance.slave
    if not is_fmi3(instance.fmu):
        instance.call("set up the experiment", slave.setupExperiment)
    before()
    instance.call("enter initialization", slave.enterInitializationMode)
    inside()
    instance.call("exit initialization", slave.exitInitializationMode)
