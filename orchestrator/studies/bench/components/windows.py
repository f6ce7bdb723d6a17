"""What an FMU for Windows costs under wine: a step of each component, beside the same sources compiled for here."""

from __future__ import annotations

import statistics
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from ....errors import InputError
from ....fmu.files.windows import FOLDERS, how_to_install, wine
from ....fmu.fmu import Fmu
from ....plan.plan import make_plan
from ....system.file.reader import load_system
from ..fmus.systems import alone
from ..peers.masters import rovbrush_loop
from .components import STEP

REPEATS = 5
PLATFORM = "win64"


def windows_rows(folder: Path, native: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds per step of every component here and under wine, measured in turns, with the share that is done.

    Raises InputError where wine or the FMUs are missing.
    """
    if wine(PLATFORM) is None:
        raise InputError(f"bench windows: {how_to_install(PLATFORM)}")
    system = load_system("nominal", native)
    for k, name in enumerate(system.components):
        here = alone(system, name, STEP)
        component = here.components[name]
        if component.fmu.windows:
            raise InputError(
                f"{component.fmu.path} has no library for this platform; build it: `rovbrush build --native`"
            )
        theirs = _only_windows(component.fmu.path, folder / f"{name}.fmu")
        there = replace(here, components={name: replace(component, fmu=Fmu.open(theirs))})
        plans = {"here": make_plan(here), "wine": make_plan(there)}
        seconds: dict[str, list[float]] = {}
        for _ in range(1 if quick else REPEATS):
            for where, plan in plans.items():
                steps = plan.clock.stop // plan.clock.periods[name]
                seconds.setdefault(where, []).append(1e6 * rovbrush_loop(plan) / steps)
        found = {where: statistics.median(values) for where, values in seconds.items()}
        row = {"component": name, "runs": len(seconds["here"]), "here_us": found["here"], "wine_us": found["wine"]}
        yield (k + 1) / len(system.components), row | {"beside_us": found["wine"] - found["here"]}


def _only_windows(path: Path, target: Path) -> Path:
    """A copy of an FMU that has lost the libraries of all other platforms. Raises InputError if none is left."""
    with zipfile.ZipFile(path) as archive, zipfile.ZipFile(target, "w") as copy:
        names = [
            name
            for name in archive.namelist()
            if not name.startswith("binaries/") or name.split("/")[1] in FOLDERS[PLATFORM]
        ]
        if not any(name.startswith("binaries/") for name in names):
            raise InputError(
                f"{path} has no library for {PLATFORM}; build it with mingw-w64: `rovbrush build --native`"
            )
        for name in names:
            copy.writestr(name, archive.read(name))
    return target
