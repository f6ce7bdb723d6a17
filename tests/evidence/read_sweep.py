"""Mutated sweep files, read and made a design of points."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from rovbrush.orchestrator.studies.sweep.design.design import make_design
from rovbrush.orchestrator.studies.sweep.file import sweep_file

from . import seeded
from .mutations import mutated
from .strangers import TOML
from .toys import prepare_system, read, toy_system

NAME = "read_sweep"
CLAIM = "a mutated sweep file is read and made a design, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

SEED = """\
description = "what for"
system = "case.toml"
stop_time = "5 ms"
random = 4
seed = 7
design = "latin"
[set]
"a.u" = 0.5
"a.v" = [1.0, 2.0]
[vary]
"a.k" = "0.5:2.0"
"a.n" = "1:5:log"
"a.mode" = [1, 2]
[summary]
peak_y = "peak a.y"
"""
GRID = (
    SEED.replace("random = 4\n", "")
    .replace('design = "latin"\n', "")
    .replace("0.5:2.0", "0.5:2.0:3")
    .replace("1:5:log", "1,3")
)
RANGES = [
    '"1:2"',
    '"1:2:3"',
    '"2:1:3"',
    '"1:2:99999999999999"',
    '"-1:2:3:log"',
    '"1,1"',
    '"a:b:c"',
    '"::"',
]
SWEEP = replace(TOML, strangers=[*TOML.strangers, *RANGES], values=[*TOML.values, *RANGES])
prepare = prepare_system


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    path = folder / "sweep.toml"
    path.write_bytes(mutated(random, random.choice([SEED, GRID]), SWEEP))

    def reading() -> None:
        file = sweep_file(str(path))
        system = toy_system().with_values(file.values, "set")
        make_design(system, file.vary, file.random, file.seed)

    return read(reading)
