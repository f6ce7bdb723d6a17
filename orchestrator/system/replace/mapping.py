"""A mapping file: what the variables of one of our components are called in somebody else's FMU.

    [variables]                                             # ours = theirs; what is not listed has the same name
    V_in = "supply.voltage"
    valve = "cmd"                                           # an array: valve[1] is cmd[1], and so on
    torque = { name = "tau", sign = -1, unit = "N.m" }      # the opposite direction; a unit that their FMU leaves out
    W_gear = ""                                             # their FMU does not have it

    [inputs]                                                # their own inputs, in their units, held over the run
    temperature = 293.15

    [parameters]                                            # their own parameters
    solver_tolerance = 1e-8

Signs and units of ours are kept in results, summaries and figures; values are converted where they cross.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...errors import InputError, nearest
from ...fmu.types import Value
from ...toml.file import TomlFile
from ...units import parse_unit
from ..schema.checked import checked
from ..schema.keys.mapping import EntryTable, MappingTable


@dataclass(frozen=True)
class Entry:
    """Their variable behind one of ours: `theirs = sign * ours`, converted to their unit. No name: they lack it."""

    name: str
    sign: float = 1.0
    unit: str | None = None  # the unit of theirs where their FMU states none
    where: str = ""  # the line of the mapping file, "(map.toml, line 3)"; empty where it says nothing

    @property
    def absent(self) -> bool:
        return not self.name


@dataclass(frozen=True)
class VariableMapping:
    """A mapping file, read: `entry` finds their variable for one of ours."""

    path: Path | None = None
    entries: Mapping[str, Entry] = field(default_factory=dict)
    inputs: Mapping[str, Value] = field(default_factory=dict)  # by their names, in their units
    parameters: Mapping[str, Value] = field(default_factory=dict)

    def entry(self, ours: str) -> Entry:
        """Their variable for one of ours, scalar or element of an array; the same name where the file says nothing."""
        if ours in self.entries:
            return self.entries[ours]
        base, bracket, index = ours.partition("[")
        if bracket and base in self.entries:
            whole = self.entries[base]
            return Entry(whole.name and f"{whole.name}[{index}", whole.sign, whole.unit, whole.where)
        return Entry(ours)

    def states(self, ours: str) -> bool:
        """Does the file say anything of this variable of ours?"""
        return ours in self.entries or ours.partition("[")[0] in self.entries

    def check(self, ours: Iterable[str], theirs: Iterable[str], component: str, fmu: str) -> None:
        """Raise InputError for names that neither side has. `component` and `fmu` are what the message calls them."""
        known = {"our": _with_bases(ours), "their": _with_bases(theirs)}
        for name, entry in self.entries.items():
            if name not in known["our"]:
                raise InputError(f"{component} has no variable '{name}'{_close(name, known['our'])} {entry.where}")
            if not entry.absent and entry.name not in known["their"]:
                raise InputError(
                    f"{name}: {fmu} has no variable '{entry.name}'{_close(entry.name, known['their'])}; "
                    f'where it has none, write {_key(name)} = "" {entry.where}'
                )
        for table, values in (("inputs", self.inputs), ("parameters", self.parameters)):
            for name in values:
                if name not in known["their"]:
                    raise InputError(
                        f"[{table}]: {fmu} has no variable '{name}'{nearest(name, known['their'])} ({self.file})"
                    )

    @property
    def file(self) -> str:
        """What messages call the file."""
        return self.path.name if self.path else "no mapping file"


def load_mapping(path: Path) -> VariableMapping:
    """Read a mapping file. Raises InputError, with the line, for whatever is not as the head of this file shows."""
    file = TomlFile(path)
    checked(MappingTable, file.data, "", file)
    entries: dict[str, Entry] = {}
    targets: dict[str, str] = {}
    for ours, value in file.entry(dict, "variables").items():
        entry = _entry(file, ours, value)
        if entry.name in targets:
            raise InputError(
                f"{targets[entry.name]} and {ours} both name '{entry.name}'; one variable cannot be two {entry.where}"
            )
        if not entry.absent:
            targets[entry.name] = ours
        entries[ours] = entry
    own = {table: _values(file, table, targets) for table in ("inputs", "parameters")}
    return VariableMapping(path, entries, **own)


def _entry(file: TomlFile, ours: str, value: Any) -> Entry:
    where = file.at(ours, "variables")
    if isinstance(value, str):
        return Entry(value, where=where)
    if not isinstance(value, dict):
        raise InputError(
            f'{ours} = {value!r}: write the name of their variable, {{ name = "x", sign = -1, unit = "N" }}, '
            f'or "" if there is none {where}'
        )
    table = checked(EntryTable, value, ours, file, "variables", where)
    name, sign, unit = ours if table.name is None else table.name, table.sign, table.unit
    if unit is not None:
        try:
            parse_unit(unit)
        except InputError as error:
            raise InputError(f"{ours}: {error} {where}") from None
    return Entry(name, sign, unit, where)


def _values(file: TomlFile, table: str, targets: Mapping[str, str]) -> dict[str, Value]:
    """Values for their own variables, which must not be mapped as well."""
    values: dict[str, Value] = {}
    for name, value in file.entry(dict, table).items():
        where = file.at(name, table)
        if name in targets:
            raise InputError(
                f"[{table}]: '{name}' is mapped to {targets[name]} and has a value too; remove one {where}"
            )
        for scalar, number in _scalars(name, value):
            if not isinstance(number, (bool, int, float, str)):
                raise InputError(f"[{table}]: {scalar} = {number!r} is no number, text or switch {where}")
            values[scalar] = number
    return values


def _scalars(name: str, value: Any) -> list[tuple[str, Any]]:
    return [(f"{name}[{k}]", v) for k, v in enumerate(value, 1)] if isinstance(value, list) else [(name, value)]


def _with_bases(names: Iterable[str]) -> set[str]:
    """The names, and those of the arrays that they are elements of."""
    return {form for name in names for form in (name, re.sub(r"\[\d+\]$", "", name))}


def _close(name: str, known: Iterable[str]) -> str:
    found = difflib.get_close_matches(name, sorted(known), n=1, cutoff=0.5)
    return f"; did you mean '{found[0]}'?" if found else ""


def _key(name: str) -> str:
    return name if re.fullmatch(r"[\w-]+", name) else f'"{name}"'
