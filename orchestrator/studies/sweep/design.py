"""Which points a sweep computes: a grid over axes, random points in ranges, or the rows of a table.

An axis is written `low:high:count` (`low:high:count:log` for equal ratios) or as a list `8,10,12`; in a random design
`low:high`, `low:high:log` or a list to choose from.
"""

from __future__ import annotations

import csv
import math
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import InputError, nearest
from ...system.model import System, Value, checked_values

LARGEST = 1_000_000  # points; a larger design is a typing error
RANDOM = "random"
SAMPLERS = (RANDOM, "latin", "sobol")
DIGITS = 12  # of grid values: 0.6 and not 0.6000000000000001, so that it can be selected


@dataclass(frozen=True)
class Axis:
    """A varied parameter: its values along a grid, or one value for each point of another design."""

    name: str  # component.variable
    unit: str
    description: str
    values: tuple[Value, ...]


@dataclass(frozen=True)
class Design:
    """A `grid` is the product of its axes, the last one fastest; `list` and SAMPLERS have one value per point."""

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
) -> Design:
    """The design of `name: text` entries; `count` > 0 points in ranges; the rows of a CSV file with `table`.

    `sampler`: how points are drawn in ranges, one of SAMPLERS; empty for the first.

    Raises InputError for an unknown, driven or doubly varied parameter, a value out of range, an empty or malformed
    range.
    """
    if sampler and sampler not in SAMPLERS:
        raise InputError(f"--design {sampler}{nearest(sampler, SAMPLERS)}; one of {', '.join(SAMPLERS)}")
    if sampler and not count:
        raise InputError(f"--design {sampler} needs the number of points: --random 64")
    if table:
        if vary or count:
            raise InputError("--points lists every point; leave --vary and --random out")
        axes = _table_axes(system, table)
    elif not vary:
        raise InputError("nothing to vary; give --vary, for instance --vary motor.R=0.07:0.09:7")
    else:
        if not count:
            columns = {name: _grid(name, text) for name, text in vary.items()}
            check_count(math.prod(map(len, columns.values())), "the grid of --vary")
        else:
            check_count(count, f"--random {count}")
            columns = drawn(system, vary, count, seed, sampler)
        axes = tuple(_axis(system, name, values) for name, values in columns.items())
    design = Design("list" if table else (sampler or RANDOM) if count else "grid", axes, seed if count else None)
    check_count(len(design), f"--points {table}")
    owners: dict[str, str] = {}
    for axis in axes:
        component, _, variable = axis.name.partition(".")
        for scalar in system.components[component].fmu.expand(variable):
            other = owners.setdefault(f"{component}.{scalar}", axis.name)
            if other != axis.name:
                raise InputError(f"--vary {axis.name}: {component}.{scalar} is varied by {other} already")
    return design


def vary_entries(options: Sequence[str]) -> dict[str, object]:
    """`["motor.R=0.07:0.09:7"]` as a mapping. Raises InputError for what is no `component.variable=values`."""
    entries: dict[str, object] = {}
    for option in options:
        name, equals, text = (part.strip() for part in option.partition("="))
        if not equals or "." not in name:
            raise InputError(f"--vary {option}: write component.variable=low:high:count or component.variable=a,b,c")
        if name in entries:
            raise InputError(f"--vary {option}: {name} is varied twice")
        entries[name] = text
    return entries


def _axis(system: System, name: str, values: Sequence[object]) -> Axis:
    """Every value checked as a run would check it, and in the type of the variable."""
    origin = "--vary"
    system.with_values({name: values[0]}, origin)  # unknown names, driven inputs
    component, _, variable = name.partition(".")
    owner = system.components[component]
    checked = tuple(next(iter(checked_values(owner, variable, value, origin).values())) for value in values)
    described = owner.fmu.variables[owner.fmu.expand(variable)[0]]
    return Axis(name, described.unit or "1", described.description or "", checked)


def _items(name: str, text: object) -> list[object] | None:
    """The entries of a list; None for a range."""
    if not isinstance(text, list) and ":" in str(text):
        return None
    items: list[object] = text if isinstance(text, list) else [part.strip() for part in str(text).split(",")]
    if not items or "" in items or any(str(item).startswith("[") for item in items):
        raise InputError(
            f"--vary {name}={text}: an empty value; write low:high:count or a,b,c (an array takes one value for all of "
            "its elements, or vary a single element such as {name}[1])"
        )
    return items


