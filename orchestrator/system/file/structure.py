"""Values of structural parameters, from wherever they come: they decide sizes, so they are taken before all else."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from ...errors import FmuError, InputError
from ...fmu.attributes import parse_value
from ...fmu.binary import as_text
from ...fmu.fmu import Fmu
from ...fmu.reading.structure import STRUCTURAL
from ...fmu.types import Value
from ..component import Component

Stated = tuple[str, object, str]  # name, value, where it stands


def with_structure(name: str, fmu: Fmu, stated: Iterable[Stated]) -> Fmu:
    """The FMU of a component with those of the values that are structural parameters; the last of one counts.

    Raises InputError for one out of range or that is no value of its type, and for arrays that become too large.
    """
    found: dict[str, Value] = {}
    where = ""
    for key, value, origin in stated:
        own = fmu.main_name(key)
        if is_structural(fmu, own):
            label, where = f"{origin}: {name}.{key}", origin
            found[own] = parse_value(fmu.variables[own], value, label, fmu.type_of(own))
    try:
        return fmu.with_structure(found) if found else fmu
    except FmuError as error:
        raise InputError(f"{where}: {error}") from None


def is_structural(fmu: Fmu, name: str) -> bool:
    """Whether a name is that of a structural parameter."""
    return name in fmu.variables and fmu.variables[name].causality == STRUCTURAL


def given_for(name: str, count: int, values: Mapping[str, object], origin: str) -> list[Stated]:
    """What is given for a component as `component.variable`; one of `count` = 1 needs no prefix."""
    prefix = f"{name}."
    found = [(key, value, origin) for key, value in values.items() if count == 1 and not key.startswith(prefix)]
    return found + [(key.removeprefix(prefix), v, origin) for key, v in values.items() if key.startswith(prefix)]


def with_resized_starts(component: Component, later: Iterable[Stated], fail: str) -> Component:
    """Parameters of arrays that have another size: FMI 3.0 says that they have lost their values, so all are set.

    `later`: what will be set. Raises InputError, which begins with `fail`, for those without a start value that counts
    for any size.
    """
    fmu = component.fmu
    known = {scalar for name, *_ in later for scalar in fmu.expand(name)}
    known |= component.parameters.keys() | component.series.keys()
    values = dict(component.parameters)
    for array in fmu.resized:
        scalars = fmu.expand(array)
        if not scalars or fmu.variables[scalars[0]].causality != "parameter" or fmu.type_of(scalars[0]) is None:
            continue
        lacking = [scalar for scalar in scalars if scalar not in known]
        if lacking and fmu.variables[lacking[0]].start is None:
            sizes = ", ".join(f"{key} = {as_text(value)}" for key, value in fmu.structure.items())
            raise InputError(
                f"{fail}: the start values of {component.name}.{array} are for another size than that of {sizes}; "
                f"give all {len(scalars)} of it"
            )
        values |= {scalar: fmu.start(scalar) for scalar in lacking}
    return replace(component, parameters=values) if fmu.resized else component
