"""Mutated structures, parameter sets and mappings of an SSP, of version 1.0 and of 2.0, which has no schema."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from rovbrush.orchestrator.system.file.reader import load_system

from . import seeded
from .mutations import mutated
from .strangers import XML
from .toys import SEEDS, prepare_toy, read

NAME = "read_ssp"
CLAIM = "a mutated SSD, SSV or SSM is read, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

FILES = {name: (SEEDS / name).read_text(encoding="utf-8") for name in ("case.ssd", "a.ssv", "a.ssm")}


def prepare(folder: Path) -> None:
    prepare_toy(folder)


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    version = random.choice(["1.0", "2.0"])
    changed = random.choice(["case.ssd", "case.ssd", "a.ssv", "a.ssm"])
    for name, text in FILES.items():
        text = re.sub(r'(?<!xml )version="1.0"', f'version="{version}"', text)
        (folder / name).write_bytes(mutated(random, text, XML) if name == changed else text.encode())
    (folder / "resources").mkdir()
    shutil.copy(folder.parent / "toy.fmu", folder / "resources" / "toy.fmu")
    return read(lambda: load_system(str(folder / "case.ssd"), folder, "1 ms", "10 ms"))
