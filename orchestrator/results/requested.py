"""What a system file wants reported against what is recorded, before the run: a slip found after it would cost the
results. Keys and types are checked where the file is read."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import PurePath
from typing import Any

from ..errors import InputError, counted, nearest
from ..system.file.figure_kinds import figure_kind
from ..system.file.merits import OPERATIONS, merit
from ..system.model import System
from .files.writing import RESERVED
from .profiles import check_profiles

BOUNDARY = ("in", "ref", "parameters")  # ends of the CSV files of a recording
RATE = re.compile(r"every_[0-9].*\.csv|varying_steps\.csv")
FORMATS = (".png", ".pdf", ".svg")
ALWAYS = ("real_time_factor", "wall_s", "simulated_s", "start_s", "peak_memory_MB")  # figures of merit of every run


def check_reporting(recorded: set[str], system: System) -> None:
    """Raise InputError for a figure of merit, comparison or figure that could not be made of these signals."""
    reporting, origin = system.reporting, system.path.name
    check_summary(recorded, reporting, origin)
    check_numeric(system, origin)
    merits = [*(key for key in reporting["summary"] if key != "window"), *ALWAYS]
    merits += ["coupling_energy_relative"] if system.bonds else []
    merits += ["energy_balance_relative"] if reporting["balance"] else []
    for entry in reporting["compare"]:
        label = f"{origin}: compare {entry.get('label', '')}".rstrip()
        if entry["value"] not in merits:
            raise InputError(f"{label}: no figure of merit '{entry['value']}'{nearest(str(entry['value']), merits)}")
        if not entry["reference"]:
            raise InputError(f"{label}: reference = 0 has no ratio; compare with another number")
    check_files(system)
    for entry in reporting["figures"]:
        check_figure(entry, recorded, system, f"{origin}: figure {entry.get('file', '')}".rstrip())


def check_files(system: System) -> None:
    """Raise InputError for a figure or a table whose file is one of the results, or that of another figure or table."""
    taken: dict[str, str] = {name: "a file of the results" for name in RESERVED}
    for component in system.components:
        taken |= {f"{component}_{end}.csv".lower(): "a file of --record-boundary" for end in BOUNDARY}
    for entry in system.reporting["figures"]:
        for key in ("file", "table"):
            name = str(entry.get(key, ""))
            label = f"{system.path.name}: figure {entry.get('file', '')}".rstrip()
            other = taken.get(name.lower())  # Windows and macOS tell no capitals apart
            if RATE.fullmatch(name.lower()):
                other = "a file of --csv-per-rate"
            if other:
                raise InputError(f"{label}: {key} = '{name}' would overwrite {other}; give another name")
            if name:
                taken[name.lower()] = "that of another figure or table"


def check_numeric(system: System, origin: str) -> None:
    """Raise InputError for a text of which numbers are wanted: of the window, a figure of merit, or the balance."""
    reporting = system.reporting
    wanted = [("summary window", str(reporting["summary"].get("window", {}).get("angle", "")))]
    wanted += [
        (f"summary {key} = {str(text)!r}", name)
        for key, text in reporting["summary"].items()
        for name in merit(text)[1]
        if key != "window"
    ]
    wanted += [(f"balance {key}", str(name)) for key, names in reporting["balance"].items() for name in names]
    wanted += [
        (f"figure {entry.get('file', '')}", str(name))
        for entry in reporting["figures"]
        for name in entry.get("signals", ())
    ]
    for what, name in wanted:
        component, _, variable = name.partition(".")
        owner = system.components.get(component)
        if owner and variable in owner.fmu.variables and owner.fmu.variables[variable].type in ("String", "Binary"):
            raise InputError(f"{origin}: {what}: '{name}' is a text; name a number")


def check_figure(entry: Mapping[str, Any], recorded: set[str], system: System, label: str) -> None:
    """One `[[figures]]` entry; see `pictures.figures`."""
    file = PurePath(str(entry["file"]))
    if file.name != entry["file"] or file.suffix not in FORMATS:
        raise InputError(f"{label}: file must be a plain name that ends in {', '.join(FORMATS)}")
    if "kind" in entry:
        figure_kind(entry["kind"]).check(entry, system, label)
        return
    if not entry["signals"]:
        raise InputError(f"{label}: signals must be a list of names")
    if "along" in entry:
        check_profiles(entry, recorded, system, label)
        return
    for name in map(str, entry["signals"]):
        if name not in recorded:
            raise InputError(f"{label}: '{name}' is not recorded{nearest(name, recorded)}")


def check_summary(run_or_plan_names: set[str], reporting: Mapping[str, Any], origin: str) -> None:
    """Raise InputError before the run for a figure of merit that could not be computed after it."""
    for key, names in reporting["balance"].items():
        for name in names:
            if name not in run_or_plan_names:
                raise InputError(f"{origin}: balance {key}: '{name}' is not recorded{nearest(name, run_or_plan_names)}")
    for key, text in reporting["summary"].items():
        if key == "window":
            names = [text["angle"]] if "angle" in text else []
        else:
            operation, names = merit(text)
            if operation not in OPERATIONS:
                raise InputError(
                    f"{origin}: summary {key} = {text!r}: unknown operation '{operation}'"
                    f"{nearest(operation, OPERATIONS)}"
                )
            several = len(names) == 1 and names[0] not in run_or_plan_names and len(names[0].split()) > 1
            if len(names) != OPERATIONS[operation] or several:
                raise InputError(
                    f"{origin}: summary {key} = {text!r}: {operation} takes {counted(OPERATIONS[operation], 'signal')}"
                )
        for name in names:
            if name not in run_or_plan_names:
                raise InputError(
                    f"{origin}: summary {key} = {text!r}: '{name}' is not recorded{nearest(name, run_or_plan_names)}"
                )
