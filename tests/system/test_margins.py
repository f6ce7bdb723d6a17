"""Margins of the force loop: how they are measured, and that the recommended gains have them on a roller."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from helpers import Measured
from rovbrush.orchestrator.paper.margins.limits import decays, delay_limit, gain_limit, largest
from rovbrush.orchestrator.paper.margins.open_loop import BEGIN, LENGTH, open_loop
from rovbrush.orchestrator.paper.margins.table import varied
from rovbrush.orchestrator.paper.strategies import force_on_hull
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.linear.margins.open_loop import Loop
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

# A roller of 50 x 1800 bristles, 20 N, with the gains of components/rov_controller/README.md.
ROLLER = {
    "brush.bristles_per_filament": 1800.0, "brush.alpha": 0.0, "brush.k_c": 18319.0, "brush.C_a": 1.0,
    "motor.B_m": 8.4e-5, "motor.gear_efficiency": 0.81, "motor.J_b": 0.1, "mission.F_n": 20.0, "mission.depth": 0.005,
    "vehicle.m_tool": 5.0, "vehicle.buoyancy_tool": 49.05, "vehicle.I_tool": [0.05, 0.03, 0.05],
}  # fmt: skip
GAINS = {
    "controller.K_position": [1.0, 1.0, 2.0], "controller.K_velocity": [100.0, 100.0, 150.0],
    "controller.K_velocity_i": [60.0, 60.0, 200.0], "controller.K_attitude": [4.0, 4.0, 3.0],
    "controller.K_rate": [5.0, 5.0, 3.0], "controller.K_rate_i": [8.0, 8.0, 4.0], "controller.bumpless": True,
    "controller.K_force_d": 150.0, "controller.K_force_a": 10.0,
}  # fmt: skip


OBSERVER = {"controller.M_observer": [22.0, 29.2, 31.07, 0.8, 0.8, 0.35], "controller.omega_observer": 8.0}


def roller(fmus: Path) -> System:
    return assemble("hull_pass_paper", ROLLER | GAINS, f"{BEGIN + LENGTH:g} s", fmus)


def sensed(fmus: Path, folder: Path, stop: str, values: dict[str, object]) -> System:
    """The same pass, the controller seeing it by sensors."""
    text = load_system("hull_pass_paper", fmus).path.read_text(encoding="utf-8")
    seen = dict(re.findall(r'  "(vehicle\.\w+) -> controller\.(\w+)",.*\n', text))
    text = re.sub(r'  "vehicle\.\w+ -> controller\.\w+",.*\n', "", text)
    by_sensors = [f'  "{a} -> sensors.{b}",\n  "sensors.{b}_m -> controller.{b}",\n' for a, b in seen.items()]
    text = text.replace("connections = [\n", "connections = [\n" + "".join(by_sensors), 1)
    text = text.replace('"mission", "controller"]', '"mission", "sensors", "controller"]', 1)
    text += '[components.sensors]\nfmu = "rov_sensors"\nperiod = "5 ms"\ninputs = { nu_dot = 0.0 }\n'
    (folder / "sensed.toml").write_text(text, encoding="utf-8")
    shipped = load_system("hull_pass_paper", fmus).path.parent / "paper.toml"
    (folder / "paper.toml").write_text(shipped.read_text(encoding="utf-8"), encoding="utf-8")
    return assemble(str(folder / "sensed.toml"), ROLLER | GAINS | values, stop, fmus)


def of(delay: float, gain: float) -> Loop:
    """gain/s with a delay: |L| = 1 at `gain`, where the angle to -1 is pi/2 - gain*delay."""
    omega = np.geomspace(0.5, 90.0, 400)
    return Loop(omega, gain / (1j * omega) * np.exp(-1j * omega * delay))


@pytest.mark.evidence
def test_margins_of_an_integrator_with_delay_are_the_known_ones() -> None:
    for delay, gain in ((0.02, 10.0), (0.05, 4.0), (0.1, 20.0)):
        loop = of(delay, gain)
        margin = np.pi / 2.0 - gain * delay  # negative: unstable, and short of it by that much
        assert loop.phase_margin == pytest.approx(abs(margin), abs=1e-3)
        assert loop.delay_margin == pytest.approx((margin % (2.0 * np.pi)) / gain, rel=1e-3)
        if margin > 0.0:
            assert loop.gain_margin == pytest.approx(np.pi / (2.0 * gain * delay), rel=1e-3)


@pytest.mark.evidence
def test_a_loop_below_one_has_all_margins() -> None:
    loop = of(0.0, 0.1)
    assert (loop.phase_margin, loop.delay_margin, loop.gain_margin) == (np.pi, np.inf, np.inf)


@pytest.mark.evidence
def test_largest_value_is_found_by_halving() -> None:
    assert largest(lambda x: x < 0.3, 0.0, 1.0, 1e-3) == pytest.approx(0.3, abs=1e-3)
    assert largest(lambda _: True, 0.0, 1.0, 1e-3) == 1.0 and largest(lambda _: False, 0.0, 1.0, 1e-3) == 0.0


@pytest.mark.evidence
@pytest.mark.parametrize(("factor", "phase"), [(1.0, 40.0), (4.0, 20.0)])
def test_force_control_has_phase_and_delay_to_spare(
    factor: float, phase: float, fmus: Path, measured: Measured
) -> None:
    """40 degrees and 30 ms on the roller, 20 degrees at twice its stiffness."""
    loop, stiffness = open_loop(varied(roller(fmus), 2, factor))
    brush = f"a brush of {1e-3 * stiffness:.1f} N/mm"
    measured(f"force control on {brush}: phase margin [deg]", np.degrees(loop.phase_margin), f"> {phase:g}")
    measured(f"force control on {brush}: delay margin along the normal [ms]", 1e3 * loop.delay_margin, "> 30")
    assert 6e3 * np.sqrt(factor) < stiffness < 9e3 * np.sqrt(factor)
    assert np.degrees(loop.phase_margin) >= phase and loop.delay_margin >= 0.03


@pytest.mark.evidence
def test_observer_has_phase_and_delay_to_spare_too(fmus: Path, measured: Measured) -> None:
    loop, _ = open_loop(varied(roller(fmus).with_values(OBSERVER, "test"), 3, 1.0))
    measured("force control by the observer: phase margin [deg]", np.degrees(loop.phase_margin), "> 40")
    measured("force control by the observer: delay margin along the normal [ms]", 1e3 * loop.delay_margin, "> 30")
    assert np.degrees(loop.phase_margin) >= 40.0 and loop.delay_margin >= 0.03


@pytest.mark.evidence
def test_all_sensors_may_be_30_ms_late(fmus: Path, tmp_path: Path, measured: Measured) -> None:
    found = delay_limit(varied(sensed(fmus, tmp_path, f"{BEGIN + LENGTH:g} s", {}), 2, 1.0), resolution=5e-3)
    measured("force control on the roller: delay of all sensors until which a kick decays [ms]", 1e3 * found, "> 30")
    assert found >= 0.03


@pytest.mark.evidence
def test_force_is_held_with_noise_and_40_ms_of_delay(fmus: Path, tmp_path: Path, measured: Measured) -> None:
    """The sensors of a BlueROV2, which are 20 ms late, and 20 ms more: contact kept, force within 10 %."""
    sensors = assemble("station_keeping", {}, fmus=fmus).components["sensors"].parameters
    values = {f"sensors.{name}": value for name, value in sensors.items()} | {"sensors.delay": 0.02}
    signals = Signals(require_complete(simulate(planned(sensed(fmus, tmp_path, "20 s", values)))))
    delta = signals["vehicle.delta"]
    chosen = delta.time >= BEGIN
    force = force_on_hull(signals, delta.time)[chosen]
    error = float(np.sqrt(np.mean(np.square(force / 20.0 - 1.0))))
    measured("force control on the roller, noise and 40 ms of delay: force error, rms", error, "0.1")
    assert np.all(delta.values[chosen] > 0.0) and error < 0.1


@pytest.mark.evidence
def test_one_sine_says_what_many_at_once_say(fmus: Path) -> None:
    system = varied(roller(fmus), 2, 1.0)
    many, _ = open_loop(system)
    near = int(np.argmin(np.abs(many.omega - max(omega for omega, _ in many.crossovers()))))
    one, _ = open_loop(system, [many.omega[near]], amplitude=1.0)
    assert abs(one.L[0] / many.L[near] - 1.0) < 0.05  # 3 degrees


@pytest.mark.evidence
def test_gain_that_the_open_loop_allows_is_where_the_answer_to_a_kick_stays(fmus: Path, measured: Measured) -> None:
    system = varied(roller(fmus), 2, 1.0)
    loop, _ = open_loop(system)
    found = gain_limit(system, resolution=0.25)
    measured("force control: gain margin by trial over that of the open loop", found / loop.gain_margin, "0.8 to 1.25")
    assert 0.8 < found / loop.gain_margin < 1.25
    assert decays(system)
