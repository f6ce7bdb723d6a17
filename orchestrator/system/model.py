"""A system: components (FMU, period, values), connections, and what to report of a run. Data only."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from msgspec import to_builtins

from ..errors import InputError, nearest
from ..fmu.attributes import parse_value
from ..fmu.conversions import Conversion, conversion_of
from ..fmu.fmu import Fmu
from ..fmu.kinds import MODEL_EXCHANGE, SCHEDULED_EXECUTION
from ..fmu.reading.structure import STRUCTURAL
from ..fmu.tolerant.rules import Note
from ..fmu.types import Value
from ..sockets import TCP
from .event import Event
from .inputs.series import Series
from .schema.keys.live import LiveTable
from .schema.keys.solving import Loops, Solver
from .values import checked_values

Values = Mapping[str, Mapping[str, Value]]  # by component and scalar
FORMATS = (1, 2)  # of system files; of one without `format` a run says what it holds that was extrapolated then


@dataclass(frozen=True)
class Component:
    """One FMU in a system: its communication period [s] and the values it starts with."""

    name: str
    fmu: Fmu
    period: Fraction
    parameters: Mapping[str, Value] = field(default_factory=dict)  # and start values of other variables
    inputs: Mapping[str, Value] = field(default_factory=dict)  # inputs that no connection drives
    series: Mapping[str, Series] = field(default_factory=dict)  # inputs and tunable parameters that follow a table
    notes: tuple[str, ...] = ()  # what the user must know of it: see `replace/`
    isolation: str = ""  # "process": the FMU runs in a process of its own; tcp://host:port: in one of a server there
    token_file: str = ""  # with the token of that server, where it is not that of the environment
    apart: str = ""  # why it is there, where the system does not say so
    logging: Literal["warnings", "all"] = "warnings"  # what the FMU is asked to log
    tolerance: float | None = None  # relative, of its solver; None: that of its default experiment
    timeout: Fraction = Fraction(60)  # s of wall time that a call to that process may take
    direct: str = "stated"  # outputs that answer to inputs at once: those that are stated, "all", or "off"
    event_mode: Literal["offered", "off"] = "offered"  # used where offered; of Model Exchange: outside of steps
    parallel: Literal["allowed", "off"] = "allowed"  # whether it may be stepped on a thread of its own
    in_events: bool = False  # whether it takes part in events by event mode, or by partitions: the plan decides
    clocks: Mapping[str, Fraction] = field(default_factory=dict)  # s, of clocks whose interval is ours to choose

    def require_file(self, purpose: str) -> None:
        """Raise InputError where it is no FMU that another tool could take; `purpose`: what asks for one."""
        if not self.fmu.is_file:
            raise InputError(
                f"component {self.name} is no FMU but a {self.fmu.standard} ({self.fmu.path.name}), and {purpose}"
            )

    @property
    def scheduled(self) -> bool:
        """Whether its partitions are activated by clocks; it makes no steps then."""
        return self.fmu.kind == SCHEDULED_EXECUTION

    @property
    def elsewhere(self) -> bool:
        """Whether a server runs it, on this machine or another one."""
        return self.isolation.startswith(TCP)

    @property
    def choices(self) -> dict[str, Any]:
        """How its FMU is run, as far as that decides the results, ready for JSON."""
        return {
            "kind": self.fmu.kind, "tolerance": self.tolerance, "direct": self.direct, "event_mode": self.event_mode,
            "clocks": {name: str(interval) for name, interval in self.clocks.items()},
        }  # fmt: skip

    @cached_property
    def at_events(self) -> frozenset[str]:
        """The variables that are exchanged in event mode only: clocked ones, inputs that are discrete, and tunable
        parameters."""
        if not self.in_events:
            return frozenset()
        return frozenset(
            name
            for name in self.fmu.names("input", "output", "parameter")
            if self.scheduled
            or self.clocks_of(name)
            or (self.fmu.variables[name].causality == "input" and self.fmu.variables[name].variability != "continuous")
            or (self.fmu.variables[name].causality == "parameter" and self.fmu.variables[name].variability == "tunable")
        )

    def clocks_of(self, name: str) -> tuple[str, ...]:
        """The clocks at whose ticks alone a scalar is exchanged in a run; those of Model Exchange do not tick."""
        return () if self.fmu.kind == MODEL_EXCHANGE else self.fmu.clocks_of(name)

    def with_value(self, name: str, value: Value) -> Component:
        """A copy with one scalar parameter or input set."""
        return self.with_values({name: value})

    def with_values(self, values: Mapping[str, Value]) -> Component:
        """A copy with scalar parameters and inputs set."""
        inputs = {name: v for name, v in values.items() if self.fmu.variables[name].causality == "input"}
        return replace(
            self,
            parameters={**self.parameters, **{name: v for name, v in values.items() if name not in inputs}},
            inputs={**self.inputs, **inputs},
            series={name: table for name, table in self.series.items() if name not in inputs},
        )

    def with_series(self, name: str, series: Series) -> Component:
        """A copy in which one scalar input follows a table."""
        inputs = {key: value for key, value in self.inputs.items() if key != name}
        return replace(self, inputs=inputs, series={**self.series, name: series})

    def first_inputs(self, time: float) -> dict[str, Value]:
        """The inputs that no connection drives, at the start of the run [s]."""
        found = dict(self.inputs)
        for name, series in self.series.items():
            kind = self.fmu.type_of(name)
            assert kind is not None
            found[name] = series.first(kind, time)
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
    rounded: bool = False  # "round": the nearest value of the input's type
    counter: str = ""  # an output of the source's component whose rise is the time integral of the source exactly
    per_second: float = 1.0  # of the source, where the counter rises by 1 in a second

    @property
    def label(self) -> str:
        return f"{'.'.join(self.source)} -> {'.'.join(self.target)}"

    @property
    def counted(self) -> tuple[str, str] | None:
        """The counter that gives the mean, with its component; None where the mean is none of a counter."""
        return (self.source[0], self.counter) if self.counter and self.transfer == "mean" else None


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

        Errors as of `checked`."""
        return self.with_checked(self.checked(assignments, origin))

    def with_checked(self, values: Values) -> System:
        """A copy with values that `checked` has given."""
        changed = {name: self.components[name].with_values(found) for name, found in values.items()}
        return replace(self, components={**self.components, **changed})

    def checked(self, assignments: Mapping[str, object], origin: str) -> Values:
        """Values by component and scalar, from those of `component.variable`: parameters, and inputs that nothing
        drives.

        Raises InputError for an unknown name, a driven input, a wrong type or a value out of range.
        """
        components, values = self.components, dict[str, dict[str, Value]]()
        tables = {f"{c.name}.{v}": series for c in components.values() for v, series in c.series.items()}
        named: dict[tuple[str, str], str] = {}
        for given, value in assignments.items():
            key = self.full_name(given)
            name, _, variable = key.partition(".")
            if "." not in key:
                alone = next(iter(components)) if len(components) == 1 else "component"
                raise InputError(
                    f"{origin} {key}: write {alone}.variable=value{nearest(key, _names_to_set(components))}"
                )
            if name not in components:
                raise InputError(f"{origin}: no component '{name}' in '{key}'{nearest(name, components)}")
            if _same_structure(components[name], variable, value, f"{origin}: {key}"):
                continue
            for scalar, scalar_value in checked_values(components[name], variable, value, origin).items():
                self.require_free(name, scalar, origin)
                if (other := named.setdefault((name, scalar), key)) != key and components[name].fmu.aliases:
                    raise InputError(f"{origin}: {other} and {key} are one variable; give it one value")
                if f"{name}.{scalar}" in tables:
                    followed = tables[f"{name}.{scalar}"].origin
                    raise InputError(f"{origin}: {name}.{scalar} follows {followed}; remove that first")
                values.setdefault(name, {})[scalar] = scalar_value
        return values

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


def _same_structure(component: Component, name: str, value: object, label: str) -> bool:
    """Whether a name is that of a structural parameter; it has its value already. Raises InputError for another."""
    fmu = component.fmu
    own = fmu.main_name(name)
    if own not in fmu.variables or fmu.variables[own].causality != STRUCTURAL:
        return False
    if parse_value(fmu.variables[own], value, label, fmu.type_of(own)) != fmu.start(own):
        raise InputError(
            f"{label} decides sizes of arrays, so it is set where the system is read: under [components."
            f"{component.name}] parameters, with --set, or load(..., values = {{...}})"
        )
    return True


def _names_to_set(components: Mapping[str, Component]) -> list[str]:
    """What can be set, each by its full name."""
    return [f"{c.name}.{v}" for c in components.values() for v in c.fmu.base_names("parameter", "input")]
