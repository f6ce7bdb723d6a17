"""Mutated OspSystemStructure.xml and OspModelDescription.xml files, of fixed steps and of ECCO."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.system.file.reader import load_system

from . import seeded
from .mutations import mutated
from .strangers import XML
from .toys import SEEDS, prepare_toy, read

NAME = "read_osp"
CLAIM = "a mutated OspSystemStructure.xml is read, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

STRUCTURE, GROUPS = ((SEEDS / name).read_text(encoding="utf-8") for name in ("osp.xml", "osp_groups.xml"))


def prepare(folder: Path) -> None:
    prepare_toy(folder)


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    structure = STRUCTURE.replace("fixedStep", random.choice(["fixedStep", "ecco"]))
    of_groups = random.random() < 0.2
    files = {"OspSystemStructure.xml": structure, "toy_OspModelDescription.xml": GROUPS}
    for name, text in files.items():
        changed = of_groups == (text is GROUPS)
        (folder / name).write_bytes(mutated(random, text, XML) if changed else text.encode())
    (folder / "toy.fmu").symlink_to(folder.parent / "toy.fmu")
    return read(lambda: load_system(str(folder), folder, "1 ms", random.choice(["", "10 ms"])))
