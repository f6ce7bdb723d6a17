"""Recorded values as cells of a CSV file, and cells as values in the type of a variable.

Numbers have all their digits, a Boolean is 0 or 1, an Enumeration its value; a text stands in quotes where it must.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from attrs import evolve
from fmpy.model_description import ModelVariable

from ...errors import InputError, point_wanted
from ...fmu.attributes import is_number, parse_value
from ...fmu.fmu import Fmu
from ...fmu.types import FmiType, Value


def cells_of(values: np.ndarray) -> list[object]:
    """Values of a signal, (rows,), as they are written."""
    found: list[object] = (values.astype(int) if values.dtype == bool else values).tolist()
    return [value.hex() if isinstance(value, bytes) else value for value in found]


def numbers(cells: Sequence[str], label: str) -> np.ndarray:
    """A column of real numbers. Raises InputError with the line."""
    try:
        return np.array(cells, dtype=float)
    except ValueError:
        line, cell = next((k, cell) for k, cell in enumerate(cells, 2) if not is_number(cell))
        raise InputError(f"{_at(label, line)} = {cell!r} is not a number{point_wanted(cell)}") from None


def typed(cells: Sequence[str], fmu: Fmu, name: str, label: str) -> list[Value]:
    """A column in the type of a variable of the FMU, whole numbers exact. Raises InputError with the line.

    `label`: the file and the column.
    """
    kind, variable = fmu.type_of(name), fmu.variables[name]
    if kind is None:
        raise InputError(f"{fmu.path.name}: '{name}' is of type {variable.type}, which is not recorded; leave it out")
    if kind.real:
        found: list[Value] = numbers(cells, label).tolist()
        return found
    known = {cell: cell_value(cell, variable, kind, _at(label, line)) for line, cell in _first(cells)}
    return [known[cell] for cell in cells]


def cell_value(cell: str, variable: ModelVariable, kind: FmiType | None, label: str) -> Value:
    """A cell in the type of a variable, whatever its range and its items: a run may go beyond them, and not all FMUs
    begin within. Raises InputError."""
    known = evolve(variable, min=None, max=None)
    bare = evolve(known, declaredType=None) if is_number(cell) else known
    return parse_value(bare, cell, label, kind)


def _first(cells: Sequence[str]) -> list[tuple[int, str]]:
    """Each different cell with the first line in which it stands."""
    lines: dict[str, int] = {}
    for line, cell in enumerate(cells, 2):
        lines.setdefault(cell, line)
    return [(line, cell) for cell, line in lines.items()]


def _at(label: str, line: int) -> str:
    file, _, column = label.partition(": ")
    return f"{file}, line {line}: {column}"
