"""What another FMU has that stands for none of our variables."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence

from fmpy.model_description import ModelVariable

from ...errors import InputError
from ...fmu.types import Value
from ..values import start_as_toml
from .fit import can_be
from .mapping import VariableMapping


def own_values(
    variables: Mapping[str, ModelVariable],
    mapping: VariableMapping,
    mapped: set[str],
    label: str,
    unmapped: Sequence[str] = (),
) -> dict[str, Value]:
    """Values for variables of theirs that stand for none of ours.

    An input of theirs without one keeps its start value, unless it has none, or there are `unmapped` inputs of ours
    that it could stand for. Raises InputError for all that is wrong.
    """
    problems = []
    for name, variable in variables.items():
        free = variable.causality == "input" and name not in mapped and name not in mapping.inputs
        if free and (unmapped or variable.start is None):
            close = difflib.get_close_matches(name, unmapped, 1, 0.0)
            offer = f' ({close[0]} = "{name}")' if close else ""
            problems.append(
                f"{label} has an input '{name}' that nothing drives; map one of ours to it{offer} under [variables] in "
                f'a mapping file, or give it a value there: [inputs] "{name}" = {start_as_toml(variable)}'
            )
    for table, causality in (("inputs", "input"), ("parameters", "parameter")):
        for name in getattr(mapping, table):
            if name not in variables:
                problems.append(f"[{table}]: name each element of '{name}', or give a list ({mapping.file})")
            elif not can_be(causality, variables[name]):
                problems.append(
                    f"[{table}]: '{name}' of {label} is of causality {variables[name].causality}, "
                    f"no {causality} ({mapping.file})"
                )
            elif name in mapped:
                problems.append(f"[{table}]: '{name}' stands for one of our variables; remove it ({mapping.file})")
    if problems:
        raise InputError("\n".join(problems))
    return {**mapping.inputs, **mapping.parameters}
