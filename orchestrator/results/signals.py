"""The recorded signals of a run, by name: their own time grid, values and unit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..clock import Clock
from ..errors import InputError, nearest
from ..fmu.types import decode
from ..loop.texts import Texts
from ..plan.plan import Plan
from .tables import Run


@dataclass(frozen=True)
class Signal:
    """One recorded variable: time [s] and values, both of shape (rows,).

    Values have the variable's own type: floating point, whole numbers, truth values, or texts and bytes (as objects).
    """

    name: str
    unit: str
    description: str
    time: np.ndarray
    values: np.ndarray

    @property
    def label(self) -> str:
        return label(self.name, self.unit)

    def mean(self, begin: float, end: float) -> float:
        """Time average between two instants inside the run, by the trapezoidal rule; a value where they coincide."""
        if len(self.time) < 2 or end <= begin:
            return float(self.values[-1])
        t = self.time
        if begin == t[0] and end == t[-1] and np.all(t[1:] > t[:-1]):  # these bits are those of the interpolation
            return float(np.trapezoid(self.values, t) / (end - begin))
        inside = (self.time > begin) & (self.time < end)
        t = np.concatenate([[begin], self.time[inside], [end]])
        return float(np.trapezoid(np.interp(t, self.time, self.values), t) / (end - begin))


class Signals:
    """All signals of a run; `signals["motor.torque"]`."""

    def __init__(self, run: Run) -> None:
        self.run = run
        self._times: dict[int, np.ndarray] = {}

    @property
    def places(self) -> dict[str, tuple[int, int]]:
        """Group and column of every recorded variable."""
        return self.run.plan.places

    def times(self, group: int) -> np.ndarray:
        """The instants of a group [s], each exact to the last bit."""
        if group not in self._times:
            self._times[group] = instants(self.run.plan.clock, self.run.ticks_of(group))
        return self._times[group]

    def __getitem__(self, name: str) -> Signal:
        if name not in self.places:
            raise InputError(f"no recorded signal '{name}'{nearest(name, self.places)}")
        group, column = self.places[name]
        component, _, variable = name.partition(".")
        run = self.run
        if isinstance(run.recorded, list):
            values = typed(run.plan, (component, variable), run.recorded[group][:, column], run.texts)
        else:
            values = run.recorded.values(group, column)
        return Signal(name, *self.about(name), self.times(group), values)

    def about(self, name: str) -> tuple[str, str]:
        """Unit and description of a recorded variable."""
        return about(self.run.plan, name)

    def is_bytes(self, name: str) -> bool:
        """Whether a signal is a Binary variable."""
        component, _, variable = name.partition(".")
        owner = self.run.plan.system.components.get(component)
        return owner is not None and owner.fmu.variables[variable].type == "Binary"

    def __contains__(self, name: str) -> bool:
        return name in self.places


def about(plan: Plan, name: str) -> tuple[str, str]:
    """Unit and description of a variable that can be recorded."""
    component, _, variable = name.partition(".")
    extra = plan.layout.extras.get((component, variable))
    if extra:
        return extra.unit, extra.description
    fmu = plan.system.components[component].fmu
    v, kind = fmu.variables[variable], fmu.type_of(variable)
    return (v.unit or "1" if kind is None or kind.real else ""), v.description or ""


def label(name: str, unit: str) -> str:
    """A signal as it is called above a column."""
    return f"{name} [{unit}]" if unit else name


def instants(clock: Clock, ticks: np.ndarray) -> np.ndarray:
    """The times [s] of instants; bitwise `clock.time`, as all these numbers are below 2**53."""
    return (ticks + clock.start) * clock.numerator / clock.denominator


def typed(plan: Plan, key: tuple[str, str], cells: np.ndarray, texts: Texts | None) -> np.ndarray:
    """Recorded cells of a variable in its own type; texts and bytes as objects."""
    if key in plan.layout.extras:
        return cells
    fmu = plan.system.components[key[0]].fmu
    kind = fmu.type_of(key[1])
    values = cells if kind is None else decode(kind, cells)
    if fmu.variables[key[1]].type == "String" and texts is not None:
        known = {number: texts.text(number) for number in np.unique(values).tolist()}
        values = np.array([known[number] for number in values.tolist()], dtype=object)
    if fmu.variables[key[1]].type == "Binary" and texts is not None:
        content = {number: texts.bytes(number) for number in np.unique(values).tolist()}
        found = np.empty(len(values), dtype=object)
        found[:] = [content[number] for number in values.tolist()]
        return found
    return values
