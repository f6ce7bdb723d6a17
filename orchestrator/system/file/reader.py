"""TOML system file -> checked System. Every error names the file, the line where it can be found, and the mend."""

from __future__ import annotations

import difflib
import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from ...clock import instant, require_span
from ...errors import InputError, nearest, or_else
from ...fmu.files.places import named_fmu
from ...toml.file import TomlFile
from ..component import Component
from ..formats import ENDINGS, is_system_file, opened
from ..inputs.free_inputs import require_values
from ..model import FORMATS, System
from ..schema.checked import checked
from ..schema.keys.report import Balance, Comparison, Figure, Window
from ..schema.keys.solving import Loops, Solver
from ..schema.keys.system import KEYS, SystemTable
from ..workers import number_of_workers
from .bonds import bonds_of, requirement_of
from .components import component_of
from .connections.clock_links import is_clock
from .connections.connections import check_drivers, connections_of
from .events.read import events_of
from .figure_kinds import figure_kind, figure_kinds
from .live import live_of
from .messages import check_message
from .parameter_sets import sets_of, stated, with_parameter_sets
from .recorded import recorded_names
from .shipped import SYSTEMS, shipped_systems
from .structure import given_for, with_resized_starts

REPORTING = {"summary": dict, "balance": dict, "compare": list, "figures": list, "messages": list}


def load_system(
    name: str, fmus: Path | None = None, step: str = "", stop: str = "", outside: Sequence[Path] = (), start: str = "",
    values: Mapping[str, object] | None = None, complete: bool = True, parameters: str = "",
) -> System:  # fmt: skip
    """Read and check a system, by the name of a shipped one or by the path of a TOML file, a .ssp, .ssd or .fmu.

    `step`, `stop` and `start`: a period and times for what an SSP of another tool leaves open, or an FMU alone;
    `outside`: folders elsewhere from which an SSP or `python` may take files. `values`: what will be set, of which
    structural parameters count now, since sizes follow them. `complete`: it must say what every input gets.
    `parameters`: a set of them in place of the one that the file names.
    Raises InputError or FmuError for whatever could make the run wrong: see `tests/orchestrator`.
    """
    file = _opened(name, step, stop, start, outside)
    _check_format(file)
    further = {key: value for key, value in file.data.items() if key not in KEYS}
    for key in further:  # a table of an algorithm's settings, or a slip
        if difflib.get_close_matches(key, KEYS, n=1, cutoff=0.8):
            raise file.fail(f"unknown key '{key}'{nearest(key, KEYS)}", key)
    table = checked(SystemTable, {key: value for key, value in file.data.items() if key in KEYS}, "", file)
    if not table.components:
        raise InputError(f"{file.path.name}: 'components' is missing")
    sets, count = sets_of(file, parameters), len(table.components)
    later = {
        key: [*stated(sets, key, over=True), *given_for(key, count, values or {}, "--set")] for key in table.components
    }
    entries = {key: file.entry(dict, key, file.data["components"], "components") for key in table.components}
    components = {
        key: component_of(file, key, entry, fmus, stated(sets, key, over=False), later[key], outside)
        for key, entry in entries.items()
    }
    if table.order and sorted(table.order) != sorted(components):
        raise file.fail(f"order must name every component once: {', '.join(components)}", "order")
    connections = tuple(c for entry in table.connections for c in connections_of(file, components, entry))
    check_drivers(file, components, connections)
    begin, end = _span(file, table)
    record, unknown = _recorded(file, components, table)
    system = System(
        name=file.name, path=file.path, description=table.description, start=begin, stop=end,
        algorithm=table.algorithm,
        order=tuple(table.order), components=components,
        connections=tuple(c for c in connections if not is_clock(components, c)),
        clock_connections=tuple(c for c in connections if is_clock(components, c)),
        loops=checked(Loops, file.entry(dict, "loops"), "loops", file, "loops"),
        solver=checked(Solver, file.entry(dict, "solver"), "solver", file, "solver"),
        bonds=bonds_of(file, components, connections, file.entry(list, "bonds")),
        events=events_of(file, components, connections, file.entry(list, "events")),
        requirements=tuple(requirement_of(file, components, entry) for entry in file.entry(list, "require")),
        live=live_of(file, components), workers=number_of_workers(table.workers, file.fail),
        record=record, reporting=_reporting(file, components), settings=further, format=table.format,
        remarks=(*file.remarks, *unknown), breaches=file.breaches,
    )  # fmt: skip
    system = with_parameter_sets(system, sets, file.path.name)
    system = require_values(system, file.fail) if complete else system
    resized = {
        key: with_resized_starts(c, later[key], file.path.name) for key, c in system.components.items() if c.fmu.resized
    }
    return replace(system, components={**system.components, **resized}) if resized else system


