"""The recorded signals of a run, by name: their own time grid, values and unit."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .errors import InputError, nearest
from .fmi_types import decode
from .simulation import Run


@dataclass(frozen=True)
class Signal:
    """One recorded variable: time [s] and values, both of shape (rows,).

    Values have the variable's own type: floating point, whole numbers, truth values, or texts (as objects).
    """

    name: str
    unit: str
    description: str
    time: np.ndarray
    values: np.ndarray

    @property
    def label(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    def mean(self, begin: float, end: float) -> float:
        """Time average between two instants inside the run, by the trapezoidal rule; a value where they coincide."""
        if len(self.time) < 2 or end <= begin:
            return float(self.values[-1])
        inside = (self.time > begin) & (self.time < end)
        t = np.concatenate([[begin], self.time[inside], [end]])
        return float(np.trapezoid(np.interp(t, self.time, self.values), t) / (end - begin))


class Signals:
    """All signals of a run; `signals["brush.F_z"]`."""

    def __init__(self, run: Run) -> None:
        self.run = run

    @cached_property
    def places(self) -> dict[str, tuple[int, int]]:
        """Group and column of every recorded variable."""
        return {
            ".".join(key): (g, k) for g, group in enumerate(self.run.plan.groups) for k, key in enumerate(group.columns)
        }

    def time(self, group: int) -> np.ndarray:
        """The instants of a group [s], each exact to the last bit."""
        clock = self.run.plan.clock
        return np.array([clock.time(tick) for tick in self.run.ticks[group].tolist()])

    @cached_property
    def times(self) -> list[np.ndarray]:
        return [self.time(group) for group in range(len(self.run.plan.groups))]

    def __getitem__(self, name: str) -> Signal:
        if name not in self.places:
            raise InputError(f"no recorded signal '{name}'{nearest(name, self.places)}")
        group, column = self.places[name]
        component, _, variable = name.partition(".")
        values = self.run.tables[group][:, column]
        extra = self.run.plan.layout.extras.get((component, variable))
        if extra:
            return Signal(name, extra.unit, extra.description, self.times[group], values)
        fmu = self.run.plan.system.components[component].fmu
        v, kind = fmu.variables[variable], fmu.type_of(variable)
        if kind is not None:
            values = decode(kind, values)
        if v.type == "String" and self.run.texts is not None:
            known = {number: self.run.texts.text(number) for number in np.unique(values).tolist()}
            values = np.array([known[number] for number in values.tolist()], dtype=object)
        unit = v.unit or "1" if kind is None or kind.real else ""
        return Signal(name, unit, v.description or "", self.times[group], values)

    def __contains__(self, name: str) -> bool:
        return name in self.places
