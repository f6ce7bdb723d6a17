"""The FMUs of the components against those of another folder, such as built from an earlier commit, in turns."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from ...errors import FmuError, InputError, RunError
from ...fmu.files.places import fmu_folder
from ...fmu.fmu import Fmu
from ...plan.plan import Plan, make_plan
from ...system.file.reader import load_system
from ...system.file.shipped import shipped_systems
from .fmus.systems import alone
from .peers.floor import floor_loop

ROUNDS, QUICK = 15, 3
PLACES = ("", "native/fmi2")
FIRST = (
    "import sys, time\nfrom pathlib import Path\n"
    "from rovbrush.orchestrator.studies.bench.folders import single\n"
    "from rovbrush.orchestrator.studies.bench.peers.floor import started\n"
    "plan = single(sys.argv[1], Path(sys.argv[2]), sys.argv[3], Path(sys.argv[4]))\n"
    "begin = time.process_time()\nstarted(plan)\nprint(time.process_time() - begin)\n"
)


def folder_rows(folder: Path, fmus: Path | None, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds per call of every FMU here and in the other folder: medians of runs in turns, and their ratio.

    Of Python FMUs also the CPU time [s] of the first start, which compiles, with an empty cache; of all the size of the
    file [kB]. With each row comes the share of the work that is done. Raises InputError where there are none.
    """
    here = (fmus or fmu_folder()).resolve()
    pairs = [(place, system, name) for place in PLACES for system, name in components(here / place, folder / place)]
    if not pairs:
        raise InputError(f"bench fmus: no FMU of a shipped system is in both {here} and {folder}")
    for k, (place, system, name) in enumerate(pairs):
        sides = (here / place, folder.resolve() / place)
        plans = [single(system, sides[0], name, side) for side in sides]
        seen: list[list[float]] = [[], []]
        for number in range((QUICK if quick else ROUNDS) + 1):
            for side in (0, 1) if number % 2 else (1, 0):  # neither is always the first
                seconds = floor_loop(plans[side]) / (plans[side].clock.stop // min(plans[side].clock.periods.values()))
                if number:  # the first of each compiles
                    seen[side].append(1e6 * seconds)
        files = [plan.system.components[name].fmu.path for plan in plans]
        row: dict[str, Any] = {
            "fmu": f"{place}/{files[0].name}".lstrip("/"), "rounds": len(seen[0]),
            **_compared("us_per_call", *(statistics.median(times) for times in seen)),
            "ratio_of_fastest": min(seen[0]) / min(seen[1]),
            **_compared("kB", *(file.stat().st_size / 1000 for file in files)),
        }  # fmt: skip
        if not place:
            row |= _compared("first_s", *(first_seconds(system, sides[0], name, side) for side in sides))
        yield (k + 1) / len(pairs), row


def _compared(key: str, here: float, there: float) -> dict[str, float]:
    return {f"{key}_here": here, f"{key}_there": there, f"{key}_ratio": here / there}


def components(here: Path, there: Path) -> Iterator[tuple[str, str]]:
    """System and name of each component whose FMU is in both folders, each FMU once: its values are those there."""
    known: set[str] = set()
    for name in sorted(shipped_systems(), key=lambda one: one != "nominal"):
        try:
            system = load_system(name, here)
        except FmuError:  # one of it is not in the folder
            continue
        for key, component in system.components.items():
            file = component.fmu.path.name
            if file not in known and (there / file).is_file():
                known.add(file)
                yield name, key


def single(system: str, fmus: Path, component: str, other: Path) -> Plan:
    """The plan of one component of a shipped system by itself, its FMU from another folder."""
    whole = load_system(system, fmus)
    chosen = whole.components[component]
    fmu = Fmu.open(other / chosen.fmu.path.name)
    return make_plan(alone(replace(whole, components={component: replace(chosen, fmu=fmu)}), component, chosen.period))


def first_seconds(system: str, fmus: Path, component: str, other: Path) -> float:
    """CPU time [s] of the first start of an FMU in a process of its own, with an empty cache."""
    with tempfile.TemporaryDirectory() as cache:
        environment = {**os.environ, "ROVBRUSH_CACHE": cache}
        command = [sys.executable, "-c", FIRST, system, str(fmus), component, str(other)]
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    if done.returncode:
        raise RunError(f"{other}: {component} of {system} failed: {done.stderr.strip()}")
    return float(done.stdout.splitlines()[-1])
