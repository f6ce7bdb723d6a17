"""Mutated CSV files of inputs, and CSV files of points of a sweep."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.studies.sweep.design import make_design
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.reader import load_system
from rovbrush.orchestrator.system.series_file import with_files

from . import seeded
from .mutations import mutated
from .strangers import CSV
from .toys import prepare_toy, read

NAME = "read_input"
CLAIM = "a mutated CSV file of inputs or points is read, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

SYSTEM = 'stop_time = "10 ms"\ncomponents.a = { fmu = "toy", period = "1 ms", inputs = { u = 1.0, v = [0.5, 1.0] } }\n'
INPUTS = "time [ms],a.u [deg],a.v[1],a.v[2]\n0,0,1,2\n5,,1.5,\n5,90,2,3\n10,1e1,-2,4\n"
POINTS = "a.k,a.n,a.on,a.label\n1.0,2,true,x\n2.0,3,false,y\n"
_systems: list[System] = []


def prepare(folder: Path) -> None:
    prepare_toy(folder)
    (folder / "case.toml").write_text(SYSTEM)
    _systems.append(load_system(str(folder / "case.toml"), folder))


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    path = folder / "table.csv"
    if random.random() < 0.7:
        path.write_bytes(mutated(random, INPUTS, CSV))
        return read(lambda: with_files(_systems[0], [path]))
    path.write_bytes(mutated(random, POINTS, CSV))
    return read(lambda: make_design(_systems[0], {}, table=path))
