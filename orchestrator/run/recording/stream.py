"""Rows on their way to disk: the results file of a run that is too long to be kept in memory, as far as it is written.

It is a netCDF file from the beginning, of the same content as that of a shorter run, and says that it is incomplete
until it is finished. After every piece all of it is in the file, and room is reserved for the next one: a disk that
fills up ends the run before a row is lost.
"""

from __future__ import annotations

import os
import shutil
from contextlib import suppress
from pathlib import Path

import numpy as np

from ...errors import RunError
from ...files import reason
from ...loop.texts import Texts
from ...plan.plan import Plan
from ...results.files.netcdf import group_name, stored_names, write_events, write_tables
from ...results.files.rows_file import RowsFile, room_for
from ...results.signals import instants, typed
from ...results.tables import Run
from .observers import NEVER, Piece
from .read_back import as_table, type_of

LARGEST_CHUNK = 1 << 16  # rows that lie together in the file
WIDTH = {"String": 1, "Binary": 2}  # bytes in the file for each of the value: bytes are hexadecimal there
TEXT = 64  # bytes that a text takes beside its own
REFUSED = (OSError, RuntimeError, ValueError, KeyError)  # what HDF5 raises where the disk does, or a descriptor is lost


class Stream:
    """An observer: a file that grows by chunks of rows; `rows` per table are in it.

    `full` says why there is no room for another piece; `pending` holds rows that the disk refused. Room is reserved for
    `AHEAD` pieces.
    """

    AHEAD = 1

    def __init__(self, path: Path, plan: Plan, texts: Texts) -> None:
        self.path, self.plan, self.texts = path, plan, texts
        self.rows = [0] * len(plan.groups)
        self.full = ""
        self.pending: list[np.ndarray] = []
        self._file: RowsFile | None = None
        self._finished = False
        self._names = [stored_names(".".join(key) for key in group.columns) for group in plan.groups]

    @classmethod
    def going_on(cls, file: Path, path: Path, plan: Plan, texts: Texts, rows: list[int]) -> Stream:
        """The stream of a run that was interrupted: a copy of its `file` at `path`."""
        shutil.copyfile(file, path)
        stream = cls(path, plan, texts)
        stream.rows, stream._file = rows, RowsFile(path)
        return stream

    @property
    def taken(self) -> list[int]:
        """Rows per table that it has, here or in the file."""
        return self.rows

    def _unwritten(self) -> list[np.ndarray]:
        """Rows that the disk refused; no tables if there are none."""
        return self.pending

    def take_back(self, table: int, count: int) -> None:
        """The last rows of a table come again."""
        self.rows[table] -= count

    def due(self, tick: int) -> int:
        return NEVER

    def see(self, piece: Piece) -> None:
        """Write more rows of every table. Raises RunError if the disk refuses; what was in the file stays there."""
        self.append(piece.tables)

    def append(self, tables: list[np.ndarray]) -> None:
        """See `see`."""
        try:
            if self._file is None:
                self._create(tables)
            elif any(map(len, tables)):
                self._extend(tables)
        except REFUSED as error:
            raise RunError(f"cannot write {self.path}: {reason(error)}; record less (--record) or make room") from error
        self.rows = [rows + len(table) for rows, table in zip(self.rows, tables, strict=True)]
        if any(map(len, tables)):
            self._reserve(tables)

    def _create(self, tables: list[np.ndarray]) -> None:
        """The file with the first rows."""
        run = Run(self.plan, tables, failure="being written", texts=self.texts)
        file = RowsFile(self.path, new=True)
        try:
            write_tables(run, file, LARGEST_CHUNK)
            file.close()
            self._file = RowsFile(self.path)
        except BaseException:
            file.give_up()
            with suppress(OSError):
                self.path.unlink(missing_ok=True)
            raise

    def _extend(self, tables: list[np.ndarray]) -> None:
        file = self._opened()
        for g, table in enumerate(tables):
            group, first = group_name(self.plan, g), self.rows[g]
            ticks = self.plan.instants_of(g, first, len(table))
            for k, key in enumerate(self.plan.groups[g].columns):
                values = typed(self.plan, key, table[:, k], self.texts)
                file.extend(group, self._names[g][".".join(key)], first, values)
                if self.plan.adaptive and key == ("coupling", "tick"):
                    ticks = table[:, k].astype(np.int64)
            file.extend(group, "time", first, instants(self.plan.clock, ticks))
        file.flush()

    def _reserve(self, tables: list[np.ndarray]) -> None:
        """Room for another piece of this size; `full` says so if there is none."""
        try:
            file, size = self._opened(), 0
            for g, table in enumerate(tables):
                chunk, columns = file.chunk(group_name(self.plan, g)), self.plan.groups[g].columns
                size += room_for(self.rows[g], len(table), len(columns) + 1, chunk)
                size += (
                    len(table)
                    * sum(WIDTH.get(type_of(self.plan, key), 0) for key in columns)
                    * (TEXT + self.texts.longest)
                )
            file.reserve(self.AHEAD * size)
        except OSError as error:
            self.full = (
                f"the rows cannot grow in {self.path.parent}: {reason(error)}; record less (--record) or make room"
            )

    def _opened(self) -> RowsFile:
        """The file, opened anew if it was closed."""
        assert self._file is not None
        if self._file.closed:
            self._file = RowsFile(self.path)
        return self._file

    def _move(self, path: Path) -> None:
        """Go on in a copy of the file, as far as it is whole."""
        assert self._file is not None
        before, self._file = self._file, self._file.copied(path)
        with suppress(OSError):
            if path != self.path:
                self.path.unlink(missing_ok=True)
        before.give_up()
        self.path = path
        for g in range(len(self.plan.groups)):  # a piece may have been cut short
            self._file.cut(group_name(self.plan, g), self.rows[g])

    def copy(self, path: Path) -> None:
        """A copy of the file as it is now. Raises OSError."""
        self._opened().copy(path)

    def close(self) -> None:
        """Bring everything to disk."""
        if self._file is not None:
            with suppress(*REFUSED):
                self._file.close()

    def values(self, group: int, column: int) -> np.ndarray:
        """All values of one signal, in its own type."""
        key = self.plan.groups[group].columns[column]
        place, name = group_name(self.plan, group), self._names[group][".".join(key)]
        if not self._finished:
            return self._opened().values(place, name)
        import h5py  # type: ignore[import-untyped]

        from ...results.files.hdf5 import values_of

        with h5py.File(self.path, "r") as file:
            return values_of(file[place][name])

    def table(self, group: int) -> np.ndarray:
        """A whole table in cells of the loop, as precise as each signal's own type."""
        columns = len(self.plan.groups[group].columns)
        return as_table(self.rows[group], columns, lambda k: self.values(group, k), self.texts)

    def finish(self, path: Path, complete: bool, partly: bool = False, run: Run | None = None) -> None:
        """Write what is pending and what happened in `run`, say how it ended, and give the file its name, also in
        another folder.

        `partly`: without what is pending. Raises OSError or RunError if the disk refuses.
        """
        if self._finished:
            shutil.copyfile(self.path, path)
            return
        unwritten = self._unwritten()
        assert self._file is not None or unwritten
        if path.parent != self.path.parent or not self.path.exists():
            there = path.with_name(f".{path.stem}.{os.getpid()}.tmp{path.suffix}")
            if self._file is None:
                self.path = there
            else:
                self._move(there)
        if unwritten and not partly:
            self.append(unwritten)
        self.pending = []
        if self._file is None:
            raise RunError(f"cannot write {path}: no row found room")
        if run is not None:
            write_events(run, self._opened())
        if complete:
            for g in range(len(self.plan.groups)):
                self._opened().mark_complete(group_name(self.plan, g))
        self._opened().close()
        self.path.replace(path)
        self.path, self._finished = path, True
