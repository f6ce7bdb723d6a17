"""FMUs in C that carry their sources, and a system of them, compiled once."""

from __future__ import annotations

from pathlib import Path

import pytest
from emit_cases import PARTS, WIRES, Masses, with_sources, with_sources3
from helpers import read_system
from native_build import answers, feedthrough2, feedthrough3
from rovbrush.orchestrator.system.model import System


@pytest.fixture(scope="session")
def carried(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with FMUs that carry their C: mass, force, counter, feedthrough2 and feedthrough3; and `bare`, which
    has none."""

    folder = tmp_path_factory.mktemp("emitted_fmus")
    with_sources(answers(folder / "mass.fmu", "mass"), "answers.c")
    with_sources(answers(folder / "force.fmu", "force"), "answers.c")
    with_sources(answers(folder / "counter.fmu", "counter", "integers", "booleans", "reals"), "answers.c")
    answers(folder / "bare.fmu", "mass")
    with_sources(feedthrough2(folder / "feedthrough2.fmu"), "feedthrough2.c")
    with_sources3(feedthrough3(folder / "feedthrough3.fmu"), "feedthrough3.c", "unused3.c")
    return folder


@pytest.fixture
def masses(tmp_path: Path, carried: Path) -> Masses:
    """Two masses and their force, at three rates with every transfer between two."""

    def make(**keys: object) -> System:
        return read_system(tmp_path, carried, PARTS, WIRES, **{"stop": "0.1 s", "algorithm": "gauss-seidel"} | keys)

    return make
