"""Margins of the force loop: how they are measured, and that the recommended gains have them on a roller."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Measured
from rovbrush.orchestrator.paper.margins.limits import decays, gain_limit, largest
from rovbrush.orchestrator.paper.margins.open_loop import BEGIN, LENGTH, Loop, open_loop
from rovbrush.orchestrator.paper.margins.table import varied
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.model import System

# A roller of 50 x 1800 bristles, 20 N, with the gains of components/rov_controller/README.md.
ROLLER = {
    "brush.bristles_per_filament": 1800.0, "brush.alpha": 0.0, "brush.k_c": 18319.0, "brush.C_a": 1.0,
    "motor.B_m": 8.4e-5, "motor.gear_efficiency": 0.81, "motor.J_b": 0.1, "mission.F_n": 20.0, "mission.depth": 0.005,
    "vehicle.m": 16.5, "vehicle.W": 147.0, "vehicle.r_g": [-0.009, 0.0, 0.105], "vehicle.I": [0.66, 0.66, 0.21],
}  # fmt: skip
GAINS = {
    "controller.K_position": [1.0, 1.0, 2.0], "controller.K_velocity": [100.0, 100.0, 150.0],
    "controller.K_velocity_i": [60.0, 60.0, 200.0], "controller.K_attitude": [4.0, 4.0, 3.0],
    "controller.K_rate": [5.0, 5.0, 3.0], "controller.K_rate_i": [8.0, 8.0, 4.0], "controller.bumpless": True,
    "controller.K_force_d": 150.0, "controller.K_force_a": 10.0,
}  # fmt: skip


def roller(fmus: Path) -> System:
    return assemble("hull_pass_paper", ROLLER | GAINS, f"{BEGIN + LENGTH:g} s", fmus)


def of(delay: float, gain: float) -> Loop:
    """gain/s with a delay: |L| = 1 at `gain`, where the angle to -1 is pi/2 - gain*delay."""
    omega = np.geomspace(0.5, 90.0, 400)
    return Loop(omega, gain / (1j * omega) * np.exp(-1j * omega * delay))


def test_margins_of_an_integrator_with_delay_are_the_known_ones() -> None:
    for delay, gain in ((0.02, 10.0), (0.05, 4.0), (0.1, 20.0)):
        loop = of(delay, gain)
        margin = np.pi / 2.0 - gain * delay  # negative: unstable, and short of it by that much
        assert loop.phase_margin == pytest.approx(abs(margin), abs=1e-3)
        assert loop.delay_margin == pytest.approx((margin % (2.0 * np.pi)) / gain, rel=1e-3)
        if margin > 0.0:
            assert loop.gain_margin == pytest.approx(np.pi / (2.0 * gain * delay), rel=1e-3)


def test_a_loop_below_one_has_all_margins() -> None:
    loop = of(0.0, 0.1)
    assert (loop.phase_margin, loop.delay_margin, loop.gain_margin) == (np.pi, np.inf, np.inf)


def test_largest_value_is_found_by_halving() -> None:
    assert largest(lambda x: x < 0.3, 0.0, 1.0, 1e-3) == pytest.approx(0.3, abs=1e-3)
    assert largest(lambda _: True, 0.0, 1.0, 1e-3) == 1.0 and largest(lambda _: False, 0.0, 1.0, 1e-3) == 0.0


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


def test_observer_has_phase_and_delay_to_spare_too(fmus: Path, measured: Measured) -> None:
    values = {"controller.M_observer": [22.0, 29.2, 31.07, 0.78, 0.78, 0.33], "controller.omega_observer": 8.0}
    loop, _ = open_loop(varied(roller(fmus).with_values(values, "test"), 3, 1.0))
    measured("force control by the observer: phase margin [deg]", np.degrees(loop.phase_margin), "> 40")
    measured("force control by the observer: delay margin along the normal [ms]", 1e3 * loop.delay_margin, "> 30")
    assert np.degrees(loop.phase_margin) >= 40.0 and loop.delay_margin >= 0.03


def test_one_sine_says_what_many_at_once_say(fmus: Path) -> None:
    system = varied(roller(fmus), 2, 1.0)
    many, _ = open_loop(system)
    crossing = max(omega for omega, _ in many.crossovers())
    one, _ = open_loop(system, [crossing], amplitude=0.5)
    expected = np.exp(np.interp(one.omega[0], many.omega, np.log(np.abs(many.L))))
    angle = np.interp(one.omega[0], many.omega, np.unwrap(np.angle(many.L)))
    assert abs(one.L[0]) == pytest.approx(expected, rel=0.1)
    assert abs(np.angle(one.L[0] * np.exp(-1j * angle))) < np.radians(6.0)  # lines between frequencies 16 % apart


def test_gain_that_the_open_loop_allows_is_where_the_answer_to_a_kick_stays(fmus: Path, measured: Measured) -> None:
    system = varied(roller(fmus), 2, 1.0)
    loop, _ = open_loop(system)
    found = gain_limit(system, resolution=0.25)
    measured("force control: gain margin by trial over that of the open loop", found / loop.gain_margin, "0.8 to 1.25")
    assert 0.8 < found / loop.gain_margin < 1.25
    assert decays(system)
