"""What can be set: start values that an FMU calls exact, before time 0; tunable parameters, while the run goes too."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from helpers import column, edited, rovbrush, system_text
from native_build import moody, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.inputs.series_file import with_inputs

pytestmark = needs_gcc
EXACT = {
    '<ScalarVariable name="x" valueReference="0" causality="output" variability="continuous"><Real />': (
        '<ScalarVariable name="x" valueReference="0" causality="output" variability="continuous" initial="exact">'
        '<Real start="0" max="10"/>'
    ),
    'name="k" valueReference="2" causality="parameter" variability="fixed"': (
        'name="k" valueReference="2" causality="parameter" variability="tunable"'
    ),
}
LOCAL = {key: text.replace('causality="output"', 'causality="local"') for key, text in EXACT.items()}


def file(folder: Path, values: dict[str, object] | None = None, xml: dict[str, str] | None = None) -> Path:
    """x integrates u = 1 from what it starts with, y = k x behind each step."""
    edited(moody(folder / "m.fmu"), folder / "t.fmu", {}, EXACT if xml is None else xml)
    path = folder / "case.toml"
    path.write_text(system_text({"a": ("t.fmu", "1 ms", {"=u": 1.0, **(values or {})})}, [], "5 ms"), encoding="utf-8")
    return path


def plan(path: Path) -> Plan:
    return make_plan(load_system(str(path), path.parent))


def test_an_exact_start_value_is_set_in_the_system_file(tmp_path: Path) -> None:
    run = simulate(plan(file(tmp_path, {"x": 7.0})))
    t, x = column(run, "a.x")
    assert x == pytest.approx(7.0 + t, rel=1e-12)


@pytest.mark.parametrize("xml", [EXACT, LOCAL], ids=["output", "local"])
def test_and_on_the_command_line(xml: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    structure = {'<Unknown index="1"/>': ""} if xml is LOCAL else {}
    path = file(tmp_path, xml=xml | structure)
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "run", path, "--set", "a.x=7", "--out", out, "--fmus", tmp_path) == 0
    assert json.loads((out / "manifest.json").read_text())["components"]["a"]["parameters"]["x"] == 7.0
    assert simulate(make_plan(assemble(str(path), {"a.x": 7.0}))).tables[0][-1].max() >= 7.0


def test_one_out_of_its_range_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a\.x = 11 is out of range"):
        load_system(str(file(tmp_path, {"x": 11.0})), tmp_path)


def test_an_output_that_is_calculated_is_still_no_parameter(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a\.y is of causality output and cannot be set"):
        load_system(str(file(tmp_path, {"y": 1.0})), tmp_path)
    with pytest.raises(InputError, match=r"a\.x is no input"):
        load_system(str(file(tmp_path, {"=x": 1.0})), tmp_path)


TABLE = {"time": [0.0, 0.0025, 0.005], "values": [1.0, 5.0, 5.0]}


@pytest.mark.parametrize("interpreted", [False, True])
def test_a_tunable_parameter_follows_a_table_by_its_last_row(interpreted: bool, tmp_path: Path) -> None:
    path = file(tmp_path)
    text = path.read_text().replace("u = 1.0", "u = 1.0\nk = { time = [0.0, 0.0025, 0.005], values = [1.0, 5.0, 5.0] }")
    path.write_text(text)
    run = simulate(plan(path), interpreted)
    t, y = column(run, "a.y")
    k = np.array([1.0, 1.0, 1.0, 1.0, 5.0, 5.0])  # that of the beginning of the step: 0, 0, 1, 2, 3, 4 ms
    assert y == pytest.approx(k * t, rel=1e-12)


def test_or_a_csv_file_or_arrays(tmp_path: Path) -> None:
    (tmp_path / "k.csv").write_text("time,a.k\n0,1\n0.0025,5\n0.005,5\n")
    path = file(tmp_path)
    by_file = simulate(make_plan(assemble(str(path), inputs=[tmp_path / "k.csv"])))
    tables = (np.array(TABLE["time"]), np.array(TABLE["values"]))
    by_arrays = simulate(make_plan(with_inputs(load_system(str(path), tmp_path), {"a.k": tables})))
    assert np.array_equal(column(by_file, "a.y")[1], column(by_arrays, "a.y")[1])
    assert column(by_file, "a.y")[1][-1] == pytest.approx(0.025, rel=1e-12)


def test_a_fixed_parameter_follows_none(tmp_path: Path) -> None:
    path = file(tmp_path, xml={})
    with pytest.raises(InputError, match=r"a\.k is no input"):
        with_inputs(load_system(str(path), tmp_path), {"a.k": ([0.0, 1.0], [1.0, 2.0])})


def test_a_session_sets_a_tunable_parameter_from_the_next_step_on(tmp_path: Path) -> None:
    with Stepping(plan(file(tmp_path))) as session:
        session.step()
        for value in (3.0, 4.0):  # the second time goes another way
            session.set("a.k", value)
            session.step()
            assert session.get("a.y") == pytest.approx(value * session.time, rel=1e-12) and session.get("a.k") == value
        with pytest.raises(InputError, match="only inputs and tunable parameters"):
            session.set("a.x", 1.0)


def test_what_was_tuned_is_part_of_a_checkpoint(tmp_path: Path) -> None:
    path = file(tmp_path)
    with Session(plan(path)) as session:
        session.advance(cycles=2)
        session.set("a.k", 3.0)
        write_checkpoint(session, tmp_path / "out")
        session.advance()
        whole = session.run()
    with Session(plan(path)) as later:
        read_checkpoint(tmp_path / "out").restore(later)
        later.advance()
        assert all(np.array_equal(a, b) for a, b in zip(whole.tables, later.run().tables, strict=True))
