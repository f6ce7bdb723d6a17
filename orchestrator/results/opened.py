"""The results of an earlier run, read from the folder that it left; of one that ended early too."""

from __future__ import annotations

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import InputError, RunError
from ..extras import needed
from ..files import reason
from .files.hdf5 import EVENTS, OWN_NAME
from .files.netcdf import DATASETS
from .files.writing import ROWS, SUMMARY, UNITS
from .result import Result

if TYPE_CHECKING:
    import xarray

# What HDF5, and what looks into it, raise for a file that is none of ours.
UNREADABLE = (OSError, RuntimeError, ValueError, LookupError, AttributeError, TypeError)


class OpenedResult(Result):
    """As a `Result` of a run of this process, but for `run` and `save`: the files are there already."""

    folder: Path

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def require_good(self) -> Result:
        """The result itself; RunError, which carries it, if the run ended early."""
        if not self.summary["complete"]:
            error = RunError(self.summary.get("failure", f"the run of {self.folder} did not reach its stop"))
            error.result = self
            raise error
        return self

    @cached_property
    def datasets(self) -> dict[str, xarray.Dataset]:
        return {name: table for name, table in self._tables.items() if name != EVENTS}

    @cached_property
    def events(self) -> xarray.Dataset:
        needed("xarray", DATASETS)
        import xarray

        return self._tables.get(EVENTS, xarray.Dataset())

    @cached_property
    def _tables(self) -> dict[str, xarray.Dataset]:
        return open_tables(self.folder / ROWS)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """What is in summary.json; where that was not written, whether the run is complete."""
        return {key: value for key, value in self._told.items() if key != UNITS}

    @cached_property
    def _told(self) -> dict[str, Any]:
        try:
            found = json.loads((self.folder / SUMMARY).read_text(encoding="utf-8"))
            if isinstance(found, dict) and isinstance(found.get("complete"), bool):
                return found
            raise InputError(f"{self.folder / SUMMARY} is no summary of a run")
        except FileNotFoundError:
            return {"complete": self._complete}
        except (OSError, ValueError, RecursionError) as error:
            raise InputError(f"{self.folder / SUMMARY} cannot be read: {error}") from error

    @property
    def comparison(self) -> list[dict[str, Any]]:
        return list(self.summary.get("comparison", []))

    @cached_property
    def units(self) -> dict[str, str]:
        found = self._told.get(UNITS, {})
        return {str(key): str(unit) for key, unit in found.items()} if isinstance(found, dict) else {}

    @property
    def shown(self) -> list[str]:
        return []

    @property
    def title(self) -> str:
        return self.folder.resolve().name

    def save(self, folder: str | Path) -> list[Path]:
        raise InputError(f"these results are in {self.folder} already; copy that folder")

    @property
    def _complete(self) -> bool:
        return all(table.attrs.get("complete") for table in self.datasets.values())

    def __repr__(self) -> str:
        end = max((float(table["time"][-1]) for table in self.datasets.values() if table.sizes["time"]), default=0.0)
        early = "" if self._complete else ", incomplete"
        return f"<Result in {self.folder} to {end:g} s{early}: {', '.join(self.datasets)}>"


def open_result(folder: Path) -> OpenedResult:
    """The results in a folder, or beside a result.nc. Raises InputError if there are none or they cannot be read."""
    place = folder.parent if folder.name == ROWS else folder
    if not os.path.isfile(place / ROWS):  # a name that no file can have, too
        hint = "" if os.path.isdir(place) else ": there is no such folder"
        raise InputError(f"{place} holds no {ROWS}{hint}; give the folder that `rovbrush run --out` named")
    found = OpenedResult(place)
    _ = found.datasets, found.summary
    return found


def open_tables(path: Path) -> dict[str, xarray.Dataset]:
    """The tables of a result.nc by the name of their group, every variable by its own name.

    Raises InputError if the file cannot be read.
    """
    import h5py  # type: ignore[import-untyped]

    try:
        with h5py.File(path, "r") as file:
            return {str(name): _table(group) for name, group in file.items()}
    except UNREADABLE as error:
        raise InputError(f"{path} cannot be read: {reason(error)}") from error


def _table(group: Any) -> xarray.Dataset:
    needed("xarray", DATASETS)
    import xarray

    from .files.hdf5 import texts_of, values_of

    variables: dict[str, Any] = {}
    for name, stored in group.items():
        texts = texts_of(stored)
        own = texts.pop(OWN_NAME, str(name))
        texts.pop("dtype", None)
        variables[own] = ("time", values_of(stored), texts)
    time = variables.pop("time")
    about = {"period": texts_of(group)["period"], "complete": int(group.attrs["complete"].item())}
    return xarray.Dataset(variables, {"time": time}, about)
