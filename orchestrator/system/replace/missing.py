"""What a system loses when somebody else's FMU lacks variables of the component that it stands for.

Only what the mapping file declares missing is left out, and every loss is told. What cannot be left out, an output
that drives something, is an error.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from ...errors import nearest
from ...fmu.fmu import Fmu
from ...fmu.types import Value
from ..component import Component
from ..connection import Connection
from ..file.figure_kinds import figure_kind, figure_kinds
from ..file.merits import merit
from ..inputs.series import Series
from ..model import System
from ..schema.keys.message import signals_of
from .mapping import VariableMapping


@dataclass(frozen=True)
class Missing:
    """The variables of component `name` that the foreign FMU lacks, declared in the mapping file or not."""

    name: str
    label: str  # file name of the foreign FMU
    mapping: VariableMapping
    variables: list[str]
    fmu: Fmu
    problems: dict[str, str] = field(default_factory=dict)  # what may not be left out, all of it, by variable

    def has(self, signal: str) -> bool:
        """Is `component.variable` one of them?"""
        owner, _, variable = signal.partition(".")
        return owner == self.name and variable in self.variables

    def need(self, variable: str, what: str, causality: str, can_go: bool = True) -> None:
        """A problem more, unless `variable` may be left out: `what` says what the system needs it for."""
        if can_go and (self.mapping.states(variable) or variable in self.problems):
            return
        base = variable.partition("[")[0]
        where = f"{self.mapping.file}, [variables]" if self.mapping.path else "a mapping file (--map), [variables]"
        remedy = f'{base} = "their name"' + (f', or {base} = "" to do without' if can_go else "")
        self.problems[variable] = (
            f"{self.label} has no {causality} '{variable}', {what}{nearest(variable, self.fmu.names(causality))}; "
            f"write in {where}: {remedy}"
        )


@dataclass(frozen=True)
class Left:
    """A system without what depends on missing variables, and the values that the component still gets."""

    system: System
    parameters: Mapping[str, Value]
    inputs: Mapping[str, Value]
    series: Mapping[str, Series]
    notes: tuple[str, ...]


def leave_out(system: System, before: Component, missing: Missing) -> Left:
    """Take away what needs the missing variables; what the mapping does not declare missing is among the problems."""
    name, notes = missing.name, []
    kept = {}
    for table, causality in (("parameters", "parameter"), ("inputs", "input"), ("series", "input")):
        values: Mapping[str, Any] = getattr(before, table)
        lost = [v for v in values if v in missing.variables]
        for variable in lost:
            missing.need(variable, f"which the system sets to {values[variable]}", causality)
        if lost:
            texts = ", ".join(f"{v} = {values[v]}" for v in lost)
            notes.append(f"{missing.label} has no such {causality}, its value is not used: {texts}")
        kept[table] = {v: value for v, value in values.items() if v not in lost}
    connections = tuple(_uncounted(c, missing, notes) for c in system.connections if not _cut(c, missing, notes))
    for bond in system.bonds:
        for end in (*bond.effort, *bond.flow, bond.impulse, bond.displacement):
            if missing.has(end):
                variable = end.partition(".")[2]
                causality = before.fmu.variables[variable].causality
                missing.need(variable, f"which the power bond {bond.name} needs", causality, can_go=False)
    for requirement in system.requirements:
        for owner, variable in requirement.names:
            if missing.has(f"{owner}.{variable}"):
                causality = before.fmu.variables[variable].causality
                missing.need(variable, "which a requirement at time 0 needs", causality, can_go=False)
    reporting = _reporting(system.reporting, missing, notes)
    unused = [v for v in missing.variables if before.fmu.variables[v].causality == "output"]
    if unused:
        notes.append(f"{missing.label} has no such output, it is not recorded: {', '.join(unused)}")
    left = replace(system, connections=connections, reporting=reporting)
    return Left(left, kept["parameters"], kept["inputs"], kept["series"], tuple(f"{name}: {note}" for note in notes))


def _cut(connection: Connection, missing: Missing, notes: list[str]) -> bool:
    """Must this connection go? Only one into an input that the mapping declares missing may."""
    if missing.has(".".join(connection.source)):
        missing.need(connection.source[1], f"which drives {'.'.join(connection.target)}", "output", can_go=False)
    if not missing.has(".".join(connection.target)):
        return False
    missing.need(connection.target[1], f"which {'.'.join(connection.source)} drives", "input")
    notes.append(f"{missing.label} has no such input, the connection {connection.label} is left out")
    return True


def _uncounted(c: Connection, missing: Missing, notes: list[str]) -> Connection:
    """Without the counter of its mean, if that is missing: the mean is by the trapezoidal rule then."""
    if c.counted is None or not missing.has(".".join(c.counted)):
        return c
    missing.need(c.counter, f"which counts the mean of {'.'.join(c.source)}", "output")
    notes.append(f"{missing.label} has no {c.counter}, the mean of {'.'.join(c.source)} is by the trapezoidal rule")
    return replace(c, counter="", per_second=1.0)


def _reporting(reporting: Mapping[str, Any], missing: Missing, notes: list[str]) -> dict[str, Any]:
    """The reporting without the entries that name a missing output."""

    def lost(names: list[str], what: str) -> bool:
        gone = [n for n in names if missing.has(n)]
        for signal in gone:
            missing.need(signal.partition(".")[2], f"which {what} shows", "output")
        if gone:
            notes.append(f"{what} is left out, for want of {', '.join(gone)}")
        return bool(gone)

    summary = {}
    for key, text in reporting["summary"].items():
        angle = [text["angle"]] if key == "window" and "angle" in text else []
        if lost(angle if key == "window" else merit(text)[1], f"summary {key}"):
            if key == "window":
                summary[key] = {k: v for k, v in text.items() if k != "angle"}
            continue
        summary[key] = text
    gone = reporting["summary"].keys() - summary.keys()
    compare = [c for c in reporting["compare"] if c["value"] not in gone]
    balance = reporting["balance"]
    if lost([signal for names in balance.values() for signal in names], "the energy balance"):
        balance = {}
    figures = []
    for figure in reporting["figures"]:
        signals = list(figure.get("signals", ()))
        if figure.get("kind") in figure_kinds():
            absent = [f"{missing.name}.{v}" for v in missing.variables]
            signals = figure_kind(figure["kind"]).shows(figure, absent)
        first = "[1]" if "along" in figure else ""  # of an array: all of it, or nothing
        if first and lost([f"{figure['along']}{first}"], f"figure {figure.get('file', '')}: {figure['along']}"):
            continue
        shown = [s for s in signals if not lost([f"{s}{first}"], f"figure {figure.get('file', '')}: {s}")]
        if shown == signals:
            figures.append(figure)
        elif shown and "signals" in figure:
            figures.append({**figure, "signals": shown})
    messages = [m for m in reporting.get("messages", ()) if not lost(signals_of(m), f"message {m['topic']}")]
    found = {"summary": summary, "compare": compare, "balance": balance, "figures": figures, "messages": messages}
    return {**reporting, **found}
