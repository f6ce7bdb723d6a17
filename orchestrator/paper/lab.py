"""Runs that the claims ask for: each is made once, and each knows the command that repeats it."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..results.files.manifest import plain_value
from ..results.signals import Signals
from ..results.summary.summary import summarize
from ..results.tables import Run, require_complete
from ..run.planned import planned
from ..run.simulation import simulate
from ..system.assemble import assemble


@dataclass(frozen=True)
class Case:
    """A complete run with its signals, its summary and the command that repeats it."""

    run: Run
    signals: Signals
    summary: Mapping[str, Any]
    command: str

    @property
    def window(self) -> tuple[float, float]:
        """The steady window of the summary [s]."""
        begin, end = self.summary["window_s"]
        return begin, end

    def mean(self, name: str) -> float:
        """Mean of a signal over the steady window."""
        return self.signals[name].mean(*self.window)

    def last(self, name: str) -> float:
        """Value of a signal at the end of the run."""
        return float(self.signals[name].values[-1])

    def rise(self, name: str) -> float:
        """Value at the end less the value at time 0."""
        values = self.signals[name].values
        return float(values[-1] - values[0])

    def peak(self, name: str) -> float:
        """Largest magnitude over the run."""
        return float(np.max(np.abs(self.signals[name].values)))

    def parameter(self, name: str) -> float:
        """Value of a scalar parameter, `component.variable`."""
        component, _, variable = name.partition(".")
        part = self.run.plan.system.components[component]
        value = part.parameters.get(variable, plain_value(part.fmu.variables[variable].start))
        return float(value)

    def parameters(self, name: str) -> np.ndarray:
        """Values of an array parameter, (k,)."""
        component, _, variable = name.partition(".")
        names = self.run.plan.system.components[component].fmu.expand(variable)
        return np.array([self.parameter(f"{component}.{scalar}") for scalar in names])

    def calculated(self, name: str, count: int) -> np.ndarray:
        """The first `count` elements of a calculated array parameter."""
        return np.array([self.run.calculated[f"{name}[{k}]"] for k in range(1, count + 1)])


class Lab:
    """Makes runs and remembers them; `used` collects the commands of the runs asked for since it was emptied."""

    def __init__(self, fmus: Path | None = None, report: Callable[[str], None] = lambda _command: None) -> None:
        self.fmus, self.report = fmus, report
        self.used: list[str] = []
        self._cases: dict[str, Case] = {}

    def case(self, system: str, values: Mapping[str, object] | None = None, stop: str = "") -> Case:
        """A run of a shipped system with values set. Raises InputError, FmuError or RunError."""
        command = command_line(system, values or {}, stop)
        if command not in self.used:
            self.used.append(command)
        if command not in self._cases:
            self.report(command)
            run = require_complete(simulate(planned(assemble(system, values or {}, stop, self.fmus))))
            self._cases[command] = Case(run, Signals(run), summarize(run), command)
        return self._cases[command]

    @property
    def cases(self) -> list[Case]:
        """All runs so far."""
        return list(self._cases.values())

    @property
    def parameter_sets(self) -> list[str]:
        """What the sets of all runs so far are called and say of themselves."""
        systems = (case.run.plan.system for case in self.cases)
        return list(dict.fromkeys(str(system.parameter_set) for system in systems if system.parameter_set))

    def stand(self, values: Mapping[str, object] | None = None) -> Case:
        """The test stand for 10 s, touching at the paper's no-load speed: what sensitivities are measured on."""
        return self.case("test_stand", {"motor.omega_b_start": 20.0, **(values or {})}, "10 s")


def command_line(system: str, values: Mapping[str, object], stop: str) -> str:
    """The command that repeats a run."""
    words = ["rovbrush", "run", system]
    for name, value in values.items():
        text = f"[{','.join(f'{v:g}' for v in value)}]" if isinstance(value, (list, tuple)) else str(value)
        words += ["--set", f"{name}={text}"]
    if stop:
        words += ["--stop", stop]
    return shlex.join(words)
