"""Errors of the transfers on known signals, through real FMUs."""

from __future__ import annotations

from math import cos, log2
from pathlib import Path

import numpy as np
import pytest
from helpers import column, run_of
from rovbrush.orchestrator.simulation import Run
from rovbrush.orchestrator.transfer import linear_ratio, mean_tail

SINE = {"a": 1.0, "w": 5.0}


def run_pair(
    tmp_path: Path,
    fmus: Path,
    source: str,
    target: str,
    transfer: str,
    signal: dict[str, float],
    stop: str = "1.2 s",
    algorithm: str = "jacobi",
) -> Run:
    parts = {"s": ("wave", source, signal), "t": ("integrator", target)}
    return run_of(tmp_path, fmus, parts, [f"s.y -> t.u ({transfer})"], stop=stop, algorithm=algorithm)


def error(run: Run, after: float = 0.2) -> float:
    """Largest difference between the held input and the mean of the true sine over the step."""
    t, held = column(run, "t.held")
    integral = np.array([(1.0 - cos(SINE["w"] * time)) / SINE["w"] for time in t])
    true = np.diff(integral) / np.diff(t)
    return float(np.max(np.abs(held[1:] - true)[t[1:] > after]))


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(("transfer", "order"), [("hold", 1.0), ("linear", 2.0)])
def test_order_of_the_error_from_slow_to_fast(
    transfer: str, order: float, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    errors = [
        error(run_pair(tmp_path, fmus, slow, fast, transfer, SINE, algorithm=algorithm))
        for slow, fast in (("20 ms", "5 ms"), ("10 ms", "2.5 ms"))
    ]
    # The phase of the sine at which the worst step falls moves with the step: 0.15.
    assert log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.15)


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(("fast", "slow"), [("1 ms", "5 ms"), ("3 ms", "5 ms"), ("5 ms", "5 ms")])
def test_mean_is_second_order(fast: str, slow: str, algorithm: str, tmp_path: Path, fmus: Path) -> None:
    errors = []
    for scale in (4, 2):
        fast_, slow_ = (f"{scale * float(text.split()[0])} ms" for text in (fast, slow))
        errors.append(error(run_pair(tmp_path, fmus, fast_, slow_, "mean", SINE, algorithm=algorithm)))
    assert log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.15)


@pytest.mark.parametrize("transfer", ["hold", "linear", "mean"])
@pytest.mark.parametrize(("source", "target"), [("1 ms", "5 ms"), ("3 ms", "5 ms"), ("5 ms", "3 ms"), ("5 ms", "5 ms")])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_constants_stay_constant(
    transfer: str, source: str, target: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    if (transfer, source) == ("mean", "5 ms") and target == "3 ms":
        return  # refused
    _, held = column(run_pair(tmp_path, fmus, source, target, transfer, {"c0": 0.7}, "150 ms", algorithm), "t.held")
    np.testing.assert_allclose(held[1:], 0.7, rtol=4e-16 if transfer != "mean" else 1e-14)


@pytest.mark.parametrize(("source", "target"), [("1 ms", "5 ms"), ("3 ms", "5 ms"), ("5 ms", "3 ms"), ("5 ms", "5 ms")])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_linear_is_exact_for_a_ramp_from_the_second_sample_on(
    source: str, target: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    run = run_pair(tmp_path, fmus, source, target, "linear", {"c0": 2.0, "c1": 3.0}, "150 ms", algorithm)
    t, held = column(run, "t.held")
    H = t[1]
    later = t[1:] > 0.005 + H
    np.testing.assert_allclose(held[1:][later], (2.0 + 3.0 * (t[1:] - H / 2))[later], rtol=1e-12)


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(("fast", "slow", "every"), [("1 ms", "5 ms", 1), ("3 ms", "5 ms", 3), ("1/60 s", "1/20 s", 1)])
def test_mean_makes_and_loses_no_impulse(
    fast: str, slow: str, every: int, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    """At instants that both reach, the integral of what was held is that of the source's samples, to rounding."""
    run = run_pair(tmp_path, fmus, fast, slow, "mean", {"c0": 1.0, "a": 3.0, "w": 400.0}, "1.5 s", algorithm)
    t_slow, impulse = column(run, "t.impulse")
    t_fast, y = column(run, "s.y")
    trapezoid = np.concatenate([[0.0], np.cumsum((y[1:] + y[:-1]) / 2 * t_fast[1])])
    common = t_slow[::every]
    np.testing.assert_allclose(impulse[::every], np.interp(common, t_fast, trapezoid), rtol=1e-12, atol=1e-13)


def test_mean_does_not_alias_a_ripple(tmp_path: Path, fmus: Path) -> None:
    """A 125 Hz ripple into a 100 Hz target: hold shows a slow 25 Hz beat at full height, the mean nearly none of it."""
    signal = {"a": 1.0, "w": 2 * np.pi * 125.0}
    held = {
        transfer: column(run_pair(tmp_path, fmus, "0.5 ms", "10 ms", transfer, signal, "400 ms"), "t.held")[1][1:]
        for transfer in ("hold", "mean")
    }
    assert np.max(np.abs(held["hold"])) > 0.95
    # The mean of a sine over 1.25 of its periods is at most 1/(1.25 pi) = 0.255 of its height.
    assert np.max(np.abs(held["mean"])) < 0.26


def test_coefficients_are_rounded_once() -> None:
    assert linear_ratio(sample=5, source_period=5, start=5, target_period=3) == 0.3
    assert linear_ratio(sample=10, source_period=10, start=5, target_period=5) == -0.25
    assert mean_tail(sample=3, source_period=3, end=5, target_period=5) == (2 / 5 + 4 / 30, -4 / 30)
    assert mean_tail(sample=5, source_period=5, end=5, target_period=5) == (0.0, 0.0)
