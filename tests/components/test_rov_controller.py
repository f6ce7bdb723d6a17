"""The controller by itself and in closed loop with the vehicle."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from lives import Instance, component
from rovbrush.components.kernels import compiled

DECLARED = component("rov_controller")
VEHICLE = component("rov_vehicle")
MEASURED = ("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r")
T_S = 0.02


def controller(**parameters: Any) -> Instance:
    instance = Instance(DECLARED, compiled(DECLARED.kernel), **parameters)
    instance.start()
    return instance


class Loop:
    """Vehicle and controller, the controller's output acting at once."""

    def __init__(self, vehicle: dict[str, Any] | None = None, **parameters: Any) -> None:
        self.controller = controller(**parameters)
        self.vehicle = Instance(VEHICLE, compiled(VEHICLE.kernel), **(vehicle or {}))
        self.vehicle.start()

    def run(self, duration: float) -> np.ndarray:
        rows = []
        for _ in range(round(duration / T_S)):
            self.controller.set(**{name: self.vehicle[name] for name in MEASURED})
            self.controller.step(T_S)
            self.vehicle.set(u_thruster=self.controller["u_thruster"])
            for _ in range(4):
                self.vehicle.step(T_S / 4)
            rows.append([self.vehicle[name] for name in MEASURED[:6]])
        return np.array(rows)


def thrust(u: np.ndarray) -> np.ndarray:
    return np.where(u > 0, 40.9, 32.2) * u * np.abs(u)


def test_no_error_gives_no_command() -> None:
    seen = controller()
    seen.step(T_S)
    assert not np.any(seen["u_thruster"])


def test_pseudoinverse_is_that_of_numpy() -> None:
    seen = controller()
    np.testing.assert_allclose(seen.arrays["B_pinv"], np.linalg.pinv(seen.arrays["B"]), atol=1e-13)


@pytest.mark.parametrize("attitude_first", [True, False])
def test_allocation_gives_a_feasible_wrench_exactly(attitude_first: bool) -> None:
    seen = controller(attitude_first=attitude_first)
    seen.set(x_ref=0.3, y_ref=-0.1, z_ref=0.2, phi_ref=0.1, theta_ref=-0.1, psi_ref=0.2)
    seen.step(T_S)
    given = seen.arrays["B"] @ thrust(seen["u_thruster"])
    np.testing.assert_allclose(given, np.concatenate([seen["F_ref"], seen["M_ref"]]), atol=1e-12)
    assert not seen["saturated"]
    assert np.all(np.abs(given) > 0.1)


def test_saturated_allocation_keeps_the_moment_and_the_direction_of_the_force() -> None:
    seen = controller(K_velocity=(1e3,) * 3)
    seen.set(z_ref=10.0, theta_ref=0.2)
    seen.step(T_S)
    given = seen.arrays["B"] @ thrust(seen["u_thruster"])
    np.testing.assert_allclose(given[3:], seen["M_ref"], atol=1e-12)
    assert 100.0 < given[2] < seen["F_ref"][2]
    assert np.abs(seen["u_thruster"]).max() == pytest.approx(1.0, abs=1e-12)
    assert seen["saturated"] and seen["saturation_count"] == 1.0
    clipped = controller(K_velocity=(1e3,) * 3, attitude_first=False)
    clipped.set(z_ref=10.0, theta_ref=0.2)
    clipped.step(T_S)
    assert abs((clipped.arrays["B"] @ thrust(clipped["u_thruster"]))[4]) < 0.1 * abs(seen["M_ref"][1])


def test_commands_never_exceed_one() -> None:
    rng = np.random.default_rng(1)
    for attitude_first in (True, False):
        seen = controller(attitude_first=attitude_first)
        for _ in range(300):
            values = rng.normal(size=18) * 2.0
            inputs = (*MEASURED, "x_ref", "y_ref", "z_ref", "phi_ref", "theta_ref", "psi_ref")
            seen.set(**dict(zip(inputs, values, strict=True)))
            seen.step(T_S)
            assert np.abs(seen["u_thruster"]).max() <= 1.0 + 1e-12


def test_output_is_constant_between_samples() -> None:
    seen = controller()
    seen.set(x_ref=1.0)
    commands = []
    for k in range(12):
        seen.set(x_n=0.01 * k)
        seen.step(T_S / 4)
        commands.append(seen["u_thruster"])
    blocks = np.array(commands).reshape(3, 4, 8)
    assert np.all(blocks == blocks[:, :1])
    assert np.all(np.any(blocks[1:, 0] != blocks[:-1, 0], axis=1))


