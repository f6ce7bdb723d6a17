"""Inputs that nothing drives and that have no value: they keep what their FMU starts with, where it says so."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Iterator
from typing import Any

from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.attributes import items_of
from ...fmu.fmu import Fmu
from ..model import System
from ..values import start_as_toml

NAMED = 5  # inputs of a component that a note names


def left_alone(system: System) -> dict[str, list[str]]:
    """By component the inputs that nothing drives and that have no value: they keep what their FMU starts with."""
    return {
        name: found
        for name, component in system.components.items()
        if (
            found := [
                variable
                for variable in component.fmu.names("input")
                if component.fmu.type_of(variable) is not None  # Binary and Clock
                and (name, variable) not in system.drivers
                and variable not in component.inputs
                and variable not in component.series
            ]
        )
    }


def lacking_starts(fmu: Fmu, known: Collection[str] = ()) -> Iterator[tuple[str, Any]]:
    """Inputs that are not `known`, by themselves or with their array, and have no start value, with what is taken."""
    for name in fmu.names("input"):
        variable = fmu.variables[name]
        given = name in known or name.split("[")[0] in known or fmu.type_of(name) is None
        if variable.start is None and not given:
            yield name, _taken(variable)


def _taken(variable: ModelVariable) -> Any:
    """Nothing, or what is nearest to it: an empty text, false, the first item, a number within its range."""
    if variable.type in ("String", "Boolean"):
        return "" if variable.type == "String" else False
    if items := items_of(variable):
        return next(iter(items))
    low, high = (None if limit is None else float(limit) for limit in (variable.min, variable.max))
    if low is not None and low > 0.0:
        return str(variable.min)
    return str(variable.max) if high is not None and high < 0.0 else start_as_toml(variable)


def require_values(system: System, fail: Callable[[str, str], InputError]) -> System:
    """The system itself, if all inputs have a driver, a value or a start value of their FMU.

    Raises what `fail` makes of all that have none, and of the heading of the first.
    """
    lacking: dict[str, list[str]] = {}
    for name, variables in left_alone(system).items():
        fmu = system.components[name].fmu
        found = [f"{_key(base)} = {start_as_toml(fmu.variables[variable])}"
                 for base, variable in {v.split("[")[0]: v for v in reversed(variables)}.items()
                 if fmu.variables[variable].start is None]  # fmt: skip
        if found:
            lacking[name] = found[::-1]
    if not lacking:
        return system
    names = [f"{name}.{line.partition(' = ')[0]}" for name, lines in lacking.items() for line in lines]
    tables = "; ".join(f"[components.{name}.inputs] {', '.join(lines)}" for name, lines in lacking.items())
    heading = f"[components.{next(iter(lacking))}]"
    who = f"input {names[0]} has" if len(names) == 1 else f"inputs {', '.join(names)} have"
    raise fail(
        f"{who} no driver, and no start value in the FMU; connect what has none, or give it a value, for instance "
        f"{tables}",
        heading,
    )


def start_notes(system: System) -> list[str]:
    """What a person must know of it: one line for each component."""
    found = []
    for name, variables in left_alone(system).items():
        known = system.components[name].fmu.variables
        words = [f"{v} = {start_as_toml(known[v])}{f' {known[v].unit}' if known[v].unit else ''}" for v in variables]
        more = f" and {len(words) - NAMED} more" if len(words) > NAMED else ""
        found.append(f"{name}: nothing drives {', '.join(words[:NAMED])}{more}: the start values of its FMU are kept")
    return found


def _key(name: str) -> str:
    """A name as a key of TOML."""
    return name if re.fullmatch(r"[\w-]+", name) else json.dumps(name, ensure_ascii=False)
