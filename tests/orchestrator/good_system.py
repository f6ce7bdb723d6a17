"""A system file without a fault, of which tests make faulty ones."""

from __future__ import annotations

from pathlib import Path

from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

GOOD = """\
format = 2  # A gain is a gain again: words like k, u and y stand in comments too, before the lines that count.
description = "k"
stop_time = "1 s"
connections = [
  "source.y -> g.u",
  "g.y -> i.u (hold)",
]

[components.source]
fmu = "wave"
period = "10 ms"
parameters = { c0 = 1.0 }

[components.g]
fmu = "gain"
period = "10 ms"
[components.g.parameters]
k = 2.0
count = 3
on = true
weights = [1.0, 2.0]

[components.i]
fmu = "integrator"
period = "20 ms"
"""


def read(tmp_path: Path, fmus: Path, text: str, name: str = "case.toml") -> System:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return load_system(str(path), fmus)
