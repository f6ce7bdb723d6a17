"""Macro steps by step doubling: one whole step against two halves."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Measured, column, edited, plan_of, run_of
from quarter_car import exact
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
DECAY = ["a.x -> g.u", "g.y -> a.u"]  # dx/dt = k x, the gain as an FMU of its own


def car(tmp_path: Path, fmus: Path, tolerance: float = 1e-2, stop: str = "1 s", **keys: Any) -> Run:
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")}
    settings = {"tolerance": tolerance, "minimum": "1 us", **keys}
    return run_of(tmp_path, fmus, parts, WIRES, stop=stop, algorithm="adaptive", adaptive=settings)


def growth(tmp_path: Path, fmus: Path, tolerance: float) -> Run:
    """dx/dt = y and dy/dt = x in two FMUs, both exp(t)."""
    parts = {name: ("integrator", "1 ms", {"x_start": 1.0}) for name in "xy"}
    settings = {"tolerance": tolerance, "minimum": "10 us", "maximum": "1 s"}
    return run_of(tmp_path, fmus, parts, ["x.x -> y.u", "y.x -> x.u"], stop="2 s", algorithm="adaptive",
                  adaptive=settings)  # fmt: skip


def worst_z_w(run: Run) -> float:
    times, z_w = column(run, "w.z_w")
    return float(np.max(np.abs(z_w - exact(times)["z_w"])))


def test_the_error_falls_with_the_root_of_the_tolerance(tmp_path: Path, fmus: Path, measured: Measured) -> None:
    """The error of a step is of second order in its length and what is summed up of first: a hundredth of the
    tolerance takes ten times as many steps and leaves a tenth of the error."""
    runs = [growth(tmp_path, fmus, tolerance) for tolerance in (1e-4, 1e-6)]
    errors = [abs(column(run, "x.x")[1][-1] / math.exp(2.0) - 1.0) for run in runs]
    steps = [len(run.tables[0]) - 1 for run in runs]
    measured("exp(t) in two FMUs, adaptive: error at 1e-4 over that at 1e-6", errors[0] / errors[1], "10 +- 1.5")
    assert errors[0] / errors[1] == pytest.approx(10.0, rel=0.15)
    assert steps[1] / steps[0] == pytest.approx(10.0, rel=0.15)


def test_with_direct_dependence_it_is_first_order_in_the_steps(tmp_path: Path, fmus: Path, measured: Measured) -> None:
    """The damper's force depends at once on a held speed, so its error, which is judged, falls with the step."""
    runs = [car(tmp_path, fmus, tolerance, "0.5 s") for tolerance in (1e-3, 2e-4)]
    errors, steps = [worst_z_w(run) for run in runs], [len(run.tables[0]) - 1 for run in runs]
    order = math.log(errors[0] / errors[1]) / math.log(steps[1] / steps[0])
    measured("quarter car, adaptive: order of the error in the number of steps", order, "1 +- 0.1")
    assert order == pytest.approx(1.0, abs=0.1)
    assert steps[1] / steps[0] == pytest.approx(5.0, rel=0.15)


def test_every_step_keeps_the_tolerance_by_its_exact_error(tmp_path: Path, fmus: Path) -> None:
    """Held over two halves of H, exp grows by (1 + H/2)^2: the error that Richardson's estimate leaves is of third
    order, below a tenth of the tolerance here."""
    run = growth(tmp_path, fmus, 1e-4)
    times, x = column(run, "x.x")
    local = np.abs(x[1:] - x[:-1] * np.exp(np.diff(times))) / x[1:]
    assert np.max(local) <= 1.1e-4
    indicator = column(run, "coupling.indicator")[1][1:]
    assert np.max(indicator) <= 1.0
    assert np.median(indicator[5:-2]) > 0.5  # no step is shorter than needed


def test_steps_grow_where_nothing_happens(tmp_path: Path, fmus: Path, measured: Measured) -> None:
    """dx/dt = -5 x from 5: fixed steps of the same number err more."""
    parts = {"a": ("integrator", "1 ms", {"x_start": 5.0}), "g": ("gain", "1 ms", {"k": -5.0, "offset": 0.0})}
    settings = {"tolerance": 1e-2, "minimum": "1 us", "maximum": "50 ms"}
    adaptive = run_of(tmp_path, fmus, parts, DECAY, stop="4 s", algorithm="adaptive", adaptive=settings)
    fixed = run_of(tmp_path, fmus, parts, DECAY, stop="4 s", algorithm="jacobi")
    products = []
    for run in (adaptive, fixed):
        times, x = column(run, "a.x")
        products.append((len(times) - 1) * np.max(np.abs(x - 5.0 * np.exp(-5.0 * times))))
    measured("decay, adaptive: steps times error against those of 1 ms", products[0] / products[1], "0.5")
    assert products[0] < 0.5 * products[1]


def test_a_first_step_that_is_too_long_is_done_again(tmp_path: Path, fmus: Path) -> None:
    parts = {"a": ("integrator", "500 ms", {"x_start": 5.0}), "g": ("gain", "500 ms", {"k": -1.0, "offset": 0.0})}
    settings = {"tolerance": 1e-4, "minimum": "10 us", "maximum": "1 s"}
    run = run_of(tmp_path, fmus, parts, DECAY, stop="2 s", algorithm="adaptive", adaptive=settings)
    times, rejected = column(run, "coupling.rejected")
    assert rejected[1] >= 1 and times[1] < 0.1
    x = column(run, "a.x")[1]
    assert abs(x[-1] - 5.0 * math.exp(-2.0)) < 2e-2
    summary = summarize(run)
    assert summary["steps_rejected"] == rejected.sum() and summary["macro_steps"] == len(times) - 1


