"""Aliases of FMI 3.0: another name is good for whatever its variable is good for, and is never a second variable."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from helpers import column, edited, last, plan_of, read_system, run_of
from native_build import FREE3, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.contents import contents_of
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.run.session.session import Session

pytestmark = needs_gcc

ALIASES = {
    '<Float64 name="Float64_in" valueReference="0" causality="input" start="0">': (
        '<Float64 name="Float64_in" valueReference="0" causality="input" start="0" unit="rad" displayUnit="rad">'
        '<Alias name="phi" description="the angle" displayUnit="deg"/>'
    ),
    '<Float64 name="Float64_out" valueReference="1" causality="output">': (
        '<Float64 name="Float64_out" valueReference="1" causality="output" unit="rad"><Alias name="phi out"/>'
    ),
    'causality="input" start="1 2 3 4 5 6 7 8">': 'causality="input" start="1 2 3 4 5 6 7 8"><Alias name="row"/>',
    '<Float64 name="a_out" valueReference="101" causality="output">': (
        '<Float64 name="a_out" valueReference="101" causality="output"><Alias name="row out"/>'
    ),
    '<String name="t_in" valueReference="102" causality="input">': (
        '<String name="t_in" valueReference="102" causality="input"><Alias name="words"/>'
    ),
    '<Float64 name="bad_at" valueReference="104" causality="parameter" start="1e9" variability="fixed">': (
        '<Float64 name="bad_at" valueReference="104" causality="parameter" start="1e9" variability="fixed">'
        '<Alias name="when"/>'
    ),
    "<ModelVariables>": (
        '<UnitDefinitions><Unit name="rad"><BaseUnit rad="1"/><DisplayUnit name="deg" factor="57.29577951308232"/>'
        "</Unit></UnitDefinitions><ModelVariables>"
    ),
}


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("aliases")
    made = built(folder) / "feedthrough3.fmu"
    edited(made, folder / "named.fmu", {}, ALIASES).replace(made)
    return folder


def free(**values: Any) -> dict[str, Any]:
    return FREE3 | values


def test_connections_by_other_names_are_those_of_the_variables(fmus: Path, tmp_path: Path) -> None:
    wires = ["a.phi out -> b.phi", "a.row out -> b.row"]
    driven = {k: v for k, v in FREE3.items() if k not in ("=Float64_in", "=a_in")}
    parts = {"a": ("feedthrough3", "1 ms", FREE3), "b": ("feedthrough3", "1 ms", driven)}
    run = run_of(tmp_path, fmus, parts, wires, stop="5 ms")
    assert [c.label for c in run.plan.system.connections][:2] == [
        "a.Float64_out -> b.Float64_in", "a.a_out[1] -> b.a_in[1]"
    ]  # fmt: skip
    assert last(run, "b.Float64_out") == 0.1 and last(run, "b.a_out[8]") == 7.0
    assert last(run, "b.phi out") == 0.1, "an output is recorded by all of its names"


def test_an_input_of_two_names_has_one_driver(fmus: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough3", "1 ms"), "b": ("feedthrough3", "1 ms")}
    wires = ["a.Float64_out -> b.Float64_in", "a.Float64_out -> b.phi"]
    with pytest.raises(InputError, match=r"input b\.Float64_in is driven twice"):
        read_system(tmp_path, fmus, parts, wires)
    with pytest.raises(InputError, match=r"input b\.Float64_in is driven by .* and has a value too"):
        read_system(tmp_path, fmus, parts | {"b": ("feedthrough3", "1 ms", {"=phi": 1.0})}, wires[:1])


@pytest.mark.parametrize("interpreted", [False, True])
def test_values_are_set_by_other_names_and_not_put_back_to_the_start(
    interpreted: bool, fmus: Path, tmp_path: Path
) -> None:
    values = {"=phi": 0.25, "=row": [8, 7, 6, 5, 4, 3, 2, 1], "=words": ["x", "y"]}
    run = run_of(tmp_path, fmus, {"a": ("feedthrough3", "1 ms", values)}, stop="5 ms", interpreted=interpreted)
    assert last(run, "a.Float64_out") == 0.25 and last(run, "a.a_out[1]") == 8.0
    assert Result(run)["a.t_out[2]"].values[-1] == "y"


def test_two_values_of_one_variable_are_an_error(fmus: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a\.Float64_in has a value already; a\.phi is the same variable"):
        read_system(tmp_path, fmus, {"a": ("feedthrough3", "1 ms", {"=Float64_in": 1.0, "=phi": 2.0})})
    system = read_system(tmp_path, fmus, {"a": ("feedthrough3", "1 ms", free())})
    with pytest.raises(InputError, match=r"--set: a\.Float64_in and a\.phi are one variable"):
        system.with_values({"a.Float64_in": 1.0, "a.phi": 2.0}, "--set")
    assert system.with_values({"a.phi": "90 deg"}, "--set").components["a"].inputs["Float64_in"] == pytest.approx(
        1.5707963267948966
    )


def test_other_names_of_inputs_and_parameters_are_recorded_by_these_names(fmus: Path, tmp_path: Path) -> None:
    run = run_of(tmp_path, fmus, {"a": ("feedthrough3", "1 ms", free())}, stop="2 ms", record=["a.phi", "a.when"])
    assert last(run, "a.phi") == 0.1 and last(run, "a.when") == 1e9
    usual = plan_of(tmp_path, fmus, {"a": ("feedthrough3", "1 ms", free())}, stop="2 ms")
    assert not {"phi", "when"} & {name for group in usual.groups for _, name in group.columns}


def test_a_session_reads_and_sets_by_other_names(fmus: Path, tmp_path: Path) -> None:
    with Session(plan_of(tmp_path, fmus, {"a": ("feedthrough3", "1 ms", free())}, stop="5 ms")) as session:
        session.set("a.phi", 3.0)
        session.set("a.row", [1.0] * 8)
        session.advance(cycles=1)
        assert session.get("a.phi out") == 3.0 and session.get("a.row out") == [1.0] * 8
        assert session.get("a.row[2]") == 1.0


def test_what_depends_on_a_variable_depends_on_it_by_every_name(fmus: Path) -> None:
    fmu = Fmu.open(fmus / "feedthrough3.fmu")
    found = fmu.feedthrough()
    assert found["phi out"] == found["Float64_out"] == {"Float64_in"}
    assert "phi" not in fmu.names("input") and "phi" in fmu.names("input", aliases=True)


def test_contents_tell_of_which_variable_a_name_is_and_its_own_display_unit(fmus: Path) -> None:
    found = {v["name"]: v for v in contents_of(Fmu.open(fmus / "feedthrough3.fmu"))["variables"]}
    assert found["phi"] | {"alias": "Float64_in", "displayUnit": "deg", "unit": "rad"} == found["phi"]
    assert found["phi"]["description"] == "the angle"
    assert "displayUnit" not in found["Float64_in"] and "alias" not in found["Float64_in"]


def test_recorded_signals_of_both_names_are_the_same(fmus: Path, tmp_path: Path) -> None:
    ramp = {"time": [0.0, 1.0], "values": [0.0, 1.0]}
    run = run_of(tmp_path, fmus, {"a": ("feedthrough3", "1 ms", free(**{"=Float64_in": ramp}))}, stop="5 ms")
    assert (column(run, "a.phi out")[1] == column(run, "a.Float64_out")[1]).all()
    assert len(set(column(run, "a.phi out")[1])) > 3
