"""Sets of parameters: values for many components in a file of their own, which a system or a run takes by name."""

from __future__ import annotations

import difflib
import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from ...errors import InputError, nearest
from ...toml.file import TomlFile
from ..model import ParameterSet, System
from ..schema.checked import checked_value
from ..schema.keys.values import Value
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


def sets_of(file: TomlFile, chosen: str = "") -> list[TomlFile]:
    """The set that is taken, the one that it names as its base, the base of that...: what counts first comes first.

    Raises InputError where one is missing, or is below itself.
    """
    found: list[TomlFile] = []
    table = parameter_set(file, chosen)
    while table is not None:
        if any(table.path.samefile(other.path) for other in found):
            if not found[-1].data[BASE]:  # the system's own is above already
                break
            raise found[-1].fail(f"'{BASE}' leads back to {table.path.name}", BASE)
        found.append(table)
        table = _base_of(file, table)
    return found


def _base_of(file: TomlFile, table: TomlFile) -> TomlFile | None:
    """The set below another: of an empty name the one that the system names itself, of a path from the set's folder."""
    if BASE not in table.data:
        return None
    name = table.data[BASE]
    if not isinstance(name, str):
        raise table.fail(f"'{BASE}' must be the name of a set, or \"\" for that of the system", BASE)
    beside = table.path.parent / name
    try:
        return parameter_set(file, str(beside) if name and beside.is_file() else name)
    except InputError as error:
        raise table.fail(str(error), BASE) from None


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


def stated(sets: Sequence[TomlFile], component: str, over: bool) -> list[Stated]:
    """What sets state of a component, what counts last: those that come over the system's own values, or under them.

    See `with_parameter_sets` for what is refused.
    """
    return [
        (key, value, f"{table.name} {table.at(key, component)}")
        for table in reversed(sets)
        if (BASE in table.data) is over and isinstance(entries := table.data.get(component), dict)
        for key, value in entries.items()
    ]


def with_parameter_sets(system: System, sets: Sequence[TomlFile], origin: str) -> System:
    """The values of a set come under those of the system's own file, which is called `origin`.

    Those of one that has a base come over them, and over those of its base; see `sets_of` for the order.
    """
    if not sets:
        return system
    about = description_of(sets[0])
    values = {table.path: _values(system, table) for table in sets}
    own = {
        f"{c.name}.{key}": value
        for c in system.components.values()
        for key, value in {**c.parameters, **c.inputs}.items()
    }
    under, over = ([table for table in reversed(sets) if (BASE in table.data) is above] for above in (False, True))
    placed = system
    for table in under:
        placed = placed.with_values(values[table.path], table.path.name)
    placed = placed.with_values(own, origin)
    for table in over:
        placed = placed.with_values(values[table.path], table.path.name)
    return replace(placed, parameter_set=ParameterSet(sets[0].path.stem, about))


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
