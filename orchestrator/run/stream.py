"""Rows on their way to disk: the results file of a run that is too long to be kept in memory, as far as it is written.

It is a netCDF file from the beginning, of the same content as that of a shorter run, and says that it is incomplete
until it is finished.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import RunError
from ..fmu.types import encode_cells
from ..loop.texts import Texts
from ..plan.plan import Plan
from ..results.signals import instants, typed
from ..results.tables import Run

LARGEST_CHUNK = 1 << 16  # rows that lie together in the file
NO_CACHE = 0  # bytes: what is written is not read again


def _opened(path: Path, mode: str) -> Any:
    import h5netcdf  # type: ignore[import-untyped]

    return h5netcdf.File(path, mode, rdcc_nbytes=NO_CACHE)


class Stream:
    """A file that grows by chunks of rows; `rows` per table are in it."""

    def __init__(self, path: Path, plan: Plan, texts: Texts) -> None:
        self.path, self.plan, self.texts = path, plan, texts
        self.rows = [0] * len(plan.groups)
        self._file: Any = None

    def append(self, tables: list[np.ndarray]) -> None:
        """Write more rows of every table. Raises RunError if the disk refuses."""
        try:
            if not any(self.rows):
                self._create(tables)
            elif any(map(len, tables)):
                self._extend(tables)
        except OSError as error:
            why = os.strerror(error.errno) if error.errno else str(error)
            raise RunError(f"cannot write {self.path}: {why}; record less (--record) or make room") from error
        self.rows = [rows + len(table) for rows, table in zip(self.rows, tables, strict=True)]

    def _create(self, tables: list[np.ndarray]) -> None:
        """The file with the first rows; how it looks is left to xarray."""
        from ..results.netcdf import datasets

        found = datasets(Run(self.plan, tables, failure="being written", texts=self.texts))
        for k, (name, dataset) in enumerate(found.items()):
            chunk = {"chunksizes": (min(max(dataset.sizes["time"], 1), LARGEST_CHUNK),)}
            dataset.to_netcdf(
                self.path, mode="a" if k else "w", group=name, engine="h5netcdf", unlimited_dims=("time",),
                encoding=dict.fromkeys(map(str, dataset.variables), chunk),
            )  # fmt: skip

    def _extend(self, tables: list[np.ndarray]) -> None:
        from ..results.netcdf import group_name

        for g, table in enumerate(tables):
            group, first = self._open()[group_name(self.plan, g)], self.rows[g]
            group.resize_dimension("time", first + len(table))
            ticks = self.plan.groups[g].period * np.arange(first, first + len(table))
            for k, key in enumerate(self.plan.groups[g].columns):
                values = typed(self.plan, key, table[:, k], self.texts)
                group[".".join(key)][first:] = values
                if self.plan.adaptive and key == ("coupling", "tick"):
                    ticks = table[:, k].astype(np.int64)
            group["time"][first:] = instants(self.plan.clock, ticks)

    def _open(self) -> Any:
        if self._file is None:
            self._file = _opened(self.path, "a")
        return self._file

    def close(self) -> None:
        """Bring everything to disk; `append` opens the file again."""
        if self._file is not None:
            self._file.close()
            self._file = None

    def values(self, group: int, column: int) -> np.ndarray:
        """All values of one signal, in its own type."""
        from ..results.netcdf import group_name

        key = self.plan.groups[group].columns[column]
        self.close()
        with _opened(self.path, "r") as file:
            found: np.ndarray = file[group_name(self.plan, group)][".".join(key)][:]
        if found.dtype.kind == "O":
            texts = [text.decode() if isinstance(text, bytes) else text for text in found.tolist()]
            return np.array(texts, dtype=object)
        return found.astype(bool) if found.dtype == np.int8 and self._boolean(key) else found

    def _boolean(self, key: tuple[str, str]) -> bool:
        component = self.plan.system.components.get(key[0])
        return component is not None and component.fmu.variables[key[1]].type == "Boolean"

    def table(self, group: int) -> np.ndarray:
        """A whole table in cells of the loop, as precise as each signal's own type."""
        cells = np.empty((self.rows[group], len(self.plan.groups[group].columns)))
        for k in range(cells.shape[1]):
            values = self.values(group, k)
            if values.dtype.kind == "O":
                values = np.array([self.texts.number(text) for text in values.tolist()], dtype=np.int64)
            cells[:, k] = encode_cells(values)
        return cells

    def finish(self, path: Path, complete: bool) -> None:
        """Say how the run ended, and rename the file. Raises OSError if the disk refuses."""
        from ..results.netcdf import group_name

        for g in range(len(self.plan.groups)):
            attributes = self._open()[group_name(self.plan, g)].attrs
            attributes["complete"] = np.asarray(attributes["complete"]).dtype.type(complete)
        self.close()
        self.path = self.path.replace(path)