@pytest.mark.parametrize("h", [T_S / 3, T_S, 5 * T_S])
def test_number_of_samples_does_not_depend_on_the_communication_step(h: float) -> None:
    seen = controller(K_velocity_i=(1e4,) * 3)  # always saturated: the count is the number of samples
    seen.set(x_ref=10.0, y_ref=10.0, z_ref=10.0, theta_ref=1.0)
    seen.set(u=-5.0)
    for _ in range(round(3.0 / h)):
        seen.step(h)
    assert seen["saturation_count"] == round(3.0 / T_S)


def test_brush_voltage_follows_its_set_point() -> None:
    seen = controller()
    assert seen["V_in"] == 12.0
    seen.set(V_ref=9.0)
    seen.step(T_S)
    assert seen["V_in"] == 9.0


@pytest.mark.parametrize("theta", [0.5, 1.4, 1.7, 3.0])
def test_attitude_error_is_the_shortest_rotation_beyond_ninety_degrees(theta: float) -> None:
    # Pure pitch; beyond 90 degrees the Euler angles are (pi, pi - theta, pi).
    seen = controller(rate_max=10.0, K_attitude=(1.0,) * 3, K_rate=(1.0,) * 3)
    flipped = theta > np.pi / 2
    angles = (np.pi, np.pi - theta, np.pi) if flipped else (0.0, theta, 0.0)
    seen.set(**dict(zip(("phi", "theta", "psi"), angles, strict=True)))
    seen.step(T_S)
    np.testing.assert_allclose(seen["M_ref"], [0.0, -theta, 0.0], atol=1e-12)


def test_position_error_is_turned_into_the_body_frame() -> None:
    seen = controller(K_velocity=(1.0,) * 3, K_position=(1.0,) * 3)
    seen.set(psi=np.pi / 2, psi_ref=np.pi / 2, x_ref=0.3)
    seen.step(T_S)
    np.testing.assert_allclose(seen["F_ref"], [0.0, -0.3, 0.0], atol=1e-15)


@pytest.mark.parametrize("force", [(20.0, 0.0, 0.0), (0.0, 20.0, 0.0), (0.0, 0.0, -20.0)])
def test_station_is_held_against_20_newtons(force: tuple[float, float, float]) -> None:
    loop = Loop()
    loop.vehicle.set(F_external=force)
    path = loop.run(20.0)
    assert np.abs(path[:, :3]).max() < 0.2
    np.testing.assert_allclose(path[-1], 0.0, atol=1e-5)
    np.testing.assert_allclose(loop.vehicle["F_control"], -np.array(force) + [0.0, 0.0, 0.3], atol=1e-3)


def test_station_is_held_in_a_current() -> None:
    loop = Loop()
    loop.vehicle.set(v_c=(-0.5, 0.3, 0.0))
    path = loop.run(30.0)
    np.testing.assert_allclose(path[-1], 0.0, atol=1e-4)


def test_vehicle_turns_from_upside_down_to_level() -> None:
    loop = Loop({"attitude_start": (0.0, 3.0, 0.0)})
    np.testing.assert_allclose(loop.run(20.0)[-1, 3:], 0.0, atol=1e-4)


def test_a_tenth_of_the_tool_wrench_of_table_3_is_held() -> None:
    loop = Loop()
    loop.vehicle.set(F_x=-11.09, F_z=-22.17, M_y=-1.663)
    path = loop.run(20.0)
    np.testing.assert_allclose(path[-1], 0.0, atol=1e-4)


def test_saturated_integrals_do_not_wind_up() -> None:
    # 150 N for 5 s is more than the thrusters have: the vehicle is carried off, and should come back without overshoot.
    def overshoot(K_windup: float) -> float:
        loop = Loop(K_windup=K_windup)
        loop.vehicle.set(F_external=(150.0, 0.0, 0.0))
        away = loop.run(5.0)
        assert away[-1, 0] > 1.0
        assert loop.controller["saturation_count"] > 100
        loop.vehicle.set(F_external=(0.0, 0.0, 0.0))
        back = loop.run(40.0)
        np.testing.assert_allclose(back[-1, :3], 0.0, atol=0.02)
        return float(-back[:, 0].min())

    assert overshoot(5.0) < 0.25
    assert overshoot(5.0) < 0.5 * overshoot(0.0)
