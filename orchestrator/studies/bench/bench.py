"""`rovbrush bench`: what the master costs, part by part, each with how long it takes to find out."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ...errors import InputError, counted, nearest
from ...files import prepare_folder, write_file, write_json
from ...fmu.files.windows import how_to_install, wine
from .against import against
from .components.components import component_rows
from .components.elsewhere import elsewhere_rows
from .components.outside import outside_rows
from .components.sizes import size_rows
from .components.windows import PLATFORM, windows_rows
from .fmus.systems import cases, native_folder
from .folders import folder_rows
from .peers.hosts import HOSTS, missing
from .peers.masters import measured, process_figures, rerun_figures
from .runs.foreign import foreign_rows
from .runs.growth import growth_rows
from .runs.gym import gym_rows
from .runs.loop import loop_rows
from .runs.observers import observer_rows
from .runs.pacing import pacing_rows
from .runs.solvers import solver_rows
from .runs.streaming import long_runs
from .runs.sweeps import sweep_rows
from .runs.workers import worker_rows

Rows = list[dict[str, Any]]


@dataclass(frozen=True)
class Part:
    """What a part measures, and about how long that takes on two cores [s], in full and quick."""

    words: str
    full: float
    quick: float


PARTS = {
    "masters": Part("systems in this master, in others and as bare calls", 260.0, 45.0),
    "loop": Part("the loop beside the bare calls of the same FMUs, 4 to 4 000 of them", 120.0, 70.0),
    "foreign": Part("FMUs as other tools export them: many variables, messages, 10 000 signals", 600.0, 120.0),
    "start": Part("a start to the first step, and runs from Python", 30.0, 20.0),
    "components": Part("every component by itself", 60.0, 15.0),
    "sizes": Part("components as their size grows, native and as compiled kernels", 60.0, 30.0),
    "long": Part("memory of long runs", 80.0, 10.0),
    "growth": Part("reader and plan of large systems", 40.0, 15.0),
    "solvers": Part("FMUs for Model Exchange, beside the same solver driven from C", 20.0, 8.0),
    "windows": Part("FMUs for Windows under wine", 20.0, 10.0),
    "elsewhere": Part("FMUs in processes of their own, and at a server on this machine", 25.0, 8.0),
    "gym": Part("environments of Gymnasium: steps and resets", 25.0, 10.0),
    "outside": Part("components that are no FMU: Python functions, and peers by UDP and shared memory", 10.0, 5.0),
    "pacing": Part("deadlines of a run in real time", 15.0, 5.0),
    "observers": Part("who looks on while a run goes", 60.0, 20.0),
    "sweeps": Part("points of a sweep with their results, by FMUs that stay loaded", 90.0, 15.0),
    "workers": Part("several threads in one run, where they pay and where not", 60.0, 20.0),
    "against": Part("this installation against another one", 300.0, 60.0),
    "fmus": Part("the FMUs of the components against those of another folder", 240.0, 120.0),
}


@dataclass(frozen=True)
class Asked:
    """Which parts (all but comparisons, if none is named), how thoroughly, and what to compare with: another
    installation, by its interpreter, or other FMUs, by their folder."""

    parts: tuple[str, ...] = ()
    quick: bool = False
    fmus: Path | None = None
    python: Path | None = None
    folder: Path | None = None

    def chosen(self) -> tuple[str, ...]:
        """The parts, in order. Raises InputError for an unknown one, or a comparison with nothing."""
        for name in self.parts:
            if name not in PARTS:
                raise InputError(f"bench {name}: no such part{nearest(name, PARTS)}; there are {', '.join(PARTS)}")
        if "against" in self.parts and self.python is None:
            raise InputError("bench against: against which? give the other interpreter, --against OTHER/bin/python")
        if "fmus" in self.parts and self.folder is None:
            raise InputError("bench fmus: against which? give the folder of the other FMUs, --against FOLDER")
        compared = {"against": self.python, "fmus": self.folder}
        names = self.parts or tuple(name for name in PARTS if name not in compared)
        return tuple(name for name in PARTS if name in names or compared.get(name))

    def seconds(self, name: str) -> float:
        """About how long a part takes."""
        return PARTS[name].quick if self.quick else PARTS[name].full


@dataclass
class Measured:
    """The rows of each part that was measured."""

    parts: dict[str, Rows] = field(default_factory=dict)


def bench(
    asked: Asked,
    json_file: Path | None = None,
    tell: Callable[[str], None] = lambda _line: None,
    progress: Callable[[float], None] = lambda _share: None,
) -> Measured:
    """Measure; write the rows to a file if one is given.

    `tell` hears how long it will take and what cannot be measured, `progress` the share of that time that is over, 0 to
    1. Raises InputError, or RunError if a run fails.
    """
    names = asked.chosen()
    if json_file:
        prepare_folder(json_file.parent, "--json")
    whole = sum(map(asked.seconds, names))
    tell(f"{counted(len(names), 'part')}, about {_duration(whole)} on two cores: {', '.join(names)}")
    if not asked.quick and whole > 60:
        tell("--quick takes fewer repetitions and shorter runs; `rovbrush bench PART` measures one part")
    result, done = Measured(), 0.0
    for name in names:
        rows: Rows = []
        for share, row in _measure(name, asked, tell):
            rows.append(row)
            progress((done + share * asked.seconds(name)) / whole)
        result.parts[name] = rows
        done += asked.seconds(name)
        progress(done / whole)
    if json_file:
        every = [{"part": name, **row} for name, rows in result.parts.items() for row in rows]
        write_file(json_file, lambda path: write_json(path, every))
    return result


def _measure(name: str, asked: Asked, tell: Callable[[str], None]) -> Iterator[tuple[float, dict[str, Any]]]:
    """The rows of a part as they are found, each with the share of the part that is done."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        if name == "masters":
            found = cases(folder, asked.fmus)
            hosts = _hosts(tell)
            for k, case in enumerate(found):
                yield from _shared(measured(case, hosts, asked.quick), (k + 1) / len(found))
        elif name == "loop":
            yield from loop_rows(folder, asked.quick)
        elif name == "foreign":
            yield from foreign_rows(folder, _hosts(tell), asked.quick)
        elif name == "start":
            yield 1.0, {"system": "nominal", **process_figures(asked.fmus), **rerun_figures(asked.fmus)}
        elif name == "components":
            found = cases(folder, asked.fmus)
            rows = component_rows(native=found[-1].system, python=found[-2].system, quick=asked.quick)
            yield from _shared(rows, 1.0)
        elif name == "sizes":
            yield from size_rows(folder, native_folder(asked.fmus), asked.quick)
        elif name == "long":
            yield from _shared(long_runs(asked.quick), 1.0)
        elif name == "growth":
            yield from growth_rows(folder, asked.quick)
        elif name == "solvers":
            yield from solver_rows(folder, asked.quick)
        elif name == "elsewhere":
            yield from elsewhere_rows(native_folder(asked.fmus), asked.quick)
        elif name == "gym":
            if not asked.parts and find_spec("gymnasium") is None:
                tell("without environments: pip install 'rovbrush[gym]'")
                return
            yield from gym_rows(folder, asked.quick)
        elif name == "outside":
            yield from outside_rows(folder, asked.quick)
        elif name == "pacing":
            yield from pacing_rows(folder, asked.quick)
        elif name == "observers":
            yield from observer_rows(folder, asked.quick)
        elif name == "sweeps":
            yield from sweep_rows(folder, native_folder(asked.fmus), asked.quick)
        elif name == "workers":
            yield from worker_rows(folder, asked.quick)
        elif name == "windows":
            if not asked.parts and wine(PLATFORM) is None:
                tell(f"without FMUs for Windows: {how_to_install(PLATFORM)}")
                return
            yield from windows_rows(folder, native_folder(asked.fmus), asked.quick)
        elif name == "fmus" and asked.folder:
            yield from folder_rows(asked.folder, asked.fmus, asked.quick)
        elif asked.python:
            yield from against(asked.python, folder, asked.fmus, asked.quick)


def _hosts(tell: Callable[[str], None]) -> list[str]:
    """The other masters that are here; of those that are not it is said why."""
    absent = {host: why for host in HOSTS if (why := missing(host))}
    for host, why in absent.items():
        tell(f"without {host}: {why}")
    return [host for host in HOSTS if host not in absent]


def _shared(rows: Sequence[dict[str, Any]], share: float) -> Iterator[tuple[float, dict[str, Any]]]:
    return ((share, row) for row in rows)


def _duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"
