"""Mutated mapping files, read and applied to an FMU."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.replace.mapping import load_mapping
from rovbrush.orchestrator.system.replace.replacement import replace_component

from . import seeded
from .mutations import mutated
from .strangers import TOML
from .toys import DESCRIPTION2, prepare_toy, read, write_fmu

NAME = "read_mapping"
CLAIM = "a mutated mapping file is read and applied, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

SYSTEM = """\
stop_time = "10 ms"
components.a = { fmu = "toy", period = "1 ms", parameters = { k = 2.0 }, inputs = { u = 1.0, v = [0.5, 1.0] } }
record = ["a.y"]
"""
SEED = """\
[variables]
u = { name = "u", sign = -1 }
"v[1]" = "speed"
"v[2]" = ""
label = ""
mode = { name = "" }
y = "w"
w = { name = "y", sign = -1, unit = "rad" }
n = ""
on = { name = "on" }
[inputs]
temperature = 1.5
[parameters]
title = "x"
gear = 2
"""
_systems: list[System] = []


def prepare(folder: Path) -> None:
    prepare_toy(folder)
    theirs = DESCRIPTION2.replace("v[1]", "speed").replace("v[2]", "temperature")
    theirs = theirs.replace('"label"', '"title"').replace('name="mode" valueReference', 'name="gear" valueReference')
    write_fmu(folder / "theirs.fmu", theirs.encode())
    (folder / "case.toml").write_text(SYSTEM)
    _systems.append(load_system(str(folder / "case.toml"), folder))


def one(index: int, folder: Path) -> str:
    path = folder / "map.toml"
    path.write_bytes(mutated(seeded(NAME, index), SEED, TOML))
    fmu = Fmu.open(folder.parent / "theirs.fmu")
    return read(lambda: replace_component(_systems[0], "a", fmu, load_mapping(path)))
