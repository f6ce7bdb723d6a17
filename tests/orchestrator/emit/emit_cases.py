"""What tests of exported systems share: FMUs that carry their C, and the rows of a program beside those of a run."""

from __future__ import annotations

import csv
import re
import subprocess
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from helpers import column, edited
from native_build import NATIVE
from rovbrush.orchestrator.emit.folder import write_c
from rovbrush.orchestrator.results.files.csv import rate_names
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.model import System

Table = dict[str, np.ndarray]


def with_sources(fmu: Path, *files: str) -> Path:
    """An FMU of FMI 2.0 with its C files in it."""
    listed = "".join(f'<File name="{name}"/>' for name in files)
    with zipfile.ZipFile(fmu) as archive:
        head, _, tail = archive.read("modelDescription.xml").decode().partition("<CoSimulation ")
    inside, _, rest = tail.partition("/>")
    xml = f"{head}<CoSimulation {inside}><SourceFiles>{listed}</SourceFiles></CoSimulation>{rest}"
    changes: dict[str, bytes | None] = {f"sources/{name}": (NATIVE / name).read_bytes() for name in files}
    return edited(fmu, fmu.with_suffix(".new"), changes | {"modelDescription.xml": xml.encode()}).replace(fmu)


def with_sources3(fmu: Path, *files: str) -> Path:
    """The same of FMI 3.0."""
    listed = "".join(f'<SourceFile name="{name}"/>' for name in files)
    build = (
        f'<fmiBuildDescription fmiVersion="3.0"><BuildConfiguration modelIdentifier="{fmu.stem}"><SourceFileSet '
        f'language="C11">{listed}</SourceFileSet></BuildConfiguration></fmiBuildDescription>'
    )
    changes = {f"sources/{name}": (NATIVE / name).read_bytes() for name in files}
    changes["sources/buildDescription.xml"] = build.encode()
    made = edited(fmu, fmu.with_suffix(".new"), dict(changes))
    made.replace(fmu)
    return fmu


Masses = Callable[..., System]
PARTS = {
    "a": ("mass", "1 ms", {"m": 1.5, "x0": 0.1}),
    "b": ("mass", "4 ms", {"m": 2.0}),
    "f": ("force", "2 ms", {"k": 40.0, "d": 0.3}),
}
WIRES = [
    "a.x -> f.x1 (mean)",
    "a.v -> f.v1",
    "b.x -> f.x2 (linear)",
    "b.v -> f.v2",
    "f.F -> a.F",
    "f.back -> b.F (mean)",
]


def tables_of(system: System, folder: Path, options: str = "-O1 -w", *values: str, make: str = "") -> dict[str, Table]:
    """What the program of a system writes, by file; `make`: a variable for its Makefile."""
    write_c(system, folder)
    made = subprocess.run(
        ["make", f"CC=gcc {options}", *filter(None, [make])], cwd=folder, capture_output=True, text=True, check=False
    )
    assert made.returncode == 0, made.stderr
    (folder / "rows").mkdir(exist_ok=True)
    (program,) = folder.glob("*_run")
    done = subprocess.run([str(program), "rows", *values], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return {path.name: read_table(path) for path in (folder / "rows").iterdir()}


def read_table(path: Path) -> Table:
    """The columns of a CSV by their names, without units."""
    with path.open(encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    cells = [[float(cell) for cell in row] for row in rows]
    return dict(zip((re.sub(r" \[[^\]]*\]$", "", name) for name in head), np.array(cells).T, strict=True))


def run_of_system(system: System) -> Run:
    """The run of a system, which must reach its end."""
    run = simulate(planned(system))
    assert not run.failure, run.failure
    return run


def differing(tables: Mapping[str, Table], run: Run) -> list[str]:
    """The signals of a run that are not bit by bit those of the tables."""
    from rovbrush.orchestrator.results.signals import Signals

    found, signals = [], Signals(run)
    for group, file in zip(run.plan.groups, rate_names(run.plan), strict=True):
        for key in group.columns:
            name = ".".join(key)
            own = np.asarray(signals[name].values)
            their = tables[file][name]
            if own.shape != their.shape or own.astype(float).tobytes() != their.tobytes():
                found.append(name)
    return found


def alone(fmu: Path, step: str = "", stop: str = "0.1 s", **values: float) -> Run:
    """The run of one FMU."""
    run = simulate(planned(assemble(str(fmu), dict(values), stop, None, step=step)))
    assert not run.failure, run.failure
    return run


def unlike(one: Run, run: Run) -> list[str]:
    """The outputs that are not bit by bit those of the system's run, at the instants of both."""
    found = []
    for group in run.plan.groups:
        for key in group.columns:
            name = ".".join(key)
            if key not in run.plan.layout.outputs or _is_text(run, key):
                continue
            times, own = column(run, name)
            there, their = column(one, f"whole.{name}")
            both = np.isin(times, there), np.isin(there, times)
            assert both[0].sum() > 5
            if own[both[0]].tobytes() != their[both[1]].tobytes():
                found.append(name)
    return found


def _is_text(run: Run, key: tuple[str, str]) -> bool:
    """Whether a signal is a text or bytes, which no exported system shows."""
    return run.plan.system.components[key[0]].fmu.variables[key[1]].type in ("String", "Binary")
