"""The strategies that use the measured tool wrench: its filter, feedforward and the force along the hull normal."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from lives import Instance, component
from rovbrush.components.kernels import compiled

DECLARED = component("rov_controller")
T_S = 0.02
WRENCH = {"F_tool": (-10.0, 2.0, -30.0), "M_tool": (0.5, -6.0, 0.2)}


def controller(**parameters: Any) -> Instance:
    instance = Instance(DECLARED, compiled(DECLARED.kernel), **parameters)
    instance.start()
    return instance


def wrench(seen: Instance) -> np.ndarray:
    """What the controller asks of the thrusters."""
    return np.concatenate([seen["F_ref"], seen["M_ref"]])


@pytest.mark.parametrize("h", [0.005, 0.02])
def test_filter_of_the_wrench_is_a_first_order_lag_at_any_communication_step(h: float) -> None:
    seen = controller(T_filter=0.04)
    seen.set(**WRENCH)
    for k in range(1, 20):
        seen.step(h)
        assert seen["F_n"] == pytest.approx(30.0 * (1.0 - np.exp(-k * h / 0.04)), rel=1e-12)


def test_filter_can_be_off() -> None:
    seen = controller(T_filter=0.0)
    seen.set(**WRENCH)
    seen.step(T_S)
    assert seen["F_n"] == 30.0


def test_plain_pid_does_not_look_at_the_tool() -> None:
    blind, seeing = controller(mode=0), controller(mode=0)
    seeing.set(**WRENCH, F_n_ref=40.0)
    for k in range(50):
        for seen in (blind, seeing):
            seen.set(x_ref=0.1, q=0.01 * k)
            seen.step(T_S)
    np.testing.assert_array_equal(blind["u_thruster"], seeing["u_thruster"])


@pytest.mark.parametrize("share", [0.5, 1.0])
def test_feedforward_asks_for_the_opposite_of_the_measured_wrench(share: float) -> None:
    seen = controller(mode=1, T_filter=0.0, K_feedforward=share)
    seen.set(**WRENCH)
    seen.step(T_S)
    np.testing.assert_allclose(wrench(seen), -share * np.array([*WRENCH["F_tool"], *WRENCH["M_tool"]]), atol=1e-12)


def test_force_along_the_normal_reaches_its_set_point_on_a_rigid_hull() -> None:
    # On a hull that does not give, the vehicle stays and the tool's force is what the thrusters press with.
    seen = controller(mode=2)
    seen.set(F_n_ref=40.0)
    force = 10.0
    for _ in range(500):
        seen.set(F_tool=(0.0, 0.0, -force))
        seen.step(T_S)
        force = seen["F_ref"][2]
    assert seen["pressing"] == 1.0
    assert force == pytest.approx(40.0, abs=1e-3)


def test_force_control_is_blind_to_position_along_the_normal_and_not_across_it() -> None:
    def asked(**references: float) -> np.ndarray:
        seen = controller(mode=2, T_filter=0.0)
        seen.set(**WRENCH, F_n_ref=40.0, **references)
        seen.step(T_S)
        return wrench(seen)

    still = asked()
    first = asked(z_ref=0.001)  # the first sample takes over from the PID: no jump
    assert first[2] == pytest.approx(still[2] + 90.0 * 0.001)
    assert asked(x_ref=0.01)[0] == pytest.approx(still[0] + 60.0 * 0.01)

    def later(z_ref: float) -> float:
        seen = controller(mode=2)
        seen.set(**WRENCH, F_n_ref=30.0)
        for _ in range(100):
            seen.step(T_S)
        seen.set(z_ref=z_ref)
        seen.step(T_S)
        return float(seen["F_ref"][2])

    assert later(0.0) == later(0.5)


def test_taking_over_and_giving_back_make_no_jump() -> None:
    seen = controller(mode=2, T_filter=0.0, K_feedforward=0.0)
    forces = []
    for k in range(300):
        pressing = 50 <= k < 200
        seen.set(F_tool=(0.0, 0.0, -20.0), z_ref=0.05, F_n_ref=20.0 if pressing else 0.0)
        seen.step(T_S)
        assert seen["pressing"] == float(pressing)
        forces.append(seen["F_ref"][2])
    change = np.abs(np.diff(forces))
    assert change[49] < 0.2  # the integral goes on by 90 N/m * 0.05 m/s * 0.02 s
    assert change[199] == pytest.approx(90.0 * 0.05, abs=0.5)  # what the position error itself asks for comes back


def test_force_control_waits_for_contact_and_ends_below_half_of_it() -> None:
    seen = controller(mode=2, T_filter=0.0, contact_force=5.0)
    seen.set(F_n_ref=40.0)
    states = []
    for force in (0.0, 4.9, 5.1, 3.0, 2.4, 4.9):
        seen.set(F_tool=(0.0, 0.0, -force))
        seen.step(T_S)
        states.append(seen["pressing"])
    assert states == [0.0, 0.0, 1.0, 1.0, 0.0, 0.0]


def test_normal_can_point_anywhere() -> None:
    seen = controller(mode=2, normal=(1.0, 0.0, 0.0), T_filter=0.0)
    seen.set(F_tool=(-25.0, 0.0, 0.0), F_n_ref=40.0)
    seen.step(T_S)
    assert seen["F_n"] == 25.0 and seen["pressing"] == 1.0


def test_integral_of_the_force_does_not_wind_up_at_saturation() -> None:
    def after(K_windup: float) -> float:
        seen = controller(mode=2, K_windup=K_windup)
        for k in range(600):
            seen.set(F_tool=(0.0, 0.0, -20.0), F_n_ref=400.0 if k < 500 else 20.0)  # far beyond the thrusters
            seen.step(T_S)
        return float(seen["F_ref"][2])

    assert after(5.0) < 200.0 < after(0.0)


def test_set_point_that_moves_is_followed_without_lag_in_steady_state() -> None:
    seen = controller(v_max=0.5)
    seen.set(v_ref=(0.1, 0.0, 0.0), u=0.1)  # at the set-point, with its velocity
    seen.step(T_S)
    np.testing.assert_allclose(wrench(seen), 0.0, atol=1e-12)
