"""The co-simulation of the nominal system against one continuous solution of the same kernels."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import Measured
from monolithic import Monolithic, Solution
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.signals import Signals

STOP = 5.0  # s
TURNS = 8  # the last 3.2 s; the speed settles within 1 s
MEANS = {"F_z": "brush.F_z", "F_x": "brush.F_x", "T_brush": "brush.T_brush", "omega_b": "motor.omega_b"}


@pytest.fixture(scope="module")
def monolithic(nominal_plan: Plan) -> Monolithic:
    return Monolithic(nominal_plan.system)


@pytest.fixture(scope="module")
def solution(monolithic: Monolithic) -> Solution:
    return monolithic.solve(STOP)


def turned(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Angle [rad] of the rotation from a to b, unit quaternions; precise for small angles too."""
    chord = np.minimum(np.linalg.norm(a - b, axis=-1), np.linalg.norm(a + b, axis=-1))
    return 4.0 * np.arcsin(0.5 * chord)


def pose_errors(signals: Signals, solution: Solution) -> tuple[float, float]:
    """Largest distances in position and attitude until STOP, relative to the largest excursions from the start."""
    time = signals["vehicle.x_n"].time
    rows = np.flatnonzero(time <= STOP)
    position = np.column_stack([signals[f"vehicle.{axis}_n"].values for axis in "xyz"])[rows]
    quat = np.column_stack([signals[f"vehicle.quat[{k}]"].values for k in (1, 2, 3, 4)])[rows]
    same = np.round(time[rows] / solution.time[1]).astype(int)
    np.testing.assert_allclose(solution.time[same], time[rows], atol=1e-12)
    far = np.linalg.norm(solution.position - solution.position[0], axis=1).max()
    wide = turned(solution.quat, solution.quat[0]).max()
    assert far > 1.0 and wide > 0.1, "nothing to compare"
    apart = np.linalg.norm(position - solution.position[same], axis=1)
    return float(apart.max() / far), float(turned(quat, solution.quat[same]).max() / wide)


@pytest.mark.evidence
@pytest.mark.parametrize("name", MEANS)
def test_means_agree_within_half_a_percent(name: str, signals: Signals, solution: Solution, measured: Measured) -> None:
    theta_b = signals["brush.theta_b"]
    begin = float(np.interp(np.interp(STOP, theta_b.time, theta_b.values) - 2.0 * np.pi * TURNS, theta_b.values,
                            theta_b.time))  # fmt: skip
    seen, expected = signals[MEANS[name]].mean(begin, STOP), solution.means(TURNS)[name]
    measured(f"monolithic: relative difference of the mean of {name}", seen / expected - 1.0, "5e-3")
    assert seen == pytest.approx(expected, rel=5e-3)


@pytest.mark.evidence
def test_pose_agrees_within_a_percent_of_its_excursion(
    signals: Signals, solution: Solution, measured: Measured
) -> None:
    position, attitude = pose_errors(signals, solution)
    measured("monolithic: difference in position over its excursion, 5 s", position, "1e-2")
    measured("monolithic: difference in attitude over its excursion, 5 s", attitude, "1e-2")
    assert position < 1e-2 and attitude < 1e-2


@pytest.mark.evidence
def test_solution_is_converged(solution: Solution, monolithic: Monolithic) -> None:
    loose = monolithic.solve(0.5, rtol=1e-6)
    rows = len(loose.time)
    # 100 times the tolerance: what it changes is far below what is claimed.
    assert np.abs(loose.position - solution.position[:rows]).max() < 1e-5
    assert turned(loose.quat, solution.quat[:rows]).max() < 1e-5
