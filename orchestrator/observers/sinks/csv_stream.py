"""Rows as lines of CSV, as they come: into a file, or to standard output for the next program.

All tables share the lines: an instant has one, and cells of tables without a row there are empty.
"""

from __future__ import annotations

import csv
import io
import os
import sys
from contextlib import suppress
from typing import Any

from ..asked import file_of
from ..layout import Layout, Rows
from ..sink import FILE_PATIENCE, FILE_ROOM

OUT, ERRORS = 1, 2  # the descriptors of standard output and standard error
BATCH = 1 << 16  # bytes


class CsvStream:
    """Lines are written when all tables are behind their instant. `path` empty: to standard output."""

    room, patience = FILE_ROOM, FILE_PATIENCE

    def __init__(self, path: str) -> None:
        self.path = path
        self._to = -1
        self._waiting: dict[float, list[Any]] = {}
        self._last: list[float] = []
        self._first: list[int] = []
        self._text = io.StringIO()
        self._writer = csv.writer(self._text, lineterminator="\n")

    def open(self, layout: Layout) -> str:
        if self.path:
            self._to = os.open(self.path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o666)
        else:
            self._to = _alone()
        names = ["time"]
        for table in layout.tables:
            self._first.append(len(names))
            names += [column.name for column in table.columns]
        self._count = len(names)
        self._last = [float("-inf")] * len(layout.tables)
        self._writer.writerow(names)
        self._flush()
        return ""

    def write(self, rows: Rows) -> int:
        first = self._first[rows.table]
        for time, values in zip(rows.times.tolist(), rows.each(), strict=True):
            line = self._waiting.setdefault(time, [""] * self._count)
            line[0], line[first : first + len(values)] = time, values
        self._last[rows.table] = float(rows.times[-1])
        self._lines(min(self._last))
        return 0

    def _lines(self, until: float) -> None:
        done = sorted(time for time in self._waiting if time <= until)
        for time in done:
            self._writer.writerow(self._waiting.pop(time))
        if done:
            self._flush()

    def _flush(self) -> None:
        data = self._text.getvalue().encode()
        self._text.seek(0)
        self._text.truncate()
        while data:
            data = data[os.write(self._to, data[:BATCH]) :]

    def close(self) -> None:
        if self._to < 0:
            return
        try:
            self._lines(float("inf"))
        finally:
            if not self.path:
                os.dup2(self._to, OUT)
            os.close(self._to)
            self._to = -1


def _alone() -> int:
    """Standard output for the rows alone: what FMUs and others print from now on goes to standard error."""
    if sys.stdout:
        sys.stdout.flush()
    rows = os.dup(OUT)
    with suppress(OSError):  # there is no standard error
        os.dup2(ERRORS, OUT)
    return rows


def sink_of(where: str, label: str) -> CsvStream:
    """`-` or a file."""
    return CsvStream("" if where == "-" else str(file_of(where, label)))
