"""Mutated CSV files of inputs, and CSV files of points of a sweep."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.studies.sweep.design.design import make_design
from rovbrush.orchestrator.system.inputs.series_file import with_files

from . import seeded
from .mutations import mutated
from .strangers import CSV
from .toys import prepare_system, read, toy_system

NAME = "read_input"
CLAIM = "a mutated CSV file of inputs or points is read, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

INPUTS = "time [ms],a.u [deg],a.v[1],a.v[2]\n0,0,1,2\n5,,1.5,\n5,90,2,3\n10,1e1,-2,4\n"
POINTS = "a.k,a.n,a.on,a.label\n1.0,2,true,x\n2.0,3,false,y\n"
prepare = prepare_system


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    path = folder / "table.csv"
    if random.random() < 0.7:
        path.write_bytes(mutated(random, INPUTS, CSV))
        return read(lambda: with_files(toy_system(), [path]))
    path.write_bytes(mutated(random, POINTS, CSV))
    return read(lambda: make_design(toy_system(), {}, table=path))
