"""One FMU driven alone, FMI 2.0 or 3.0: for replays, which need no speed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ...fmu.types import function_type
from ...participant.opening import load


class LoneFmu:
    """A loaded FMU whose scalars are named as in FMI 2.0: the elements of an array are `u[1]`, `u[2]` ..."""

    def __init__(self, path: Path) -> None:
        """Unpack, read and instantiate. Raises FmuError for what is no FMI 2.0 or 3.0 co-simulation FMU."""
        self.path, self.fmu = path, Fmu.open(path)
        self.variables = self.fmu.variables
        self.instance = load(self.fmu, path.stem)

    def initialize(self, stop: float) -> None:
        """Enter initialization mode for a run from time 0 to `stop` [s]."""
        self.instance.enter_initialization(stop)

    def begin(self) -> None:
        """Leave initialization mode."""
        self.instance.exit_initialization()

    def step(self, time: float, size: float) -> None:
        """One communication step [s]."""
        outcome = self.instance.call(f"step from t = {time:.9g} s", self.instance.slave.doStep, time, size)
        if self.fmu.version == 3 and (outcome[1] or (outcome[2] and outcome[3] < time + size)):
            raise FmuError(f"{self.path.name} ended the step from t = {time:.9g} s early, at {outcome[3]:.9g} s")

    def set(self, values: Mapping[str, Any]) -> None:
        """Set scalars of any type; the elements of an array all at once."""
        self.instance.set_all(values)

    def close(self) -> None:
        """Terminate and free the instance; its library stays loaded."""
        self.instance.close()


class Port:
    """Scalars of one type that are exchanged by one call."""

    def __init__(self, lone: LoneFmu, names: Sequence[str]) -> None:
        self.lone, self.names, fmu = lone, names, lone.fmu
        scalars = list(dict.fromkeys(chain.from_iterable(fmu.arrays[name] for name in names)))
        self.references = [fmu.places[name].reference for name in scalars if fmu.places[name].index == 0]
        self.places = [scalars.index(name) for name in names]
        self.values: list[Any] = [fmu.start(name) for name in scalars]
        kind = function_type(fmu.version, fmu.variables[names[0]].type) if names else "Boolean"
        self.setter, self.getter = (getattr(lone.instance.slave, f"{verb}{kind}") for verb in ("set", "get"))

    def put(self, values: Iterable[Any]) -> None:
        """Set them, in the order of the names."""
        for place, value in zip(self.places, values, strict=True):
            self.values[place] = value
        if self.names:
            self.lone.instance.call(f"set {', '.join(self.names)}", self.setter, self.references, self.values)

    def take(self) -> list[Any]:
        """Get them, in the order of the names."""
        if not self.names:
            return []
        count = () if self.lone.fmu.version == 2 else (len(self.values),)
        values = self.lone.instance.call(f"get {', '.join(self.names)}", self.getter, self.references, *count)
        return [values[place] for place in self.places]
