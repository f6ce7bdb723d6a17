"""Inputs that follow a table: held over a step at the mean of the table's lines, or sampled, in every algorithm."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Measured, column, last, read_system
from native_build import FREE2, built, needs_gcc
from rovbrush.orchestrator.loop.lookup import held_at, mean_over, value_at
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import require_complete
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.inputs.series_file import with_files
from series_cases import CONTROLLER, ROWS, VALUES, one, planned

CAR = {"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")}
CAR_WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}


def piecewise(times: list[float], values: list[float], begin: float, end: float) -> float:
    """Mean of the lines between two times, by 1000 midpoints in every stretch between rows."""
    edges = sorted({begin, end, *(t for t in times if begin < t < end)})
    total = 0.0
    for a, b in pairwise(edges):
        k = max(j for j, t in enumerate(times) if t <= a)
        if k + 1 == len(times):
            total += values[k] * (b - a)
            continue
        x = a + (np.arange(1000) + 0.5) / 1000 * (b - a)
        line = values[k] + (values[k + 1] - values[k]) * (x - times[k]) / (times[k + 1] - times[k])
        total += float(np.mean(line)) * (b - a)
    return total / (end - begin)


def test_a_table_is_exact_at_its_rows_and_straight_between_them() -> None:
    table = np.array([float(len(ROWS)), *ROWS, *VALUES])
    for time, value in ((0.0, 1.0), (0.003, 4.0), (0.0045, 5.0), (0.02, 5.0), (0.0015, 2.5), (0.1, 5.0)):
        assert value_at(table, 0, time) == pytest.approx(value, rel=1e-15)
    assert [held_at(table, 0, t) for t in (0.0, 0.0029, 0.003, 0.0045, 7.0)] == [1.0, 1.0, 4.0, 5.0, 5.0]


def test_its_mean_is_that_of_its_lines() -> None:
    table = np.array([float(len(ROWS)), *ROWS, *VALUES])
    for begin, end in ((0.0, 0.02), (0.001, 0.002), (0.002, 0.004), (0.003, 0.0045), (0.0045, 0.01), (0.004, 0.005)):
        assert mean_over(table, 0, begin, end) == pytest.approx(piecewise(ROWS, VALUES, begin, end), rel=1e-12)
    assert mean_over(table, 0, 0.001, 0.002) == value_at(table, 0, 0.0015)


def test_a_constant_table_is_the_constant(tmp_path: Path, fmus: Path) -> None:
    system = one(tmp_path, fmus)
    constant = simulate(make_plan(system.with_values({"i.u": 0.1}, "test")))
    table = simulate(planned(system, {"i.u": (np.array([0.0, 0.02]), np.array([0.1, 0.1]))}))
    assert column(constant, "i.x")[1].tobytes() == column(table, "i.x")[1].tobytes()


@pytest.mark.parametrize("period", ["10 ms", "2 ms", "0.5 ms"])
def test_the_integral_of_a_table_arrives_whatever_the_step(period: str, tmp_path: Path, fmus: Path) -> None:
    run = require_complete(simulate(planned(one(tmp_path, fmus, period=period), {"i.u": (ROWS, VALUES)})))
    exact = 0.003 * 2.5 + 0.0015 * 1.0 + 0.0155 * 5.0
    assert last(run, "i.x") == pytest.approx(exact, rel=1e-13)  # sums of at most 40 terms


def test_the_error_against_a_smooth_signal_is_second_order_in_the_rows(
    tmp_path: Path, fmus: Path, measured: Measured
) -> None:
    errors = []
    for rows in (21, 41, 81):
        t = np.linspace(0.0, 1.0, rows)
        run = simulate(planned(one(tmp_path, fmus, "1 s", "5 ms"), {"i.u": (t, np.sin(5 * t))}))
        errors.append(abs(last(run, "i.x") - (1 - np.cos(5.0)) / 5))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    measured("input from a table: observed order in the distance of its rows", float(orders[-1]), "2 +- 0.05")
    assert orders == pytest.approx(2.0, abs=0.05)


def test_over_a_step_the_mean_is_held_and_recorded_and_at_time_0_the_first_value(tmp_path: Path, fmus: Path) -> None:
    run = simulate(planned(one(tmp_path, fmus), {"i.u": ([0.0, 0.02], [3.0, 23.0])}))
    t, u = column(run, "i.u")
    assert u[0] == 3.0
    assert u[1:] == pytest.approx(3.0 + 1000.0 * (t[1:] - 0.001), rel=1e-14)
    assert np.array_equal(column(run, "i.held")[1][1:], u[1:])


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel", "iterated", "ecco"])
def test_every_algorithm_gives_the_same_integral_compiled_and_interpreted(
    algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    t = np.linspace(0.0, 0.2, 57)
    u = np.cos(31 * t) + t
    keys: dict[str, Any] = {"bonds": [BOND]} if algorithm == "ecco" else {}
    system = read_system(tmp_path, fmus, {**CAR, **{"i": ("integrator", "1 ms", {"=u": 0.0})}}, CAR_WIRES,
                         stop="200 ms", algorithm=algorithm, **keys)  # fmt: skip
    plan = planned(system, {"i.u": (t, u)})
    runs = [require_complete(simulate(plan, interpreted)) for interpreted in (False, True)]
    assert [x.tobytes() for x in runs[0].tables] == [x.tobytes() for x in runs[1].tables]
    assert last(runs[0], "i.x") == pytest.approx(np.trapezoid(u, t), rel=1e-12)  # some hundred terms
    assert "mean of a table over" in explain(plan)


def test_a_mean_of_what_answers_a_table_at_once_is_read_behind_the_new_input(tmp_path: Path, fmus: Path) -> None:
    parts = {"g": ("gain", "1 ms", {"k": 2.0, "offset": 0.0, "=u": 0.0}), "i": ("integrator", "4 ms")}
    t = [0.0, 0.02]
    system = read_system(tmp_path, fmus, parts, ["g.y -> i.u"], stop="20 ms", algorithm="gauss-seidel")
    plan = planned(system, {"g.u": (t, [0.0, 1.0])})
    assert "depends at once on u" in plan.rereads["g"]
    assert last(simulate(plan), "i.x") == pytest.approx(0.02, rel=1e-12)  # 2 times the integral of the ramp


@needs_gcc
@pytest.mark.parametrize("isolation", ["", 'isolation = "process"'])
def test_what_is_no_floating_point_number_takes_the_last_row(
    isolation: str, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    native = built(tmp_path_factory.mktemp("native"))
    text = tmp_path / "profile.csv"
    text.write_text("time,a.n_in,a.on_in,a.u\n0,-7,false,0\n0.002,5,,\n0.0035,8,true,\n0.006,8,true,6\n")
    system = read_system(tmp_path, native, {"a": ("feedthrough2", "1 ms", FREE2)}, stop="6 ms")
    if isolation:
        component = replace(system.components["a"], isolation="process")
        system = system.with_component(component)
    run = require_complete(simulate(make_plan(with_files(system, [text]))))
    assert column(run, "a.n_out")[1].view(np.int64).tolist() == [-7, -7, -7, 5, 5, 8, 8]
    assert column(run, "a.on_out")[1].view(np.int64).tolist() == [0, 0, 0, 0, 0, 1, 1]
    assert column(run, "a.y")[1] == pytest.approx([0.0, 0.5, 1.5, 2.5, 3.5, 4.5, 5.5], rel=1e-12)


def test_a_sampled_input_takes_the_last_row_at_the_beginning_of_its_step(tmp_path: Path, fmus: Path) -> None:
    parts = {"m": ("dc_motor", "10 ms", {"=T_brush": 0.0}), "c": ("rov_controller", "20 ms", CONTROLLER)}
    system = read_system(tmp_path, fmus, parts, ["c.V_in -> m.V_in"], stop="100 ms")
    plan = planned(system, {"c.V_ref": ([0.0, 0.04, 0.1], [3.0, 9.0, 9.0])})
    assert "a table, 3 rows; sample, the last row" in explain(plan)
    t, V = column(simulate(plan), "c.V_ref")
    assert V.tolist() == [3.0, 3.0, 3.0, 9.0, 9.0, 9.0] and len(t) == 6
