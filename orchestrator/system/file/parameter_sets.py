"""Sets of parameters: values for many components in a file of their own, which a system or a run takes by name."""

from __future__ import annotations

import difflib
import os
from dataclasses import replace
from pathlib import Path

from ...errors import InputError, nearest
from ...toml_file import TomlFile
from ..model import ParameterSet, System
from ..schema.checked import checked_value
from ..schema.values import Value
from ..values import checked_values
from .shipped import SYSTEMS
from .structure import Stated, is_structural

DESCRIPTION = "description"  # of the set, in a line
BASE = "base"  # the set below one that was found by a study: its values come over those of the system's own file
BESIDE = (DESCRIPTION, BASE)  # keys beside the tables


def parameter_set(file: TomlFile, chosen: str = "") -> TomlFile | None:
    """The set that a system file names, or the one chosen instead: a file, or the name of one beside the system or of a
    shipped one. Raises InputError where there is none."""
    name = chosen or file.data.get("parameters")
    if not name:
        return None
    named = Path(name) if chosen else file.path.parent / name
    if name.endswith(".toml") or os.path.isfile(named):
        return TomlFile(named)
    for folder in (file.path.parent, SYSTEMS):
        if os.path.isfile(folder / f"{name}.toml"):
            return TomlFile(folder / f"{name}.toml")
    known = sorted({*_sets_in(SYSTEMS), *_sets_in(file.path.parent)})
    message = (
        f"no parameter set '{name}'{nearest(name, known)} (a set is a file with tables [COMPONENT], beside the system "
        "or one of ours)"
    )
    raise InputError(f"--parameters: {message}") if chosen else file.fail(message, "parameters")


def base_of(file: TomlFile, table: TomlFile | None) -> TomlFile | None:
    """The set below another: of an empty name the one that the system names itself. Raises InputError."""
    if table is None or BASE not in table.data:
        return None
    name = table.data[BASE]
    if not isinstance(name, str):
        raise table.fail(f"'{BASE}' must be the name of a set, or \"\" for that of the system", BASE)
    return parameter_set(file, name)


def shipped_sets() -> dict[str, str]:
    """What the sets that come with the package say of themselves, by name."""
    return {name: description_of(TomlFile(SYSTEMS / f"{name}.toml")) for name in _sets_in(SYSTEMS)}


def _sets_in(folder: Path) -> list[str]:
    """Names of the files that only hold tables of values: a system file has components."""
    found = []
    for path in sorted(folder.glob("*.toml")):
        try:
            data = TomlFile(path).data
        except InputError:
            continue
        tables = {key: value for key, value in data.items() if key not in BESIDE}
        if tables and all(isinstance(value, dict) for value in tables.values()) and "components" not in data:
            found.append(path.stem)
    return found


def description_of(table: TomlFile) -> str:
    """What a set says of itself. Raises InputError if that is no text."""
    text = table.data.get(DESCRIPTION, "")
    if not isinstance(text, str):
        raise table.fail(f"'{DESCRIPTION}' must be a text", DESCRIPTION)
    return text


def stated(table: TomlFile | None) -> dict[str, list[Stated]]:
    """What a set states, by component; see `with_parameter_set` for what is refused."""
    if table is None:
        return {}
    return {
        heading: [(key, value, f"{table.name} {table.at(key, heading)}") for key, value in entries.items()]
        for heading, entries in table.data.items()
        if isinstance(entries, dict)
    }


def with_parameter_set(system: System, table: TomlFile | None, origin: str, base: TomlFile | None = None) -> System:
    """The values of a set come under those of the system's own file, which is called `origin`.

    Those of one that has a base come over them, and the base under them.
    """
    if table is None:
        return system
    about, values = description_of(table), _values(system, table)
    own = {
        f"{c.name}.{key}": value
        for c in system.components.values()
        for key, value in {**c.parameters, **c.inputs}.items()
    }
    if BASE in table.data:
        below = system if base is None else system.with_values(_values(system, base), base.path.name)
        placed = below.with_values(own, origin).with_values(values, table.path.name)
    else:
        placed = system.with_values(values, table.path.name).with_values(own, origin)
    return replace(placed, parameter_set=ParameterSet(table.path.stem, about))


def _values(system: System, table: TomlFile) -> dict[str, object]:
    """What a set says of the components of a system, by full name. Raises InputError."""
    for heading, entries in table.data.items():  # a table for a component of another system is fine, a slip is not
        if heading in BESIDE:
            continue
        close = difflib.get_close_matches(heading, system.components, n=1, cutoff=0.8)
        if not isinstance(entries, dict):
            raise table.fail(f"'{heading}' must be a table of values, [COMPONENT]", heading)
        if heading not in system.components and close:
            raise table.fail(f"no component '{heading}'; did you mean '{close[0]}'?", heading)
        for key, value in entries.items():
            checked_value(Value | list[Value], value, f"{heading}: {key}", table.at(key, heading))
            if heading in system.components and not is_structural(system.components[heading].fmu, key):
                checked_values(system.components[heading], key, value, f"{table.name} {table.at(key, heading)}")
    return {
        f"{c}.{key}": value
        for c, entries in table.data.items()
        if c in system.components
        for key, value in entries.items()
        if not set(system.components[c].fmu.expand(key)) & system.components[c].series.keys()
        and not is_structural(system.components[c].fmu, key)
    }
