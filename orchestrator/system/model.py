"""A system: components (FMU, period, values), connections, and what to report of a run. Data only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any

from msgspec import to_builtins

from ..errors import InputError
from ..fmu.conversions import Conversion, conversion_of
from ..fmu.tolerant.rules import Note
from .assigned import Values, assigned
from .component import Component
from .connection import Bond, Connection
from .event import Event
from .schema.keys.live import LiveTable
from .schema.keys.solving import Loops, Solver

FORMATS = (1, 2)  # of system files; of one without `format` a run says what it holds that was extrapolated then


@dataclass(frozen=True)
class Requirement:
    """What an output or parameter must be at time 0, and what to tell if it is not."""

    value: tuple[str, str]
    minimum: float | tuple[str, str]  # a number, or another output or parameter
    maximum: float | tuple[str, str]
    message: str
    otherwise: str = "error"  # or "warning"

    @property
    def names(self) -> list[tuple[str, str]]:
        """All that it looks at."""
        return [self.value, *(bound for bound in (self.minimum, self.maximum) if isinstance(bound, tuple))]


@dataclass(frozen=True)
class ParameterSet:
    """The set of parameters that a system has taken: its name, and what it says of itself."""

    name: str
    description: str = ""

    def __str__(self) -> str:
        return f"{self.name} ({self.description})" if self.description else self.name


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
    loops: Loops = field(default_factory=Loops)  # how loops of direct dependence are solved
    solver: Solver = field(default_factory=Solver)  # how FMUs for Model Exchange are integrated
    bonds: tuple[Bond, ...] = ()
    events: tuple[Event, ...] = ()  # what happens at a time or when a signal crosses a value
    requirements: tuple[Requirement, ...] = ()
    record: tuple[str, ...] = ("*",)
    observed: tuple[str, ...] = ()  # further variables that the loop reads, recorded or not: see `run/stepping/`
    reporting: Mapping[str, Any] = field(default_factory=dict)  # summary, balance, compare, figures, messages
    settings: Mapping[str, Any] = field(default_factory=dict)  # tables of settings of algorithms, as they stand
    start: Fraction = Fraction(0)  # s; the run goes from here to the stop, both are times of the same clock
    strict: bool = False  # an FMU that breaks the standard is an error, also where a run can do without
    format: int = FORMATS[-1]  # of its file: see `FORMATS`
    remarks: tuple[str, ...] = ()  # what the user must know of how its file was taken
    breaches: tuple[Note, ...] = ()  # where its file breaks the standard, and how that was taken
    parameter_set: ParameterSet | None = None
    live: LiveTable | None = None  # the page of a live run
    workers: str = "1"  # how many threads step FMUs: a number, or "auto" for those that pay
    clock_connections: tuple[Connection, ...] = ()  # from a clock to another one that ticks with it

    @property
    def choices(self) -> dict[str, Any]:
        """How it is solved beside its algorithm, as far as that decides the results, ready for JSON."""
        return {"solver": to_builtins(self.solver), "loops": to_builtins(self.loops)}

    @cached_property
    def drivers(self) -> dict[tuple[str, str], Connection]:
        """The connections by the inputs that they drive."""
        return {connection.target: connection for connection in self.connections}

    def is_real(self, connection: Connection) -> bool:
        """Whether both ends of a connection are floating point."""
        ends = (connection.source, connection.target)
        return all(self.components[name].fmu.is_real(variable) for name, variable in ends)

    def conversion(self, connection: Connection) -> Conversion:
        """What becomes of the values of a connection between two types; see `connections` for what is refused."""
        (a, u), (b, v) = connection.source, connection.target
        source, target = self.components[a].fmu, self.components[b].fmu
        return conversion_of(source.variables[u], source.type_of(u), target.variables[v], target.type_of(v), True)

    def with_values(self, assignments: Mapping[str, object], origin: str) -> System:
        """A copy with `component.variable` set: a parameter, or an input that nothing drives.

        Errors as of `assigned`.
        """
        return self.with_checked(self.checked(assignments, origin))

    def with_checked(self, values: Values) -> System:
        """A copy with values that `checked` has given."""
        changed = {name: self.components[name].with_values(found) for name, found in values.items()}
        return replace(self, components={**self.components, **changed})

    def checked(self, assignments: Mapping[str, object], origin: str) -> Values:
        """Values by component and scalar, from those of `component.variable`. Errors as of `assigned`."""
        return assigned(self, assignments, origin)

    def full_name(self, name: str) -> str:
        """`component.variable`; where there is one component its variables need no prefix."""
        if len(self.components) == 1:
            (component,) = self.components.values()
            own = name.startswith(f"{component.name}.") and component.fmu.expand(name[len(component.name) + 1 :])
            if not own and component.fmu.expand(name):
                return f"{component.name}.{name}"
        return name

    def with_component(self, component: Component) -> System:
        """A copy with a component of the same name in place of another."""
        return replace(self, components={**self.components, component.name: component})

    def require_free(self, name: str, variable: str, origin: str) -> None:
        """Raise InputError for an input that a connection drives."""
        driver = self.drivers.get((name, variable))
        if driver:
            raise InputError(
                f"{origin}: {name}.{variable} is driven by the connection {driver.label}; remove that first"
            )

    def with_periods(self, factor: Fraction) -> System:
        """A copy with every communication period multiplied by `factor`."""
        return replace(
            self, components={name: replace(c, period=c.period * factor) for name, c in self.components.items()}
        )
