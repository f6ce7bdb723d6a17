"""The pass on a battery: motor and thrusters lower the voltage, a command gives less thrust, and the force is held."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Measured, column, last
from rovbrush.components.battery.parameters import NOMINAL
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

R_0 = NOMINAL.n_series * NOMINAL.R_cell / NOMINAL.n_parallel + NOMINAL.R_leads
PRESSING = 10.0  # s, from when on the brush is pressed with the whole force and under way


def passed(fmus: Path, **values: float) -> Run:
    """Its first 12 s, with values of the battery."""
    changes = {f"battery.{name}": value for name, value in values.items()}
    return require_complete(simulate(make_plan(assemble("hull_pass_battery", changes, "12 s", fmus))))


@pytest.fixture(scope="module")
def low(fmus: Path) -> Run:
    """As shipped: a fifth full."""
    return passed(fmus)


@pytest.fixture(scope="module")
def full(fmus: Path) -> Run:
    return passed(fmus, soc_start=1.0)


def mean(run: Run, name: str) -> float:
    """Mean of an output while the brush is pressed."""
    t, values = column(run, name)
    return float(np.mean(values[t > PRESSING]))


def test_voltage_sags_by_the_current_of_motor_and_thrusters(low: Run, measured: Measured) -> None:
    """Ohmic drop at once, polarisation on top; both consumers take tens of amperes."""
    i, i_other = mean(low, "motor.i"), mean(low, "vehicle.i_thruster")
    assert i > 20.0 and i_other > 20.0
    drop = mean(low, "battery.V_oc") - mean(low, "battery.V")
    ratio = drop / (R_0 * (i + i_other))
    measured("hull_pass_battery: sag over the ohmic drop of motor and thrusters", ratio, "1 to 2")
    assert 1.0 < ratio < 2.0


def test_force_is_held_on_a_battery_that_is_nearly_empty(low: Run, measured: Measured) -> None:
    error = mean(low, "vehicle.F_z") / -mean(low, "mission.F_n_ref") - 1.0
    measured("hull_pass_battery: error of the mean force", error, "0.01")
    assert abs(error) < 0.01
    assert last(low, "controller.saturation_count") == 0.0


def test_lower_voltage_takes_larger_commands_and_a_slower_brush(low: Run, full: Run) -> None:
    """For the same force each vertical thruster is commanded more, and the brush turns slower."""
    assert mean(full, "battery.V") - mean(low, "battery.V") > 1.5
    for k in range(5, 9):
        name = f"controller.u_thruster[{k}]"
        assert abs(mean(low, name)) > abs(mean(full, name)) > 0.1
    assert mean(low, "motor.omega_b") < mean(full, "motor.omega_b") - 1.5


def test_what_the_battery_gives_motor_and_thrusters_take(low: Run, measured: Measured) -> None:
    t, V = column(low, "battery.V")
    t_i, i = column(low, "vehicle.i_thruster")
    thrusters = float(np.trapezoid(V * np.interp(t, t_i, i), t))
    taken = last(low, "motor.W_electrical") + thrusters
    error = last(low, "battery.W_terminals") / taken - 1.0
    measured("hull_pass_battery: energy given by the battery over what is taken", error, "5e-3")
    # Thruster current and voltage are held over 5 ms, and the command changes every 20 ms.
    assert abs(error) < 5e-3
