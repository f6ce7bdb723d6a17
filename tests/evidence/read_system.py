"""Mutated system files."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.system.file.reader import load_system

from . import seeded
from .mutations import mutated
from .strangers import TOML
from .toys import prepare_toy, read

NAME = "read_system"
CLAIM = "a mutated system file is read, or is one error of ours"
COUNT = 20_000
UNIT = "files"
LIMIT = 5.0
SAMPLE = 100

SEED = """\
format = 2
description = "two of them"   # a remark
stop_time = "60 ms"
algorithm = "iterated"
order = ["a", "b"]
parameters = "values.toml"
record = ["a.*", "b.y"]
connections = [
  "a.y -> b.u (linear)",
  "b.w -> a.u",
]
[components.a]
fmu = "toy"
period = "2 ms"
isolation = "process"
timeout = "1 s"
parameters = { k = 2.0, n = 3, on = true, label = "text", mode = 2 }
inputs = { v = [0.5, 1.0] }
[components.b]
fmu = "toy.fmu"
period = "1/250 s"
[components.b.inputs]
"v[1]" = { csv = "table.csv", column = "v" }
"v[2]" = { time = [0.0, 0.1], values = [0, 5], unit = "1" }
[[bonds]]
name = "shaft"
effort = "b.u"
flow = "a.u"
sign = -1
limit = 1.0
[[events]]
at = "10 ms"
set = { "a.v[1]" = "1.0" }
[[events]]
name = "e"
when = "b.w > 0.5"
after = "2 ms"
repeat = true
fault = "bias"
on = "b.u"
value = 0.1
until = "40 ms"
[[require]]
value = "a.y"
minimum = 0.0
message = "m"
[iteration]
method = "newton"
tolerance = 1e-6
max_iterations = 20
[summary]
window = { angle = "a.y", start = 0.01, end = 0.05 }
mean_y = "mean a.y"
part = "ratio a.y b.y"
[balance]
supplied = ["a.w"]
lost = []
[[compare]]
label = "mean"
value = "mean_y"
unit = "rad"
reference = 1.0
tolerance = 0.1
[[figures]]
file = "y.png"
title = "y"
signals = ["a.y"]
from = 0.01
"""
VALUES = "[a]\nk = 1.5\n[b]\nk = 2.5\n"
TABLE = "time [ms],v\n0,0\n100,1\n"


def prepare(folder: Path) -> None:
    prepare_toy(folder)


def one(index: int, folder: Path) -> str:
    random = seeded(NAME, index)
    texts = {"case.toml": SEED, "values.toml": VALUES, "table.csv": TABLE}
    changed = "case.toml" if random.random() < 0.9 else random.choice(["values.toml", "table.csv"])
    for name, text in texts.items():
        (folder / name).write_bytes(mutated(random, text, TOML) if name == changed else text.encode())
    (folder / "toy.fmu").symlink_to(folder.parent / "toy.fmu")
    return read(lambda: load_system(str(folder / "case.toml"), folder.parent))
