"""What a person must know of an FMU in the place of a component."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from fmpy.model_description import ModelVariable

from ...fmu.attributes import parse_value
from ...fmu.binary import as_text
from ...fmu.fmu import Fmu
from ...fmu.types import Value
from ..component import Component
from ..values import start_as_toml
from .crossing import Crossing
from .mapping import VariableMapping


def kept_inputs(name: str, fmu: Fmu, known: Collection[str]) -> Iterable[str]:
    """Inputs of theirs that keep their start values."""
    left = [v for v in fmu.names("input") if v not in known and fmu.type_of(v) is not None]
    if left:
        values = ", ".join(f"{v} = {start_as_toml(fmu.variables[v])}" for v in left)
        yield f"{name}: nothing drives {values} of {fmu.path.name}: the start values are kept"


def needed_tool(fmu: Fmu) -> Iterable[str]:
    """The tool that must be on this machine."""
    if fmu.interface.needsExecutionTool:
        maker = fmu.description.generationTool or "the tool that made it"
        yield f"{fmu.path.name} says that it needs {maker} on this machine to run (needsExecutionTool)"


def crossing_notes(name: str, crossings: dict[str, Crossing], mapping: VariableMapping) -> Iterable[str]:
    """Crossings that change a value, or that the mapping states."""
    for ours, cross in crossings.items():
        if mapping.states(ours) or not cross.exact:
            yield f"{name}.{ours} is {cross}"


def differing(before: Component, presented: Iterable[ModelVariable], crossings: dict[str, Crossing]) -> Iterable[str]:
    """Parameters that the system does not set and that their FMU starts with another value."""
    for theirs in presented:
        ours = before.fmu.variables.get(theirs.name)
        if ours is None or ours.causality != "parameter" or theirs.name in before.parameters:
            continue
        values = [parse_value(theirs, v.start, theirs.name) for v in (theirs, ours) if v.start is not None]
        if len(values) == 2 and not _alike(*values):
            unit = f" {ours.unit}" if ours.unit and ours.unit != "1" else ""
            there, here = map(as_text, values)
            yield f"{before.name}.{theirs.name} is {there}{unit} there, {here}{unit} here; theirs is kept"


def _alike(a: Value, b: Value) -> bool:
    if isinstance(a, float) and isinstance(b, float):
        return abs(a - b) <= 1e-9 * max(abs(a), abs(b))
    return a == b
