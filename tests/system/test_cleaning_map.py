"""The map of the cleaning: what the brush has rubbed away is on the hull, and the way back finds less fouling."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Measured, column, last
from rovbrush.components.hull_fouling.parameters import NOMINAL
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble


@pytest.fixture(scope="module")
def run(fmus: Path) -> Run:
    found = simulate(make_plan(assemble("cleaning_map", {}, fmus=fmus)))
    assert not found.failure, found.failure
    return found


def cells(run: Run, name: str) -> np.ndarray:
    """A vector of the map at the end."""
    return np.array([last(run, f"hull.{name}[{k}]") for k in range(1, 51)])


def test_shear_work_of_all_cells_is_the_friction_work_of_the_brush(run: Run, measured: Measured) -> None:
    done = last(run, "hull.W_friction")
    on_cells = float(np.sum(cells(run, "shear_work"))) * NOMINAL.cell_length * NOMINAL.track_width
    missing = abs(on_cells + last(run, "hull.W_beyond") - done) / done
    measured("cleaning_map: friction work that is on no cell, of all", missing, "1e-12")
    assert missing < 1e-12


def test_the_way_back_finds_less_fouling(run: Run) -> None:
    t, friction = column(run, "hull.friction_scale")
    there, back = friction[t <= 20.0], friction[t >= 22.0]
    assert np.max(there) > np.max(back) + 0.1  # barnacles
    assert np.min(there) < np.min(back) - 0.1  # slime, which is smoother than the hull


def test_the_track_has_been_passed_twice(run: Run) -> None:
    place, passes = NOMINAL.place_start + NOMINAL.cell_length * (np.arange(50) + 0.5), cells(run, "passes")
    assert set(passes[(place > 0.0) & (place < 0.9)]) == {2.0}
    assert set(passes[(place < -0.05) | (place > 1.1)]) == {0.0}
    assert last(run, "hull.cleaned") == pytest.approx(NOMINAL.cell_length * np.sum(cells(run, "fouling") == 0.0))
