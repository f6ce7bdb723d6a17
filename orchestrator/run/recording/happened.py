"""Rows of events: in memory, and where they become many in a file without a name, as other rows go to one."""

from __future__ import annotations

import shutil
import struct
import tempfile
from collections.abc import Iterator, Sequence
from copy import copy
from itertools import islice
from pathlib import Path
from typing import IO, Any, overload

import numpy as np

from ...errors import RunError
from ...files import reason
from ...results.tables import EventRow

IN_MEMORY = 30_000_000  # bytes of rows that are kept there, where a folder is given for more
BESIDE = 300  # bytes that a row takes beside its cells, about
HEAD = struct.Struct("<dqq")  # of a row in the file: time, number, bytes of what happened


class Happened:
    """The rows of a run, each of so many `columns`; without `folder` all stay in memory."""

    def __init__(self, columns: int, folder: Path | None = None) -> None:
        self.columns, self.folder = columns, folder
        self.count = 0
        self.last: EventRow | None = None
        self._kept: list[EventRow] = []
        self._most = max(IN_MEMORY // (8 * columns + BESIDE), 1)
        self._file: IO[bytes] | None = None
        self._stored, self._end = 0, 0  # rows and bytes that are in the file

    def add(self, time: float, what: str, cells: np.ndarray) -> None:
        """Another row; the first of an instant has the number 0. Raises RunError if the disk refuses; it is kept."""
        number = self.last.number + 1 if self.last is not None and self.last.time == time else 0
        self._take(EventRow(time, number, what, cells))
        if len(self._kept) >= self._most and self.folder is not None:
            self._spill(self.folder)

    def _take(self, row: EventRow) -> None:
        self._kept.append(row)
        self.last, self.count = row, self.count + 1

    def _spill(self, folder: Path) -> None:
        try:
            if self._file is None:
                self._file = tempfile.TemporaryFile(dir=folder, prefix=".events.")  # noqa: SIM115 (as long as the run)
            self._file.seek(self._end)
            for row in self._kept:
                write_row(self._file, row)
            self._file.flush()
        except OSError as error:
            raise RunError(f"cannot keep rows of events in {folder}: {reason(error)}; make room") from error
        self._end, self._stored, self._kept = self._file.tell(), self.count, []

    def rows(self) -> Rows:
        """What there is now, also if a run goes back behind it."""
        now = copy(self)
        now._kept = self._kept.copy()
        return Rows(now, self.count)

    def go_back(self, rows: Rows) -> None:
        """To what there was, as `rows` gave it; all must be in memory."""
        then = rows.happened
        self.count, self.last, self._kept = then.count, then.last, then._kept.copy()

    def each(self) -> Iterator[EventRow]:
        """All rows, one after the other."""
        kept, stored = self._kept, self._stored
        if self._file is not None and stored:
            yield from _read(self._file, stored, self.columns)
        yield from kept

    def write(self, path: Path) -> None:
        """All rows into a file. Raises OSError."""
        with path.open("wb") as target:
            if self._file is not None:
                self._file.seek(0)
                shutil.copyfileobj(self._file, target)
                target.truncate(self._end)
                target.seek(self._end)
            for row in self._kept:
                write_row(target, row)

    def read(self, path: Path, count: int) -> None:
        """As they were written instead. Raises OSError, ValueError."""
        self.count, self.last, self._kept, self._file, self._stored, self._end = 0, None, [], None, 0, 0
        with path.open("rb") as source:
            for row in _read(source, count, self.columns):
                self._take(row)
                if len(self._kept) >= self._most and self.folder is not None:
                    self._spill(self.folder)
            if source.read(1):
                raise ValueError("there are more rows of events")


class Rows(Sequence[EventRow]):
    """The first rows of a run; more of them come and are not seen here."""

    def __init__(self, happened: Happened, count: int) -> None:
        self.happened, self._count = happened, count

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[EventRow]:
        return islice(self.happened.each(), self._count)

    @overload
    def __getitem__(self, at: int) -> EventRow: ...
    @overload
    def __getitem__(self, at: slice) -> list[EventRow]: ...
    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, slice):
            return list(self)[at]
        place = at + self._count if at < 0 else at
        if not 0 <= place < self._count:
            raise IndexError(f"there are {self._count} rows of events")
        return next(islice(self.happened.each(), place, None))


def write_row(file: IO[bytes], row: EventRow) -> None:
    text = row.what.encode()
    file.write(HEAD.pack(row.time, row.number, len(text)) + text + row.cells.tobytes())


def _read(file: IO[bytes], count: int, columns: int) -> Iterator[EventRow]:
    """Rows of a file; others may read it meanwhile."""
    at = 0
    for _ in range(count):
        file.seek(at)
        head = file.read(HEAD.size)
        if len(head) < HEAD.size:
            raise ValueError("rows of events are missing")
        time, number, size = HEAD.unpack(head)
        content = file.read(size + 8 * columns)
        if not 0 <= size <= len(content) == size + 8 * columns:
            raise ValueError("a row of events is cut short")
        yield EventRow(time, number, content[:size].decode(), np.frombuffer(content[size:], dtype=float))
        at += HEAD.size + len(content)
