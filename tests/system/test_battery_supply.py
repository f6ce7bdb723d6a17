"""The test stand on a battery: the voltage sags under the motor's current, and the energy that it gives arrives."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Measured, column, last
from rovbrush.components.battery.parameters import NOMINAL
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

R_0 = NOMINAL.n_series * NOMINAL.R_cell / NOMINAL.n_parallel + NOMINAL.R_leads


def stand(fmus: Path, **values: float) -> Run:
    """A second of it, with values of the battery."""
    changes = {f"battery.{name}": value for name, value in values.items()}
    run = simulate(make_plan(assemble("test_stand_battery", changes, "1 s", fmus)))
    assert not run.failure, run.failure
    return run


@pytest.fixture(scope="module")
def stiff(fmus: Path) -> Run:
    """Without polarisation and without other consumers."""
    return stand(fmus, R_1_cell=0.0, i_other=0.0)


def test_voltage_sags_by_the_motor_s_current_times_the_resistance(stiff: Run) -> None:
    (_, V), (_, V_oc), (_, i) = (column(stiff, name) for name in ("battery.V", "battery.V_oc", "motor.i"))
    assert np.max(V_oc - V) > 1.0
    # The battery steps first, with the current of the instant before: one period's change of the current apart.
    np.testing.assert_allclose(V_oc - V, R_0 * i, rtol=0, atol=R_0 * np.max(np.abs(np.diff(i))))


def test_what_the_battery_gives_the_motor_takes(stiff: Run, measured: Measured) -> None:
    given, taken = last(stiff, "battery.W_terminals"), last(stiff, "motor.W_electrical")
    # Each holds the other's value for a period of 0.5 ms; within the first few the current rises to its peak.
    measured("battery and motor: energy that the coupling makes, of what is given", abs(given / taken - 1.0), "1e-3")
    assert given == pytest.approx(taken, rel=1e-3)


def test_brush_is_slower_on_a_battery_that_is_nearly_empty(fmus: Path) -> None:
    full, low = (last(stand(fmus, soc_start=soc), "brush.omega_b") for soc in (1.0, 0.1))
    assert low < full - 2.0
