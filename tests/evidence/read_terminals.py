"""Mutated terminalsAndIcons.xml, read, shown and connected."""

from __future__ import annotations

import json
import os
from pathlib import Path

from rovbrush.orchestrator.fmu.contents import contents_of
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.system.file.reader import load_system

from . import seeded
from .mutations import mutated
from .strangers import XML
from .toys import DESCRIPTION3, read, write_fmu

NAME = "read_terminals"
CLAIM = "an FMU with a mutated terminalsAndIcons.xml is read whole; terminals are connected, or are one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

PLACE = "terminalsAndIcons/terminalsAndIcons.xml"
SEED = (Path(__file__).parent / "seeds" / "terminals.xml").read_text(encoding="utf-8")
SYSTEM = """format = 2
stop_time = "10 ms"
connections = ["{0} -> {1}"]
[components]
a = {{ fmu = "toy.fmu", period = "1 ms" }}
b = {{ fmu = "toy.fmu", period = "1 ms" }}
"""
ENDS = ["a.port", "b.port", "a.flow", "b.flow", "b.port.inner", "a.port.inner", "a.bus", "b.list", "b.bus", "a.list"]


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    os.environ["ROVBRUSH_CACHE"] = str(folder / "cache")  # goes with the folder
    path = write_fmu(folder / "toy.fmu", DESCRIPTION3.encode(), {PLACE: mutated(random, SEED, XML, most=2)})
    fmu = Fmu.open(path)  # whatever is in that file, the FMU can be run
    json.dumps(contents_of(fmu))
    (folder / "case.toml").write_text(SYSTEM.format(*random.sample(ENDS, 2)))
    return read(lambda: load_system(str(folder / "case.toml"), folder))
