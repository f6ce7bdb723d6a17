"""Points are gathered into one sweep only where all that decides their results is the same."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from helpers import read_system
from rovbrush.orchestrator.studies.sweep.workers.point import digest
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.schema.keys.solving import Loops, Solver


def of_component(system: System, **choice: Any) -> System:
    return system.with_component(replace(system.components["i"], **choice))


@pytest.mark.parametrize(
    "change",
    [
        lambda s: of_component(s, tolerance=1e-5),
        lambda s: of_component(s, direct="off"),
        lambda s: of_component(s, event_mode="off"),
        lambda s: of_component(s, clocks={"tick": Fraction(1, 60)}),
        lambda s: of_component(s, period=Fraction(1, 7)),
        lambda s: of_component(s, fmu=replace(s.components["i"].fmu, kind="model-exchange")),
        lambda s: replace(s, solver=Solver(method="rk4")),
        lambda s: replace(s, solver=Solver(tolerance=1e-3)),
        lambda s: replace(s, loops=Loops(tolerance=1e-6)),
        lambda s: replace(s, clock_connections=(Connection(("i", "tick"), ("w", "tick")),)),
        lambda s: replace(s, stop=2 * s.stop),
    ],
    ids=["tolerance", "direct", "event_mode", "clocks", "period", "kind", "method", "solver", "loops", "clock", "stop"],
)
def test_all_that_decides_results_is_in_the_digest_of_a_system(change: Any, tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wave", "10 ms"), "i": ("integrator", "10 ms")}
    system = read_system(tmp_path, fmus, parts, ["w.y -> i.u"])
    assert digest(change(system)) != digest(system) == digest(read_system(tmp_path, fmus, parts, ["w.y -> i.u"]))
