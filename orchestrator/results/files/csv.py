"""Recorded rows as a table of text: a row per instant, a column `name [unit]` per signal."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...errors import RunError
from ...files import write_file
from ...plan.plan import Plan
from ..signals import Signals
from ..tables import Run
from .netcdf import group_name

CSV_ROWS = 2_000  # that are text in memory at once


def write_csv(run: Run, path: Path) -> None:
    """A row per instant at which anything is recorded; cells of signals that are not recorded then are empty."""
    _write(run, path, range(len(run.plan.groups)))


def rate_files(run: Run, folder: Path) -> list[Path]:
    """A table for each rate, `every_1_ms.csv`: no cell is empty. Raises RunError for rows that are not in memory."""
    if not isinstance(run.recorded, list):
        raise RunError("no CSV for each rate: the tables are too large; result.nc holds all rows")
    return [
        write_file(folder / name, lambda path, g=g: _write(run, path, [g]))  # type: ignore[misc]
        for g, name in enumerate(rate_names(run.plan))
    ]


def rate_names(plan: Plan) -> list[str]:
    """What the files of `rate_files` are called."""
    return [f"{group_name(plan, g)}.csv" for g in range(len(plan.groups))]


def _write(run: Run, path: Path, chosen: Sequence[int]) -> None:
    """The tables of these rates in one."""
    groups = [run.plan.groups[g] for g in chosen]
    signals, ticks = Signals(run), [run.ticks_of(g) for g in chosen]
    instants = np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *ticks]))
    found = [[signals[".".join(key)] for key in group.columns] for group in groups]
    labels = [csv_text(signal.label) for group in found for signal in group]
    with path.open("w", encoding="utf-8") as file:
        file.write(",".join(["time [s]", *labels]) + "\n")
        for first in range(0, len(instants), CSV_ROWS):
            some = instants[first : first + CSV_ROWS]
            columns = [[repr(run.plan.clock.time(tick)) for tick in some.tolist()]]
            for own, group in zip(ticks, found, strict=True):
                begin, end = np.searchsorted(own, [some[0], some[-1] + 1]).tolist()
                rows = np.searchsorted(some, own[begin:end]).tolist()
                for signal in group:
                    texts = csv_texts(signal.values[begin:end])
                    if len(texts) < len(some):
                        column = [""] * len(some)
                        for row, text in zip(rows, texts, strict=True):
                            column[row] = text
                        texts = column
                    columns.append(texts)
            file.writelines(",".join(row) + "\n" for row in zip(*columns, strict=True))


def csv_texts(values: np.ndarray) -> list[str]:
    """The cells of a column, (instants,). A number that is held is made text once."""
    if values.dtype != np.float64 or not len(values):
        return [csv_text(value) for value in values.tolist()]
    bits = np.ascontiguousarray(values).view(np.int64)  # 0 and -0 differ, nan is itself
    begins = np.flatnonzero(np.concatenate([[True], bits[1:] != bits[:-1]]))
    texts = [f"{value:.10g}" for value in values[begins].tolist()]
    if len(texts) == len(values):
        return texts
    often = np.diff(begins, append=len(values))
    found: list[str] = np.repeat(np.array(texts, dtype=object), often).tolist()
    return found


def csv_text(value: float | int | bool | str | bytes) -> str:
    """A cell of the table; a text is quoted where it must be, bytes are hexadecimal."""
    if isinstance(value, bytes):
        return value.hex()
    if isinstance(value, str):
        quoted = value.replace('"', '""')
        return f'"{quoted}"' if any(c in value for c in ',"\r\n') else value
    return (
        str(value).lower() if isinstance(value, bool) else f"{value:.10g}" if isinstance(value, float) else str(value)
    )
