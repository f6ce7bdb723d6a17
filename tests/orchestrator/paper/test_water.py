"""The table of what the water changes: its effects and errors are computed, and as large as is said of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Measured
from rovbrush.orchestrator.paper import water
from rovbrush.orchestrator.paper.lab import Lab
from rovbrush.orchestrator.paper.theory.blade import blade

LAMBDA = (1.875104068711961, 4.694091132974175, 7.854757438237613)


@pytest.fixture(scope="module")
def lab(fmus: Path) -> Lab:
    return Lab(fmus)


def percent(text: str) -> list[float]:
    return [float(part) for part in text.split(",")]


def test_effects_of_the_water_on_the_paper_s_brush_are_those_of_the_review(lab: Lab, measured: Measured) -> None:
    brush = next(b for b in water.brushes(lab) if b.name == "paper")
    rows = water.effects(lab, brush)
    dry, mass, drag, pack, paddles = rows
    assert dry[-1] == "" and [float(cell) for cell in dry[1:3]] == pytest.approx([-221.7, -109.7], rel=1e-3)
    F_z, _, T_brush, _ = percent(mass[-1])
    assert F_z == pytest.approx(-7.0, abs=0.5) and T_brush == pytest.approx(-11.0, abs=0.5)  # model.md 9.4
    measured("water: added mass takes from F_z and T_brush [%]", f"{F_z:g}, {T_brush:g}", "7 and 11, model.md 9.4")
    for row in (drag, pack, paddles):
        assert percent(row[-1])[2] > 5.0, row[0]
    assert percent(pack[-1])[:2] == [0.0, 0.0]


@pytest.mark.evidence
def test_errors_of_the_approximations_are_told(lab: Lab) -> None:
    for brush in water.brushes(lab):
        rows = dict(water.errors(lab, brush))
        default, everywhere, *assumptions, _, points = rows.values()
        assert max(map(abs, percent(default))) < 1.0
        assert max(map(abs, percent(everywhere))) > 2.0
        assert all(max(map(abs, percent(text))) > 1.0 for text in assumptions)
        assert 0.0 < float(points) < 1.0
        assert 0.9 < brush.co_rotation < 0.92 and brush.shielding < 0.25


def test_six_points_are_enough_while_drag_keeps_its_sign_and_nearly_so_after() -> None:
    assert 0.0 < water.points_error(np.array(LAMBDA)) < 0.01


def test_a_stiff_blade_stands_upright_with_all_its_drag() -> None:
    stiff = blade(1e-3)
    assert stiff.deflection == pytest.approx(1e-3 / 8.0, rel=1e-4)
    assert stiff.effective_length == pytest.approx(1.0, abs=1e-6)
