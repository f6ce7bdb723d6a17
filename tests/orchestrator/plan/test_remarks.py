"""What a run says of its transfers: what the plan chose, what was another before, what aliases; and files' formats."""

from __future__ import annotations

import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Part, column, plan_of, read_system, rovbrush, run_of, system_text
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.plan.remarks import aliased, chosen, held_now
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.ranges import left_range
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.file.shipped import shipped_systems
from rovbrush.orchestrator.system.request import Changes
from rovbrush.orchestrator.system.ssp.write import write_ssp

RATES: dict[str, Part] = {"slow": ("integrator", "2 ms"), "fast": ("integrator", "1 ms")}
BOTH = ["slow.x -> fast.u", "fast.x -> slow.u"]


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize("version", [1, 2])
def test_a_faster_component_gets_the_held_value_whatever_the_format(
    version: int, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    parts = {"s": ("wave", "4 ms", {"c0": 1.0, "c1": 5.0}), "f": ("gain", "1 ms", {"k": 1.0})}
    keys: dict[str, Any] = {"stop": "20 ms", "algorithm": algorithm, "format": version}
    runs = [run_of(tmp_path, fmus, parts, [f"s.y -> f.u{words}"], **keys) for words in ("", " (hold)")]
    found = [column(run, "f.u")[1] for run in runs]
    assert np.array_equal(*found) and len(set(found[0])) <= 6


def test_without_a_format_a_run_names_what_is_held_now_and_the_word_for_the_former_result(
    tmp_path: Path, fmus: Path
) -> None:
    plan = plan_of(tmp_path, fmus, RATES, BOTH, format=1)
    (line,) = held_now(plan)
    assert line.startswith('"slow.x -> fast.u": held since')
    assert '"slow.x -> fast.u (linear)" gives the former result' in line
    assert line in explain(plan)
    assert not held_now(plan_of(tmp_path, fmus, RATES, BOTH))
    assert not held_now(plan_of(tmp_path, fmus, RATES, ["slow.x -> fast.u (linear)", BOTH[1]], format=1))


@pytest.mark.parametrize(
    ("parts", "wires", "former"),
    [
        (RATES, ["slow.x -> fast.u (interpolate)", "fast.x -> slow.u"], "linear"),
        (
            {**RATES, "twin": ("integrator", "2 ms")},
            ["slow.x -> fast.u (interpolate)", "slow.x -> twin.u"],
            "interpolate",
        ),
    ],
)
def test_the_word_is_that_of_the_former_choice(
    parts: dict[str, Part], wires: list[str], former: str, tmp_path: Path, fmus: Path
) -> None:
    (line,) = held_now(plan_of(tmp_path, fmus, parts, wires, format=1))
    assert f'"{wires[1]} ({former})" gives' in line
    stated = plan_of(tmp_path, fmus, parts, [wires[0], f"{wires[1]} ({former})"], format=1)
    assert not held_now(stated)


def test_arrays_are_one_line(tmp_path: Path, fmus: Path) -> None:
    system = load_system("hull_pass", fmus)
    system = replace(system, format=1, connections=tuple(replace(c, transfer="") for c in system.connections))
    lines = held_now(make_plan(system))
    assert [line.split(":")[0] for line in lines] == [
        f'"vehicle.{name} -> brush.{name}"' for name in ("delta", "delta_dot", "v_rov", "tilt_x")
    ]


def test_the_command_says_it_once_before_the_run_and_nothing_with_format_2(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for version, expected in ((1, 1), (2, 0)):
        path = tmp_path / f"case{version}.toml"
        path.write_text(system_text(RATES, BOTH, stop="4 ms", format=version), encoding="utf-8")
        assert rovbrush(monkeypatch, "run", path, "--fmus", fmus, "--out", tmp_path / f"out{version}") == 0
        said = "".join(capsys.readouterr().out.split())  # whatever the width of the terminal
        assert said.count("givestheformerresult") == expected
        assert f"betweenratestheplanchose1mean,1heldvalue:`rovbrushplan{path}`showseach" in said


def test_one_line_counts_what_the_plan_chose_between_rates(tmp_path: Path, fmus: Path) -> None:
    parts = {**RATES, "twin": ("integrator", "1 ms")}
    plan = plan_of(tmp_path, fmus, parts, ["slow.x -> fast.u", "fast.x -> slow.u", "fast.x -> twin.u"])
    assert chosen(plan) == "between rates the plan chose 1 mean, 1 held value"
    assert chosen(plan_of(tmp_path, fmus, parts, ["slow.x -> fast.u (hold)", "fast.x -> slow.u (mean)"])) == ""


@pytest.mark.parametrize("text", ["3", "0", '"2"', "2.0", "true", "[2]"])
def test_an_unknown_format_is_one_clear_error(text: str, tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(f"format = {text}\nstop_time = 3\nnew_key = 1\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"format = .* is unknown: this version of rovbrush reads 1 and 2.*line 1"):
        load_system(str(path), fmus)


def test_unknown_names_under_record_are_warnings_without_a_format_and_errors_with_it(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    record = ["fast.x", "fast.xx", "nobody.*"]
    with pytest.raises(InputError, match=r"record = \['fast.xx'\]: no variable is called so"):
        read_system(tmp_path, fmus, RATES, BOTH, record=record)
    system = read_system(tmp_path, fmus, RATES, BOTH, record=record, format=1)
    assert system.record == ("fast.x",)
    assert [line.split(":")[:2] for line in system.remarks] == [
        ["warning", " record = ['fast.xx']"], ["warning", " record = ['nobody.*']"]
    ]  # fmt: skip
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "run", tmp_path / "case.toml", "--fmus", fmus, "--stop", "4 ms", "--out", out) == 0
    assert "".join(capsys.readouterr().out.split()).count("withformat=2itisanerror") == 2


@pytest.mark.parametrize("version", [1, 2])
def test_what_is_written_has_format_2(version: int, tmp_path: Path, fmus: Path) -> None:
    system = read_system(tmp_path, fmus, RATES, BOTH, format=version)
    again = load_system(str(write_ssp(system, tmp_path / "case.ssp")), fmus)
    assert again.format == 2 and not held_now(make_plan(again))
    assert all(load_system(name, fmus).format == 2 for name in shipped_systems())


def test_an_ssp_of_ours_from_before_gets_the_line_with_its_own_words(tmp_path: Path, fmus: Path) -> None:
    path = write_ssp(read_system(tmp_path, fmus, RATES, BOTH), tmp_path / "case.ssp")
    with zipfile.ZipFile(path) as archive:
        text = archive.read("SystemStructure.ssd").decode().replace(', "format": 2', "")
    assert '"format"' not in text
    older = tmp_path / "older.ssp"
    with zipfile.ZipFile(path) as archive, zipfile.ZipFile(older, "w") as new:
        for name in archive.namelist():
            new.writestr(name, text if name == "SystemStructure.ssd" else archive.read(name))
    (line,) = held_now(make_plan(load_system(str(older), fmus)))
    assert 'its annotation {"transfer": "linear"} gives the former result' in line


def test_a_component_that_steps_more_rarely_than_its_fmu_states_is_warned_of(fmus: Path) -> None:
    plan = make_plan(assemble("nominal", fmus=fmus, changes=Changes(periods=(("motor", "1 s"),))))
    (line,) = aliased(plan)
    assert line.startswith("warning: motor steps every 1 s, its FMU states 500 us")
    assert "aliased in brush, which steps more often" in line and line in explain(plan)


def test_no_shipped_system_aliases(fmus: Path) -> None:
    for name in shipped_systems():
        assert not aliased(make_plan(load_system(name, fmus))), name


@pytest.mark.parametrize(("words", "count"), [("", 0), (" (mean)", 0), (" (hold)", 1)])
def test_one_value_of_many_is_warned_of_and_a_mean_is_not(words: str, count: int, tmp_path: Path, fmus: Path) -> None:
    found = aliased(plan_of(tmp_path, fmus, RATES, [f"fast.x -> slow.u{words}"]))
    assert len(found) == count
    assert all("takes one of 2 values, every 2 ms" in line and "(mean) averages it" in line for line in found)


@pytest.mark.parametrize("transfer", ["linear", "quadratic", "hold", "interpolate"])
def test_an_input_that_left_the_range_of_its_source_is_named_with_both(
    transfer: str, tmp_path: Path, fmus: Path
) -> None:
    parts = {"s": ("wave", "10 ms", {"a": 1.0, "w": 50.0}), "f": ("gain", "1 ms", {"k": 1.0})}
    run = run_of(tmp_path, fmus, parts, [f"s.y -> f.u ({transfer})"], stop="200 ms")
    lines = left_range(run, Signals(run))
    u, y = column(run, "f.u")[1], column(run, "s.y")[1]
    beyond = bool(np.max(u) > np.max(y) or np.min(u) < np.min(y))
    assert beyond == (transfer in ("linear", "quadratic")) == bool(lines)
    if lines:
        assert f"f.u was extrapolated to {np.min(u):.6g} to {np.max(u):.6g}" in lines[0]
        assert f"its source s.y stayed within {np.min(y):.6g} to {np.max(y):.6g}" in lines[0]
        assert summarize(run)["left_range"] == lines
