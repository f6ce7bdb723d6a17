"""One FMU: its description, and a running instance with a guard between its faults and the run.

fmpy reads the description, loads the library and does the calls before and after the loop; inside the loop the FMI
functions are called by their addresses (`calls.py`).
"""

from __future__ import annotations

import ctypes
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import fmpy
from fmpy import fmi2
from fmpy.model_description import ModelDescription, ModelVariable

from .crossing import Crossing
from .errors import FmuError, InputError
from .exit_guard import end_before_library_destructors
from .unpack import unpack

STATUS = {0: "OK", 1: "Warning", 2: "Discard", 3: "Error", 4: "Fatal", 5: "Pending"}


@dataclass(frozen=True)
class Fmu:
    """An unpacked FMI 2.0 co-simulation FMU and what its model description says."""

    path: Path
    folder: Path
    digest: str
    description: ModelDescription
    # Somebody else's FMU in the place of a component: the variables that the system sees, and where they cross.
    presented: tuple[ModelVariable, ...] = ()
    crossings: Mapping[str, Crossing] = field(default_factory=dict)

    @classmethod
    def open(cls, path: Path) -> Fmu:
        """Unpack and read an FMU. Raises FmuError if it is missing, corrupt, or no FMI 2.0 co-simulation FMU."""
        folder, digest = unpack(path)
        xml = folder / "modelDescription.xml"
        if not xml.is_file():
            raise FmuError(f"FMU {path} has no modelDescription.xml; it is not an FMU, or not a complete one")
        version = fmi_version(path, xml)
        if version != "2.0":
            raise FmuError(f"FMU {path} is of FMI version {version}; version 2.0 is needed")
        try:
            description = fmpy.read_model_description(str(folder), validate=True)
        except Exception as error:
            raise FmuError(f"FMU {path}: its modelDescription.xml is not valid: {str(error).strip()}") from error
        if description.coSimulation is None:
            raise FmuError(f"FMU {path} is for model exchange only; export it for co-simulation")
        library = (
            folder
            / "binaries"
            / fmpy.platform
            / f"{description.coSimulation.modelIdentifier}{fmpy.sharedLibraryExtension}"
        )
        if not library.is_file():
            there = sorted(p.name for p in (folder / "binaries").glob("*")) or ["none"]
            raise FmuError(f"FMU {path} has no binary for {fmpy.platform}; it has {', '.join(there)}")
        return cls(path, folder, digest, description)

    @cached_property
    def variables(self) -> dict[str, ModelVariable]:
        """All variables by name; of a foreign FMU those that the system sees (see `swap.py`)."""
        return {v.name: v for v in self.presented or self.description.modelVariables}

    def names(self, *causalities: str) -> list[str]:
        """Names of the variables with one of the causalities, in the order of the description."""
        return [name for name, v in self.variables.items() if v.causality in causalities]

    def expand(self, name: str) -> list[str]:
        """The scalars behind a name: itself, or the elements `name[1]`, `name[2]` ... of an array; [] if unknown."""
        if name in self.variables:
            return [name]
        return [v for v in self.variables if v.startswith(f"{name}[") and v.endswith("]")]

    def base_names(self, *causalities: str) -> list[str]:
        """Names without their element index, for suggestions."""
        return list(dict.fromkeys(name.split("[")[0] for name in self.names(*causalities)))


def fmi_version(path: Path, xml: Path) -> str | None:
    """The version attribute. A document type declaration is refused: it can expand entities or open files."""
    from lxml import etree

    try:
        tree = etree.parse(str(xml), etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False))
    except etree.XMLSyntaxError as error:
        raise FmuError(f"FMU {path}: its modelDescription.xml is not well-formed: {error}") from error
    if tree.docinfo.doctype:
        raise FmuError(f"FMU {path}: its modelDescription.xml has a document type declaration; refused")
    version: str | None = tree.getroot().get("fmiVersion")
    return version


def parse_value(variable: ModelVariable, value: object, label: str) -> float | int | bool | str:
    """A parameter or start value in the variable's type and range. Raises InputError saying what is allowed."""
    unit = f" {variable.unit}" if variable.unit not in (None, "", "1") else ""
    try:
        if variable.type == "String":
            return str(value)
        if variable.type == "Boolean":
            return {"true": True, "1": True, "1.0": True, "false": False, "0": False, "0.0": False}[
                str(value).strip().lower()
            ]
        number = float(str(value))
        if number != number or abs(number) == float("inf"):
            raise ValueError
        if variable.type in ("Integer", "Enumeration") and number != int(number):
            raise ValueError
    except (ValueError, KeyError):
        kind = {"Real": "a finite number", "Boolean": "true or false"}.get(variable.type, "a whole number")
        raise InputError(f"{label} = {value!s} is not {kind}") from None
    low = float(variable.min) if variable.min is not None else -float("inf")
    high = float(variable.max) if variable.max is not None else float("inf")
    if not low <= number <= high:
        raise InputError(f"{label} = {number:g}{unit} is out of range: {low:g} to {high:g}{unit} are allowed")
    return number if variable.type == "Real" else int(number)


