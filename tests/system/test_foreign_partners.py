"""Partners from elsewhere in the closed loop: the motor of a Modelica compiler, and a controller at another rate."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from fixtures.modelica.build import build_dc_motor
from helpers import FIXTURES, Measured, build_fixture
from rovbrush.orchestrator.errors import RunError
from rovbrush.orchestrator.exchange.recordings.replay import replay
from rovbrush.orchestrator.exchange.recordings.write import write_boundary
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.request import Changes, changes_of

MOTOR_MAP = FIXTURES / "modelica" / "map.toml"
WATCHED = ("motor.omega_b", "motor.i", "brush.F_z", "brush.T_brush")
STOP = "2 s"


@pytest.fixture(scope="module")
def modelica_motor(tmp_path_factory: pytest.TempPathFactory) -> Callable[[int], Path]:
    """The Modelica motor with so many solver steps per communication step."""
    folder = tmp_path_factory.mktemp("modelica")
    return cache(lambda substeps: build_dc_motor(folder, substeps))


def motor(fmu: Path) -> Changes:
    return changes_of([f"motor={fmu}"], [f"motor={MOTOR_MAP}"], [])


def test_the_modelica_motor_is_ours_within_its_solver_error(
    modelica_motor: Callable[[int], Path], fmus: Path, measured: Measured
) -> None:
    """Its explicit Euler method errs in proportion to its step, so halving the step halves what the two differ by.

    What is left when the error is extrapolated to a step of zero bounds every other difference between the two.
    """
    wanted = Signals(require_complete(simulate(planned(assemble("nominal", {}, STOP, fmus)))))
    found = {
        substeps: Signals(
            require_complete(
                simulate(planned(assemble("nominal", {"motor.R": 0.08}, STOP, fmus, motor(modelica_motor(substeps)))))
            )
        )
        for substeps in (10, 20, 40)
    }
    for name in WATCHED:
        reference, (coarse, middle, fine) = wanted[name].values, (found[k][name].values for k in (10, 20, 40))
        scale = np.max(np.abs(reference))
        errors = [np.max(np.abs(values - reference)) / scale for values in (coarse, middle, fine)]
        assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.1)
        assert errors[1] / errors[2] == pytest.approx(2.0, abs=0.1)
        # Of second order in the solver's step, but for filaments that touch a moment sooner or later.
        rest = np.max(np.abs(2 * fine - middle - reference)) / scale
        assert rest < 0.1 * errors[2]
        measured(f"Modelica motor in the loop, {name}: difference", errors[0], "first order in its solver's step")
        measured(f"Modelica motor in the loop, {name}: extrapolated", rest, "0.1 of the finest difference")
    # The speed, which the paper compares, is far closer than the current's switch-on peak.
    assert found[10]["motor.omega_b"].mean(1.0, 2.0) == pytest.approx(wanted["motor.omega_b"].mean(1.0, 2.0), rel=1e-6)


def test_a_recording_of_ours_judges_the_modelica_motor(
    modelica_motor: Callable[[int], Path], fmus: Path, tmp_path: Path
) -> None:
    run = require_complete(simulate(planned(assemble("nominal", {}, "500 ms", fmus, boundaries=("motor",)))))
    write_boundary(run, "motor", tmp_path)
    verdicts = replay(
        modelica_motor(10), tmp_path, mapping=MOTOR_MAP, rtol=0.02
    ).require_within()  # of the current's switch-on peak
    assert {v.output for v in verdicts} == {"i", "omega_b", "P_copper"}
    with pytest.raises(RunError, match="outside the tolerance: i, omega_b, P_copper"):
        replay(modelica_motor(10), tmp_path, mapping=MOTOR_MAP).require_within()


def test_a_controller_at_half_the_rate_flies_the_approach(fmus: Path, tmp_path: Path, measured: Measured) -> None:
    """Plain pythonfmu, 10 ms in place of 5 ms, other names, heights for depths, degrees and rpm."""
    fmu = build_fixture("foreign_controller", tmp_path)
    changes = changes_of(
        [f"controller={fmu}"], [f"controller={FIXTURES / 'foreign_controller.toml'}"], ["controller=10 ms"]
    )
    plan = planned(assemble("hull_pass_paper", {}, "14 s", fmus, changes))
    assert plan.clock.periods["controller"] == 2 * plan.clock.periods["vehicle"] and "controller" in plan.samplers
    run = require_complete(simulate(plan))
    signals, summary = Signals(run), summarize(run)
    wanted = signals["mission.F_n_ref"].values[-1]
    pressed = -signals["vehicle.F_z"].mean(10.0, 14.0)
    assert pressed == pytest.approx(wanted, rel=0.15)  # it has no force control: the position decides
    assert abs(signals["vehicle.theta"].mean(10.0, 14.0)) < 1e-2  # rad; an angle in degrees would be lost at once
    assert summary["energy_balance_relative"] < 1e-5
    measured("force of a foreign 10 ms controller over that wanted", pressed / wanted, "0.85 to 1.15")
    assert any("saturated_samples is left out" in note for note in plan.system.components["controller"].notes)
