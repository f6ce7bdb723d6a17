"""Vectors of outputs along another vector, as they are at an instant: a table, and what a figure of it draws.

A `[[figures]]` entry with `along` is one: `along` and `signals` name arrays of as many elements, `component.variable`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Any

import numpy as np

from ..errors import InputError, nearest
from ..system.model import System
from .files.csv import csv_text
from .signals import Signals
from .tables import Run


@dataclass(frozen=True)
class Profile:
    """A vector: its name, its unit, a value for each place, and `at 20 s` where the entry names instants."""

    name: str
    unit: str
    values: np.ndarray
    when: str = ""

    @property
    def label(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name


@dataclass(frozen=True)
class Profiles:
    """Vectors, in the order of the entry, and the one that they lie along."""

    along: Profile
    vectors: Sequence[Profile]


def elements(system: System, name: str) -> list[str]:
    """The scalars of an array `component.variable`; [] if there is none of this name."""
    component, _, variable = name.partition(".")
    owner = system.components.get(component)
    found = owner.fmu.expand(variable) if owner else []
    return [f"{component}.{one}" for one in found] if found != [variable] else []


def check_profiles(entry: Mapping[str, Any], recorded: set[str], system: System, label: str) -> None:
    """Raise InputError for an entry with `along` that could not be made."""
    for key in ("from", "to", "reference"):
        if key in entry:
            raise InputError(f"{label}: {key} is of a figure over time, which one with `along` is not")
    table = PurePath(str(entry.get("table", "table.csv")))
    if table.name != str(table) or table.suffix != ".csv":
        raise InputError(f"{label}: table must be a plain name that ends in .csv")
    size = 0
    for name in map(str, [entry["along"], *entry["signals"]]):
        found = elements(system, name)
        if not found:
            arrays = {f"{c.name}.{v.partition('[')[0]}" for c in system.components.values() for v in c.fmu.variables}
            raise InputError(f"{label}: there is no array '{name}'{nearest(name, sorted(arrays))}")
        size = size or len(found)
        if len(found) != size:
            raise InputError(f"{label}: {name} has {len(found)} elements, and {entry['along']} has {size}")
        if not all(one in recorded or (name == entry["along"] and is_calculated(system, one)) for one in found):
            raise InputError(f"{label}: {name} is not recorded")


def is_calculated(system: System, name: str) -> bool:
    """Is a scalar a calculated parameter, whose value a run keeps without recording it?"""
    component, _, variable = name.partition(".")
    causality: str = system.components[component].fmu.variables[variable].causality
    return causality == "calculatedParameter"


def profiles(run: Run, entry: Mapping[str, Any]) -> Profiles | None:
    """The vectors of an entry at its instants; None if an element was not recorded, or no instant reached."""
    signals, system = Signals(run), run.plan.system
    places = elements(system, str(entry["along"]))
    if places[0] in signals:
        along = _profile(signals, places, str(entry["along"]), run.end)
    else:
        values = np.array([run.calculated[name] for name in places])
        component, _, variable = places[0].partition(".")
        unit = system.components[component].fmu.variables[variable].unit or "1"
        along = Profile(str(entry["along"]), unit, values)
    instants = [t for t in entry.get("at", [run.end]) if float(system.start) <= t <= run.end]
    names = [str(name) for name in entry["signals"]]
    if not instants or not all(one in signals for name in names for one in elements(system, name)):
        return None
    vectors = []
    for name in names:
        for t in instants:
            when = f"at {t:g} s" if "at" in entry else ""
            vectors.append(_profile(signals, elements(system, name), name, t, when))
    return Profiles(along, vectors)


def _profile(signals: Signals, names: Sequence[str], name: str, instant: float, when: str = "") -> Profile:
    """Elements as they are in the last row at or before an instant."""
    first = signals[names[0]]
    row = max(int(np.searchsorted(first.time, instant + 1e-12 * abs(instant), side="right")) - 1, 0)
    return Profile(name, first.unit, np.array([signals[one].values[row] for one in names]), when)


def write_profiles(run: Run, entry: Mapping[str, Any], path: Path) -> None:
    """The table: a row for each place."""
    found = profiles(run, entry)
    assert found is not None
    columns = [found.along, *found.vectors]
    with path.open("w", encoding="utf-8") as file:
        heads = [" ".join(filter(None, (column.label, column.when))) for column in columns]
        file.write(",".join(map(csv_text, heads)) + "\n")
        for row in zip(*(column.values.tolist() for column in columns), strict=True):
            file.write(",".join(csv_text(value) for value in row) + "\n")
