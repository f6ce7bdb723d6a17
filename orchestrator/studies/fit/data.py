"""Measured data: columns of a CSV file, what each of them is to the system, in the system's units."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from ...errors import InputError, counted, nearest, point_wanted
from ...system.inputs.series_file import Column, columns_of, with_column
from ...system.model import System
from ...system.values import follows_tables
from ...units import conversion

LEAST = 3  # rows of a column that can be compared


@dataclass(frozen=True)
class Measured:
    """A signal as it was measured: times [s] that rise and values in the signal's own unit, both (rows,)."""

    name: str
    unit: str
    times: np.ndarray
    values: np.ndarray


@dataclass(frozen=True)
class Match:
    """What is compared: a signal of the run, and the column that was measured of it."""

    name: str
    column: str


def matches_of(texts: Sequence[str]) -> tuple[Match, ...]:
    """`drive.y,drive.w`, or `drive.y=current` where the column is called otherwise. Raises InputError."""
    found = []
    for entry in (part.strip() for text in texts for part in text.split(",")):
        name, _, column = (part.strip() for part in entry.partition("="))
        if not name or ("=" in entry and not column):
            raise InputError(f"--match {entry}: write component.output, or component.output=column of the data")
        found.append(Match(name, column or name))
    names = [match.name for match in found]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"--match {name}: it stands there twice")
    if not found:
        raise InputError("--match says which signals were measured, for instance --match drive.y,drive.w")
    return tuple(found)


def driven_by(system: System, columns: Mapping[str, Column], matches: Sequence[Match], path: Path) -> list[str]:
    """The columns that are free inputs of the system, which follow the data. Raises InputError for driven ones."""
    compared, found = {match.column for match in matches}, []
    for column in columns:
        owner, _, variable = system.full_name(column).partition(".")
        component = system.components.get(owner)
        if column in compared or component is None:
            continue
        scalars = component.fmu.expand(variable)
        if scalars and all(follows_tables(component.fmu.variables[s]) for s in scalars):
            for scalar in scalars:
                system.require_free(owner, scalar, f"--data {path.name}: column {column}")
            found.append(column)
    return found


def with_data(system: System, columns: Mapping[str, Column], names: Sequence[str], path: Path) -> System:
    """A copy whose inputs follow columns of the data. Raises InputError."""
    for name in names:
        system = with_column(system, name, columns[name], path, "--data")
    return system


def read(path: Path) -> dict[str, Column]:
    """The columns of a file. Raises InputError."""
    if not path.is_file():
        raise InputError(f"--data {path}: there is no such file")
    return columns_of(path, "--data")


def unused(system: System, columns: Mapping[str, Column], inputs: Sequence[str], matches: Sequence[Match],
           path: Path) -> list[str]:  # fmt: skip
    """What is said of columns that play no part."""
    left = [name for name in columns if name not in inputs and name not in {match.column for match in matches}]
    known = {f"{c.name}.{v}" for c in system.components.values() for v in c.fmu.variables}
    return [
        f"{path.name}: column '{name}' is not used: "
        + ("--match compares it" if system.full_name(name) in known else "the system has no variable of that name")
        for name in left
    ]


def measured(
    system: System, match: Match, columns: Mapping[str, Column], path: Path, span: tuple[float, float],
    tell: Callable[[str], None],
) -> Measured:  # fmt: skip
    """What was measured of a signal within the times of the run [s]. Raises InputError."""
    label = f"--data {path.name}"
    if match.column not in columns:
        raise InputError(
            f"{label}: no column '{match.column}' for --match {match.name}{nearest(match.column, columns)}"
        )
    column, name = columns[match.column], system.full_name(match.name)
    owner, _, variable = name.partition(".")
    if owner not in system.components:
        raise InputError(f"--match {match.name}: no component '{owner}'{nearest(owner, system.components)}")
    fmu = system.components[owner].fmu
    if variable not in fmu.variables:
        raise InputError(
            f"--match {match.name}: {owner} has no variable '{variable}'{nearest(variable, fmu.variables)}"
        )
    kind = fmu.type_of(variable)
    if kind is None or kind.dtype.kind not in "fiu":
        raise InputError(f"--match {match.name}: values of type {fmu.variables[variable].type} are not compared")
    gain, offset = 1.0, 0.0
    if column.unit is not None:
        own = fmu.unit(variable)
        if own is None:
            raise InputError(
                f"{label}: column {match.column} is in {column.unit}, and {fmu.path.name} states no unit for "
                f"{variable}; leave the unit out of the heading"
            )
        given = fmu.unit_called(column.unit, variable)
        gain, offset = conversion(given, own, f"{label}: column {match.column}")
    rows, gaps = [], 0
    for line, time, cell in column.rows:
        try:
            value = float(cell)
        except ValueError:
            raise InputError(
                f"{label}, line {line}: {match.column} = '{cell}' is not a number{point_wanted(cell)}"
            ) from None
        if math.isnan(value):
            gaps += 1
        elif math.isinf(value) or not math.isfinite(time):
            raise InputError(f"{label}, line {line}: {match.column} = {cell} at t = {time:g} s is not finite")
        else:
            rows.append((line, time, gain * value + offset))
    for (_, before, _), (line, time, _) in pairwise(rows):
        if time <= before:
            raise InputError(f"{label}, line {line}: the times of {match.column} do not rise, {before:g} to {time:g} s")
    inside = [(time, value) for _, time, value in rows if span[0] <= time <= span[1]]
    if len(inside) < LEAST:
        within = (
            f"{counted(len(inside), 'row')} of column '{match.column}' within the run, {span[0]:g} to {span[1]:g} s"
        )
        raise InputError(f"{label}: {within}; at least {LEAST} are needed (--start and --stop say which times are run)")
    if gaps:
        tell(f"{path.name}: {match.column} has {counted(gaps, 'gap')}, which count for nothing")
    if len(inside) < len(rows):
        tell(f"{path.name}: {len(rows) - len(inside)} rows of {match.column} lie outside the run and count for nothing")
    times, values = (np.array(part) for part in zip(*inside, strict=True))
    return Measured(name, fmu.variables[variable].unit or "1", times, values)
