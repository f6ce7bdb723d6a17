"""What is known where parameters that are declared `usual` have their start values: numbers, and sizes of arrays."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from types import SimpleNamespace

from .interface import Array, Variable


def usual_values(variables: Iterable[Variable]) -> dict[str, float]:
    """The scalar parameters that are mostly left as they are, by name, with these values; none that can be tuned."""
    return {v.name: v.start[0] for v in variables if v.usual and not v.size and not v.tunable}


def usual_sizes(variables: Sequence[Variable], arrays: Iterable[Array]) -> dict[str, tuple[int | None, int | None]]:
    """Rows and columns of each array as far as they follow from usual values, else None; a vector has one column."""
    found = {}
    for array in arrays:
        one, other = (_shape(array, variables, size) for size in (7, 11))  # whatever else follows differs in these two
        found[array.name] = tuple(a if a == b else None for a, b in zip(one, other, strict=True))
    return found  # type: ignore[return-value]


def _shape(array: Array, variables: Sequence[Variable], unknown: int) -> tuple[int, ...]:
    """The shape where all that is not usual is `unknown`."""
    usual = usual_values(variables)
    values = {v.name: _number(v, usual[v.name]) if v.name in usual else unknown for v in variables}
    shape = array.shape_for(SimpleNamespace(**values))
    return shape if isinstance(shape, tuple) else (shape, 1)


def _number(variable: Variable, value: float) -> float:
    return int(value) if variable.kind != "Real" else value
