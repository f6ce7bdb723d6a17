"""Mutated files of a recording."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.exchange.recordings.read import read_recording

from . import seeded
from .mutations import mutated
from .strangers import CSV
from .toys import read

NAME = "read_recording"
CLAIM = "a mutated file of a recording is read, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

FILES = {
    "m_in.csv": "time,u,v\n0,1,2\n0.001,1.5,2\n0.002,2,2\n",
    "m_ref.csv": "time,y\n0,1\n0.001,1.5\n0.002,2\n",
    "m_ref.opt": "StartTime, 0\nStopTime, 0.002\nStepSize, 0.001\nRelTol, 1e-6\n",
    "m_parameters.csv": "name,causality,value,unit\nk,parameter,1.5,kg\nu,input,1,\ny,output,,m\n",
}


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    changed = random.choice(sorted(FILES))
    for name, text in FILES.items():
        (folder / name).write_bytes(mutated(random, text, CSV) if name == changed else text.encode())
    return read(lambda: read_recording(folder))
