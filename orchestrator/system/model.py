"""A system: components (FMU, period, values), connections, and what to report of a run. Data only."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from ..errors import InputError, nearest
from ..fmu.attributes import parse_value
from ..fmu.fmu import Fmu
from .series import Series

Value = float | int | bool | str


@dataclass(frozen=True)
class Component:
    """One FMU in a system: its communication period [s] and the values it starts with."""

    name: str
    fmu: Fmu
    period: Fraction
    parameters: Mapping[str, Value] = field(default_factory=dict)
    inputs: Mapping[str, Value] = field(default_factory=dict)  # inputs that no connection drives
    series: Mapping[str, Series] = field(default_factory=dict)  # inputs that follow a table
    notes: tuple[str, ...] = ()  # what the user must know of it: see `swap.py`
    isolation: str = ""  # "process": the FMU runs in a process of its own
    timeout: Fraction = Fraction(60)  # s of wall time that a call to that process may take

    def with_value(self, name: str, value: Value) -> Component:
        """A copy with one scalar parameter or input set."""
        if self.fmu.variables[name].causality == "input":
            series = {key: table for key, table in self.series.items() if key != name}
            return replace(self, inputs={**self.inputs, name: value}, series=series)
        return replace(self, parameters={**self.parameters, name: value})

    def with_series(self, name: str, series: Series) -> Component:
        """A copy in which one scalar input follows a table."""
        inputs = {key: value for key, value in self.inputs.items() if key != name}
        return replace(self, inputs=inputs, series={**self.series, name: series})

    def first_inputs(self) -> dict[str, Value]:
        """The inputs that no connection drives, at time 0."""
        found = dict(self.inputs)
        for name, series in self.series.items():
            kind = self.fmu.type_of(name)
            assert kind is not None
            found[name] = series.first(kind)
        return found


@dataclass(frozen=True)
class Connection:
    """One scalar output that drives one scalar input: `target = gain * source + offset` (unit conversion)."""

    source: tuple[str, str]
    target: tuple[str, str]
    transfer: str = ""  # empty: the plan chooses
    gain: float = 1.0
    offset: float = 0.0
    where: str = ""

    @property
    def label(self) -> str:
        return f"{'.'.join(self.source)} -> {'.'.join(self.target)}"


@dataclass(frozen=True)
class Bond:
    """A power bond: effort and flow, each crossing one connection, in opposite directions."""

    name: str
    effort: tuple[str, str]  # output and input, as "component.variable"
    flow: tuple[str, str]  # the input is empty where the other side is not told of the flow
    sign: float
    impulse: str = ""  # an output that counts the time integral of the effort exactly
    displacement: str = ""  # and of the flow
    limit: float = math.inf  # J that the coupling may make or lose over the run
    limit_relative: float = math.inf  # of the energy that the bond carries


@dataclass(frozen=True)
class Requirement:
    """What an output must be at time 0, and what to tell if it is not."""

    value: tuple[str, str]
    minimum: float
    maximum: float
    message: str


@dataclass(frozen=True)
class System:
    """A checked system, ready to be planned."""

    name: str
    path: Path
    description: str
    stop: Fraction
    algorithm: str
    order: tuple[str, ...]
    components: Mapping[str, Component]
    connections: tuple[Connection, ...]
    bonds: tuple[Bond, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    record: tuple[str, ...] = ("*",)
    reporting: Mapping[str, Any] = field(default_factory=dict)  # summary, balance, compare, figures: see results
    settings: Mapping[str, Any] = field(default_factory=dict)  # tables of settings of algorithms, as they stand

    def with_values(self, assignments: Mapping[str, object], origin: str) -> System:
        """A copy with `component.variable` set: a parameter, or an input that nothing drives.

        Raises InputError for an unknown name, a driven input, a wrong type or a value out of range.
        """
        components = dict(self.components)
        tables = {f"{c.name}.{v}": series for c in components.values() for v, series in c.series.items()}
        for key, value in assignments.items():
            name, _, variable = key.partition(".")
            if name not in components:
                raise InputError(f"{origin}: no component '{name}' in '{key}'{nearest(name, components)}")
            component = components[name]
            for scalar, scalar_value in checked_values(component, variable, value, origin).items():
                self.require_free(name, scalar, origin)
                if f"{name}.{scalar}" in tables:
                    followed = tables[f"{name}.{scalar}"].origin
                    raise InputError(f"{origin}: {name}.{scalar} follows {followed}; remove that first")
                component = component.with_value(scalar, scalar_value)
            components[name] = component
        return replace(self, components=components)

    def with_component(self, component: Component) -> System:
        """A copy with a component of the same name in place of another."""
        return replace(self, components={**self.components, component.name: component})

    def require_free(self, name: str, variable: str, origin: str) -> None:
        """Raise InputError for an input that a connection drives."""
        for c in self.connections:
            if c.target == (name, variable):
                raise InputError(
                    f"{origin}: {name}.{variable} is driven by the connection {c.label}; remove that first"
                )

    def with_periods(self, factor: Fraction) -> System:
        """A copy with every communication period multiplied by `factor`."""
        return replace(
            self, components={name: replace(c, period=c.period * factor) for name, c in self.components.items()}
        )


def checked_values(component: Component, name: str, value: object, origin: str) -> dict[str, Value]:
    """`value` for each scalar behind `name` (a list for an array), in type and range. Raises InputError."""
    fmu = component.fmu
    scalars = fmu.expand(name)
    settable = fmu.base_names("parameter", "input")
    if not scalars or fmu.variables[scalars[0]].causality not in ("parameter", "input"):
        kind = fmu.variables[scalars[0]].causality if scalars else "variable"
        what = f"is of causality {kind} and cannot be set" if scalars else "is unknown"
        raise InputError(f"{origin}: {component.name}.{name} {what}{nearest(name, [s for s in settable if s != name])}")
    values = list(value) if isinstance(value, (list, tuple)) else [value] * len(scalars)
    if len(values) != len(scalars):
        raise InputError(f"{origin}: {component.name}.{name} has {len(scalars)} elements, not {len(values)}")
    return {
        scalar: parse_value(fmu.variables[scalar], v, f"{origin}: {component.name}.{scalar}", fmu.type_of(scalar))
        for scalar, v in zip(scalars, values, strict=True)
    }
