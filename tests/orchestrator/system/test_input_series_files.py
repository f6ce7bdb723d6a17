"""Tables from CSV files, system files and arrays; wrong ones are an error before time 0."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from helpers import column, last, plan_of, read_system, run_of, system_text
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.container import write_container
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.files.csv import write_csv
from rovbrush.orchestrator.results.files.manifest import manifest
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.sweep.workers.point import digest
from rovbrush.orchestrator.system.inputs.series_file import with_files, with_inputs
from rovbrush.orchestrator.system.ssp.write import write_ssp
from series_cases import ROWS, VALUES, one, planned


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


@pytest.mark.parametrize(("mark", "word"), [(";", "semicolons"), ("\t", "tabs")])
def test_a_file_as_a_spreadsheet_writes_it_is_refused_with_what_is_wrong(
    mark: str, word: str, tmp_path: Path, fmus: Path
) -> None:
    (tmp_path / "p.csv").write_text(f"time [s]{mark}i.u [1]\n0,5{mark}1,5\n", encoding="utf-8-sig")
    with pytest.raises(InputError, match=f"p.csv: its columns are separated by {word}; write a comma"):
        with_files(one(tmp_path, fmus), [tmp_path / "p.csv"])


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
    ("time,j.u\n0,1\n", "no component 'j' in 'j.u'; did you mean 'i.u'?"),
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
    ({"time": [0, 1], "values": [1, [2]]}, "rows of different lengths"),
    ({"time": [0, 1], "values": [[1, 2], [3]]}, "rows of different lengths"),
    ({"time": [0, [1]], "values": [1, 2]}, "time"),
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
    wide = {**os.environ, "COLUMNS": "160"}  # the plan is wrapped at the terminal's width
    done = subprocess.run([*command, "plan", *options], capture_output=True, text=True, check=True, env=wide)
    shown = done.stdout
    assert "i.u = mean of column i.u of profile.csv over 0 s by 2 ms" in shown
    subprocess.run([*command, "run", *options, "--out", str(tmp_path)], capture_output=True, check=True)
    with xarray.open_dataset(tmp_path / "result.nc", group="every_2_ms") as saved:
        assert float(saved["i.x"][-1]) == pytest.approx(0.04, rel=1e-12)
    profile.write_text("time,i.uu\n0,1\n")
    done = subprocess.run([*command, "run", *options], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.strip() == "error: --input profile.csv: i.uu is no input; did you mean 'u'?"
