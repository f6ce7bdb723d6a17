"""The brush motor against closed-form solutions, the matrix exponential and its own energy balance."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from helpers import Measured
from lives import Instance, component
from rovbrush.components.kernels import compiled
from scipy.linalg import expm

DECLARED = component("dc_motor")
P = DECLARED.parameters()
N_G = P.gear_ratio_per_stage**P.gear_stages


def motor(V_in: float, T_brush: float, duration: float, h: float = 1e-3, **parameters: Any) -> Instance:
    instance = Instance(DECLARED, compiled(DECLARED.kernel), **parameters)
    instance.set(V_in=V_in, T_brush=T_brush)
    instance.start()
    for _ in range(round(duration / h)):
        instance.step(h)
    return instance


def exact(V_in: float, T_brush: float, duration: float) -> np.ndarray:
    """i and omega_m of the linear circuit from rest."""
    J = P.J_m + P.J_b / N_G**2
    A = np.array([[-P.R / P.L_a, -P.K_e / P.L_a], [P.K_t / J, -P.B_m / J]])
    steady = np.linalg.solve(A, -np.array([V_in / P.L_a, T_brush / N_G / J]))
    return steady - expm(A * duration) @ steady


def test_nothing_moves_without_voltage_and_load() -> None:
    assert not motor(0.0, 0.0, 0.1)["omega_b"]


def test_stall_current_equals_voltage_over_resistance(measured: Measured) -> None:
    # A brush too heavy to turn within 20 ms, 33 electrical time constants.
    assert motor(12.0, 0.0, 0.02, J_b=100.0, gear_stages=1, J_m=1.0)["i"] == pytest.approx(12.0 / P.R, rel=2e-4)
    # Under the load that just stalls it the motor comes to rest, time constant 0.2 s.
    stalled = motor(12.0, -P.K_t * 12.0 / P.R * N_G, 8.0)
    measured("motor: relative error of the stall current", stalled["i"] * P.R / 12.0 - 1.0, "1e-6")
    assert stalled["i"] == pytest.approx(12.0 / P.R, rel=1e-9)
    assert stalled["omega_b"] == pytest.approx(0.0, abs=1e-9)


def test_no_load_speed_is_that_of_the_circuit(measured: Measured) -> None:
    omega_m = 12.0 * P.K_t / (P.K_e * P.K_t + P.R * P.B_m)
    seen = motor(12.0, 0.0, 8.0)["omega_b"]
    measured("motor: relative error of the no-load speed", seen * N_G / omega_m - 1.0, "1e-6")
    measured("motor: no-load speed with the default parameters [rad/s]", seen, "reported (paper: 20)")
    assert seen == pytest.approx(omega_m / N_G, rel=1e-9)


def test_damping_that_gives_the_loaded_speed_of_table_3_gives_a_no_load_speed_above_20(measured: Measured) -> None:
    loaded, free = (motor(12.0, torque, 6.0, B_m=9.83e-4)["omega_b"] for torque in (-16.63, 0.0))
    measured("motor: speed under 16.63 N.m with B_m = 9.83e-4 [rad/s]", loaded, "15.70 within 0.005")
    measured("motor: no-load speed with B_m = 9.83e-4 [rad/s]", free, "21.05 within 0.01 (paper: 20)")
    assert loaded == pytest.approx(15.70, abs=0.005)
    assert free == pytest.approx(21.05, abs=0.01)  # the paper's figure rounds it to 20


def test_one_planetary_stage_cannot_carry_the_torque_of_table_3() -> None:
    assert motor(12.0, -16.63, 4.0, gear_stages=1)["omega_b"] < 0.0


@pytest.mark.parametrize("duration", [0.001, 0.01, 0.1])
@pytest.mark.parametrize("h", [1e-3, 5e-4])
def test_step_response_equals_the_matrix_exponential(duration: float, h: float, measured: Measured) -> None:
    # Fourth order at a twelfth of L_a/R: the error of the current is 1.3e-7 of its 150 A.
    i, omega_m = exact(12.0, -5.0, duration)
    seen = motor(12.0, -5.0, duration, h)
    measured("motor: error of the current in a step response over 150 A", (seen["i"] - i) / 150.0, "1e-6")
    measured("motor: error of the speed in a step response over 570 rad/s", (seen["omega_m"] - omega_m) / 570.0, "1e-6")
    assert seen["i"] == pytest.approx(i, abs=1e-6 * 150.0)
    assert seen["omega_m"] == pytest.approx(omega_m, abs=1e-6 * 570.0)


def test_error_falls_with_the_fourth_power_of_the_internal_step(measured: Measured) -> None:
    expected = exact(12.0, -5.0, 2e-3)[0]
    coarse, fine = (abs(motor(12.0, -5.0, 2e-3, max_step=dt)["i"] - expected) for dt in (4e-5, 2e-5))
    measured("motor: order of the integration", np.log2(coarse / fine), "4 within 0.15")
    assert np.log2(coarse / fine) == pytest.approx(4.0, abs=0.15)


def test_result_does_not_depend_on_the_communication_step() -> None:
    # The internal steps coincide; only the rounding of h differs.
    for parameters in ({}, {"current_limit": 70.0}):
        by_1_ms = motor(12.0, -5.0, 0.1, 1e-3, **parameters).values["y"]
        by_5_ms = motor(12.0, -5.0, 0.1, 5e-3, **parameters).values["y"]
        np.testing.assert_allclose(by_1_ms, by_5_ms, rtol=1e-9, atol=1e-8)


def test_small_inductance_is_stepped_inside_the_stability_limit() -> None:
    assert motor(12.0, -16.63, 4.0, 0.01, L_a=1e-6, B_m=9.83e-4)["omega_b"] == pytest.approx(15.70, abs=0.005)


@pytest.mark.parametrize(
    "parameters",
    [{}, {"gear_efficiency": 0.7}, {"current_limit": 60.0}, {"gear_efficiency": 0.7, "current_limit": 60.0}],
)
def test_energy_is_accounted_for(parameters: dict[str, float], measured: Measured) -> None:
    # 2 kJ go in; the fourth-order quadrature over the start-up transient leaves less than 1e-6 J.
    # The band in which the gear loss fades out is not smooth and costs some digits.
    seen = motor(12.0, -10.0, 3.0, **parameters)
    assert seen["W_electrical"] > 1000.0
    measured("motor: energy residual over the work", abs(seen["energy_residual"]) / seen["W_electrical"], "1e-7")
    assert abs(seen["energy_residual"]) < (1e-6 if "gear_efficiency" not in parameters else 1e-4)


def test_shaft_energy_is_the_work_done_on_the_brush() -> None:
    seen = motor(12.0, -16.63, 4.5)
    assert seen["P_shaft"] == pytest.approx(16.63 * seen["omega_b"])
    balance = seen["P_electrical"] - seen["P_copper"] - seen["P_friction"] - seen["P_gear"] - seen["P_shaft"]
    # What is left still accelerates the shaft: time constant 0.2 s, so e^-21 of the initial power.
    assert balance == pytest.approx(0.0, abs=1e-4)


def test_gear_efficiency_is_the_ratio_of_output_to_input_power() -> None:
    seen = motor(12.0, -16.63, 8.0, gear_efficiency=0.8)
    assert seen["P_shaft"] / (seen["P_shaft"] + seen["P_gear"]) == pytest.approx(0.8, rel=1e-9)
    assert seen["omega_b"] < 15.0


def test_gear_loses_power_when_the_brush_drives_the_motor() -> None:
    seen = motor(0.0, 10.0, 4.0, gear_efficiency=0.8)
    assert seen["omega_b"] > 0.0
    assert seen["P_shaft"] < 0.0 < seen["P_gear"]
    assert seen["P_gear"] == pytest.approx(-0.2 * seen["P_shaft"], rel=1e-9)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_current_limit_holds_and_releases(sign: float) -> None:
    held = motor(sign * 12.0, 0.0, 0.05, current_limit=60.0)
    assert sign * held["i"] == pytest.approx(60.0, rel=1e-8)
    J = P.J_m + P.J_b / N_G**2
    # Constant torque: the speed rises as that of a damped flywheel; the first 0.3 ms are the current's rise.
    expected = P.K_t * 60.0 / P.B_m * (1.0 - np.exp(-P.B_m / J * 0.05))
    assert sign * held["omega_m"] == pytest.approx(expected, rel=5e-3)
    released = motor(sign * 12.0, 0.0, 4.0, current_limit=60.0)
    free = motor(sign * 12.0, 0.0, 4.0)
    assert released["omega_b"] == pytest.approx(free["omega_b"], rel=1e-7)
