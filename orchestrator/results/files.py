"""What a run leaves on disk: result.nc, result.csv, summary.json, manifest.json and figures.

Every file is written under a temporary name and renamed when complete.
"""

from __future__ import annotations

import platform
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import RunError
from ..files import write_file, write_json
from ..plan.explain import explain
from ..system.series import manifest_of
from .netcdf import datasets
from .signals import Signals
from .tables import Run, Stored

CSV_ROWS = 10_000  # that are text in memory at once
PACKAGES = ("rovbrush", "numpy", "numba", "scipy", "fmpy", "pythonfmu", "xarray", "h5netcdf")


def write_results(run: Run, folder: Path, summary: dict[str, Any]) -> list[Path]:
    """Write everything; returns the paths in the order of writing. Raises RunError if the disk refuses.

    What was recorded to a file becomes result.nc, and there is no result.csv.
    """
    table = folder / "result.csv"
    if isinstance(run.recorded, list):
        paths = [
            write_file(folder / "result.nc", lambda path: write_netcdf(run, path)),
            write_file(table, lambda path: write_csv(run, path)),
        ]
    else:
        paths = [finish_stream(run.recorded, folder / "result.nc", not run.failure)]
        table.unlink(missing_ok=True)  # that of an earlier run
    return [
        *paths,
        write_file(folder / "summary.json", lambda path: write_json(path, summary)),
        write_file(folder / "manifest.json", lambda path: write_json(path, manifest(run))),
        *_figures(run, folder),
    ]


def write_netcdf(run: Run, path: Path) -> None:
    """A group per table."""
    for k, (group, dataset) in enumerate(datasets(run).items()):
        dataset.to_netcdf(path, mode="a" if k else "w", group=group, engine="h5netcdf")


def finish_stream(stored: Stored, path: Path, complete: bool) -> Path:
    """Give the file that the rows are in its name. Raises RunError if the disk refuses."""
    try:
        stored.finish(path, complete)
    except OSError as error:
        raise RunError(f"cannot write {path}: {error.strerror or error}") from error
    return path


def _figures(run: Run, folder: Path) -> list[Path]:
    from .plots import figures

    return [write_file(folder / name, figure.savefig) for name, figure in figures(run)]


def write_csv(run: Run, path: Path) -> None:
    """A row per instant at which anything is recorded, a column `name [unit]` per signal; other cells are empty."""
    signals, ticks = Signals(run), run.ticks
    instants = np.unique(np.concatenate(ticks))
    found = [[signals[".".join(key)] for key in group.columns] for group in run.plan.groups]
    with path.open("w", encoding="utf-8") as file:
        file.write(",".join(["time [s]", *(signal.label for group in found for signal in group)]) + "\n")
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


def manifest(run: Run) -> dict[str, Any]:
    """Everything needed to know what was run: values, content hashes, versions, plan. No dates: reruns are equal."""
    system = run.plan.system
    components = {}
    for name, component in system.components.items():
        fmu = component.fmu
        values = {v: fmu.variables[v].start for v in fmu.names("parameter")}
        components[name] = {
            "fmu": fmu.path.name, "sha256": fmu.digest, "guid": fmu.description.guid,
            "period_s": float(component.period),
            "parameters": {v: plain_value(value) for v, value in {**values, **component.parameters}.items()},
            "inputs": {**component.inputs, **manifest_of(component.series)},
        }  # fmt: skip
    return {
        "system": system.name, "description": system.description,
        "stop_s": float(system.stop), "complete": not run.failure,
        "components": components, "calculated": run.calculated,
        "connections": [{"connection": c.label, "transfer": run.plan.choices[c].transfer} for c in system.connections],
        "versions": {"python": platform.python_version(), **{package: version(package) for package in PACKAGES}},
        "platform": f"{platform.system()} {platform.machine()}",
        "plan": explain(run.plan).splitlines(),
    }  # fmt: skip


def plain_value(value: Any) -> Any:
    """A start value of a model description (text) as a number where it is one."""
    if not isinstance(value, str):
        return value
    try:
        return {"true": True, "false": False}[value] if value in ("true", "false") else float(value)
    except ValueError:
        return value
