"""Mutated descriptions of FMUs, FMI 1.0, 2.0 and 3.0."""

from __future__ import annotations

import os
from pathlib import Path

from rovbrush.orchestrator.fmu.fmu import Fmu

from . import seeded
from .mutations import mutated
from .strangers import XML
from .toys import DESCRIPTION1, DESCRIPTION2, DESCRIPTION3, read, write_fmu

NAME = "read_description"
CLAIM = "an FMU with a mutated modelDescription.xml is read whole, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    os.environ["ROVBRUSH_CACHE"] = str(folder / "cache")  # goes with the folder
    good = random.choice([DESCRIPTION1, DESCRIPTION2, DESCRIPTION3])
    path = write_fmu(folder / "toy.fmu", mutated(random, good, XML, most=2))

    def reading() -> None:
        fmu = Fmu.open(path)
        for name in fmu.variables:
            fmu.type_of(name)
            _ = fmu.places[name], fmu.arrays[name], fmu.expand(name)
        _ = fmu.can_save_state, fmu.can_serialize_state, fmu.can_vary_step, fmu.recommended_step, fmu.internal_step
        for initial in (False, True):
            fmu.feedthrough(initial)
        for name in fmu.names("input", "parameter"):
            fmu.start(name)
        sizes = {name: 3 for name in fmu.names("structuralParameter") if not isinstance(fmu.start(name), (bytes, str))}
        other = fmu.with_structure(sizes)
        for name in other.names("input", "parameter"):
            other.start(name)

    return read(reading)
