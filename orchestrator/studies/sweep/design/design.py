"""Which points a sweep computes: a grid over axes, random points in ranges, or the rows of a table.

How an axis is written: see `axis`; how points are drawn: see `sampling`.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, overload

import numpy as np

from ....errors import InputError, nearest
from ....fmu.types import Value
from ....system.file.events.numbers import is_of_event
from ....system.model import System
from .axis import LARGEST, Axis, checked_axis, listed, range_of, spaced
from .blocks import block_size
from .sampling import RANDOM, SAMPLERS, drawn


@dataclass(frozen=True)
class Design:
    """A `grid` is the product of its axes, the last one fastest; `list`, SAMPLERS, BLOCKS have one value per point."""

    kind: str
    axes: tuple[Axis, ...]
    seed: int | None = None

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values along each axis of a grid; of points otherwise."""
        return tuple(len(axis.values) for axis in self.axes) if self.kind == "grid" else (len(self.axes[0].values),)

    def __len__(self) -> int:
        return math.prod(self.shape)

    def point(self, k: int) -> dict[str, Value]:
        """The values of point k by name."""
        at = [int(i) for i in np.unravel_index(k, self.shape)] if self.kind == "grid" else [k] * len(self.axes)
        return {axis.name: axis.values[i] for axis, i in zip(self.axes, at, strict=True)}

    def points(self, numbers: Iterable[int]) -> PointsOf:
        """Some of the points with their values, which are made when they are asked for."""
        return PointsOf(self, list(numbers))


class PointsOf(Sequence[tuple[int, dict[str, Value]]]):
    """Numbers and values of points of a design."""

    def __init__(self, design: Design, numbers: list[int]) -> None:
        self._design, self._numbers = design, numbers

    def __len__(self) -> int:
        return len(self._numbers)

    @overload
    def __getitem__(self, at: int) -> tuple[int, dict[str, Value]]: ...
    @overload
    def __getitem__(self, at: slice) -> list[tuple[int, dict[str, Value]]]: ...
    def __getitem__(self, at: int | slice) -> Any:
        if isinstance(at, slice):
            return [(k, self._design.point(k)) for k in self._numbers[at]]
        return self._numbers[at], self._design.point(self._numbers[at])


def check_count(count: int, origin: str) -> None:
    """Raise InputError for more points than a sweep may have, before they are drawn."""
    if count > LARGEST:
        raise InputError(f"{origin}: a sweep may have {LARGEST} points at most; take fewer")


def make_design(
    system: System,
    vary: Mapping[str, object],
    count: int = 0,
    seed: int = 1,
    table: Path | None = None,
    sampler: str = "",
    blocks: str = "",
) -> Design:
    """The design of `name: text` entries; `count` > 0 points in ranges; the rows of a CSV file with `table`.

    `sampler`: how points are drawn in ranges, one of SAMPLERS; empty for the first. `blocks`: `count` is the
    number of blocks of this kind, one of BLOCKS.

    Raises InputError for an unknown, driven or doubly varied parameter, a value out of range, an empty or malformed
    range.
    """
    if sampler and sampler not in SAMPLERS:
        raise InputError(f"--design {sampler}{nearest(sampler, SAMPLERS)}; one of {', '.join(SAMPLERS)}")
    if sampler and not count:
        raise InputError(f"--design {sampler} needs the number of points: --random 64")
    named = {system.full_name(name): text for name, text in vary.items()}
    if len(named) < len(vary):
        raise InputError(f"--vary: a parameter is varied twice ({', '.join(vary)})")
    if table:
        if vary or count:
            raise InputError("--points lists every point; leave --vary and --random out")
        axes = _table_axes(system, table)
    elif not vary:
        raise InputError("nothing to vary; give --vary, for instance --vary motor.R=0.07:0.09:7")
    else:
        if not count:
            columns = {name: _grid(system, name, text) for name, text in named.items()}
            check_count(math.prod(map(len, columns.values())), "the grid of --vary")
        else:
            if blocks:
                check_count(count * block_size(blocks, len(vary)), f"--samples {count}")
            else:
                check_count(count, f"--random {count}")
            columns = drawn(system, named, count, seed, blocks or sampler)
        axes = tuple(checked_axis(system, name, values) for name, values in columns.items())
    design = Design(
        "list" if table else (blocks or sampler or RANDOM) if count else "grid", axes, seed if count else None
    )
    check_count(len(design), f"--points {table}")
    owners: dict[str, str] = {}
    for axis in axes:
        component, _, variable = axis.name.partition(".")
        if is_of_event(system, axis.name):
            continue
        for scalar in system.components[component].fmu.expand(variable):
            other = owners.setdefault(f"{component}.{scalar}", axis.name)
            if other != axis.name:
                raise InputError(f"--vary {axis.name}: {component}.{scalar} is varied by {other} already")
    return design


def vary_entries(options: Sequence[str]) -> dict[str, object]:
    """`["motor.R=0.07:0.09:7"]` as a mapping. Raises InputError for what is no `name=values`."""
    entries: dict[str, object] = {}
    for option in options:
        name, equals, text = (part.strip() for part in option.partition("="))
        if not (equals and name):
            raise InputError(
                f"--vary {option}: write component.variable=low:high:count or component.variable=a,b,c (of an FMU "
                f"alone the variable's own name will do)"
            )
        if name in entries:
            raise InputError(f"--vary {option}: {name} is varied twice")
        entries[name] = text
    return entries


def _grid(system: System, name: str, text: object) -> Sequence[object]:
    items = listed(system, name, text)
    if items is None:
        items = spaced(name, text, range_of(system, name, text, "low:high:count", grid=True))
    if len({str(item) for item in items}) < len(items):
        raise InputError(f"--vary {name}={text}: a value is there twice")
    return items


def _table_axes(system: System, path: Path) -> tuple[Axis, ...]:
    """Columns of a CSV file: the head names the parameters, each further row is a point."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows: list[Any] = [[cell.strip() for cell in row] for row in csv.reader(file) if row]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"--points {path} cannot be read: {error}") from error
    if len(rows) < 2:
        raise InputError(f"--points {path}: no points; the first row names the parameters, each further row is a point")
    for number, row in enumerate(rows, 1):
        if len(row) != len(rows[0]):
            raise InputError(f"--points {path}: row {number} has {len(row)} cells, the first row {len(rows[0])}")
    names = [system.full_name(name) for name in rows[0]]
    if len(set(names)) < len(names):
        raise InputError(f"--points {path}: a parameter has two columns")
    columns = zip(*rows[1:], strict=True)
    return tuple(checked_axis(system, name, column) for name, column in zip(names, columns, strict=True))
