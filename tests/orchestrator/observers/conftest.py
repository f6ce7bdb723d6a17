"""A small system that is looked at."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import Part, system_text
from rovbrush.orchestrator import Model, load

PARTS: dict[str, Part] = {
    "w": ("wave", "2 ms", {"c1": 2.0}), "i": ("integrator", "2 ms"), "j": ("integrator", "6 ms"),
}  # fmt: skip
WIRES = ["w.y -> i.u", "w.y -> j.u"]
MESSAGE = """
[[messages]]
topic = "/there/pose"
type = "PoseStamped"
frame = "ned"
position = ["i.x", 0.5, "w.y"]
orientation = [0.0, 0.0, "i.x"]
[[messages]]
topic = "/there/wrench"
type = "WrenchStamped"
force = ["j.x", 1, 2]
[[messages]]
topic = "/several/rates"
type = "TwistStamped"
linear = ["j.x", "i.x", 0]
"""


@pytest.fixture
def path(tmp_path: Path, fmus: Path) -> Path:
    found = tmp_path / "case.toml"
    found.write_text(system_text(PARTS, WIRES, stop="60 ms") + MESSAGE, encoding="utf-8")
    return found


@pytest.fixture
def model(path: Path, fmus: Path) -> Model:
    return load(path, fmus=fmus)
