"""Errors of the transfers on known signals, through real FMUs."""

from __future__ import annotations

from math import cos, log2
from pathlib import Path

import numpy as np
import pytest
from helpers import column, plan_of, run_of
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.schedule.formulas import linear_ratio, mean_tail, quadratic_weights, value_ratio
from rovbrush.orchestrator.results.tables import Run

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
@pytest.mark.parametrize(("transfer", "order"), [("hold", 1.0), ("linear", 2.0), ("quadratic", 3.0)])
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


@pytest.mark.parametrize("transfer", ["hold", "linear", "quadratic", "interpolate", "mean"])
@pytest.mark.parametrize(("source", "target"), [("1 ms", "5 ms"), ("3 ms", "5 ms"), ("5 ms", "3 ms"), ("5 ms", "5 ms")])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_constants_stay_constant(
    transfer: str, source: str, target: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    slower = float(source.split()[0]) - float(target.split()[0])
    if (transfer == "mean" and slower > 0) or (transfer == "interpolate" and slower < 0):
        with pytest.raises(InputError, match=f"'{transfer}' needs"):
            run_pair(tmp_path, fmus, source, target, transfer, {"c0": 0.7}, "150 ms", algorithm)
        return
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
    assert quadratic_weights(sample=5, source_period=5, start=5, target_period=5, last_period=5) == (0.5, 5 / 12)
    assert value_ratio(sample=10, source_period=10, at=4) == -0.6


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(("source", "target"), [("5 ms", "1 ms"), ("5 ms", "3 ms"), ("5 ms", "5 ms")])
def test_interpolate_is_second_order_and_better_than_extrapolation(
    source: str, target: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    found = {}
    for transfer in ("linear", "interpolate"):
        found[transfer] = [
            error(run_pair(tmp_path, fmus, *(f"{scale * float(text.split()[0])} ms" for text in (source, target)),
                           transfer, SINE, algorithm=algorithm))
            for scale in (4, 2)
        ]  # fmt: skip
    assert log2(found["interpolate"][0] / found["interpolate"][1]) == pytest.approx(2.0, abs=0.15)
    # The error of a line is f'' (x - s)(x - s + h)/2: a quarter inside the interval of what it is behind it, or less.
    if (source, target) == ("5 ms", "1 ms"):
        assert found["interpolate"][1] < 0.25 * found["linear"][1]


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(("source", "target"), [("5 ms", "1 ms"), ("5 ms", "3 ms"), ("5 ms", "5 ms")])
def test_interpolate_is_exact_for_a_ramp_from_the_first_step_on(
    source: str, target: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    run = run_pair(tmp_path, fmus, source, target, "interpolate", {"c0": 2.0, "c1": 3.0}, "150 ms", algorithm)
    assert run.plan.leaders == ("s",)
    t, held = column(run, "t.held")
    np.testing.assert_allclose(held[1:], 2.0 + 3.0 * (t[1:] - t[1] / 2), rtol=1e-12)
    times, y = column(run, "s.y")
    np.testing.assert_allclose(y, 2.0 + 3.0 * times, rtol=1e-12)  # recorded at its own instants


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_quadratic_is_exact_for_a_parabola_from_the_third_sample_on(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    for source, target in (("5 ms", "1 ms"), ("5 ms", "3 ms"), ("3 ms", "5 ms")):
        signal = {"c0": 2.0, "c1": 3.0, "c2": -40.0}
        run = run_pair(tmp_path, fmus, source, target, "quadratic", signal, "150 ms", algorithm)
        t, held = column(run, "t.held")
        integral = 2.0 * t + 1.5 * t**2 - 40.0 / 3.0 * t**3
        later = t[1:] > 0.010 + t[1]
        np.testing.assert_allclose(held[1:][later], (np.diff(integral) / t[1])[later], rtol=1e-10)


def test_a_held_output_of_a_component_that_steps_first_is_that_of_the_beginning(tmp_path: Path, fmus: Path) -> None:
    parts = {"s": ("wave", "4 ms", {"c1": 1.0}), "a": ("integrator", "1 ms"), "b": ("integrator", "2 ms")}
    run = run_of(tmp_path, fmus, parts, ["s.y -> a.u (interpolate)", "s.y -> b.u (hold)"], stop="40 ms")
    t, held = column(run, "b.held")
    np.testing.assert_allclose(held[1:], t[:-1], atol=1e-15)


def test_two_components_cannot_both_step_first(tmp_path: Path, fmus: Path) -> None:
    parts = {"a": ("integrator", "2 ms"), "b": ("integrator", "2 ms")}
    with pytest.raises(InputError, match="'interpolate' needs b to step first"):
        plan_of(tmp_path, fmus, parts, ["a.x -> b.u (interpolate)", "b.x -> a.u (interpolate)"])


def test_there_is_no_mean_yet_for_a_component_that_steps_first(tmp_path: Path, fmus: Path) -> None:
    parts = {"slow": ("integrator", "5 ms"), "fast": ("integrator", "1 ms")}
    wires = ["slow.x -> fast.u (interpolate)", "fast.x -> slow.u"]
    plan = plan_of(tmp_path, fmus, parts, wires)
    assert [(choice.transfer) for choice in plan.choices.values()] == ["interpolate", "hold"]
    assert "slow steps first: its outputs are interpolated" in explain(plan)
    with pytest.raises(InputError, match=r"slow steps before fast .* so there is no 'mean' yet"):
        plan_of(tmp_path, fmus, parts, [wires[0], f"{wires[1]} (mean)"])
