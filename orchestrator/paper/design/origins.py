"""Where a number stands: in the task, in the parameter set, in the system's file, or in the FMU with its source."""

from __future__ import annotations

import re
from dataclasses import dataclass

from ...results.files.manifest import plain_value
from ...system.file.shipped import SYSTEMS
from ...toml.file import TomlFile
from .task import SWEEP, Task

SOURCE = re.compile(r"\s*\(source: (.*)\)$")


@dataclass(frozen=True)
class Number:
    """A parameter: its value as text, what it means, and where the value comes from."""

    name: str
    value: str
    unit: str
    meaning: str
    origin: str

    @property
    def cells(self) -> tuple[str, str, str, str, str]:
        return self.name, self.value, self.unit, self.meaning, self.origin


def numbers(task: Task, component: str, only: tuple[str, ...] = ()) -> list[Number]:
    """The parameters of a component, an array as one of them; those whose names begin with one of `only`, if given."""
    part = task.case.run.plan.system.components[component]
    rows: dict[str, list[str]] = {}
    for name, variable in part.fmu.variables.items():
        if variable.causality in ("parameter", "structuralParameter") and name.startswith(only or ("",)):
            value = part.parameters.get(name, plain_value(variable.start))
            rows.setdefault(name.partition("[")[0], []).append(_text(value))
    return [_number(task, component, name, values) for name, values in rows.items()]


def _text(value: object) -> str:
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def _number(task: Task, component: str, name: str, values: list[str]) -> Number:
    variables = task.case.run.plan.system.components[component].fmu.variables
    variable = variables[name] if name in variables else variables[f"{name}[1]"]
    said = variable.description or ""
    source = SOURCE.search(said)
    meaning = SOURCE.sub("", said).replace("`", "")
    while len(values) > 1 and values[-1] == values[-2] and len(values) > 3:
        values = values[:-1]  # the rest of an array is like its last
    text = values[0] if len(set(values)) == 1 else ", ".join(values)
    return Number(name, text, variable.unit or "1", meaning, origin(task, component, name, source[1] if source else ""))


def origin(task: Task, component: str, name: str, source: str) -> str:
    """Where the value of a parameter comes from, in words."""
    system = task.case.run.plan.system

    def among(keys: object, prefix: str = "") -> bool:
        return isinstance(keys, dict) and any(key.partition("[")[0] == prefix + name for key in keys)

    if among(task.study.values, f"{component}."):
        return f"sweeps/{SWEEP}.toml"
    own = TomlFile(system.path).data["components"][component].get("parameters", {})
    if among(own):
        return system.path.name
    if system.parameter_set:
        shipped = SYSTEMS / f"{system.parameter_set.name}.toml"
        if among(TomlFile(shipped).data.get(component, {})):
            return shipped.name
    return source or "the FMU's own"
