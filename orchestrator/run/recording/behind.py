"""Rows on their way to disk while the run goes on: a piece is written by a thread as the next one is filled.

A piece takes the disk a tenth of a second and more, for which a run in real time cannot wait.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...results.tables import Run
from .observers import Piece
from .stream import Stream


class WrittenBehind(Stream):
    """A stream whose `see` returns at once; the tables of the piece must stay as they are until the next call of it.

    What the disk refuses is told by the next call. Room is reserved for two pieces: one may be on its way.
    """

    AHEAD = 2
    _thread: threading.Thread | None = None
    _piece: list[np.ndarray] | None = None  # on its way, or refused
    _reached: Sequence[int] = ()  # rows in the file before it
    _error: BaseException | None = None

    @property
    def taken(self) -> list[int]:
        piece = self._piece
        if piece is None:
            return self.rows
        return [rows + len(table) for rows, table in zip(self._reached, piece, strict=True)]

    def see(self, piece: Piece) -> None:
        self._settle()
        if self.full:  # there is room for this one alone
            super().append(piece.tables)
            return
        self._piece, self._reached = piece.tables, list(self.rows)
        self._thread = threading.Thread(target=self._write, args=(piece.tables,), name="rows", daemon=True)
        self._thread.start()

    def _write(self, tables: list[np.ndarray]) -> None:
        try:
            super().append(tables)
        except BaseException as error:  # it is raised where somebody hears it
            self._error = error

    def _settle(self, insist: bool = True) -> None:
        """Wait for what is on its way. Raises what became of it, unless it does not `insist`."""
        if self._thread is not None:
            self._thread.join()
            self._thread = None
            if self._error is None:
                self._piece = None
        if self._error is not None and insist:
            raise self._error

    def _unwritten(self) -> list[np.ndarray]:
        before = self._piece or []
        if not (before and self.pending):
            return before or self.pending
        return [np.concatenate(pair) for pair in zip(before, self.pending, strict=True)]

    def append(self, tables: list[np.ndarray]) -> None:
        self._settle()
        super().append(tables)

    def take_back(self, table: int, count: int) -> None:
        self._settle()
        super().take_back(table, count)

    def copy(self, path: Path) -> None:
        self._settle()
        super().copy(path)

    def close(self) -> None:
        self._settle(insist=False)
        super().close()

    def values(self, group: int, column: int) -> np.ndarray:
        self._settle(insist=False)
        return super().values(group, column)

    def finish(self, path: Path, complete: bool, partly: bool = False, run: Run | None = None) -> None:
        self._settle(insist=False)
        self._error = None  # another attempt
        super().finish(path, complete, partly, run)
        self._piece = None
