"""An FMU alone is a system: its own experiment, its own names."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest
from cells_fmu import cells, scalar
from helpers import rovbrush
from native_build import needs_gcc
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep
from rovbrush.orchestrator.system.assemble import assemble, assemble_request
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.request import Request, changes_of

pytestmark = needs_gcc
VARIABLES = [
    scalar("u", 0, "input", start="0.5", unit="m"), scalar("a.b", 4, "parameter", start="1", unit="mm"),
    scalar("y", 100), scalar("x", 10, "local"), scalar("stop", 2), scalar("tolerance", 3),
]  # fmt: skip
Make = Callable[[str], Path]


@pytest.fixture
def make(tmp_path: Path) -> Make:
    """An FMU with an experiment."""
    return lambda experiment: cells(tmp_path / "their pump.fmu", VARIABLES, experiment)


def times(system: System) -> tuple[Fraction, Fraction]:
    """Stop and period [s]."""
    return system.stop, system.components["their_pump"].period


def test_the_default_experiment_says_how_it_is_run(make: Make) -> None:
    fmu = make('startTime="0" stopTime="0.3" stepSize="0.1" tolerance="1e-5"')
    system = assemble(str(fmu))
    assert times(system) == (Fraction(3, 10), Fraction(1, 10)) and not system.components["their_pump"].notes
    result = load(fmu).run()
    assert result["their_pump.y"].values.tolist() == [100.5] * 4
    assert result["their_pump.stop"][0] == 0.3 and result["their_pump.tolerance"][0] == 1e-5


@pytest.mark.parametrize(
    ("experiment", "stop", "step", "words"),
    [
        ("", 1, Fraction(1, 500), ["states no stop time", "states no step"]),
        ('stopTime="10"', 10, Fraction(1, 50), ["states no step"]),
        ('stopTime="10" stepSize="0.333333333"', 10, Fraction(1, 3), []),
        ('stopTime="1" stepSize="0.3"', 1, Fraction(3, 10), []),
        ('stopTime="1" stepSize="2"', 1, Fraction(1, 500), ["no step below its stop"]),
        ('startTime="1" stopTime="2" stepSize="0.5"', 2, Fraction(1, 2), ["begins at 1 s"]),
        ('startTime="3" stopTime="2" stepSize="0.5"', 4, Fraction(1, 2), ["would stop at 2 s, before it starts,"]),
        ('startTime="0" stopTime="-1" stepSize="0"', 1, Fraction(1, 500), ["no stop time", "no step"]),
    ],
)
def test_what_an_experiment_leaves_open_is_chosen_and_told(
    experiment: str, stop: Fraction, step: Fraction, words: list[str], make: Make
) -> None:
    system = assemble(str(make(experiment)))
    assert times(system) == (stop, step)
    notes = " ".join(system.components["their_pump"].notes)
    assert all(word in notes for word in words) and bool(notes) == bool(words)


def test_options_come_before_the_experiment(make: Make) -> None:
    fmu = make('stopTime="10" stepSize="0.5"')
    for period in ("1 ms", "their_pump=1 ms"):
        system = assemble_request(Request(str(fmu), period=(period,), stop="20 ms"))
        assert times(system) == (Fraction(1, 50), Fraction(1, 1000)) and not system.components["their_pump"].notes


def test_its_variables_need_no_prefix(make: Make, tmp_path: Path) -> None:
    fmu, table = make('stopTime="1" stepSize="0.5"'), tmp_path / "in.csv"
    table.write_text("time,u [mm]\n0,1000\n1,1000\n")
    request = Request(str(fmu), set_=("a.b=2 cm",), record=("y", "x"), input_=(str(table),))
    system = assemble_request(request)
    component = system.components["their_pump"]
    assert component.parameters == {"a.b": 20.0} and list(component.series) == ["u"]
    assert set(system.record) == {"their_pump.y", "their_pump.x"}
    assert load(fmu).set("u", 2).run()["their_pump.y"][-1] == 102.0
    with pytest.raises(
        InputError, match=r"u2: write their_pump\.variable=value; there are their_pump\.a\.b, their_pump\.u"
    ):
        assemble(str(fmu), {"u2": 1.0})


def test_of_an_fmu_without_outputs_all_locals_are_recorded(tmp_path: Path) -> None:
    fmu = cells(tmp_path / "mute.fmu", [scalar("u", 0, "input", start="1"), *(
        scalar(f"v[{k}].x y", 100 + k, "local") for k in range(3))])  # fmt: skip
    result = load(fmu, stop="4 ms").run()
    assert {name: result[name].values[-1] for name in result.dataset.data_vars} == {
        f"mute.v[{k}].x y": 101.0 + k for k in range(3)
    }


def test_nor_do_they_by_hand(make: Make) -> None:
    with load(make("")).start() as session:
        assert session.get("u") == session.get("their_pump.u") == 0.5
        session.set("u", 1.5)
        session.step()
        assert session.get("u") == session.get("their_pump.u") == 1.5
        assert session.get("a.b") == session.get("their_pump.a.b")
        with pytest.raises(InputError, match="no component 'w'"):
            session.get("w.y")


@pytest.mark.parametrize("period", ["1 ms", "their_pump=1 ms"])
def test_nor_does_it_in_the_options_of_studies(period: str, make: Make, tmp_path: Path) -> None:
    fmu, changes = make('stopTime="10" stepSize="0.5"'), changes_of([], [], [period])
    assert times(assemble(str(fmu), {}, "20 ms", None, changes)) == (Fraction(1, 50), Fraction(1, 1000))
    result = sweep(str(fmu), tmp_path, Options(["u=1,2"], {"a.b": "2"}, "4 ms", workers=1, changes=changes))
    assert result.require_all()["y_last"].values.tolist() == [101.0, 102.0]


def test_another_fmu_in_its_place_needs_no_name_of_a_component(make: Make, tmp_path: Path) -> None:
    other = cells(tmp_path / "other.fmu", [*VARIABLES[:2], scalar("y", 100), *VARIABLES[3:]])
    system = assemble(str(make("")), changes=changes_of([str(other)], [], []))
    assert "other.fmu in place of their pump.fmu" in " ".join(system.components["their_pump"].notes)


def test_two_periods_of_one_fmu_are_an_error(make: Make) -> None:
    with pytest.raises(InputError, match="--period 2 ms: their_pump has 1 ms already"):
        assemble(str(make("")), changes=changes_of([], [], ["1 ms", "their_pump=2 ms"]))


def test_an_input_that_it_has_not_is_named_with_the_nearest(make: Make, tmp_path: Path) -> None:
    (tmp_path / "in.csv").write_text("time,uu\n0,1\n1,2\n")
    with pytest.raises(InputError, match=r"'uu' is no input; (there are|did you mean) '?their_pump\.u"):
        assemble(str(make("")), inputs=(tmp_path / "in.csv",))


def test_nor_do_its_results(make: Make, tmp_path: Path) -> None:
    result = load(make("")).run()
    result.save(tmp_path / "out")
    for found in (result, Result.open(tmp_path / "out")):
        assert found["y"].equals(found["their_pump.y"])
        with pytest.raises(InputError, match="no recorded signal 'yy'; there are their_pump"):
            found["yy"]


@pytest.mark.parametrize(
    ("attributes", "value"),
    [({}, 0.0), ({"min": "2"}, 2.0), ({"max": "-3", "min": "-5"}, -3.0), ({"min": "-1", "max": "1"}, 0.0)],
)
def test_an_input_without_start_value_is_told_and_can_be_given(
    attributes: dict[str, str], value: float, tmp_path: Path
) -> None:
    fmu = cells(tmp_path / "f.fmu", [scalar("u", 0, "input", **attributes), scalar("y", 100)], 'stopTime="1"')
    notes = " ".join(assemble(str(fmu)).components["f"].notes)
    assert f"states no start value of inputs: u = {value:g}" in notes and "--set" in notes
    assert load(fmu).run()["y"].values[-1] == 100 + value
    assert (
        load(fmu).set("u", value - 0.5 if value < 0 else value + 0.5).run()["y"].values[-1]
        == (99.5 if value < 0 else 100.5) + value
    )
    table = tmp_path / "in.csv"
    table.write_text(f"time,u\n0,{value}\n1,{value}\n")
    assert load(fmu).run(inputs=table)["y"].values[-1] == 100 + value


@pytest.mark.parametrize(("option", "value"), [("--set", "a.u=2"), ("--input", "in.csv")])
def test_so_can_one_of_a_system_where_it_is_an_error_otherwise(
    option: str, value: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    fmu = cells(tmp_path / "f.fmu", [scalar("u", 0, "input"), scalar("y", 100)], "")
    case = tmp_path / "case.toml"
    case.write_text(f'stop_time = "1 s"\n[components.a]\nfmu = "{fmu}"\nperiod = "0.1 s"\n')
    (tmp_path / "in.csv").write_text("time,a.u\n0,2\n1,2\n")
    with pytest.raises(InputError, match=r"input a\.u has no driver, .*\(case\.toml, \[components\.a\]\)"):
        assemble(str(case))
    assert rovbrush(monkeypatch, "run", case, option, value, "--out", tmp_path / "o") == 0
    assert Result.open(tmp_path / "o")["a.y"].values[-1] == 102.0
