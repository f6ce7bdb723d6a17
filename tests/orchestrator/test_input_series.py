"""Inputs that follow a table: held over a step at the mean of the table's lines, or sampled, in every algorithm."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from helpers import Measured, column, last, plan_of, read_system, run_of, system_text
from native_build import built, needs_gcc
from rovbrush.orchestrator.changes import Changes
from rovbrush.orchestrator.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.container import write_container
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.explain import explain
from rovbrush.orchestrator.lookup import held_at, mean_over, value_at
from rovbrush.orchestrator.plan import Plan, make_plan
from rovbrush.orchestrator.results import manifest, write_csv
from rovbrush.orchestrator.series_file import with_files, with_inputs
from rovbrush.orchestrator.session import Session
from rovbrush.orchestrator.simulation import require_complete, simulate
from rovbrush.orchestrator.ssp.write import write_ssp
from rovbrush.orchestrator.studies.point import digest
from rovbrush.orchestrator.system import System
from test_types import FREE2

ONE = {"i": ("integrator", "2 ms", {"=u": 0.0})}
ROWS = [0.0, 0.003, 0.0045, 0.0045, 0.02]
VALUES = [1.0, 4.0, -2.0, 5.0, 5.0]
CAR = {"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")}
CAR_WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}


def one(tmp_path: Path, fmus: Path, stop: str = "20 ms", period: str = "2 ms") -> System:
    return read_system(tmp_path, fmus, {"i": ("integrator", period, {"=u": 0.0})}, stop=stop)


def planned(system: System, inputs: dict[str, Any]) -> Plan:
    return make_plan(with_inputs(system, inputs))


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


CONTROLLER = {
    f"={name}": 0.0
    for name in (
        *("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r", "x_ref", "y_ref", "z_ref"),
        *("phi_ref", "theta_ref", "psi_ref", "v_ref", "V_ref", "F_n_ref", "F_tool", "M_tool"),
    )
}


def test_a_file_a_system_file_and_arrays_give_the_same_bits(tmp_path: Path, fmus: Path) -> None:
    rows = "".join(f"{t!r},{v!r}\n" for t, v in zip(ROWS, VALUES, strict=True))
    (tmp_path / "profile.csv").write_text("time [s],i.u [1]\n" + rows)
    (tmp_path / "named.csv").write_text("time,speed\n" + rows)
    system = one(tmp_path, fmus)
    plans = [planned(system, {"i.u": (ROWS, VALUES)}), make_plan(with_files(system, [tmp_path / "profile.csv"]))]
    for stated in (
        {"csv": "profile.csv"}, {"csv": "named.csv", "column": "speed"}, {"time": ROWS, "values": VALUES},
    ):  # fmt: skip
        plans.append(plan_of(tmp_path, fmus, {"i": ("integrator", "2 ms", {"=u": stated})}, stop="20 ms"))
    tables = [simulate(plan).tables[0].tobytes() for plan in plans]
    assert len(tables) == 5 and len(set(tables)) == 1


def test_units_of_a_heading_are_converted(tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "p.csv").write_text("time [ms],m.T_brush [N.mm]\n0,1000\n20,3000\n")
    system = read_system(tmp_path, fmus, {"m": ("dc_motor", "10 ms", {"=T_brush": 0.0, "=V_in": 0.0})}, stop="20 ms")
    run = simulate(make_plan(with_files(system, [tmp_path / "p.csv"])))
    assert column(run, "m.T_brush")[1] == pytest.approx([1.0, 1.5, 2.5], rel=1e-13)


def test_results_of_one_run_are_inputs_of_another(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wave", "1 ms", {"c0": 0.3, "a": 2.0, "w": 90.0})}
    write_csv(run_of(tmp_path, fmus, parts, stop="20 ms"), tmp_path / "r.csv")
    system = one(tmp_path, fmus)
    (tmp_path / "r.csv").write_text((tmp_path / "r.csv").read_text().replace("w.y [1]", "i.u [1]").replace("w.Y", "Y"))
    component = read_system(
        tmp_path, fmus, {"i": ("integrator", "2 ms", {"=u": {"csv": "r.csv"}})}, stop="20 ms"
    ).components["i"]
    run = simulate(make_plan(system.with_component(component)))
    t = np.linspace(0.0, 0.02, 21)
    assert last(run, "i.x") == pytest.approx(np.trapezoid(0.3 + 2.0 * np.sin(90.0 * t), t), rel=1e-8)  # 10 digits


def test_the_plan_and_the_manifest_name_the_table(tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "profile.csv").write_text("time,i.u\n0,1\n1,2\n")
    system = with_files(one(tmp_path, fmus), [tmp_path / "profile.csv"])
    text = explain(make_plan(system))
    assert "i.u = mean of column i.u of profile.csv over 0 s by 2 ms" in text
    assert "column i.u of profile.csv, 2 rows; series" in text
    told = manifest(simulate(make_plan(system)))["components"]["i"]["inputs"]["u"]
    assert told["from"] == "column i.u of profile.csv" and len(told["sha256"]) == 64
    json.dumps(told)
    other = with_inputs(system, {"i.u": ([0.0, 1.0], [1.0, 2.5])})
    assert digest(other) != digest(system)


WRONG = [
    ("time,i.u\n0,1\n0.01,2\n", 'holds 0 s to 0.01 s, the run goes from 0 s to 20 ms; add rows, or stop at "0.01 s"'),
    ("time,i.u\n0.001,1\n1,2\n", "holds 0.001 s to 1 s, the run goes from 0 s"),
    ("t,i.u\n0,1\n", "there is no column 'time' among t, i.u"),
    ("time,i.u,i.u\n0,1,1\n", "column 'i.u' appears twice"),
    ("time,i.v\n0,1\n", "i.v is no input; there are u"),
    ("time,j.u\n0,1\n", "no component 'j' in 'j.u'; there are i"),
    ("time,i.x\n0,1\n", "i.x is no input"),
    ("time,i.u\n0,1,2\n", "line 2: 3 cells under 2 headings"),
    ("time,i.u\n0,one\n", "line 2: i.u = 'one' is not a number"),
    ("time,i.u\nnow,1\n", "line 2: time = 'now' is not a number"),
    ("time,i.u\n0,\n", "column 'i.u' of p.csv is empty"),
    ("time,i.u\n0,nan\n1,1\n", "row 1 holds nan, which is no finite number"),
    ("time,i.u\n0,1\n2,1\n1,1\n", "the times fall, from 2 s to 1 s in row 3"),
    ("time,i.u [kg]\n0,1\n1,1\n", "the units do not fit: kg cannot become 1"),
    ("time [m],i.u\n0,1\n1,1\n", "column time: the units do not fit"),
    ("", "there is no column 'time' among none"),
]


@pytest.mark.parametrize(("text", "message"), WRONG, ids=[message[:30] for _, message in WRONG])
def test_a_wrong_file_is_an_error_before_time_0(text: str, message: str, tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "p.csv").write_text(text)
    with pytest.raises(InputError) as error:
        make_plan(with_files(one(tmp_path, fmus), [tmp_path / "p.csv"]))
    assert message in str(error.value) and "p.csv" in str(error.value)


ENTRIES: list[tuple[dict[str, Any], str]] = [
    ({"csv": "none.csv"}, "cannot be read"),
    ({"csv": "p.csv", "column": "speeed"}, "has no column 'speeed'; did you mean 'speed'?"),
    ({"csv": "p.csv", "unit": "1"}, "only 'column' may stand"),
    ({"time": [0, 1]}, "write { csv ="),
    ({"tim": [0, 1], "values": [0, 1]}, "unknown key 'tim'; did you mean 'time'?"),
    ({"time": [0, 1], "values": [0, 1, 2]}, "2 times and values of shape (3,)"),
    ({"time": [0, 1], "values": [0, "x"]}, "could not convert"),
    ({"time": [], "values": []}, "a list of numbers is needed"),
]


@pytest.mark.parametrize(("entry", "message"), ENTRIES, ids=[message[:30] for _, message in ENTRIES])
def test_a_wrong_entry_names_its_line(entry: dict[str, Any], message: str, tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "p.csv").write_text("time,speed\n0,1\n1,2\n")
    with pytest.raises(InputError, match=r"case.toml, line \d+") as error:
        read_system(tmp_path, fmus, {"i": ("integrator", "2 ms", {"=u": entry})}, stop="20 ms")
    assert message in str(error.value)


def test_values_out_of_range_and_driven_inputs_are_refused(tmp_path: Path, fmus: Path) -> None:
    parts = {"b": ("wave", "1 ms"), "i": ("integrator", "1 ms")}
    system = read_system(tmp_path, fmus, parts, ["b.y -> i.u"], stop="20 ms")
    with pytest.raises(InputError, match=r"i.u is driven by the connection b.y -> i.u"):
        with_inputs(system, {"i.u": ([0, 1], [0, 1])})
    free = with_inputs(one(tmp_path, fmus), {"i.u": ([0, 1], [0, 1])})
    with pytest.raises(InputError, match=r"i.u follows a table; remove that first"):
        free.with_values({"i.u": 1.0}, "--set")
    assert with_inputs(free, {"i.u": 1.0}).components["i"].inputs == {"u": 1.0}


def test_what_cannot_hold_a_table_says_so(tmp_path: Path, fmus: Path) -> None:
    system = with_inputs(one(tmp_path, fmus), {"i.u": ([0, 1], [0, 1])})
    with pytest.raises(InputError, match=r"input i.u follows a table, which is not written to an SSP"):
        write_ssp(system, tmp_path / "x.ssp")
    with pytest.raises(InputError, match=r"input i.u follows a table, which a container cannot hold"):
        write_container(system, tmp_path / "x.fmu")


def test_the_command_line_takes_files(tmp_path: Path, fmus: Path) -> None:
    path, profile = tmp_path / "case.toml", tmp_path / "profile.csv"
    path.write_text(system_text({"i": ("integrator", "2 ms", {"=u": 0.0})}, stop="20 ms"))
    profile.write_text("time,i.u\n0,1\n0.02,3\n")
    command = [sys.executable, "-m", "rovbrush.orchestrator"]
    options = [str(path), "--fmus", str(fmus), "--input", str(profile)]
    shown = subprocess.run([*command, "plan", *options], capture_output=True, text=True, check=True).stdout
    assert "i.u = mean of column i.u of profile.csv over 0 s by 2 ms" in shown
    subprocess.run([*command, "run", *options, "--out", str(tmp_path)], capture_output=True, check=True)
    with xarray.open_dataset(tmp_path / "result.nc", group="every_2_ms") as saved:
        assert float(saved["i.x"][-1]) == pytest.approx(0.04, rel=1e-12)
    profile.write_text("time,i.uu\n0,1\n")
    done = subprocess.run([*command, "run", *options], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.strip() == "error: --input profile.csv: i.uu is no input; did you mean 'u'?"


def test_a_resumed_run_goes_on_with_the_table_and_with_no_other(tmp_path: Path, fmus: Path) -> None:
    t = np.linspace(0.0, 0.02, 33)
    system = one(tmp_path, fmus)
    plan, other = (planned(system, {"i.u": (t, np.sin(k * t))}) for k in (300.0, 301.0))
    with Session(plan) as session:
        session.advance(cycles=4)
        write_checkpoint(session, tmp_path)
    with Session(plan) as session:
        read_checkpoint(tmp_path).restore(session)
        assert session.time == 0.008
        session.advance()
        resumed = session.run()
    assert resumed.tables[0].tobytes() == simulate(plan).tables[0].tobytes()
    with Session(other) as session, pytest.raises(InputError, match=r"i\.u was a table \("):
        read_checkpoint(tmp_path).restore(session)


def test_a_table_reaches_the_fmu_that_replaces_a_component_in_its_direction(tmp_path: Path, fmus: Path) -> None:
    entry = {"time": ROWS, "values": VALUES}
    system = read_system(tmp_path, fmus, {"i": ("integrator", "2 ms", {"=u": entry})}, stop="20 ms")
    (tmp_path / "map.toml").write_text('[variables]\nu = { name = "u", sign = -1 }\n')
    same, turned = (
        Changes((("i", str(fmus / "integrator.fmu")),), mappings).apply(system)
        for mappings in ((), (("i", str(tmp_path / "map.toml")),))
    )
    x, kept, against = (last(simulate(make_plan(s)), "i.x") for s in (system, same, turned))
    assert kept == x and against == -x and x > 0.0


def test_a_replaced_component_without_the_input_must_be_said_to_lack_it(tmp_path: Path, fmus: Path) -> None:
    entry = {"time": ROWS, "values": VALUES}
    system = read_system(tmp_path, fmus, {"i": ("integrator", "2 ms", {"=u": entry})}, stop="20 ms")
    with pytest.raises(InputError, match=r"u.*which the system sets to the table in the system file"):
        Changes((("i", str(fmus / "wave.fmu")),)).apply(system)
