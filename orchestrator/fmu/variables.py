"""The variables of an FMU as scalars: themselves, or the elements `u[1]`, `M[1,2]` of an FMI 3 array."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from math import prod
from pathlib import Path

from attrs import evolve
from fmpy.model_description import ModelVariable

from ..errors import FmuError
from .types import Value

MOST_ELEMENTS = 100_000  # of all arrays of an FMU; every one is a signal with a name

Elements = dict[str, dict[str, ModelVariable]]  # the scalars of every variable, by its own name


@dataclass(frozen=True)
class Place:
    """Where a scalar lives in its FMU: the value reference, and its position in an array of `count` values.

    `negated`: it is what is there with the other sign.
    """

    reference: int
    index: int
    count: int
    negated: bool = False

    def turned(self, value: Value) -> Value:
        """A value of the scalar as what is there, or back."""
        return -value if self.negated and not isinstance(value, (str, bytes)) else value


def elements_of(path: Path, variables: list[ModelVariable], texts: dict[str, list[str]]) -> Elements:
    """The scalars of every variable. Raises FmuError for arrays that are too large, and for two scalars of one name."""
    total, found, names = 0, {}, set()
    for variable in variables:
        total += prod(variable.shape) if variable.shape else 0
        if total > MOST_ELEMENTS:
            raise FmuError(
                f"FMU {path}: with array {variable.name} its arrays have more than {MOST_ELEMENTS} elements; "
                f"export smaller ones"
            )
        found[variable.name] = scalars_of(path, variable, texts)
        for name in found[variable.name]:
            if name in names:
                raise FmuError(f"FMU {path}: two variables are called '{name}', one of them an element of an array")
            names.add(name)
    return found


def scalars_of(path: Path, variable: ModelVariable, texts: dict[str, list[str]]) -> dict[str, ModelVariable]:
    """A variable as scalars, each with its own start value."""
    if not variable.shape:
        return {variable.name: variable}
    if variable.type in ("String", "Binary"):
        name = variable.alias.name if variable.alias is not None else variable.name
        starts = texts[name]
    else:
        starts = (variable.start or "").split()
    count = prod(variable.shape)
    if len(starts) not in (0, 1, count):
        raise FmuError(f"FMU {path}: array {variable.name} has {count} elements and {len(starts)} start values")
    values: list[str | None] = list(starts) if len(starts) == count else [starts[0] if starts else None] * count
    indices = product(*(range(1, n + 1) for n in variable.shape))
    return {
        f"{variable.name}[{','.join(map(str, index))}]": evolve(
            variable, name=f"{variable.name}[{','.join(map(str, index))}]", shape=(), start=start
        )
        for index, start in zip(indices, values, strict=True)
    }
