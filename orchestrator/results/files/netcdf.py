"""Recorded rows as netCDF: one group per rate; variables carry unit and description.

A name that netCDF forbids, such as `tank.gain/y`, is stored as another one, and the variable's attribute
`recorded_name` holds what it is called; `results.opened` gives every variable its own name back.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...clock import seconds_text
from ...extras import needed
from ...plan.plan import Plan
from ..signals import Signals, typed
from ..tables import EventRow, Run
from .hdf5 import EVENTS, OWN_NAME
from .rows_file import RowsFile

if TYPE_CHECKING:
    import xarray

DATASETS = "a result as datasets"
PIECE = 10_000  # rows of events that are written at once


@dataclass(frozen=True)
class Column:
    """One variable of a table: its values, and what is said of them."""

    name: str
    values: np.ndarray
    attributes: dict[str, str]


@dataclass(frozen=True)
class RateTable:
    """What was recorded at one rate; `columns` are made as they are asked for."""

    name: str  # such as `every_500_us`
    period: str
    complete: bool
    time: np.ndarray
    columns: Iterator[Column]


TIME = {"units": "s", "long_name": "time"}


def rate_tables(run: Run) -> Iterator[RateTable]:
    """All tables of a run, the fastest rate first."""
    signals = Signals(run)
    for g, group in enumerate(run.plan.groups):
        period = "varies" if run.plan.adaptive else seconds_text(run.plan.clock.seconds(group.period))
        columns = (_column(signals, ".".join(key)) for key in group.columns)
        yield RateTable(group_name(run.plan, g), period, not run.failure, signals.times(g), columns)


def _column(signals: Signals, name: str) -> Column:
    signal = signals[name]
    return Column(name, signal.values, _said(signal.unit, signal.description) | _written(signals, name))


def _written(signals: Signals, name: str) -> dict[str, str]:
    """How the values of a signal stand in the file, where that is not as they are."""
    return {"written_as": "hexadecimal"} if signals.is_bytes(name) else {}


def _said(unit: str, description: str) -> dict[str, str]:
    """The attributes of a signal."""
    return {**({"units": unit} if unit else {}), "long_name": description}


def datasets(run: Run) -> dict[str, xarray.Dataset]:
    """One dataset per rate, by a name such as `every_500_us`."""
    needed("xarray", DATASETS)
    import xarray

    return {
        table.name: xarray.Dataset(
            {column.name: ("time", column.values, column.attributes) for column in table.columns},
            {"time": ("time", table.time, TIME)},
            {"period": table.period, "complete": int(table.complete)},
        ) for table in rate_tables(run)
    }  # fmt: skip


def events_dataset(run: Run) -> xarray.Dataset:
    """What happened in a run, one row each; none of a system without events."""
    needed("xarray", DATASETS)
    import xarray

    columns = {column.name: ("time", column.values, column.attributes) for column in event_columns(run)}
    return xarray.Dataset(columns, attrs={"period": "events", "complete": int(not run.failure)})


def stored_names(names: Iterable[str]) -> dict[str, str]:
    """What every variable of a table is called in the file: its own name, but for characters that are forbidden."""
    own = list(names)
    found = {name: "".join(_allowed(c) for c in name).rstrip(" ") for name in own}
    taken = {name for name in own if found[name] == name}
    for name, other in found.items():
        if other != name:
            number, unique = 2, other
            while unique in taken:
                unique, number = f"{other}_{number}", number + 1
            found[name] = unique
            taken.add(unique)
    return found


def _allowed(character: str) -> str:
    if character == "/":
        return "|"
    return character if character.isprintable() else "_"


def write_netcdf(run: Run, path: Path) -> None:
    """A group per table. Raises OSError if the disk refuses."""
    file = RowsFile(path, new=True)
    try:
        write_tables(run, file)
        write_events(run, file)
        file.close()
    finally:
        file.give_up()


def event_columns(run: Run, rows: Sequence[EventRow] | None = None) -> Iterator[Column]:
    """What is true in events, one row each: when, in which order, what happened, and all recorded signals; of some
    `rows` of them."""
    rows = list(run.events) if rows is None else rows
    yield Column("time", np.array([row.time for row in rows], dtype=float), TIME)
    order = {"long_name": "in the order of what happens at the instant"}
    yield Column("number", np.array([row.number for row in rows], dtype=np.int64), order)
    yield Column("what", np.array([row.what for row in rows], dtype=object), {"long_name": "what happened"})
    keys = [key for group in run.plan.groups for key in group.columns]
    cells = np.array([row.cells for row in rows]).reshape(-1, len(keys))
    signals = Signals(run)
    for k, key in enumerate(keys):
        name = ".".join(key)
        yield Column(
            name, typed(run.plan, key, cells[:, k], run.texts), _said(*signals.about(name)) | _written(signals, name)
        )


def write_events(run: Run, file: RowsFile) -> None:
    """The group `events`, of a system that has some; so many rows at a time."""
    if not (run.plan.system.events or run.plan.events):
        return
    waiting, first, count = iter(run.events), 0, len(run.events)
    chunk = PIECE if count > PIECE else 0
    made = file.create(EVENTS, "events", not run.failure, chunk)
    while first == 0 or first < count:
        rows = list(islice(waiting, PIECE))
        columns = list(event_columns(run, rows))
        names = stored_names(column.name for column in columns)
        for column in columns:
            other = {OWN_NAME: column.name} if names[column.name] != column.name else {}
            if first == 0:
                made.add(names[column.name], column.values, {**column.attributes, **other})
            else:
                file.extend(EVENTS, names[column.name], first, column.values)
        first += max(len(rows), 1)


def write_tables(run: Run, file: RowsFile, largest_chunk: int = 0) -> None:
    """All tables into an empty file; they can grow, in chunks of their first rows but `largest_chunk`, if that is set.

    A variable whose name netCDF forbids is called otherwise and says so.
    """
    for table, group in zip(rate_tables(run), run.plan.groups, strict=True):
        names = stored_names(".".join(key) for key in group.columns)
        chunk = min(max(len(table.time), 1), largest_chunk) if largest_chunk else 0
        made = file.create(table.name, table.period, table.complete, chunk)
        made.add("time", table.time, TIME)
        for column in table.columns:
            other = {OWN_NAME: column.name} if names[column.name] != column.name else {}
            made.add(names[column.name], column.values, {**column.attributes, **other})


def group_name(plan: Plan, group: int) -> str:
    """Name of a rate's table in the results file."""
    if plan.adaptive:
        return "varying_steps"
    return "every_" + seconds_text(plan.clock.seconds(plan.groups[group].period)).replace(" ", "_").replace(
        "/", "_per_"
    )