def _range(name: str, text: object, form: str) -> tuple[float, float, list[str]]:
    """Ends of a range and what follows them."""
    low_text, high_text, *more = str(text).split(":")
    try:
        low, high = float(low_text), float(high_text)
    except ValueError:
        raise InputError(f"--vary {name}={text}: not a range of numbers; write {form}") from None
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise InputError(f"--vary {name}={text}: an empty range; {form} needs a finite low below high")
    if more and more[-1] == "log" and low <= 0:
        raise InputError(f"--vary {name}={text}: equal ratios need a range above 0")
    return low, high, more


def _grid(name: str, text: object) -> Sequence[object]:
    items = _items(name, text)
    if items is None:
        form = "low:high:count"
        low, high, more = _range(name, text, form)
        if len(more) not in (1, 2) or more[1:] not in ([], ["log"]) or not more[0].isdecimal():
            raise InputError(f"--vary {name}={text}: write {form}, for instance {name}={low:g}:{high:g}:5")
        if int(more[0]) < 2:
            raise InputError(f"--vary {name}={text}: an empty range; it needs at least 2 values, or write one value")
        if int(more[0]) > LARGEST:
            raise InputError(f"--vary {name}={text}: more than {LARGEST} values")
        spaced = (np.geomspace if more[1:] else np.linspace)(low, high, int(more[0]))
        items = [float(f"{value:.{DIGITS}g}") for value in spaced]
    if len({str(item) for item in items}) < len(items):
        raise InputError(f"--vary {name}={text}: a value is there twice")
    return items


def drawn(
    system: System, vary: Mapping[str, object], count: int, seed: int, sampler: str = ""
) -> dict[str, Sequence[object]]:
    """`count` values of every name.

    Random draws of one name do not depend on what else is varied. A Latin hypercube or Sobol's sequence (scrambled; any
    count, but a power of 2 keeps it balanced) fill all ranges together, evenly.
    """
    if sampler in ("", RANDOM):
        return {name: _random(system, name, text, count, seed) for name, text in vary.items()}
    from scipy.stats import qmc

    engine = (qmc.LatinHypercube if sampler == "latin" else qmc.Sobol)(len(vary), rng=np.random.default_rng(seed))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of counts that are no power of 2
        points = engine.random(count)
    return {name: _spread(system, name, text, points[:, k]) for k, (name, text) in enumerate(vary.items())}


def _spread(system: System, name: str, text: object, shares: np.ndarray) -> Sequence[object]:
    """Values of a range, or of a list, at `shares` of it in 0 to 1, (count,)."""
    items = _items(name, text)
    if items is not None:
        return [items[int(k)] for k in np.minimum(shares * len(items), len(items) - 1)]
    low, high, log = _random_range(system, name, text)
    if _whole(system, name):
        first, last = int(low), int(high)
        return [int(k) for k in np.minimum(first + np.floor(shares * (last - first + 1)), last)]
    values = np.exp(math.log(low) + shares * math.log(high / low)) if log else low + shares * (high - low)
    return [min(max(float(value), low), high) for value in values]


def _random(system: System, name: str, text: object, count: int, seed: int) -> Sequence[object]:
    """`count` independent draws; those of one name do not depend on what else is varied."""
    generator = np.random.default_rng([seed, *name.encode()])
    items = _items(name, text)
    if items is not None:
        return [items[k] for k in generator.integers(len(items), size=count)]
    low, high, log = _random_range(system, name, text)
    if _whole(system, name):
        return [int(value) for value in generator.integers(int(low), int(high), size=count, endpoint=True)]
    values = (
        np.exp(generator.uniform(math.log(low), math.log(high), count)) if log else generator.uniform(low, high, count)
    )
    return [min(max(float(value), low), high) for value in values]


def _random_range(system: System, name: str, text: object) -> tuple[float, float, bool]:
    """Ends of a range to draw from, both allowed, and whether in equal ratios."""
    form = "low:high (or low:high:log) with --random"
    low, high, more = _range(name, text, form)
    if more not in ([], ["log"]):
        raise InputError(f"--vary {name}={text}: write {form}; the number of points is that of --random")
    _axis(system, name, [low, high])
    return low, high, bool(more)


def _whole(system: System, name: str) -> bool:
    """Whether a variable takes whole numbers only."""
    component, _, variable = name.partition(".")
    fmu = system.components[component].fmu
    return bool(fmu.variables[fmu.expand(variable)[0]].type != "Real")


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
    if len(set(rows[0])) < len(rows[0]):
        raise InputError(f"--points {path}: a parameter has two columns")
    columns = zip(*rows[1:], strict=True)
    return tuple(_axis(system, name, column) for name, column in zip(rows[0], columns, strict=True))