@pytest.mark.parametrize("stop", ["1 s", "1/3 s", "123.4567 ms", "1 ms"])
def test_times_are_exact_and_the_last_is_the_stop(stop: str, tmp_path: Path, fmus: Path) -> None:
    run = car(tmp_path, fmus, stop=stop)
    times, step = column(run, "coupling.step")
    assert times[0] == 0.0 and times[-1] == float(run.plan.system.stop) == run.end
    np.testing.assert_allclose(np.diff(times), step[1:], rtol=1e-9)


@pytest.mark.parametrize("stop", ["34 ms", "35.3 ms", "100.1 ms"])
def test_no_step_is_beyond_the_largest(stop: str, tmp_path: Path, fmus: Path) -> None:
    run = car(tmp_path, fmus, tolerance=10.0, stop=stop, maximum="10 ms", minimum="1 ms")
    assert np.max(column(run, "coupling.step")[1]) <= 10e-3
    assert run.end == float(run.plan.system.stop)


def test_an_error_at_the_smallest_step_ends_the_run_with_its_name(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")}
    settings = {"tolerance": 1e-9, "minimum": "1 ms"}
    run = simulate(plan_of(tmp_path, fmus, parts, WIRES, stop="1 s", algorithm="adaptive", adaptive=settings))
    assert "the error of " in run.failure and "in the step to t = 0.001 s" in run.failure
    assert "no longer than the smallest allowed, 1 ms; lower minimum under [adaptive]" in run.failure
    assert run.end == 0.0 and [len(table) for table in run.tables] == [1]


def test_compiled_loop_and_interpreter_agree_bitwise(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "20 ms"), "c": ("chassis", "20 ms")}
    plan = plan_of(tmp_path, fmus, parts, WIRES, stop="300 ms", algorithm="adaptive")
    compiled, interpreted = simulate(plan), simulate(plan, interpreted=True)
    assert compiled.tables[0].tobytes() == interpreted.tables[0].tobytes()
    assert column(compiled, "coupling.rejected")[1].sum() > 0


def test_what_is_recorded_does_not_change_the_steps(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")}
    keys: dict[str, Any] = {"stop": "100 ms", "algorithm": "adaptive"}
    steps = [column(run_of(tmp_path, fmus, parts, WIRES, record=r, **keys), "coupling.tick")[1]
             for r in (["*"], ["w.z_w"])]  # fmt: skip
    assert np.array_equal(*steps)


def test_the_plan_explains_the_steps(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}
    text = explain(plan_of(tmp_path, fmus, parts, WIRES, algorithm="adaptive"))
    for words in (
        "one whole and two halves of it agree within 0.0001",
        "the first step is 2 ms",
        "halve       the macro step",
        "advance     to the middle",
        "estimate    coupling.tick",
        "restore     the state of c",
    ):
        assert words in text


@pytest.mark.parametrize("flag", ["canHandleVariableCommunicationStepSize", "canGetAndSetFMUstate"])
def test_an_fmu_that_cannot_is_refused_by_name_and_flag(flag: str, tmp_path: Path, fmus: Path) -> None:
    changed = {f'{flag}="true"': f'{flag}="false"', 'canSerializeFMUstate="true"': 'canSerializeFMUstate="false"'}
    wheel = edited(fmus / "wheel.fmu", tmp_path / "unable.fmu", {}, changed)
    parts = {"w": (str(wheel), "5 ms"), "c": ("chassis", "5 ms")}
    with pytest.raises(InputError, match=rf"(?i)component w: algorithm 'adaptive' needs .*unable\.fmu.*{flag} = false"):
        plan_of(tmp_path, fmus, parts, WIRES, algorithm="adaptive")


@pytest.mark.parametrize(
    ("periods", "wires", "settings", "message"),
    [
        (("1 ms", "2 ms"), WIRES, {}, "need one period"),
        (("1 ms", "1 ms"), WIRES, {"grow": 0.5}, "grow = 0.5 above"),
        (("1 ms", "1 ms"), WIRES, {"minimum": "2 ms"}, "must be between minimum 2 ms"),
        (("1 ms", "1 ms"), [f"{WIRES[0]} (linear)", WIRES[1]], {}, "'linear' has no meaning; leave it out"),
        (("1 ms", "1 ms"), WIRES, {"tolerance": -1.0}, "tolerance = -1.0 must be a number above 0"),
        (("1 ms", "1 ms"), WIRES, {"tolerances": 1.0}, "unknown key 'tolerances'; did you mean 'tolerance'"),
    ],
)
def test_what_cannot_be_is_refused(
    periods: tuple[str, str], wires: list[str], settings: dict[str, Any], message: str, tmp_path: Path, fmus: Path
) -> None:
    parts = {"w": ("wheel", periods[0]), "c": ("chassis", periods[1])}
    with pytest.raises(InputError, match=message):
        plan_of(tmp_path, fmus, parts, wires, algorithm="adaptive", adaptive=settings)


def test_a_system_without_connections_has_nothing_to_judge(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(InputError, match="no connection has one; take another algorithm"):
        plan_of(tmp_path, fmus, {"a": ("integrator", "1 ms", {"=u": 1.0})}, algorithm="adaptive")
