"""What was run, for who finds the results later: manifest.json."""

from __future__ import annotations

import platform
from collections.abc import Iterable
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from ...fmu.reading.structure import STRUCTURAL
from ...system.connection import Connection
from ...system.inputs.series import manifest_of
from ..tables import Run

PACKAGES = ("rovbrush", "numpy", "numba", "scipy", "fmpy", "pythonfmu", "xarray", "h5netcdf")


def manifest(run: Run, files: Iterable[str] = ()) -> dict[str, Any]:
    """Everything needed to know what was run: values, content hashes, versions. No dates: reruns are equal.

    `files`: what the run writes into its folder, for the next run there to know what it may replace.
    """
    system = run.plan.system
    components = {}
    for name, component in system.components.items():
        fmu = component.fmu
        values = {v: fmu.variables[v].start for v in fmu.names(STRUCTURAL, "parameter")}
        components[name] = {
            "fmu": fmu.path.name, "from": fmu.origin, "sha256": fmu.digest, "guid": fmu.description.guid,
            "period_s": float(component.period),
            "parameters": {v: plain_value(value) for v, value in {**values, **component.parameters}.items()},
            "inputs": {**component.inputs, **manifest_of(component.series)},
        }  # fmt: skip
    return {
        "system": system.name, "description": system.description,
        **({"parameters": str(system.parameter_set)} if system.parameter_set else {}),
        **({"start_time_s": float(system.start)} if system.start else {}), "stop_s": float(system.stop),
        "complete": not run.failure,
        **({"ended": run.ended} if run.ended else {}),
        "components": components, "calculated": run.calculated,
        "connections": [_connection(run, c) for c in system.connections],
        "versions": {"python": platform.python_version(), **versions()},
        "platform": f"{platform.system()} {platform.machine()}",
        "files": list(files),
    }  # fmt: skip


def versions() -> dict[str, str]:
    """Of PACKAGES, those that are installed."""
    found = {}
    for package in PACKAGES:
        with suppress(PackageNotFoundError):
            found[package] = version(package)
    return found


def _connection(run: Run, c: Connection) -> dict[str, Any]:
    counter = {"counter": ".".join(c.counted)} if c.counted else {}
    return {"connection": c.label, "transfer": run.plan.choices[c].transfer} | counter


def plain_value(value: Any) -> Any:
    """A start value of a model description (text) as a number where it is one."""
    if not isinstance(value, str):
        return value
    try:
        return {"true": True, "false": False}[value] if value in ("true", "false") else float(value)
    except ValueError:
        return value
