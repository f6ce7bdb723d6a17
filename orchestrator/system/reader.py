"""TOML system file -> checked System. Every error names the file, the line where it can be found, and the mend."""

from __future__ import annotations

import difflib
import os
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from ..clock import duration
from ..errors import InputError, nearest
from ..fmu.fmu import Fmu
from ..toml_file import TomlFile
from .connections import bond_of, check_drivers, connections_of, requirement_of
from .model import Component, System, checked_values
from .series_file import stated_series
from .settings import DEFAULT_ALGORITHM, KEYS
from .stated_units import stated_units

SYSTEMS = Path(__file__).parent.parent / "systems"
COMPONENT_KEYS = {"fmu", "period", "parameters", "inputs", "isolation", "timeout", "units"}
ISOLATION = ("none", "process")


def shipped_systems() -> list[str]:
    """Names of the systems that come with the package."""
    return sorted(path.stem for path in SYSTEMS.glob("*.toml") if "[components." in path.read_text(encoding="utf-8"))


def fmu_folder() -> Path:
    """Where built FMUs are: $ROVBRUSH_FMUS, the checkout's fmus/, or the user's data folder."""
    chosen = os.environ.get("ROVBRUSH_FMUS")
    if chosen:
        return Path(chosen)
    checkout = Path(__file__).parent.parent.parent
    if (checkout / "pyproject.toml").is_file():
        return checkout / "fmus"
    from platformdirs import user_data_path

    return user_data_path("rovbrush") / "fmus"


def load_system(name: str, fmus: Path | None = None, step: str = "", stop: str = "") -> System:
    """Read and check a system, by the name of a shipped one or by the path of a TOML file, a .ssp or a .ssd.

    `step` and `stop`: a period and a stop time for what an SSP of another tool leaves open.
    Raises InputError or FmuError for whatever could make the run wrong: see `tests/orchestrator`.
    """
    file = _opened(name, step, stop)
    data = file.data
    further = {key: value for key, value in data.items() if key not in KEYS}
    for key in further:  # a table of an algorithm's settings, or a slip
        if difflib.get_close_matches(key, KEYS, n=1, cutoff=0.8):
            raise file.fail(f"unknown key '{key}'{nearest(key, KEYS)}", key)
    for key in ("stop_time", "components"):
        if key not in data or data[key] == {}:
            raise InputError(f"{file.path.name}: '{key}' is missing")
    algorithm = str(data.get("algorithm", DEFAULT_ALGORITHM))
    tables = file.entry(dict, "components")
    components = {key: _component(file, key, file.entry(dict, key, tables, "components"), fmus) for key in tables}
    order = tuple(file.entries(str, "order"))
    if order and sorted(order) != sorted(components):
        raise file.fail(f"order must name every component once: {', '.join(components)}", "order")
    connections = tuple(c for entry in file.entry(list, "connections") for c in connections_of(file, components, entry))
    check_drivers(file, components, connections)
    system = System(
        name=file.name, path=file.path, description=str(data.get("description", "")),
        stop=_duration(file, data["stop_time"], "stop_time"), algorithm=algorithm, order=order,
        components=components, connections=connections,
        bonds=tuple(bond_of(file, components, connections, entry) for entry in file.entries(dict, "bonds")),
        requirements=tuple(requirement_of(file, components, entry) for entry in file.entries(dict, "require")),
        record=tuple(file.entries(str, "record")) if "record" in data else ("*",),
        reporting={
            **{key: file.entry(dict, key) for key in ("summary", "balance")},
            **{key: file.entries(dict, key) for key in ("compare", "figures")},
        },
        settings=further,
    )  # fmt: skip
    return _with_parameter_file(file, system)


def _opened(name: str, step: str, stop: str) -> TomlFile:
    path = Path(name)
    if path.suffix in (".ssp", ".ssd"):
        from .ssp.read import SspFile

        return SspFile(path, step, stop)
    if path.suffix != ".toml":
        path = SYSTEMS / f"{name}.toml"
        if not path.is_file():
            raise InputError(
                f"no system '{name}'{nearest(name, shipped_systems())}, or give the path of a .toml, .ssp or .ssd file"
            )
    return TomlFile(path)