def _span(file: TomlFile, table: SystemTable) -> tuple[Fraction, Fraction]:
    """Start and stop. Raises InputError for what is no time, and for a stop that is not after the start."""
    found = {}
    for key in ("start_time", "stop_time"):
        try:
            found[key] = instant(getattr(table, key), key)
            if key == "stop_time":
                require_span(found["start_time"], found[key])
        except InputError as error:
            raise file.fail(str(error), key) from None
    return found["start_time"], found["stop_time"]


def _check_format(file: TomlFile) -> None:
    """Raise InputError for a file of a later format, before its keys are looked at."""
    found = file.data.get("format", FORMATS[0])
    if type(found) is not int or found not in FORMATS:
        known = " and ".join(map(str, FORMATS))
        raise file.fail(
            f"format = {found!r} is unknown: this version of rovbrush reads {known}; write format = {FORMATS[-1]}, or "
            "update rovbrush for files of a later one",
            "format",
        )


def _recorded(
    file: TomlFile, components: dict[str, Component], table: SystemTable
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What is recorded, and of format 1 what cannot be. Raises InputError for that otherwise."""
    found: list[str] = []
    unknown: list[str] = []
    for pattern in table.record:
        try:
            found += recorded_names(
                components, [pattern], lambda name, why: file.fail(f"record = [{name!r}]: {why}", name)
            )
        except InputError as error:
            if table.format > 1:
                raise
            unknown.append(f"warning: {error}; it is passed over, with format = {FORMATS[-1]} it is an error")
    return tuple(dict.fromkeys(found)), tuple(unknown)


def _reporting(file: TomlFile, components: dict[str, Component]) -> dict[str, Any]:
    """What the file wants reported, as it stands there, each entry of the right type; see `results/requested`."""
    origin, summary = file.path.name, file.entry(dict, "summary")
    for key, text in summary.items():
        if key == "window":
            if not isinstance(text, dict):
                example = '{ angle = "motor.angle", start = 5.0 }'
                raise file.fail(f"{origin}: summary window must be a table such as {example}", key, "summary")
            checked(Window, text, f"{origin}: summary window", file, "summary")
        elif not isinstance(text, str) or not text.strip():
            raise file.fail(
                f'{origin}: summary {key} must be an operation and its signals, such as "mean motor.i"', key, "summary"
            )
    checked(Balance, file.entry(dict, "balance"), f"{origin}: balance", file, "balance")
    for entry in file.entry(list, "compare"):
        checked(Comparison, entry, f"{origin}: compare {entry.get('label', '')}".rstrip(), file, "compare")
    for entry in file.entry(list, "figures"):
        _check_figure(file, entry, f"{origin}: figure {entry.get('file', '')}".rstrip())
    for entry in file.entry(list, "messages"):
        check_message(file, components, entry, f"{origin}: message {entry.get('topic', '')}".rstrip())
    return {key: file.entry(type_, key) for key, type_ in REPORTING.items()}


def _check_figure(file: TomlFile, entry: dict[str, Any], label: str) -> None:
    """An entry of `[[figures]]`: the keys of every figure, and those that its kind adds."""
    kinds, kind = figure_kinds(), entry.get("kind")
    if isinstance(kind, str) and kind not in kinds:
        raise file.fail(f"{label}: unknown kind '{kind}'{nearest(kind, kinds)}", "kind", "figures")
    if "along" in entry and kind is not None:
        raise file.fail(f"{label}: along goes with signals, and a figure of a kind has its own", "along", "figures")
    further = figure_kind(kind).KEYS if isinstance(kind, str) else ()
    checked(Figure, entry, label, file, "figures", further=further)
    for key in further or ("signals",):
        if key not in entry:
            raise file.fail(f"{label}: '{key}' is missing", "[[figures]]")
    for key in ("at", "table"):
        if key in entry and "along" not in entry:
            raise file.fail(f"{label}: {key} goes with `along`, what the signals are drawn along", key, "figures")


def _opened(name: str, step: str, stop: str, start: str, outside: Sequence[Path]) -> TomlFile:
    if is_system_file(name):
        return opened(Path(name), step, stop, tuple(outside), start)
    path = SYSTEMS / f"{name}.toml"
    if not os.path.isfile(path):
        raise InputError(f"no system '{name}'{_meant(name)}")
    return TomlFile(path)


def _meant(name: str) -> str:
    """What a name of no shipped system may stand for: a file that lies here, an FMU of ours, another system."""
    here = next((f"{name}{ending}" for ending in ENDINGS if os.path.isfile(f"{name}{ending}")), "")
    ours = named_fmu(name, None)
    if here or os.path.isfile(ours):
        return f"; did you mean '{here or ours}'?"
    return or_else(
        nearest(name, shipped_systems()), "give the path of a .toml, .ssp, .ssd, .fmu or OspSystemStructure.xml"
    )


def system_description(path: Path) -> str:
    """The first words of a system file about itself."""
    return str(TomlFile(path).data.get("description", ""))
