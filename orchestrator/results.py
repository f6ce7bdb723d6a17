"""What a run leaves on disk: result.nc, result.csv, summary.json, manifest.json and figures.

Every file is written under a temporary name and renamed when complete.
"""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Callable
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .clock import seconds_text
from .errors import InputError, RunError
from .explain import explain
from .plan import Plan
from .series import manifest_of
from .signals import Signals
from .simulation import Run

if TYPE_CHECKING:
    import xarray

PACKAGES = ("rovbrush", "numpy", "numba", "scipy", "fmpy", "pythonfmu", "xarray", "h5netcdf")


def prepare_folder(folder: Path, option: str = "--out") -> None:
    """Create the output folder and prove that it can be written to, before anything is computed. Raises InputError.

    `option` is the one to choose another folder with.
    """
    probe = folder / f".probe.{os.getpid()}.tmp"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe.write_bytes(b"")
        probe.unlink()
    except OSError as error:
        raise InputError(
            f"cannot write to the output folder {folder}: {error.strerror}; choose another with {option}"
        ) from error


def write_file(path: Path, write: Callable[[Path], Any]) -> Path:
    """Let `write` fill a temporary file, then rename it. Raises RunError if the disk refuses."""
    temporary = path.with_name(f".{path.stem}.{os.getpid()}.tmp{path.suffix}")
    try:
        write(temporary)
        temporary.replace(path)
    except OSError as error:
        raise RunError(f"cannot write {path}: {error.strerror or error}; nothing was left half-written") from error
    finally:
        with suppress(OSError):  # a read-only disk would hide the error above
            temporary.unlink(missing_ok=True)
    return path


def datasets(run: Run) -> dict[str, xarray.Dataset]:
    """One dataset per rate, by a name such as `every_500_us`; variables carry unit and description."""
    import xarray

    signals = Signals(run)
    found = {}
    for g, group in enumerate(run.plan.groups):
        variables = {}
        for name in (".".join(key) for key in group.columns):
            signal = signals[name]
            units = {"units": signal.unit} if signal.unit else {}
            variables[name] = ("time", signal.values, {**units, "long_name": signal.description})
        time = ("time", signals.times[g], {"units": "s", "long_name": "time"})
        period = "varies" if run.plan.adaptive else seconds_text(run.plan.clock.seconds(group.period))
        attributes = {"period": period, "complete": int(not run.failure)}
        found[group_name(run.plan, g)] = xarray.Dataset(variables, {"time": time}, attributes)
    return found


def group_name(plan: Plan, group: int) -> str:
    """Name of a rate's table in the results file."""
    if plan.adaptive:
        return "varying_steps"
    return "every_" + seconds_text(plan.clock.seconds(plan.groups[group].period)).replace(" ", "_").replace(
        "/", "_per_"
    )


def write_results(run: Run, folder: Path, summary: dict[str, Any]) -> list[Path]:
    """Write everything; returns the paths in the order of writing. Raises RunError if the disk refuses."""
    tables = datasets(run)

    def netcdf(path: Path) -> None:
        for k, (group, dataset) in enumerate(tables.items()):
            dataset.to_netcdf(path, mode="a" if k else "w", group=group, engine="h5netcdf")

    return [
        write_file(folder / "result.nc", netcdf),
        write_file(folder / "result.csv", lambda path: write_csv(run, path)),
        write_file(folder / "summary.json", lambda path: write_json(path, summary)),
        write_file(folder / "manifest.json", lambda path: write_json(path, manifest(run))),
        *_figures(run, folder),
    ]


def _figures(run: Run, folder: Path) -> list[Path]:
    from .plots import figures

    return [write_file(folder / name, figure.savefig) for name, figure in figures(run)]


def write_csv(run: Run, path: Path) -> None:
    """A row per instant at which anything is recorded, a column `name [unit]` per signal; other cells are empty."""
    signals = Signals(run)
    plan = run.plan
    instants = np.unique(np.concatenate(run.ticks))
    header, columns = ["time [s]"], [[repr(plan.clock.time(tick)) for tick in instants.tolist()]]
    for g, group in enumerate(plan.groups):
        rows = np.searchsorted(instants, run.ticks[g]).tolist()
        for name in (".".join(key) for key in group.columns):
            signal = signals[name]
            header.append(signal.label)
            column = [""] * len(instants)
            for row, value in zip(rows, signal.values.tolist(), strict=True):
                column[row] = csv_text(value)
            columns.append(column)
    with path.open("w", encoding="utf-8") as file:
        file.write(",".join(header) + "\n")
        file.writelines(",".join(row) + "\n" for row in zip(*columns, strict=True))


def csv_text(value: float | int | bool | str) -> str:
    """A cell of the table; a text is quoted where it must be."""
    if isinstance(value, str):
        quoted = value.replace('"', '""')
        return f'"{quoted}"' if any(c in value for c in ',"\r\n') else value
    return (
        str(value).lower() if isinstance(value, bool) else f"{value:.10g}" if isinstance(value, float) else str(value)
    )


def write_json(path: Path, content: Any) -> None:
    """JSON with sorted-by-insertion keys; refuses NaN, which is no JSON."""
    path.write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")


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
