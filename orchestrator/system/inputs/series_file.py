"""Where the tables that inputs follow are stated: CSV files, system files, and arrays from Python.

A CSV file has a column `time` and one for each input, `component.input`; a heading may state the unit, `name [unit]`.
An empty cell is no row of its column, so that inputs of several rates share a file.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import InputError, nearest, point_wanted
from ...files import csv_rows
from ...units import conversion
from ..component import Component
from ..model import System
from ..schema.checked import checked
from ..schema.keys.system import Table
from ..values import checked_values, follows_tables
from .series import Series, series_of, shape_of

SEPARATORS = {";": "semicolons", "\t": "tabs"}  # as spreadsheets write them


@dataclass(frozen=True)
class Column:
    """One column of a file: its unit, and the rows (line, time [s], cell) that are not empty."""

    unit: str | None
    rows: list[tuple[int, float, str]]


def columns_of(path: Path, label: str) -> dict[str, Column]:
    """All columns of a CSV file but `time`, by name without unit. Raises InputError naming file and line."""
    try:
        head, *rows = csv_rows(path) or [[""]]
    except InputError as error:
        raise InputError(f"{label}: {error}") from None
    heads = [_heading(cell) for cell in head]
    names = [name for name, _ in heads]
    if "time" not in names:
        text = ",".join(head)
        wrong = next((word for mark, word in SEPARATORS.items() if mark in text), "")
        if wrong:
            raise InputError(
                f"{label}: {path.name}: its columns are separated by {wrong}; write a comma between them, and numbers "
                "with a point, such as time,u [V] and 0.5,12.0"
            )
        raise InputError(
            f"{label}: {path.name}: there is no column 'time' among {', '.join(filter(None, names)) or 'none'}; "
            "the first line has the headings, such as time,u [V]"
        )
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"{label}: {path.name}: column '{name}' appears twice")
    at = names.index("time")
    gain, offset = conversion(heads[at][1], "s", f"{label}: {path.name}: column time")
    found = {name: Column(unit, []) for name, unit in heads if name and name != "time"}
    for line, row in enumerate(rows, 2):
        if len(row) != len(head):
            raise InputError(f"{label}: {path.name}, line {line}: {len(row)} cells under {len(head)} headings")
        try:
            time = gain * float(row[at]) + offset
        except ValueError:
            raise InputError(
                f"{label}: {path.name}, line {line}: time = '{row[at]}' is not a number{point_wanted(row[at])}"
            ) from None
        for name, cell in zip(names, row, strict=True):
            if name in found and cell.strip():
                found[name].rows.append((line, time, cell.strip()))
    return found


def _heading(cell: str) -> tuple[str, str | None]:
    """`motor.angle [deg]` as name and unit."""
    match = re.fullmatch(r"(.+?)\s+\[([^\[\]]+)\]", cell.strip())  # without a space it is an element, u[1]
    return (match[1], match[2]) if match else (cell.strip(), None)


def _column_series(component: Component, scalar: str, path: Path, name: str, column: Column, label: str) -> Series:
    if not column.rows:
        raise InputError(f"{label}: column '{name}' of {path.name} is empty")
    cells: list[Any] = [cell for _, _, cell in column.rows]
    if component.fmu.is_real(scalar):
        for k, (line, _, cell) in enumerate(column.rows):
            try:
                cells[k] = float(cell)
            except ValueError:
                raise InputError(
                    f"{label}: {path.name}, line {line}: {name} = '{cell}' is not a number{point_wanted(cell)}"
                ) from None
    times = [time for _, time, _ in column.rows]
    origin = f"column {name} of {path.name}"
    return series_of(component.fmu, scalar, times, cells, column.unit, origin, f"{label}: {origin}")


def with_files(system: System, paths: Iterable[Path], option: str = "--input") -> System:
    """A copy whose inputs follow the columns of CSV files. Raises InputError."""
    for path in paths:
        for name, column in columns_of(path, option).items():
            system = with_column(system, name, column, path, option)
    return system


def with_column(system: System, name: str, column: Column, path: Path, option: str) -> System:
    """A copy in which one input follows a column of a file. Raises InputError."""
    component, scalars = _inputs_of(system, name, f"{option} {path.name}")
    if len(scalars) > 1:
        raise InputError(f"{option} {path.name}: {name} has {len(scalars)} elements; give each a column")
    series = _column_series(component, scalars[0], path, name, column, option)
    return system.with_component(component.with_series(scalars[0], series))


def with_inputs(system: System, inputs: Mapping[str, Any], origin: str = "inputs") -> System:
    """A copy in which inputs that nothing drives follow tables or take one value.

    `inputs`: by `component.input` either (times [s], values), shapes (n,) and (n,), or (n, elements) for an array; or
    one value. Raises InputError.
    """
    for name, given in inputs.items():
        component, scalars = _inputs_of(system, name, origin)
        variable = system.full_name(name).partition(".")[2]
        if not isinstance(given, tuple):
            for scalar, value in checked_values(component, variable, given, origin).items():
                component = component.with_value(scalar, value)
        elif len(given) != 2:
            raise InputError(f"{origin}: {name} needs (times, values), not {len(given)} things")
        else:
            component = _with_table(component, scalars, *given, None, "a table", f"{origin}: {name}")
        system = system.with_component(component)
    return system


def stated_series(component: Component, name: str, entry: Mapping[str, Any], folder: Path, label: str) -> Component:
    """A component whose input follows what a system file states. Raises InputError.

    `{ csv = "profile.csv" }`, where a `column` other than `component.input` can be named; or `{ time = [0, 1],
    values = [0, 5], unit = "mm" }`. Paths are relative to `folder`.
    """
    checked(Table, dict(entry), label)
    scalars = [s for s in component.fmu.expand(name) if follows_tables(component.fmu.variables[s])]
    if not scalars:
        raise InputError(
            f"{label}: {component.name}.{name} is no input{nearest(name, component.fmu.base_names('input'))}"
        )
    if "csv" not in entry:
        if not {"time", "values"} <= entry.keys() or "column" in entry:
            raise InputError(f'{label}: write {{ csv = "file.csv" }} or {{ time = [...], values = [...] }}')
        table = (entry["time"], entry["values"], entry.get("unit"))
        return _with_table(component, scalars, *table, "the table in the system file", label)
    if len(entry) > 1 + ("column" in entry):
        raise InputError(f"{label}: beside csv only 'column' may stand; a unit is part of the heading, `name [unit]`")
    path = folder / str(entry["csv"])
    columns = columns_of(path, label)
    for scalar in scalars:
        column = str(entry.get("column", f"{component.name}.{scalar}"))
        if column not in columns:
            raise InputError(f"{label}: {path.name} has no column '{column}'{nearest(column, columns)}")
        component = component.with_series(
            scalar, _column_series(component, scalar, path, column, columns[column], label)
        )
    return component


def _with_table(
    component: Component, scalars: list[str], times: Any, values: Any, unit: str | None, origin: str, label: str
) -> Component:
    """Every element of an array has a column of its own; one column is for all."""
    shape = shape_of(values, label)
    if len(shape) == 2 and shape[1] != len(scalars):
        raise InputError(f"{label}: values of shape {shape} do not fit {len(scalars)} elements")
    for k, scalar in enumerate(scalars):
        own = np.asarray(values)[:, k] if len(shape) == 2 else values
        component = component.with_series(scalar, series_of(component.fmu, scalar, times, own, unit, origin, label))
    return component


def _inputs_of(system: System, name: str, origin: str) -> tuple[Component, list[str]]:
    """The component and the scalars behind `component.input`, which nothing must drive."""
    owner, _, variable = system.full_name(name).partition(".")
    if owner not in system.components:
        known = [f"{c.name}.{v}" for c in system.components.values() for v in c.fmu.base_names("input")]
        what = f"no component '{owner}' in '{name}'" if variable else f"'{name}' is no input"
        raise InputError(f"{origin}: {what}{nearest(name, known)}")
    component = system.components[owner]
    scalars = [s for s in component.fmu.expand(variable) if follows_tables(component.fmu.variables[s])]
    if not scalars:
        raise InputError(f"{origin}: {name} is no input{nearest(variable, component.fmu.base_names('input'))}")
    for scalar in scalars:
        system.require_free(owner, scalar, origin)
    return component, scalars
