"""Recorded rows as a table of text: a row per instant, a column `name [unit]` per signal."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..signals import Signals
from ..tables import Run

CSV_ROWS = 10_000  # that are text in memory at once


def write_csv(run: Run, path: Path) -> None:
    """A row per instant at which anything is recorded; cells of signals that are not recorded then are empty."""
    signals, ticks = Signals(run), run.ticks
    instants = np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *ticks]))
    found = [[signals[".".join(key)] for key in group.columns] for group in run.plan.groups]
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
                    column = [""] * len(some)
                    for row, value in zip(rows, signal.values[begin:end].tolist(), strict=True):
                        column[row] = csv_text(value)
                    columns.append(column)
            file.writelines(",".join(row) + "\n" for row in zip(*columns, strict=True))


def csv_text(value: float | int | bool | str) -> str:
    """A cell of the table; a text is quoted where it must be."""
    if isinstance(value, str):
        quoted = value.replace('"', '""')
        return f'"{quoted}"' if any(c in value for c in ',"\r\n') else value
    return (
        str(value).lower() if isinstance(value, bool) else f"{value:.10g}" if isinstance(value, float) else str(value)
    )
