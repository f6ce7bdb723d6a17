"""The components of a system file: FMU, period and start values, each checked."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from ...clock import duration
from ...errors import FmuError, InputError, nearest, shown
from ...fmu.binary import beside
from ...fmu.files.places import named_fmu
from ...fmu.fmu import Fmu
from ...fmu.outside.declared import DeclaredFmu
from ...fmu.types import REALS, Value
from ...sockets import TCP, tcp_address
from ...toml.file import TomlFile
from ...units import left_open, parse_unit
from ..component import Component
from ..inputs.series_file import stated_series
from ..schema.checked import checked, checked_value
from ..schema.keys.system import ComponentTable
from ..values import checked_values
from .outside.component import outside_component
from .structure import Stated, is_structural, with_structure

STATED = (bool, int, float, str)  # what a value in a file may be


def component_of(
    file: TomlFile, name: str, entry: dict[str, Any], fmus: Path | None, before: Sequence[Stated] = (),
    after: Sequence[Stated] = (), outside: Sequence[Path] = (),
) -> Component:  # fmt: skip
    """One table `[components.name]`. Raises InputError or FmuError.

    `outside`: folders elsewhere from which files may be taken. `before`, `after`: values beside its own, of which
    those of structural parameters count now, under and over those.
    """
    heading = f"components.{name}"
    if not re.fullmatch(r"\w+", name):
        raise file.fail(f"component name '{name}': only letters, digits and _ are allowed", name)
    for key in ("parameters", "inputs"):
        file.entry(dict, key, entry, heading)
    table = checked(ComponentTable, entry, f"component {name}", file, heading)
    fmu = _fmu_of(file, name, entry, table, fmus, outside)
    if table.kind is not None:
        try:
            fmu = fmu.of_kind(table.kind)
        except FmuError as error:
            raise file.fail(f"component {name}: {error}", "kind", heading) from None
    own = [(key, value, f"parameters of {name} {file.at(key, heading)}") for key, value in table.parameters.items()]
    fmu = with_structure(name, fmu, [*before, *own, *after])
    if table.units:
        fmu = replace(fmu, units=stated_units(file, name, table.units, fmu, heading))
    try:
        period = duration(table.period, f"component {name}: period")
    except InputError as error:
        raise file.fail(str(error), "period", heading) from None
    own_process = _isolation(file, name, table, "timeout" in entry, heading)
    remarks = (fmu.remark,) if isinstance(fmu, DeclaredFmu) and fmu.remark else ()
    component = Component(name, fmu, period, notes=(*file.notes.get(name, ()), *remarks), **own_process)
    component = replace(component, logging=table.logging, tolerance=table.tolerance, direct=table.direct)
    component = replace(component, parallel=table.parallel)
    component = replace(
        component,
        event_mode=table.event_mode,
        clocks=_intervals(file, component, table.clocks, heading),
    )
    return _with_values(file, component, table, heading)


def _intervals(file: TomlFile, component: Component, stated: Mapping[str, object], heading: str) -> dict[str, Fraction]:
    """The intervals of clocks that the file sets. Raises InputError for a clock whose interval is not to be set."""
    found = {}
    for name, text in stated.items():
        label, known = f"component {component.name}: clock {name}", component.fmu.clocks
        if name not in known:
            raise file.fail(
                f"{label}: {component.fmu.path.name} has no such clock{nearest(name, known)}", name, heading
            )
        if not known[name].settable:
            raise file.fail(
                f"{label}: it is {known[name].variability}, its interval is not to be set; fixed and tunable clocks "
                f"that state one take another",
                name,
                heading,
            )
        try:
            found[name] = duration(text, f"{label}: interval")
        except InputError as error:
            raise file.fail(str(error), name, heading) from None
    return found


def _fmu_of(
    file: TomlFile, name: str, entry: Mapping[str, Any], table: ComponentTable, fmus: Path | None,
    outside: Sequence[Path],
) -> Fmu:  # fmt: skip
    """The FMU of a component, or what takes part as one."""
    if name in file.made:
        made: Fmu = file.made[name]
        return made
    found = outside_component(file, name, entry, table, outside)
    if found is not None:
        return found
    assert table.fmu is not None
    path = _path_of(table.fmu, file.path.parent, fmus)
    return Fmu.open(path, table.compile, elsewhere=table.isolation.startswith(TCP))


def _path_of(stated: str, beside: Path, fmus: Path | None) -> Path:
    """The file, or the folder of an unpacked FMU, that is stated: its path, or the name of a built one."""
    path = beside / stated
    named = (
        path.suffix.lower() == ".fmu"
        or "/" in stated
        or "\\" in stated
        or os.path.isfile(path / "modelDescription.xml")
    )
    built = named_fmu(stated, fmus)
    return path if named and not os.path.isfile(built) else built


def _with_values(file: TomlFile, component: Component, table: ComponentTable, heading: str) -> Component:
    name = component.name
    for kind, values in (("parameters", table.parameters), ("inputs", table.inputs)):
        found: dict[str, Value] = {}
        for key, value in values.items():
            origin = f"{kind} of {name} {file.at(key, heading)}"
            if kind == "inputs" and isinstance(value, dict):
                component = stated_series(component, key, value, file.path.parent, origin)
                continue
            for one in value if isinstance(value, list) else [value]:
                if not isinstance(one, STATED) and component.fmu.expand(key):
                    raise InputError(f"{origin}: {name}.{key} = {one} is not a finite number, text, true or false")
            if is_structural(component.fmu, key):  # it is in the FMU already: see `structure`
                if kind == "inputs":
                    raise InputError(f"{origin}: {name}.{key} is a structural parameter: it is set under parameters")
                if (of := component.fmu.main_name(key)) != key and of in values:
                    raise InputError(f"{origin}: {name}.{of} has a value already; {name}.{key} is the same variable")
                continue
            scalars = checked_values(component, key, beside(value, file.path.parent), origin)
            is_input = component.fmu.variables[next(iter(scalars))].causality == "input"
            if is_input != (kind == "inputs"):
                raise InputError(f"{origin}: {name}.{key} is no {'parameter' if is_input else 'input'}")
            if twice := found.keys() & scalars.keys():
                raise InputError(
                    f"{origin}: {name}.{min(twice)} has a value already; {name}.{key} is the same variable"
                )
            found |= scalars
        component = component.with_values(found)
    return component


def _isolation(file: TomlFile, name: str, table: ComponentTable, limited: bool, heading: str) -> dict[str, Any]:
    elsewhere, own = table.isolation.startswith(TCP), f"component {name}"
    if table.token_file and not elsewhere:
        raise file.fail(f'{own}: token_file needs isolation = "tcp://HOST:PORT"', "token_file", heading)
    if table.isolation == "none":
        if limited:
            raise file.fail(f'{own}: timeout needs isolation = "process"', "timeout", heading)
        return {}
    if elsewhere:
        try:
            tcp_address(table.isolation)
        except InputError as error:
            raise file.fail(f"{own}: isolation = {error}", "isolation", heading) from None
    elif table.isolation != "process":
        known = nearest(table.isolation, ("none", "process", "tcp://HOST:PORT"))
        raise file.fail(f"{own}: unknown isolation '{shown(table.isolation)}'{known}", "isolation", heading)
    elif not hasattr(os, "fork"):
        raise file.fail(f"{own}: isolation needs Linux or macOS; remove it", "isolation", heading)
    try:
        found = {"isolation": table.isolation, "timeout": duration(table.timeout, f"{own}: timeout")}
    except InputError as error:
        raise file.fail(str(error), "timeout", heading) from None
    return found | ({"token_file": str(file.path.parent / table.token_file)} if table.token_file else {})


def stated_units(file: TomlFile, component: str, entry: dict[str, str] | str, fmu: Fmu, heading: str) -> dict[str, str]:
    """Units that an FMU leaves out, by scalar: stated in the system file or in a file beside it.

    units = { torque = "N.m", speed = "rad/s" }      # or: units = "pump_units.toml", a file with such lines

    Raises InputError for a name that the FMU does not have or that is no real number, a unit that is not understood,
    and one that contradicts the FMU.
    """
    if isinstance(entry, str):
        file, heading = TomlFile(file.path.parent / entry), ""
        entry = file.data
        for name, unit in entry.items():
            checked_value(str, unit, f"component {component}: unit of {name}", file.at(name))
    found: dict[str, str] = {}
    for name, unit in entry.items():
        scalars = fmu.expand(name)
        label = f"component {component}: unit of {name}"
        if not scalars:
            raise file.fail(
                f"{label}: {fmu.path.name} has no such variable{nearest(name, fmu.variables)}", name, heading
            )
        found |= {scalar: _checked_unit(file, label, name, unit, fmu, scalar, heading) for scalar in scalars}
    return found


def _checked_unit(file: TomlFile, label: str, name: str, unit: Any, fmu: Fmu, scalar: str, heading: str) -> str:
    variable = fmu.variables[scalar]
    if variable.type not in REALS:
        raise file.fail(f"{label}: it is of type {variable.type}, which has no unit", name, heading)
    own, said = fmu.unit(scalar), fmu.unit_called(str(unit), scalar)
    try:
        if said.definition is None:
            parse_unit(said.name)
        if own is not None and own.name != said.name and not left_open(own, said):
            raise InputError(f"{fmu.path.name} states {own} itself; remove {unit!r}")
    except InputError as error:
        raise file.fail(f"{label}: {error}", name, heading) from None
    return str(unit)
