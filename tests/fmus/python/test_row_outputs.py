"""Per-filament outputs, where the brush is built with them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from fmpy.validation import validate_fmu
from rovbrush.components.build import HERE, build
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system

SYSTEM = """
stop_time = "20 ms"
[components.brush]
fmu = "filament_brush.fmu"
period = "1 ms"
inputs = { omega_b = 15.7, delta = 0.005, delta_dot = 0.0, v_rov = 0.05, friction_scale = 1.0, tilt_x = 0.0 }
"""


@pytest.fixture(scope="module")
def signals(tmp_path_factory: pytest.TempPathFactory) -> Signals:
    folder = tmp_path_factory.mktemp("rows")
    build(HERE / "filament_brush", folder, rows=60)  # ten more than there are filaments
    (folder / "rows.toml").write_text(SYSTEM)
    return Signals(simulate(make_plan(load_system(str(folder / "rows.toml")))))


@pytest.mark.evidence
def test_per_filament_forces_add_up_to_those_of_the_brush(signals: Signals) -> None:
    normal = np.sum([signals[f"brush.filament_F_n[{i}]"].values for i in range(1, 61)], axis=0)
    friction = np.sum([signals[f"brush.filament_F_f[{i}]"].values for i in range(1, 61)], axis=0)
    np.testing.assert_allclose(-normal, signals["brush.F_z"].values, rtol=1e-12)
    np.testing.assert_allclose(-friction, signals["brush.F_x"].values, rtol=1e-12)


@pytest.mark.evidence
def test_filaments_are_evenly_spread_and_missing_ones_stay_zero(signals: Signals) -> None:
    phi = np.array([signals[f"brush.filament_phi[{i}]"].values[-1] for i in range(1, 61)])
    spacing = np.diff(np.unwrap(phi[:50]))
    np.testing.assert_allclose(spacing, 2 * np.pi / 50, rtol=1e-9)
    assert not phi[50:].any()


@pytest.mark.evidence
def test_largest_deflection_is_that_of_a_filament(signals: Signals) -> None:
    y = np.abs([signals[f"brush.filament_y[{i}]"].values for i in range(1, 51)])
    # The one is seen where micro-steps begin, the other at communication points: near a maximum they differ little.
    assert y.max() / 0.08 == pytest.approx(signals["brush.deflection_ratio_max"].values[-1], rel=0.01)


@pytest.mark.evidence
def test_such_an_fmu_is_valid_and_the_plain_one_has_no_such_outputs(fmus: Path, tmp_path: Path) -> None:
    assert validate_fmu(str(build(HERE / "filament_brush", tmp_path, rows=3)[0])) == []
    from rovbrush.orchestrator.fmu.fmu import Fmu

    assert not Fmu.open(fmus / "filament_brush.fmu").expand("filament_F_n")
    assert len(Fmu.open(tmp_path / "filament_brush.fmu").expand("filament_F_n")) == 3
