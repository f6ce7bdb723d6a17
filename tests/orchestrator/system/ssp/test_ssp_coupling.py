"""How a system is coupled survives the way from TOML to SSP and back, and the run is the same bit by bit."""

from __future__ import annotations

import math
import os
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from helpers import system_text
from rovbrush.orchestrator.plan.algorithms.ecco import EccoSettings
from rovbrush.orchestrator.plan.algorithms.iterated import IteratedSettings
from rovbrush.orchestrator.plan.algorithms.registry import algorithm_of
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.ssp.write import write_ssp
from test_ssp_export import assert_equal_plans, plain

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "impulse": "w.J", "displacement": "c.z_c"}
ECCO = {"tolerance": 0.1, "relative": 0.05, "minimum": "1/3000 s", "maximum": "10 ms", "safety": 0.7, "integral": 0.2,
        "proportional": 0.1, "shrink": 0.5, "grow": 1.25}  # fmt: skip


def both(folder: Path, fmus: Path, isolated: bool = False, **keys: Any) -> tuple[System, System]:
    """The quarter car from TOML, and that from its SSP."""
    text = system_text({"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}, WIRES, stop="20 ms", **keys)
    if isolated:
        text = text.replace("[components.w]\n", '[components.w]\nisolation = "process"\ntimeout = "50 s"\n')
    path = folder / "case.toml"
    path.write_text(text, encoding="utf-8")
    system = load_system(str(path), fmus)
    again = load_system(str(write_ssp(system, folder / "case.ssp")))
    assert plain(again) == plain(system)
    assert_equal_plans(system, again)
    runs = [simulate(make_plan(s)) for s in (system, again)]
    assert not runs[0].failure and [t.tobytes() for t in runs[0].tables] == [t.tobytes() for t in runs[1].tables]
    return system, again


def test_an_iteration_and_its_settings(fmus: Path, tmp_path: Path) -> None:
    iteration = {"method": "newton", "tolerance": 1e-9, "max_iterations": 7}
    _, again = both(tmp_path, fmus, algorithm="iterated", iteration=iteration)
    assert again.algorithm == "iterated" and algorithm_of(again).settings == IteratedSettings(
        "newton", tolerance=1e-9, max_iterations=7
    )


def test_settings_of_loops(fmus: Path, tmp_path: Path) -> None:
    _, again = both(tmp_path, fmus, loops={"tolerance": 1e-9, "max_iterations": 7})
    assert (again.loops.tolerance, again.loops.max_iterations) == (1e-9, 7)


def test_ecco_with_all_its_settings(fmus: Path, tmp_path: Path) -> None:
    _, again = both(tmp_path, fmus, algorithm="ecco", ecco=ECCO, bonds=[BOND])
    limits = (Fraction(1, 3000), Fraction(1, 100))
    found = algorithm_of(again).settings
    assert again.algorithm == "ecco" and found == EccoSettings(0.1, 0.05, *limits, 0.7, 0.2, 0.1, 0.5, 1.25)


@pytest.mark.parametrize("limits", [{}, {"limit": 0.5}, {"limit": 0.0, "limit_relative": 0.25}])
def test_the_limits_and_counters_of_a_bond(limits: dict[str, float], fmus: Path, tmp_path: Path) -> None:
    _, again = both(tmp_path, fmus, bonds=[{**BOND, **limits}])
    bond = again.bonds[0]
    assert (bond.limit, bond.limit_relative) == tuple(limits.get(k, math.inf) for k in ("limit", "limit_relative"))
    assert (bond.impulse, bond.displacement) == ("w.J", "c.z_c")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
def test_isolation_and_its_timeout(fmus: Path, tmp_path: Path) -> None:
    _, again = both(tmp_path, fmus, isolated=True, algorithm="iterated")
    assert again.components["w"].isolation == "process" and again.components["w"].timeout == 50
    assert again.components["c"].isolation == ""


@pytest.mark.parametrize("transfer", ["quadratic", "interpolate"])
def test_every_transfer(transfer: str, fmus: Path, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "2 ms")}
    path.write_text(system_text(parts, [f"{WIRES[0]} ({transfer})", WIRES[1]], stop="20 ms"), encoding="utf-8")
    again = load_system(str(write_ssp(load_system(str(path), fmus), tmp_path / "case.ssp")))
    assert [c.transfer for c in again.connections] == [transfer, ""]
