"""The vehicle with an autopilot in the loop, a fake one on loopback: `rovbrush run ardusub --stop "2 s" --out dive`."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fixtures.fake_autopilot import Fakes, Faults, Keeper
from helpers import FIXTURES, column, rovbrush
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

G = 9.80665  # m/s2, of rov_sensors
VEHICLE_AND_AUTOPILOT = (FIXTURES / "vehicle_and_autopilot.toml").read_text(encoding="utf-8")


@pytest.fixture
def fakes(monkeypatch: pytest.MonkeyPatch) -> Iterator[Fakes]:
    """Autopilots that are stopped when the test ends."""
    made = Fakes(monkeypatch)
    yield made
    made.stop()


def small(
    native: Path, folder: Path, fakes: Fakes, faults: Faults | None = None, timeout: str = "60 s",
    stop: str = "1 s", **keys: Any,
) -> Run:  # fmt: skip
    """A run of a vehicle without a tool, whose depth and attitude the fake autopilot keeps."""
    path = folder / "small.toml"
    path.write_text(VEHICLE_AND_AUTOPILOT.replace("60 s", timeout), encoding="utf-8")
    fakes.make(faults=faults, **({"pilot": Keeper(), "patience": 0.5} | keys))
    return simulate(make_plan(assemble(str(path), stop=stop, fmus=native / "fmi2")))


def test_accelerations_are_the_rates_of_velocities_less_gravity(native: Path, tmp_path: Path, fakes: Fakes) -> None:
    """What the autopilot is told fits together: positions, velocities, attitudes, rates and accelerations."""
    done = small(native, tmp_path, fakes)
    assert not done.failure, done.failure
    states = fakes[0].states[:400]
    time = np.array([s["timestamp"] for s in states])
    assert list(time) == [k / 400 for k in range(400)]
    position = np.array([s["position"] for s in states])
    velocity = np.array([s["velocity"] for s in states])
    force = np.array([turned(s["attitude"], s["imu"]["accel_body"]) for s in states])
    assert position[0] == pytest.approx([1.0, 2.0, 10.0])
    # Trapezoids, whose error is the square of the step times the third derivative: ~1e-5 m/s and below.
    travelled = np.cumsum((velocity[1:] + velocity[:-1]) / 2, axis=0) / 400
    assert position[1:] - position[0] == pytest.approx(travelled, abs=2e-5)
    gained = np.cumsum((force[1:] + force[:-1]) / 2 + [0.0, 0.0, G], axis=0) / 400
    assert velocity[1:] - velocity[0] == pytest.approx(gained, abs=2e-3)
    assert np.ptp(velocity, axis=0).max() > 0.02  # it moved


def turned(attitude: list[float], body: list[float]) -> list[float]:
    """A body vector in the world, by the rotation matrix (Fossen 2011, Eq. 2.18), written out anew."""
    phi, theta, psi = attitude
    about_z = np.array([[math.cos(psi), -math.sin(psi), 0], [math.sin(psi), math.cos(psi), 0], [0, 0, 1]])
    about_y = np.array([[math.cos(theta), 0, math.sin(theta)], [0, 1, 0], [-math.sin(theta), 0, math.cos(theta)]])
    about_x = np.array([[1, 0, 0], [0, math.cos(phi), -math.sin(phi)], [0, math.sin(phi), math.cos(phi)]])
    return list(about_z @ about_y @ about_x @ np.array(body))


def test_a_vehicle_at_rest_and_level_feels_minus_g(native: Path, tmp_path: Path, fakes: Fakes) -> None:
    text = VEHICLE_AND_AUTOPILOT
    text = text.replace("[0.1, -0.05, 0.4]", "[0.0, 0.0, 0.0]").replace("[0.3, 0.2, -0.1]", "[0.0, 0.0, 0.0]")
    text = text.replace("[0.1, 0.0, 0.0]", "0.0").replace(
        "thrust_table = true", "thrust_table = true, net_buoyancy = 0.0"
    )
    path = tmp_path / "rest.toml"
    path.write_text(text, encoding="utf-8")
    fakes.make(patience=0.5)
    simulate(make_plan(assemble(str(path), stop="0.1 s", fmus=native / "fmi2")))
    for state in fakes[0].states[:40]:
        assert state["imu"]["accel_body"] == pytest.approx([0.0, 0.0, -G], abs=1e-12)
        assert state["imu"]["gyro"] == [0.0, 0.0, 0.0]


@pytest.mark.parametrize(("motor", "name", "sign"), [(0, "r", 1), (1, "r", -1), (4, "p", 1), (4, "q", -1), (7, "q", 1)])
def test_a_motor_that_pushes_turns_the_vehicle_as_ardusub_has_it(
    motor: int, name: str, sign: int, native: Path, tmp_path: Path, fakes: Fakes
) -> None:
    pulses = [1500] * 16
    pulses[motor] = 1800
    done = small(native, tmp_path, fakes, stop="0.1 s", pilot=lambda _: pulses)
    rates = column(done, f"vehicle.{name}")[1]
    assert sign * (rates[-1] - rates[0]) > 0.02


def test_lost_doubled_and_late_packets_change_no_bit_of_a_run(native: Path, tmp_path: Path, fakes: Fakes) -> None:
    quiet = small(native, tmp_path, fakes, stop="0.25 s")
    faults = Faults(lose={10}, double={20, 21}, late={30}, garbage={40: b"\n{}\n"})
    loud = small(native, tmp_path, fakes, faults, stop="0.25 s", channels=32)
    for name in ("vehicle.z_n", "vehicle.theta", "autopilot.u_thruster[5]", "imu.f_m[3]"):
        assert np.array_equal(column(quiet, name)[1], column(loud, name)[1])
    assert "101 frames, 0 lost, 2 doubled, 1 late, 1 no servo packets" in " ".join(loud.notes)


def test_an_autopilot_that_falls_silent_ends_the_run_and_what_was_computed_is_kept(
    native: Path, tmp_path: Path, fakes: Fakes
) -> None:
    done = small(native, tmp_path, fakes, Faults(silent=50), timeout="3 s", patience=0.1)
    assert "stopped answering" in done.failure and "after its frame 49" in done.failure
    assert len(column(done, "vehicle.z_n")[1]) == 50


def test_the_shipped_system_runs_with_the_fake_autopilot(
    native: Path, tmp_path: Path, fakes: Fakes, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As the guide says: rovbrush run ardusub --stop "2 s" --out dive."""
    monkeypatch.setenv("ROVBRUSH_FMUS", str(native / "fmi2"))
    monkeypatch.chdir(tmp_path)
    fakes.make(pilot=Keeper(), patience=0.5)
    assert rovbrush(monkeypatch, "run", "ardusub", "--stop", "2 s", "--out", "dive") == 0
    summary = json.loads((tmp_path / "dive" / "summary.json").read_text(encoding="utf-8"))
    assert summary["frames"] == 800 and "801 frames, 0 lost, 0 doubled" in summary["notes"][0]
    assert summary["energy_balance_relative"] < 1e-6
    assert summary["pitch_rms"] < 0.01 and abs(summary["depth_rms"] - 0.5) < 0.05
