"""One FMU driven alone, FMI 2.0 or 3.0, through fmpy: for replays, which need no speed."""

from __future__ import annotations

import copy
import re
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any

import fmpy
from fmpy import fmi3
from fmpy.model_description import ModelVariable

from .crossing import REALS
from .errors import FmuError
from .fmu import Fmu, Instance, fmi_version, parse_value
from .unpack import unpack

SETTERS = {"Enumeration": ("Integer", "Int64")}  # types that are exchanged as another, in FMI 2.0 and 3.0


class LoneFmu:
    """A loaded FMU whose scalars are named as in FMI 2.0: the elements of an array are `u[1]`, `u[2]` ..."""

    def __init__(self, path: Path) -> None:
        """Unpack, read and instantiate. Raises FmuError for what is no FMI 2.0 or 3.0 co-simulation FMU."""
        folder, _ = unpack(path)
        xml = folder / "modelDescription.xml"
        version = fmi_version(path, xml) if xml.is_file() else None
        self.path, self.version = path, 3 if str(version).startswith("3.") else 2
        self.instance: Instance | None = None
        if self.version == 2:
            fmu = Fmu.open(path)
            self.description = fmu.description
            self.instance = Instance(fmu, path.stem)
            self.slave: Any = self.instance.slave
        else:
            self._open_fmi3(folder)
        self.variables: dict[str, ModelVariable] = {}  # by scalar
        self.places: dict[str, tuple[ModelVariable, int]] = {}  # variable and element behind a scalar
        for variable in self.description.modelVariables:
            for element, name in enumerate(_scalars(variable)):
                self.variables[name] = _element(variable, name, element)
                self.places[name] = (variable, element)

    def _open_fmi3(self, folder: Path) -> None:
        try:
            self.description = fmpy.read_model_description(str(folder), validate=True)
        except Exception as error:
            raise FmuError(f"FMU {self.path}: its modelDescription.xml is not valid: {str(error).strip()}") from error
        if self.description.coSimulation is None:
            raise FmuError(f"FMU {self.path} is not for co-simulation; export it for co-simulation")
        identifier = self.description.coSimulation.modelIdentifier
        library = folder / "binaries" / fmpy.platform_tuple / f"{identifier}{fmpy.sharedLibraryExtension}"
        if not library.is_file():
            there = sorted(p.name for p in (folder / "binaries").glob("*")) or ["none"]
            raise FmuError(f"FMU {self.path} has no binary for {fmpy.platform_tuple}; it has {', '.join(there)}")
        try:
            self.slave = fmi3.FMU3Slave(
                guid=self.description.guid, modelIdentifier=identifier, unzipDirectory=str(folder),
                instanceName=self.path.stem,
            )  # fmt: skip
            self.slave.instantiate()
        except Exception as error:
            raise FmuError(f"{self.path.name} cannot be instantiated: {error}") from error

    def call(self, what: str, function: Any, *arguments: Any) -> Any:
        """A call into the FMU; a bad status becomes an FmuError."""
        if self.instance:
            return self.instance.call(what, function, *arguments)
        try:
            return function(*arguments)
        except Exception as error:
            raise FmuError(f"{self.path.name}: cannot {what} ({error})") from error

    def initialize(self, stop: float) -> None:
        """Enter initialization mode for a run from time 0 to `stop` [s]."""
        if self.version == 2:
            self.call("set up the experiment", self.slave.setupExperiment, None, 0.0, stop)
            self.call("enter initialization", self.slave.enterInitializationMode)
        else:
            self.call("enter initialization", self.slave.enterInitializationMode, None, 0.0, stop)

    def begin(self) -> None:
        """Leave initialization mode."""
        self.call("leave initialization", self.slave.exitInitializationMode)

    def step(self, time: float, size: float) -> None:
        """One communication step [s]."""
        outcome = self.call(f"step from t = {time:.9g} s", self.slave.doStep, time, size)
        if self.version == 3 and (outcome[1] or (outcome[2] and outcome[3] < time + size)):
            raise FmuError(f"{self.path.name} ended the step from t = {time:.9g} s early, at {outcome[3]:.9g} s")

    def set(self, values: Mapping[str, Any]) -> None:
        """Set scalars of any type; the elements of an array all at once."""
        kinds: dict[str, list[str]] = {}
        for name in values:
            kinds.setdefault(self.variables[name].type, []).append(name)
        for names in kinds.values():
            Port(self, names).put([values[name] for name in names])

    def close(self) -> None:
        """Terminate and free the instance; its library stays loaded."""
        if self.instance:
            self.instance.close()
        else:
            self.call("terminate", self.slave.terminate)
            self.slave.fmi3FreeInstance(self.slave.component)


class Port:
    """Scalars of one type that are exchanged by one call."""

    def __init__(self, fmu: LoneFmu, names: Sequence[str]) -> None:
        self.fmu, self.names = fmu, names
        whole = {id(v): v for v, _ in (fmu.places[name] for name in names)}
        self.references = [v.valueReference for v in whole.values()]
        scalars = list(chain.from_iterable(_scalars(v) for v in whole.values()))
        self.places = [scalars.index(name) for name in names]
        self.values: list[Any] = [typed(fmu.variables[name], fmu.variables[name].start or 0) for name in scalars]
        kind = next(iter(whole.values())).type if names else "Real"
        if kind in SETTERS:
            kind = SETTERS[kind][fmu.version - 2]
        self.setter, self.getter = (getattr(fmu.slave, f"{verb}{kind}", None) for verb in ("set", "get"))

    def put(self, values: Iterable[Any]) -> None:
        """Set them, in the order of the names."""
        for place, value in zip(self.places, values, strict=True):
            self.values[place] = value
        if self.names:
            self.fmu.call(f"set {', '.join(self.names)}", self.setter, self.references, self.values)

    def take(self) -> list[Any]:
        """Get them, in the order of the names."""
        if not self.names:
            return []
        count = () if self.fmu.version == 2 else (len(self.values),)
        values = self.fmu.call(f"get {', '.join(self.names)}", self.getter, self.references, *count)
        return [values[place] for place in self.places]


def typed(variable: ModelVariable, value: object) -> float | int | bool | str:
    """A value in the type and range of a variable of either version. Raises InputError."""
    kind = variable.type
    known = copy.copy(variable)
    known.type = "Real" if kind in REALS else "Integer" if re.fullmatch(r"U?Int\d+", kind) else kind
    return parse_value(known, value, variable.name)


def _scalars(variable: ModelVariable) -> list[str]:
    """Names of the elements of an FMI 3.0 array, in the order of its values; else the name itself."""
    names = [variable.name]
    if not variable.dimensions:
        return names
    size = 1
    for extent in variable.shape or ():
        size *= extent
    if len(variable.shape or ()) == 1:
        return [f"{variable.name}[{k}]" for k in range(1, size + 1)]
    rows, columns = variable.shape[0], size // variable.shape[0]
    return [f"{variable.name}[{r},{c}]" for r in range(1, rows + 1) for c in range(1, columns + 1)]


def _element(variable: ModelVariable, name: str, element: int) -> ModelVariable:
    scalar = copy.copy(variable)
    scalar.name = name
    if variable.dimensions and variable.start is not None:
        parts = variable.start if isinstance(variable.start, list) else str(variable.start).split()
        scalar.start = parts[element] if len(parts) > element else parts[0]
    if scalar.start is not None and scalar.type in REALS:
        scalar.start = repr(float(scalar.start))
    return scalar
