"""What the points of a sweep gave, as a table: sweep.nc and sweep.csv."""

from __future__ import annotations

import csv
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...files import write_file
from ...results.files.hdf5 import OWN_NAME
from ...results.files.netcdf import stored_names
from .design.design import Design

if TYPE_CHECKING:
    import xarray

NOT_COMPUTED = "not computed"


@dataclass(frozen=True)
class Table:
    """All points of a sweep with what they gave."""

    title: str
    design: Design
    figures: Mapping[str, tuple[str, str]]  # unit and definition by name
    records: Mapping[int, Mapping[str, Any]]
    made_with: Sequence[Mapping[str, str]] = ()

    def column(self, figure: str) -> np.ndarray:
        """One figure of merit over the points; NaN where there is none, (points,)."""
        return np.array([math.nan if value is None else value for value in self.values(figure)])

    def values(self, figure: str) -> list[float | int | None]:
        """One figure of merit of each point, whole where its signal is; None where there is none."""
        return [self.records.get(k, {}).get("figures", {}).get(figure) for k in range(len(self.design))]

    def without_effect(self) -> list[str]:
        """The axes of a complete grid along which no figure of merit changes, to the last bit."""
        if self.design.kind != "grid" or any(self.errors()):
            return []
        grids = [self.column(figure).reshape(self.design.shape) for figure in self.figures]
        return [
            axis.name
            for k, axis in enumerate(self.design.axes)
            if len(axis.values) > 1
            and all(np.array_equal(np.broadcast_to(np.take(g, [0], k), g.shape), g, equal_nan=True) for g in grids)
        ]

    def errors(self) -> list[str]:
        """Why a point has no values; empty where it has."""
        records = [self.records.get(k, {"error": NOT_COMPUTED}) for k in range(len(self.design))]
        return [" | ".join(str(record.get("error", "")).split("\n")) for record in records]


def dataset(table: Table) -> xarray.Dataset:
    """Figures of merit over the varied parameters (grid), or over `point` with the parameters as coordinates."""
    import xarray

    design = table.design
    dims = tuple(axis.name for axis in design.axes) if design.kind == "grid" else ("point",)
    coordinates: dict[str, Any] = {
        axis.name: (
            (axis.name,) if design.kind == "grid" else ("point",),
            axis.array(),
            {"units": axis.unit, "long_name": axis.description, **axis.flags()},
        )
        for axis in design.axes
    }
    variables: dict[str, Any] = {
        name: (dims, table.column(name).reshape(design.shape), {"units": unit, "long_name": text})
        for name, (unit, text) in table.figures.items()
    }
    errors = np.array(table.errors(), dtype=object).reshape(design.shape)
    variables["error"] = (dims, errors, {"long_name": "why a point has no values; empty where it has"})
    attributes = {
        "title": table.title, "design": design.kind, "rovbrush": version("rovbrush"),
        "made_with": "; then ".join(", ".join(f"{k} {v}" for k, v in entry.items()) for entry in table.made_with),
        "complete": int(len(table.records) == len(design)),
        **({} if design.seed is None else {"seed": design.seed}),
    }  # fmt: skip
    return xarray.Dataset(variables, coordinates, attributes)


def write_table(table: Table, folder: Path) -> xarray.Dataset:
    """Write sweep.nc and sweep.csv. Raises RunError if the disk refuses.

    A name that netCDF forbids is stored as another, as in result.nc.
    """
    result = dataset(table)
    others = {str(name): other for name, other in stored_names(map(str, result.variables)).items() if other != name}
    stored = result.rename(others)
    for name, other in others.items():
        stored[other].attrs[OWN_NAME] = name
    write_file(folder / "sweep.nc", lambda path: stored.to_netcdf(path, engine="h5netcdf"))
    write_file(folder / "sweep.csv", lambda path: _write_csv(table, path))
    return result


def _write_csv(table: Table, path: Path) -> None:
    """A row per point; columns `name [unit]`, the varied parameters first, the error last."""
    design = table.design
    head = ["point", *(f"{axis.name} [{axis.unit}]" for axis in design.axes)]
    head += [*(f"{name} [{unit}]" for name, (unit, _) in table.figures.items()), "error"]
    columns = [table.values(name) for name in table.figures]
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        for k, error in enumerate(table.errors()):
            values = ["" if column[k] is None else repr(column[k]) for column in columns]
            writer.writerow([k, *design.point(k).values(), *values, error])
