"""Reads what `boundary` writes, or anybody's files in the layout of the FMI cross-check."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...errors import InputError, nearest
from ...files import csv_rows
from .values import numbers

ROUNDING = 1e-9  # relative, of times that are written with few digits
REQUIRED = ("StartTime", "StopTime", "StepSize", "RelTol")


@dataclass(frozen=True)
class Start:
    """A row of NAME_parameters.csv: a parameter or an input as it is set before time 0; of an output only the unit."""

    causality: str
    value: str
    unit: str | None


@dataclass(frozen=True)
class Recording:
    """Times [s], inputs held from one time to the next, outputs at the times.

    Columns are cells as they stand in the files, (rows,): what they mean an FMU's types say, see `values`.
    """

    name: str
    path: Path  # of the inputs
    times: np.ndarray
    inputs: dict[str, list[str]]
    outputs: dict[str, list[str]]
    options: dict[str, float]
    starts: dict[str, Start]

    def numbers(self, output: str) -> np.ndarray:
        """An output as real numbers, (rows,). Raises InputError for what is none."""
        return numbers(self.outputs[output], f"{self.name}_ref.csv: {output}")


def read_recording(folder: Path, name: str = "") -> Recording:
    """The recording `name` of a folder, or its only one. Raises InputError for what is missing or does not fit."""
    found = folder.glob("*_ref.csv") if os.path.isdir(folder) else ()
    names = sorted(path.name.removesuffix("_ref.csv") for path in found)
    if not names:
        raise InputError(
            f"{folder} holds no recording (NAME_ref.csv); make one with `rovbrush run SYSTEM --record-boundary NAME`"
        )
    if not name and len(names) > 1:
        raise InputError(f"{folder} holds several recordings: {', '.join(names)}; choose one with --name")
    name = name or names[0]
    if name not in names:
        raise InputError(f"{folder} holds no recording '{name}'{nearest(name, names)}")
    path = folder / f"{name}_in.csv"
    times, outputs = _series(folder / f"{name}_ref.csv")
    at, inputs = _series(path) if path.is_file() else (times, {})
    if len(times) < 2:
        raise InputError(f"{name}_ref.csv holds {len(times)} instants; two are needed for a step")
    if not np.array_equal(at, times):
        raise InputError(f"{path.name} and {name}_ref.csv hold different times; the inputs are needed at each of them")
    options = _options(folder / f"{name}_ref.opt")
    if options["StopTime"] < times[-1] - ROUNDING * abs(times[-1]):
        raise InputError(
            f"{name}_ref.opt: StopTime = {options['StopTime']:g} lies before the last row of {name}_ref.csv, "
            f"{times[-1]:g} s; correct one of them"
        )
    return Recording(name, path, times, inputs, outputs, options, _starts(folder, name))


def _series(path: Path) -> tuple[np.ndarray, dict[str, list[str]]]:
    head, *rows = csv_rows(path) or [[""]]
    if head[0].strip().lower() != "time":
        raise InputError(f"{path.name}: the first column must be time, it is '{head[0]}'")
    names = [cell.strip() for cell in head]
    if len(set(names)) < len(names):
        raise InputError(f"{path.name}: a column appears twice")
    for line, row in enumerate(rows, 2):
        if len(row) != len(head):
            raise InputError(f"{path.name}, line {line}: {len(row)} cells under {len(head)} columns")
    times = numbers([row[0] for row in rows], f"{path.name}: time")
    if not np.all(np.diff(times) > 0):
        raise InputError(f"{path.name}: the times do not rise from row to row")
    return times, {column: [row[k] for row in rows] for k, column in enumerate(names) if k}


def _options(path: Path) -> dict[str, float]:
    try:
        options = {key.strip(): float(value) for key, value in csv_rows(path)}
    except ValueError:
        raise InputError(f"{path.name}: write one `key, number` a line, {', '.join(REQUIRED)} among them") from None
    for key in REQUIRED:
        if key not in options:
            raise InputError(f"{path.name}: {key} is missing{nearest(key, options)}")
        if not math.isfinite(options[key]) or (key in ("StepSize", "RelTol") and options[key] < 0.0):
            raise InputError(f"{path.name}: {key} = {options[key]:g}; write a finite number, and none below 0")
    return options


def _starts(folder: Path, name: str) -> dict[str, Start]:
    path = folder / f"{name}_parameters.csv"
    if not path.is_file():
        return {}
    head, *rows = csv_rows(path) or [[]]
    if head != ["name", "causality", "value", "unit"] or any(len(row) != 4 for row in rows):
        raise InputError(f"{path.name}: the columns must be name, causality, value, unit")
    return {variable: Start(causality, value, unit or None) for variable, causality, value, unit in rows}