def _duration(file: TomlFile, value: object, what: str, table: str = "") -> Fraction:
    try:
        return duration(value, what)
    except InputError as error:
        raise file.fail(str(error), what.split()[-1], table) from None


def _component(file: TomlFile, name: str, table: dict[str, Any], fmus: Path | None) -> Component:
    heading = f"components.{name}"
    if not re.fullmatch(r"\w+", name):
        raise file.fail(f"component name '{name}': only letters, digits and _ are allowed", name)
    for key in table.keys() - COMPONENT_KEYS:
        raise file.fail(f"component {name}: unknown key '{key}'{nearest(key, COMPONENT_KEYS)}", key, heading)
    for key in ("fmu", "period"):
        if key not in table:
            raise file.fail(f"component {name}: '{key}' is missing", f"[{heading}]")
    path = Path(str(table["fmu"]))
    if path.suffix == ".fmu":
        path = path if path.is_absolute() else file.path.parent / path
    else:
        path = (fmus or fmu_folder()) / f"{path}.fmu"
    fmu = Fmu.open(path)
    if "units" in table:
        fmu = replace(fmu, units=stated_units(file, name, table["units"], fmu, heading))
    component = Component(
        name, fmu, _duration(file, table["period"], f"component {name}: period", heading),
        **_isolation(file, name, table, heading),
    )  # fmt: skip
    for kind, causality in (("parameters", "parameter"), ("inputs", "input")):
        for key, value in file.entry(dict, kind, table, heading).items():
            origin = f"{kind} of {name} {file.at(key, heading)}"
            if kind == "inputs" and isinstance(value, dict):
                component = stated_series(component, key, value, file.path.parent, origin)
                continue
            found = checked_values(component, key, value, origin)
            if component.fmu.variables[next(iter(found))].causality != causality:
                raise InputError(f"{origin}: {name}.{key} is no {causality}")
            for scalar, scalar_value in found.items():
                component = component.with_value(scalar, scalar_value)
    return component


def _isolation(file: TomlFile, name: str, table: dict[str, Any], heading: str) -> dict[str, Any]:
    isolation = table.get("isolation", "none")
    if isolation not in ISOLATION:
        raise file.fail(
            f"component {name}: unknown isolation '{isolation}'{nearest(str(isolation), ISOLATION)}",
            "isolation", heading,
        )  # fmt: skip
    if isolation == "none":
        if "timeout" in table:
            raise file.fail(f'component {name}: timeout needs isolation = "process"', "timeout", heading)
        return {}
    if not hasattr(os, "fork"):
        raise file.fail(f"component {name}: isolation needs Linux or macOS; remove it", "isolation", heading)
    limit = (
        {"timeout": _duration(file, table["timeout"], f"component {name}: timeout", heading)}
        if "timeout" in table
        else {}
    )
    return {"isolation": isolation, **limit}


def _with_parameter_file(file: TomlFile, system: System) -> System:
    """Values of the parameter file come under those of the system file itself."""
    name = file.data.get("parameters")
    if name is None:
        return system
    if not isinstance(name, str):
        raise file.fail("parameters must be the name of a file", "parameters")
    table = TomlFile(file.path.parent / name)
    for heading in table.data:  # a table for a component of another system is fine, a misspelt one is not
        close = difflib.get_close_matches(heading, system.components, n=1, cutoff=0.8)
        if heading not in system.components and close:
            raise table.fail(f"no component '{heading}'; did you mean '{close[0]}'?", heading)
    values = {
        f"{c}.{key}": value
        for c, entries in table.data.items()
        if isinstance(entries, dict) and c in system.components
        for key, value in entries.items()
        if not set(system.components[c].fmu.expand(key)) & system.components[c].series.keys()
    }
    own = {
        f"{c.name}.{key}": value
        for c in system.components.values()
        for key, value in {**c.parameters, **c.inputs}.items()
    }
    return system.with_values(values, table.path.name).with_values(own, file.path.name)


def system_description(path: Path) -> str:
    """The first words of a system file about itself."""
    return str(TomlFile(path).data.get("description", ""))
