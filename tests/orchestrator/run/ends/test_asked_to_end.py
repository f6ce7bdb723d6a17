"""An FMU that asks to end ends the run well: the last row is there, and who it was is said."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from helpers import column, python, read_system, rovbrush
from native_build import FAULTS3, FREE3, feedthrough3, moody, needs_gcc
from rovbrush.orchestrator.errors import RunError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = [needs_gcc, pytest.mark.sampled(4)]
WHOLE = "if (m->steps == 4) { m->x += h * m->u; return fmi2Discard; }"  # the fourth step, done to its end
HALF = "if (m->steps == 4) { m->x += 0.5 * h * m->u; return fmi2Discard; }"
ENDS = {"TERMINATED": "1"}
needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")


def plan(
    folder: Path, algorithm: str = "gauss-seidel", isolation: str = "none", fast: str = "1 ms", **actions: str
) -> Plan:
    """A moody `m` at 1 ms drives a well-behaved `g`."""
    moody(folder / "m.fmu", **actions)
    moody(folder / "g.fmu")
    parts = {"m": ("m.fmu", "1 ms", {"=u": 1.0}), "g": ("g.fmu", fast)}
    system = read_system(folder, folder, parts, ["m.x -> g.u"], "10 ms", algorithm=algorithm)
    text = system.path.read_text().replace("[components.m]\n", f'[components.m]\nisolation = "{isolation}"\n')
    system.path.write_text(text)
    return make_plan(load_system(str(system.path), folder))


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
@pytest.mark.parametrize("isolation", ["none", pytest.param("process", marks=needs_fork)])
def test_a_step_that_was_done_to_its_end_gives_the_last_row_of_all(
    algorithm: str, isolation: str, tmp_path: Path
) -> None:
    run = simulate(plan(tmp_path, algorithm, isolation, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS))
    assert run.failure == "" and run.ended == "component m asked to end the simulation at t = 0.004 s"
    for name in ("m.x", "g.x"):
        t, values = column(run, name)
        assert t[-1] == 0.004 and len(values) == 5
    assert column(run, "m.x")[1][-1] == pytest.approx(4e-3, rel=1e-12) and run.end == 0.004


@pytest.mark.parametrize("start", ["2 s", "-1 s", "-2 ms"])
@pytest.mark.parametrize("fast", ["1 ms", "0.5 ms"])
def test_and_so_it_does_in_a_run_that_begins_at_another_time(fast: str, start: str, tmp_path: Path) -> None:
    """The others come to the same instant, whether they step as often or more often."""
    system = plan(tmp_path, fast=fast, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS).system
    begin = Fraction(start.split()[0]) / (1000 if "ms" in start else 1)
    run = simulate(make_plan(replace(system, start=begin, stop=begin + Fraction(1, 100))))
    end = float(begin + Fraction(4, 1000))
    assert run.failure == "" and run.ended == f"component m asked to end the simulation at t = {end:.9g} s"
    assert column(run, "m.x")[0][-1] == column(run, "g.x")[0][-1] == run.end == end


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
@pytest.mark.parametrize("isolation", ["none", pytest.param("process", marks=needs_fork)])
@pytest.mark.parametrize("wires", [["g.x -> m.u"], ["g.x -> m.u", "m.x -> g.u"]], ids=["chain", "loop"])
def test_who_has_asked_to_end_is_read_but_set_no_more(
    wires: list[str], algorithm: str, isolation: str, tmp_path: Path
) -> None:
    """Its outputs answer at once to its input, which is new at the instant of its end, and it takes none any more."""
    said = {"direct": "all", "isolation": isolation}
    free = {} if len(wires) == 2 else {"=u": 1.0}
    moody(tmp_path / "m.fmu", ON_STEP=WHOLE, ON_SET="if (m->steps >= 4) return fmi2Error;", REACHED="t0 + h0", **ENDS)
    moody(tmp_path / "g.fmu")
    parts = {"m": ("m.fmu", "1 ms"), "g": ("g.fmu", "1 ms", free)}
    system = read_system(
        tmp_path, tmp_path, parts, wires, "10 ms", algorithm=algorithm, of={"m": said, "g": {"direct": "all"}}
    )
    plan = make_plan(system)
    assert "again" in explain(plan)
    run = simulate(plan)
    assert run.failure == "" and run.ended == "component m asked to end the simulation at t = 0.004 s"
    for name in ("m.x", "g.x"):
        assert column(run, name)[0].tolist() == pytest.approx([0.0, 1e-3, 2e-3, 3e-3, 4e-3])


def test_a_step_that_ended_on_its_way_leaves_the_rows_before_it(tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, ON_STEP=HALF, REACHED="0.0035", **ENDS))
    assert run.failure == "" and run.ended == "component m asked to end the simulation at t = 0.0035 s"
    assert column(run, "m.x")[0][-1] == column(run, "g.x")[0][-1] == run.end == 0.003


@pytest.mark.parametrize(("fast", "rows"), [("0.5 ms", 9), ("2 ms", 3), ("5 ms", 1)])
def test_other_rates_end_with_their_last_instant_until_then(fast: str, rows: int, tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, fast=fast, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS))
    assert not run.failure and len(column(run, "m.x")[0]) == 5 and len(column(run, "g.x")[0]) == rows


def test_a_discarded_step_is_still_a_failure_where_nobody_asks_to_end(tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, ON_STEP=WHOLE, REACHED="0.0035"))
    assert "component m returned fmi2Discard" in run.failure and not run.ended


@pytest.mark.parametrize("interpreted", [False, True])
def test_fmi_3_asks_by_terminate_simulation(interpreted: bool, tmp_path: Path) -> None:
    feedthrough3(tmp_path / "f.fmu")
    moody(tmp_path / "g.fmu")
    parts = {"f": ("f", "1 ms", {**FREE3, "fault": FAULTS3["terminate"], "bad_at": 0.003}), "g": ("g", "1 ms")}
    system = read_system(tmp_path, tmp_path, parts, ["f.Float64_out -> g.u"], "10 ms")
    run = simulate(make_plan(system), interpreted)
    assert not run.failure and run.ended.startswith("component f asked to end the simulation at t = 0.00")
    t, x = column(run, "g.x")
    assert 0.003 <= t[-1] < 0.01 and column(run, "f.Float64_out")[0][-1] == t[-1]
    assert f"t = {t[-1]:.9g} s" in run.ended
    assert x == pytest.approx(0.1 * t, abs=2e-4)


@pytest.mark.parametrize("algorithm", ["iterated", "adaptive"])
def test_where_steps_are_taken_back_the_last_row_is_the_last_that_was_accepted(algorithm: str, tmp_path: Path) -> None:
    run = simulate(plan(tmp_path, algorithm, ON_STEP="if (t > 0.0042) return fmi2Discard;", REACHED="t0 + h0", **ENDS))
    assert not run.failure and run.ended.startswith("component m asked to end")
    t, x = column(run, "m.x")
    assert 0.0 < t[-1] <= 0.0062 and run.end == t[-1] and x == pytest.approx(t, abs=1e-12)


def test_a_session_says_who_ended_it_and_goes_no_further(tmp_path: Path) -> None:
    with Stepping(plan(tmp_path, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS)) as session:
        for _ in range(4):
            session.step()
        assert session.time == 0.004 and not session.failure and "component m asked to end" in session.ended
        with pytest.raises(RunError, match="the session has ended: component m asked to end"):
            session.step()
        assert session.result().require_good().dataset["m.x"].size == 5


def test_how_a_run_is_cut_into_pieces_does_not_change_its_end(tmp_path: Path) -> None:
    whole = simulate(plan(tmp_path, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS))
    with Session(plan(tmp_path, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS)) as session:
        while not session.over:
            session.advance(cycles=1)
        pieces = session.run()
    assert all(np.array_equal(a, b) for a, b in zip(whole.tables, pieces.tables, strict=True))


@pytest.mark.parametrize("options", [[], ["--checkpoint", "2 ms"]], ids=["plain", "checkpoints"])
def test_the_command_succeeds_and_the_files_say_who_and_when(
    options: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = plan(tmp_path, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS).system.path
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "run", path, "--out", out, *options) == 0
    who = "component m asked to end the simulation at t = 0.004 s"
    assert who in capsys.readouterr().out.replace("\n", " ")
    for name in ("summary.json", "manifest.json"):
        found = json.loads((out / name).read_text())
        assert found["ended"] == who and found["complete"] is True


def test_a_run_that_is_streamed_to_disk_keeps_its_last_row(tmp_path: Path) -> None:
    code = (
        "import sys; from pathlib import Path; from rovbrush.orchestrator.run.recording import recorder;"
        "recorder.IN_MEMORY = recorder.PIECE = 64;"
        "from rovbrush.orchestrator.system.file.reader import load_system;"
        "from rovbrush.orchestrator.plan.plan import make_plan;"
        "from rovbrush.orchestrator.run.session.session import Session; p = make_plan(load_system(sys.argv[1]));"
        "s = Session(p, file=Path(sys.argv[2])); s.advance(); r = s.run();"
        "assert s.recorder.stream; r.recorded.finish(Path(sys.argv[2]), True); print(r.recorded.rows, r.ended)"
    )
    path = plan(tmp_path, ON_STEP=WHOLE, REACHED="t0 + h0", **ENDS).system.path
    done = python(code, str(path), str(tmp_path / "rows.nc"))
    assert done.stdout == "[5] component m asked to end the simulation at t = 0.004 s\n", done.stderr
