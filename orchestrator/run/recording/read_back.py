"""Rows that are on disk already, read back: tables in cells of the loop."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...fmu.types import encode_cells
from ...loop.texts import Texts
from ...plan.plan import Plan


def type_of(plan: Plan, key: tuple[str, str]) -> str:
    """The type that an FMU gives a recorded signal; empty for those of the coupling."""
    component = plan.system.components.get(key[0])
    return str(component.fmu.variables[key[1]].type) if component is not None else ""


def as_table(rows: int, columns: int, values: Callable[[int], np.ndarray], texts: Texts) -> np.ndarray:
    """A table (rows, columns) in cells of the loop, as precise as each signal's own type; `values` gives a column."""
    cells = np.empty((rows, columns))
    for k in range(columns):
        column = values(k)
        if column.dtype.kind == "O":
            numbers = [texts.number_of_bytes(x) if isinstance(x, bytes) else texts.number(x) for x in column.tolist()]
            column = np.array(numbers, dtype=np.int64)
        cells[:, k] = encode_cells(column)
    return cells
