"""A component of a system: an FMU, its period, and the values that it starts with. Data only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, Literal

from ..errors import InputError
from ..fmu.fmu import Fmu
from ..fmu.kinds import MODEL_EXCHANGE, SCHEDULED_EXECUTION
from ..fmu.types import Value
from ..sockets import TCP
from .inputs.series import Series


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
