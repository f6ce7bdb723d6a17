"""Macro steps that are repeated until inputs are the values at the end of their steps, by Jacobi or Gauss-Seidel."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Measured, column, last, plan_of, run_of
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from test_quarter_car import worst

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
DECAY = ["a.x -> g.u", "g.y -> a.u"]
SWEEPS = ["jacobi", "gauss-seidel"]


def car(tmp_path: Path, fmus: Path, periods: tuple[str, str], stop: str = "4 s", **iteration: Any) -> Run:
    parts = {"w": ("wheel", periods[0]), "c": ("chassis", periods[1])}
    return run_of(tmp_path, fmus, parts, WIRES, stop=stop, algorithm="iterated",
                  iteration={"inputs": "end", **iteration})  # fmt: skip


@pytest.mark.parametrize(
    ("method", "sweep", "rate"),
    [("newton", "jacobi", 50.0), ("newton", "gauss-seidel", 50.0), ("aitken", "gauss-seidel", 50.0),
     ("aitken", "jacobi", 5.0)],
)  # fmt: skip
def test_a_step_is_that_of_implicit_euler(method: str, sweep: str, rate: float, tmp_path: Path, fmus: Path) -> None:
    """dx/dt = -k x with x held at its end: x' = x / (1 + k H), for any H; with k H = 5 values held from the beginning
    diverge. So do Jacobi sweeps without Newton, whose two unknowns turn about the solution: there k H = 0.5."""
    parts = {"a": ("integrator", "100 ms", {"x_start": 1.0}), "g": ("gain", "100 ms", {"k": -rate, "offset": 0.0})}
    iteration = {"inputs": "end", "sweep": sweep, "method": method, "tolerance": 1e-12, "max_iterations": 200}
    run = run_of(tmp_path, fmus, parts, DECAY, stop="1 s", algorithm="iterated", iteration=iteration)
    np.testing.assert_allclose(
        column(run, "a.x")[1], (1.0 / (1.0 + 0.1 * rate)) ** np.arange(11), rtol=1e-9, atol=1e-11
    )


@pytest.mark.sampled(4)
@pytest.mark.parametrize("sweep", SWEEPS)
@pytest.mark.parametrize("periods", [("2 ms", "2 ms"), ("1 ms", "3 ms"), ("3 ms", "1 ms"), ("2 ms", "3 ms")])
def test_end_values_are_first_order(
    periods: tuple[str, str], sweep: str, tmp_path: Path, fmus: Path, measured: Measured
) -> None:
    halves = tuple(f"{float(text.split()[0]) / 2:g} ms" for text in periods)
    errors = [worst(car(tmp_path, fmus, p, "1.2 s", sweep=sweep)) for p in (periods, (halves[0], halves[1]))]
    order = float(np.log2(errors[0] / errors[1]))
    measured(f"quarter car, iterated to end values, {sweep}, {'/'.join(periods)}: observed order", order, "1 +- 0.25")
    assert order == pytest.approx(1.0, abs=0.25)


@pytest.mark.parametrize("inputs", ["end", "mean"])
@pytest.mark.parametrize("periods", [("2 ms", "2 ms"), ("1 ms", "3 ms"), ("2 ms", "3 ms")])
def test_both_sweeps_find_the_same_solution(periods: tuple[str, str], inputs: str, tmp_path: Path, fmus: Path) -> None:
    values = [
        column(car(tmp_path, fmus, periods, "300 ms", inputs=inputs, sweep=sweep, tolerance=1e-12), "c.z_c")[1]
        for sweep in SWEEPS
    ]
    np.testing.assert_allclose(values[0], values[1], rtol=0.0, atol=1e-10)


def test_a_pass_of_gauss_seidel_knows_more_and_fewer_are_needed(tmp_path: Path, fmus: Path) -> None:
    runs = [car(tmp_path, fmus, ("2 ms", "2 ms"), "300 ms", sweep=sweep) for sweep in SWEEPS]
    assert [len(run.plan.layout.unknowns) for run in runs] == [2, 1]
    passes = [column(run, "coupling.iterations")[1].sum() for run in runs]
    assert passes[1] < passes[0]


def test_a_chain_takes_one_pass(tmp_path: Path, fmus: Path) -> None:
    """Where every source steps before its target nothing is unknown."""
    parts = {"a": ("integrator", "10 ms", {"=u": 1.0}), "b": ("integrator", "10 ms")}
    iteration = {"inputs": "end", "sweep": "gauss-seidel"}
    run = run_of(tmp_path, fmus, parts, ["a.x -> b.u"], stop="100 ms", algorithm="iterated", iteration=iteration)
    assert column(run, "coupling.iterations")[1][1:].tolist() == [1.0] * 10
    assert last(run, "b.x") == pytest.approx(sum(0.01 * k for k in range(1, 11)) * 0.01, rel=1e-12)


@pytest.mark.parametrize("sweep", SWEEPS)
def test_compiled_loop_and_interpreter_agree_bitwise(sweep: str, tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "3 ms")}
    iteration = {"inputs": "end", "sweep": sweep}
    plan = plan_of(tmp_path, fmus, parts, WIRES, stop="60 ms", algorithm="iterated", iteration=iteration)
    tables = [simulate(plan, interpreted).tables for interpreted in (False, True)]
    assert all(a.tobytes() == b.tobytes() for a, b in zip(*tables, strict=True))


def test_the_plan_says_where_inputs_come_from(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "3 ms")}
    iteration = {"inputs": "end", "sweep": "gauss-seidel"}
    text = explain(plan_of(tmp_path, fmus, parts, WIRES, stop="1.2 s", algorithm="iterated", iteration=iteration))
    assert "until every input is the value at the end of its step within 1e-08; a pass takes the latest values" in text
    assert "end on line" in text and "what c.F is sent, step 2" in text


def test_a_stated_mean_has_no_meaning_at_the_end(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    with pytest.raises(InputError, match="holds inputs at the value at the end of their step, so 'mean' has no"):
        plan_of(tmp_path, fmus, parts, ["c.v_c -> w.v_c (mean)", "w.F -> c.F"], algorithm="iterated",
                iteration={"inputs": "end"})  # fmt: skip


@pytest.mark.parametrize(
    ("iteration", "message"),
    [
        ({"inputs": "ends"}, "unknown inputs 'ends'; did you mean 'end'"),
        ({"sweep": "jakobi"}, "unknown sweep 'jakobi'; did you mean 'jacobi'"),
    ],
)
def test_wrong_settings_are_refused(iteration: dict[str, Any], message: str, tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    with pytest.raises(InputError, match=message):
        plan_of(tmp_path, fmus, parts, WIRES, algorithm="iterated", iteration=iteration)
