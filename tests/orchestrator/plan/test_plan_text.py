"""The plan as a user reads it: values are followed by name, and loops at time 0 show how well they are solved."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from helpers import edited, plan_of, run_of, system_text
from native_build import needs_gcc
from rovbrush.orchestrator.cli import main as cli
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.run.start.initialize import loop_residuals
from rovbrush.orchestrator.studies.bench.fmus.native import feedthrough

GAINS = {name: ("gain", "1 ms", {"k": k, "offset": 1.0}) for name, k in (("a", -2.5), ("b", 0.5))}
LOOP = ["a.y -> b.u", "b.y -> a.u"]


def planned(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    monkeypatch.setattr("sys.argv", ["rovbrush", "plan", *map(str, arguments)])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    return int(stop.value.code or 0)


def test_plan_prints_the_residual_of_every_algebraic_loop(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "loop.toml"
    path.write_text(system_text(GAINS, LOOP))
    assert planned(monkeypatch, path, "--fmus", fmus) == 0
    found = re.search(r"at time 0, loop b\.u, a\.u: residual (\S+), relative to the inputs", capsys.readouterr().out)
    assert found is not None and float(found[1]) <= 1e-9


def test_plan_of_a_loop_without_solution_is_printed_and_then_fails(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "loop.toml"
    path.write_text(system_text({name: ("gain", "1 ms", {"k": 1.0, "offset": 1.0}) for name in "ab"}, LOOP))
    assert planned(monkeypatch, path, "--fmus", fmus) == 1
    printed = capsys.readouterr()
    assert "loop b.u, a.u (solved as a whole)" in printed.out and "has no solution" in printed.err


def test_without_a_loop_no_fmu_is_loaded(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plan = plan_of(tmp_path, fmus, {"w": ("wave", "1 ms"), "i": ("integrator", "1 ms")}, ["w.y -> i.u"])
    monkeypatch.setattr("rovbrush.orchestrator.run.start.initialize.start", lambda _: pytest.fail("loaded"))
    assert loop_residuals(plan) == {}


def test_what_is_set_and_read_is_named(fmus: Path, tmp_path: Path) -> None:
    text = explain(plan_of(tmp_path, fmus, {"w": ("wave", "1 ms"), "i": ("integrator", "1 ms")}, ["w.y -> i.u"]))
    lines = [line[19:].split(maxsplit=1) for line in text[text.index("operations") :].splitlines()[1:]]
    wanted = [["get", "w: y, Y"], ["copy", "i.u = w.y"], ["set", "i: u"], ["get", "i: x, held, impulse"]]
    assert [line for line in lines if line in wanted] == wanted
    assert text.startswith("system case\n")


@needs_gcc
def test_an_fmu_that_needs_its_tool_says_so_before_it_is_loaded(tmp_path: Path) -> None:
    tool = {"<CoSimulation": '<CoSimulation needsExecutionTool="true"'}
    fmu = edited(feedthrough(tmp_path / "plain.fmu"), tmp_path / "tool.fmu", {}, tool)
    text = explain(plan_of(tmp_path, tmp_path, {"a": (str(fmu), "1 ms", {"=u": 1.0})}))
    assert "; needs its tool on this machine" in text


@needs_gcc
def test_of_many_variables_the_first_are_named(tmp_path: Path) -> None:
    fmu = str(feedthrough(tmp_path / "many.fmu", 8))
    text = explain(plan_of(tmp_path, tmp_path, {"a": (fmu, "1 ms"), "b": (fmu, "1 ms")}, LOOP))
    assert "set         b: u[1], u[2], u[3], u[4], u[5] and 3 more" in text


def test_turns_are_counted_only_where_an_angle_is_given(fmus: Path, tmp_path: Path) -> None:
    case = ({"w": ("wave", "1 ms", {"c1": 50.0})}, [])
    assert "window_turns" not in summarize(run_of(tmp_path, fmus, *case))
    turning = run_of(tmp_path, fmus, *case, summary={"window": {"angle": "w.Y", "start": 0.1}})
    assert summarize(turning)["window_turns"] == 3  # from 0.25 to 25 rad


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "iterated"])
def test_one_of_anything_is_told_in_the_singular(algorithm: str, fmus: Path, tmp_path: Path) -> None:
    parts = {"w": ("wave", "1 ms"), "i": ("integrator", "1 ms")}
    chosen = {"algorithm": algorithm, "record": ["i.x"]}
    text = explain(plan_of(tmp_path, fmus, parts, ["w.y -> i.u"], **chosen))
    assert re.search(r"\b1 (signal|unknown)\b", text)
    assert not re.search(r"\b1 (signals|rows|unknowns|tables|components)\b", text), text
