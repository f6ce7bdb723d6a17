"""A run that begins at another time than 0: every FMU, table and row sees the times of the run, exactly."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from car_runs import ALGORITHMS, car
from helpers import Part, plan_of, rovbrush, system_text
from native_build import moody, needs_gcc
from rovbrush.orchestrator import Model, load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.recordings.replay import replay
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.write import write_ssp

TELLS = {  # x: the communication point of the last step; y: the start that was set up
    "ON_SETUP": "m->k = start; m->x = start",
    "ON_STEP": "if (t + h > m->promised) return fmi2Error; m->x = t; m->y = m->k; return fmi2OK",
}
LINE: dict[str, Part] = {"w": ("wave", "10 ms", {"c1": 1.0}), "i": ("integrator", "20 ms")}


Command = Callable[..., tuple[int, str]]


@pytest.fixture
def command(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    """A command of `rovbrush`: its exit code, and what it says."""

    def call(*arguments: object) -> tuple[int, str]:
        code = rovbrush(monkeypatch, *arguments)
        return code, " ".join("".join(capsys.readouterr()).split())

    return call


def times_of(run: Run, name: str) -> np.ndarray:
    return Signals(run)[name].time


@pytest.mark.sampled(4)
@needs_gcc
@pytest.mark.parametrize("isolation", ["none", "process"])
@pytest.mark.parametrize(
    ("start", "period", "steps"),
    [("2 s", "0.1 s", 10), ("-1/3 s", "1/60 s", 30), ("-5 ms", "1 ms", 10), ("1e6 s", "1/60 s", 60)],
)
def test_what_an_fmu_is_told_is_the_double_nearest_to_start_plus_k_steps(
    start: str, period: str, steps: int, isolation: str, tmp_path: Path
) -> None:
    moody(tmp_path / "m.fmu", **TELLS)
    begin, h = (Fraction(text.removesuffix(" s").removesuffix(" ms")) / (1000 if "ms" in text else 1)
                for text in (start, period))  # fmt: skip
    stop = f"{begin + steps * h} s"
    parts: dict[str, Part] = {"m": ("m", period, {"=u": 1.0})}
    plan = plan_of(tmp_path, tmp_path, parts, stop=stop, start_time=start, of={"m": {"isolation": isolation}})
    exact = [float(begin + k * h) for k in range(steps + 1)]
    for interpreted in (False, True):
        run = simulate(plan, interpreted)
        assert not run.failure and run.end == exact[-1]
        assert times_of(run, "m.x").tolist() == exact
        assert Signals(run)["m.x"].values[1:].tolist() == exact[:-1]
        assert set(Signals(run)["m.y"].values[1:].tolist()) == {exact[0]}


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("start", ["2 s", "-0.75 s"])
def test_what_does_not_depend_on_time_is_the_same_from_any_start(
    start: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    """Energies, means, steps that vary: nothing but the time axis moves, and the last step by its rounding."""
    plan = car(tmp_path, fmus, algorithm)
    begin = Fraction(start.split()[0])
    moved = make_plan(replace(plan.system, start=begin, stop=plan.system.stop + begin))
    there, here = simulate(moved), simulate(plan)
    assert not there.failure and there.end == float(begin + plan.system.stop)
    for moved_table, table in zip(there.tables, here.tables, strict=True):
        assert moved_table[:-3].tobytes() == table[:-3].tobytes()  # of a last step that is iterated: its three rows
        assert moved_table[-3:] == pytest.approx(table[-3:], rel=1e-9, abs=1e-12)
    for name in Signals(here).places:
        exact = times_of(here, name) + float(begin)
        assert np.max(np.abs(times_of(there, name) - exact)) <= 1e-15 * 4
    own = ("wall_s", "real_time_factor", "start_s", "peak_memory_MB")
    moving = ("window_s", "simulated_s")  # differences of doubles
    a, b = ({k: v for k, v in summarize(run).items() if k not in (*own, *moving)} for run in (there, here))
    assert a.keys() == b.keys() and summarize(there)["simulated_s"] == pytest.approx(here.end, rel=1e-15)


@pytest.mark.parametrize("interpreted", [False, True])
def test_outputs_at_the_start_are_those_of_that_time(interpreted: bool, tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(tmp_path, fmus, LINE, ["w.y -> i.u"], stop="1 s", start_time="-1 s")
    signals = Signals(simulate(plan, interpreted))
    assert signals["w.y"].values[0] == -1.0
    assert signals["w.y"].values == pytest.approx(signals["w.y"].time, abs=1e-15)
    assert signals["i.x"].values[-1] == pytest.approx(0.0, abs=1e-12)  # of t from -1 to 1


def test_an_output_that_is_asked_for_before_any_step_is_that_of_the_start(tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(tmp_path, fmus, {"w": LINE["w"]}, stop="3 s", start_time="2 s")
    with Session(plan) as session:
        assert session.get("w.y") == 2.0 and session.time == 2.0 and session.tick == 0


def test_rows_windows_and_figures_are_of_the_times_of_the_run(command: Command, tmp_path: Path, fmus: Path) -> None:
    text = system_text(LINE, ["w.y -> i.u"], stop="4 s", start_time="2 s")
    (tmp_path / "case.toml").write_text(
        text + '\n[summary]\nwindow = { start = 3.0 }\ny_mean = "mean w.y"\nabove = "positive w.y"\n'
        '[[figures]]\nfile = "y.png"\ntitle = "y"\nsignals = ["w.y"]\n'
    )
    code, text = command("run", str(tmp_path / "case.toml"), "--fmus", str(fmus), "--out", str(tmp_path / "out"))
    assert code == 0, text
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["window_s"] == [3.0, 4.0] and summary["y_mean"] == pytest.approx(3.5) and summary["steady"]
    assert summary["simulated_s"] == 2.0 and summary["macro_steps"] == 200
    assert summary["above"] == pytest.approx(2.0)
    assert json.loads((tmp_path / "out" / "manifest.json").read_text())["start_time_s"] == 2.0
    lines = (tmp_path / "out" / "result.csv").read_text().splitlines()
    assert lines[1].split(",")[0] == "2.0" and lines[-1].split(",")[0] == "4.0"
    assert "start 2 s, stop 4 s" in (tmp_path / "out" / "plan.txt").read_text()


def test_a_run_that_ends_before_its_window_takes_its_second_half(tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(tmp_path, fmus, LINE, stop="4 s", start_time="2 s", summary={"window": {"start": 5.0}})
    assert summarize(simulate(plan))["window_s"] == [3.0, 4.0]


@pytest.mark.parametrize("interpreted", [False, True])
def test_tables_are_read_at_the_times_of_the_run(interpreted: bool, tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(
        tmp_path, fmus, {"i": ("integrator", "0.25 s")}, stop="0.5 s", start_time="-1 s",
        of={"i": {"inputs": {"u": {"time": [-2.0, 0.0, 1.0], "values": [-2.0, 0.0, 1.0]}}}},
    )  # fmt: skip
    assert simulate(plan, interpreted).tables[0][:, -1].tolist() == [-1.0, -0.875, -0.625, -0.375, -0.125, 0.125, 0.375]


@pytest.mark.parametrize(
    ("start", "stop", "words"),
    [
        ("-1 s", "1 s", r"holds 0 s to 2 s, the run goes from -1 s to 1 s; add rows, or start at \"0 s\""),
        ("1 s", "3 s", r"holds 0 s to 2 s, the run goes from 1 s to 3 s; add rows, or stop at \"2 s\""),
        ("-2 s", "-1 s", r"the run goes from -2 s to -1 s; add rows$"),
    ],
)
def test_a_table_must_reach_from_the_start_to_the_stop(
    start: str, stop: str, words: str, tmp_path: Path, fmus: Path
) -> None:
    of = {"i": {"inputs": {"u": {"time": [0.0, 2.0], "values": [0.0, 1.0]}}}}
    with pytest.raises(InputError, match=words):
        plan_of(tmp_path, fmus, {"i": ("integrator", "0.25 s")}, stop=stop, start_time=start, of=of)


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_a_run_goes_on_from_a_checkpoint_at_any_time(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    system = car(tmp_path, fmus, algorithm).system
    plan = make_plan(replace(system, start=Fraction(-1), stop=system.stop - 1))
    with Session(plan) as session:
        session.advance(cycles=7)
        write_checkpoint(session, tmp_path)
    with Session(plan) as session:
        read_checkpoint(tmp_path).restore(session)
        session.advance()
        run = session.run()
    assert [t.tobytes() for t in run.tables] == [t.tobytes() for t in simulate(plan).tables]
    other = make_plan(replace(system, start=Fraction(0)))
    with Session(other) as session, pytest.raises(InputError, match=r"another (start|tick|stop) now"):
        read_checkpoint(tmp_path).restore(session)


def model(tmp_path: Path, fmus: Path) -> Model:
    (tmp_path / "case.toml").write_text(system_text(LINE, ["w.y -> i.u"], stop="1 s"))
    return load(tmp_path / "case.toml", fmus=fmus)


def test_python_begins_a_run_and_steps_by_hand_at_another_time(tmp_path: Path, fmus: Path) -> None:
    base = model(tmp_path, fmus)
    whole = base.run(start="-0.5 s", stop=0.0)
    assert whole["w.y"].values == pytest.approx(whole["w.y"]["time"].values, abs=1e-15)
    assert (float(whole["w.y"][0]), float(whole["w.y"][-1])) == (-0.5, 0.0)
    seen: list[float] = []
    base.run(start=0.5, observe=lambda time, _: seen.append(time), every="0.1 s")
    assert seen == [0.5, 0.6, 0.7, 0.8, 0.9, 1.0]
    with load(tmp_path / "case.toml", fmus=fmus, start="2 s", stop="3 s").start() as session:
        assert (session.time, session.stop, session.period) == (2.0, 3.0, 0.02)
        while session.time < session.stop:
            session.step()
        assert session.time == 3.0 and session.get("w.y") == 3.0
    assert "2 s to 3 s" in repr(base.over("2 s", "3 s"))


def test_ssp_keeps_start_and_stop(tmp_path: Path, fmus: Path) -> None:
    for start, stop in (("2", "3"), ("-1/3", "2/3"), ("0", "1")):
        system = replace(model(tmp_path, fmus).system, start=Fraction(start), stop=Fraction(stop))
        again = load_system(str(write_ssp(system, tmp_path / "case.ssp")))
        assert (again.start, again.stop) == (system.start, system.stop)
    assert load(tmp_path / "case.ssp", start="0.5 s").system.start == Fraction(1, 2)


def test_a_recording_begins_where_the_run_did(command: Command, tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "case.toml").write_text(system_text(LINE, ["w.y -> i.u"], stop="1 s"))
    out = tmp_path / "out"
    args = ("--start", "-0.3 s", "--stop", "0.5 s", "--fmus", str(fmus), "--record-boundary", "w")
    code, text = command("run", str(tmp_path / "case.toml"), *args, "--out", str(out))
    assert code == 0, text
    assert (out / "w_ref.opt").read_text().startswith("StartTime, -0.3\nStopTime, 0.5\n")
    assert {v.text for v in replay(fmus / "wave.fmu", out, rtol=0.0).require_within()} == {"equal"}


@pytest.mark.evidence
def test_studies_begin_where_they_are_told(command: Command, tmp_path: Path, fmus: Path) -> None:
    summary = '\n[summary]\ny_mean = "mean w.y"\n'
    (tmp_path / "case.toml").write_text(system_text(LINE, ["w.y -> i.u"], stop="1 s") + summary)
    times = ("--start", "2 s", "--stop", "3 s", "--fmus", str(fmus))
    code, text = command(
        "sweep", str(tmp_path / "case.toml"), "--vary", "w.c0=0,1", *times, "--out", str(tmp_path / "s")
    )
    assert code == 0, text
    rows = (tmp_path / "s" / "sweep.csv").read_text().splitlines()[1:]
    assert [float(row.split(",")[2]) for row in rows] == pytest.approx([2.5, 3.5])
    (tmp_path / "sweep.toml").write_text(
        'system = "case.toml"\nstart_time = 2\nstop_time = "3 s"\n[vary]\n"w.c0" = [0.0]\n'
    )
    code, text = command("sweep", str(tmp_path / "sweep.toml"), "--fmus", str(fmus), "--out", str(tmp_path / "t"))
    assert code == 0, text
    assert float((tmp_path / "t" / "sweep.csv").read_text().splitlines()[1].split(",")[2]) == pytest.approx(2.5)
    code, text = command("converge", str(tmp_path / "case.toml"), *times, "--out", str(tmp_path / "c"))
    assert code == 0, text
    found = json.loads((tmp_path / "c" / "convergence.json").read_text())
    assert found["rows"][0]["values"] == pytest.approx([2.5] * 3)
    code, text = command("plan", str(tmp_path / "case.toml"), *times)
    assert code == 0 and "start 2 s, stop 3 s" in text
    code, text = command("export", str(tmp_path / "case.toml"), *times, "--ssp", "--out", str(tmp_path / "x.ssp"))
    assert code == 0 and load_system(str(tmp_path / "x.ssp")).start == 2


WRONG = {
    "stop before start": (('start_time = "2 s"',), (), ["stop at 1 s is not after the start at 2 s", "toml, line 2"]),
    "stop at start": (("start_time = 1",), (), ["the stop at 1 s is not after the start at 1 s"]),
    "no time": (('start_time = "soon"',), (), ["start_time = 'soon' is not a time"]),
    "not finite": (("start_time = nan",), (), ["start_time = 'nan' is not a time"]),
    "infinite": (("start_time = -inf",), (), ["start_time = '-inf' is not a time"]),
    "no unit": (('start_time = "2 h"',), (), ["start_time = '2 h' is not a time"]),
    "another key": (('start = "2 s"',), (), ["unknown key 'start'", "did you mean 'start_time'"]),
    "option behind the stop": ((), ("--start", "1 s"), ["the stop at 1 s is not after the start at 1 s"]),
    "option no time": ((), ("--start", "now"), ["--start = 'now' is not a time"]),
    "too large to count": ((), ("--start", "-1e14 s"), ["no common tick", "keep start and stop nearer to 0"]),
    "a list": (("start_time = [1]",), (), ["start_time must be a time"]),
}  # fmt: skip


@pytest.mark.parametrize(("lines", "options", "words"), WRONG.values(), ids=WRONG.keys())
def test_a_wrong_start_is_one_error_that_says_how_to_mend_it(
    lines: tuple[str, ...], options: tuple[str, ...], words: list[str], command: Command, tmp_path: Path, fmus: Path
) -> None:
    text = "\n".join([*lines, system_text(LINE, ["w.y -> i.u"], stop="1 s")])
    (tmp_path / "case.toml").write_text(text)
    code, said = command("plan", str(tmp_path / "case.toml"), "--fmus", str(fmus), *options)
    assert code in (1, 2) and "Traceback" not in said
    assert all(word in said for word in words), said


def test_the_plan_of_a_run_from_0_says_nothing_of_a_start(tmp_path: Path, fmus: Path) -> None:
    plan: Plan = plan_of(tmp_path, fmus, LINE, stop="1 s")
    assert explain(plan).splitlines()[1].startswith("stop 1 s; tick")
