"""The controller in closed loop with the vehicle."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from lives import Instance, component
from machine_life import machine

DECLARED = component("rov_controller")
VEHICLE = component("rov_vehicle")
MEASURED = ("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r")
T_S = 0.02


def controller(**parameters: Any) -> Instance:
    instance = Instance(DECLARED, machine(DECLARED.kernel), **parameters)
    instance.start()
    return instance


class Loop:
    """Vehicle and controller, the controller's output acting at once."""

    def __init__(self, vehicle: dict[str, Any] | None = None, **parameters: Any) -> None:
        self.controller = controller(**parameters)
        self.vehicle = Instance(VEHICLE, machine(VEHICLE.kernel), **(vehicle or {}))
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


def test_pseudoinverse_is_that_of_numpy() -> None:
    seen = controller()
    np.testing.assert_allclose(seen.arrays["B_pinv"], np.linalg.pinv(seen.arrays["B"]), atol=1e-13)


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