class Instance:
    """A loaded FMU instance. After fmi2Fatal it is never called again."""

    def __init__(self, fmu: Fmu, name: str) -> None:
        self.fmu, self.name = fmu, name
        self.messages: deque[str] = deque(maxlen=50)  # an FMU may warn at every step
        self.dead = False
        assert fmu.description.coSimulation is not None
        self.made_by_pythonfmu = (fmu.folder / "resources" / "slavemodule.txt").is_file()
        if self.made_by_pythonfmu:
            end_before_library_destructors()
        self._callbacks = self._make_callbacks()
        try:
            self.slave = fmi2.FMU2Slave(
                guid=fmu.description.guid,
                modelIdentifier=fmu.description.coSimulation.modelIdentifier,
                unzipDirectory=str(fmu.folder),
                instanceName=name,
            )
            self.slave.instantiate(callbacks=self._callbacks, loggingOn=True)  # without it errors arrive without text
        except Exception as error:
            raise FmuError(
                f"component {name}: {fmu.path.name} cannot be instantiated: {error}{self.log_text()}"
            ) from error

    def _make_callbacks(self) -> Any:
        callbacks = fmi2.fmi2CallbackFunctions()
        callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(self._log)
        callbacks.allocateMemory = fmi2.defaultCallbacks.allocateMemory
        callbacks.freeMemory = fmi2.defaultCallbacks.freeMemory
        # The proxy formats the printf arguments of the FMI logger. pythonfmu passes none, but bare messages as the
        # format: an exception whose text holds %s would end the process there.
        if not self.made_by_pythonfmu:
            fmpy.logging.addLoggerProxy(ctypes.byref(callbacks))
        return callbacks

    def _log(self, _environment: Any, _instance: bytes, status: int, _category: bytes, message: bytes) -> None:
        if status > 0 and message:
            text = message.decode("utf-8", "replace").strip()
            self.messages.append(text.replace("%%", "%") if self.made_by_pythonfmu else text)

    def log_text(self) -> str:
        """What the FMU has logged, as the tail of an error message."""
        return "".join(f"\n{message}" for message in dict.fromkeys(self.messages))

    def call(self, what: str, function: Any, *arguments: Any) -> Any:
        """Call before or after the loop; a bad status becomes an FmuError with the FMU's own words."""
        if self.dead:
            raise FmuError(f"component {self.name}: cannot {what} after a fatal error{self.log_text()}")
        try:
            return function(*arguments)
        except Exception as error:
            status = getattr(error, "status", None)
            self.dead = status == 4
            reason = f"fmi2{STATUS.get(status, status)}" if status is not None else str(error)
            raise FmuError(f"component {self.name}: cannot {what} ({reason}){self.log_text()}") from error

    def set(self, name: str, value: float | int | bool | str) -> None:
        """Set one variable by name."""
        v = self.fmu.variables[name]
        if name in self.fmu.crossings and isinstance(value, float):
            value = self.fmu.crossings[name].there(value)
        setter = {"Real": self.slave.setReal, "Boolean": self.slave.setBoolean, "String": self.slave.setString}.get(
            v.type, self.slave.setInteger
        )
        self.call(f"set {name} = {value}", setter, [v.valueReference], [value])

    def get(self, name: str) -> Any:
        """Get one variable by name."""
        v = self.fmu.variables[name]
        getter = {"Real": self.slave.getReal, "Boolean": self.slave.getBoolean, "String": self.slave.getString}.get(
            v.type, self.slave.getInteger
        )
        value = self.call(f"get {name}", getter, [v.valueReference])[0]
        if name in self.fmu.crossings and isinstance(value, float):
            value = self.fmu.crossings[name].back(value)
        return value

    def address(self, function: str) -> int:
        """Address of an FMI function in the loaded library."""
        return ctypes.cast(getattr(self.slave.dll, function), ctypes.c_void_p).value or 0

    def close(self, terminate: bool = True) -> None:
        """Terminate and free the instance. The library stays loaded: unloading one with Python inside is not safe."""
        if self.dead:
            return
        try:
            if terminate:
                self.slave.terminate()
            self.slave.fmi2FreeInstance(self.slave.component)
        except Exception as error:
            self.messages.append(f"closing failed: {error}")
        self.dead = True
