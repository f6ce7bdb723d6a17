"""Values of variables before and during a run: which can be set, what is allowed, and how they are written."""

from __future__ import annotations

import json
from contextlib import suppress
from typing import TYPE_CHECKING

from fmpy.model_description import ModelVariable

from ..errors import InputError, nearest
from ..fmu.attributes import parse_value
from ..fmu.reading.structure import STRUCTURAL
from ..fmu.types import REALS, Value
from .quantities import in_own_unit

if TYPE_CHECKING:
    from .component import Component


def settable(variable: ModelVariable) -> bool:
    """Whether a variable takes a value before time 0: a parameter, an input, a start value that the FMU calls exact."""
    if variable.causality in ("parameter", "input"):
        return True
    return bool(variable.initial == "exact" and variable.variability != "constant" and variable.start is not None)


def follows_tables(variable: ModelVariable) -> bool:
    """Whether a variable can be set while the run goes: an input, a tunable parameter."""
    tunable = variable.causality == "parameter" and variable.variability == "tunable"
    return bool(variable.causality == "input" or tunable)


def checked_values(component: Component, name: str, value: object, origin: str) -> dict[str, Value]:
    """`value` for each scalar behind `name` (a list for an array), in unit, type and range. Raises InputError."""
    fmu = component.fmu
    scalars = fmu.expand(name)
    if scalars and fmu.variables[scalars[0]].causality == STRUCTURAL:
        raise InputError(f"{origin}: {component.name}.{name} is a structural parameter: it is set before a run begins")
    if not scalars or not settable(fmu.variables[scalars[0]]):
        kind = fmu.variables[scalars[0]].causality if scalars else "variable"
        what = f"is of causality {kind} and cannot be set" if scalars else "is unknown"
        others = [s for s in fmu.base_names("parameter", "input") if s != name]
        raise InputError(f"{origin}: {component.name}.{name} {what}{nearest(name, others)}")
    if fmu.type_of(scalars[0]) is None:
        kind = fmu.variables[scalars[0]].type
        raise InputError(f"{origin}: {component.name}.{name} is of type {kind}, which cannot be set; leave it out")
    values = list(value) if isinstance(value, (list, tuple)) else [value] * len(scalars)
    if len(values) != len(scalars):
        raise InputError(f"{origin}: {component.name}.{name} has {len(scalars)} elements, not {len(values)}")
    found = {}
    for scalar, v in zip(scalars, values, strict=True):
        label = f"{origin}: {component.name}.{scalar}"
        found[scalar] = parse_value(
            fmu.variables[scalar], in_own_unit(fmu, scalar, v, label), label, fmu.type_of(scalar)
        )
        most = fmu.detail(scalar, "maxSize")
        if isinstance(found[scalar], bytes) and most is not None and most.isdecimal():
            _require_size(label, len(found[scalar]), int(most))  # type: ignore[arg-type]
    return found


def _require_size(label: str, size: int, most: int) -> None:
    if size > most:
        raise InputError(f"{label}: {size} bytes are too many: {most} are allowed (maxSize)")


def start_as_toml(variable: ModelVariable) -> str:
    """The start value of a variable, or what stands for none, as it is written in a file."""
    if variable.type in ("String", "Binary"):
        return json.dumps(variable.start or "", ensure_ascii=False)
    if variable.type == "Boolean":
        return "true" if str(variable.start).lower() in ("true", "1") else "false"
    if variable.type in REALS:
        with suppress(ValueError):  # `.5` and `1.` are no numbers there
            return repr(float(variable.start or 0.0))
    return str(variable.start or 0)
