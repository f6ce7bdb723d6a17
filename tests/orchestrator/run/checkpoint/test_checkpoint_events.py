"""A run with events of FMUs that goes on from a checkpoint ends bitwise as one that was never interrupted."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import exchange_build
import pytest
from clock_build import built
from clock_cases import CASES, SCHEDULED, Case, plan_for, same
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop import cells, run
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from windows_build import clocked_for_windows, needs_wine

pytestmark = [needs_gcc, pytest.mark.sampled(4)]
ALL = CASES | SCHEDULED


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("clocks"))


def cut(plan: Plan, folder: Path, parts: int) -> Run:
    """A run that is put to disk several times and begun anew from there."""
    cycles = -(-plan.clock.stop // plan.cycle_ticks)
    for number in range(parts):
        with Session(plan) as session:
            if number:
                read_checkpoint(folder).restore(session)
            session.advance(cycles=max(cycles // parts - 1, 1))
            assert not session.failure and not session.over
            write_checkpoint(session, folder)
    with Session(plan) as session:
        read_checkpoint(folder).restore(session)
        session.advance()
        return session.run()


@pytest.mark.parametrize("name", ALL)
def test_a_run_with_events_goes_on_bit_by_bit(name: str, tmp_path: Path, fmus: Path) -> None:
    plan = plan_for(ALL[name], tmp_path, fmus)
    assert same(simulate(plan), cut(plan, tmp_path, 3))


@pytest.mark.sampled(2)
@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
@pytest.mark.parametrize("name", ["clocked control", "early returns", "countdown", "both", "partitions"])
def test_so_does_one_in_processes_of_their_own(name: str, tmp_path: Path, fmus: Path) -> None:
    plan = plan_for(ALL[name], tmp_path, fmus, isolation="process")
    assert same(simulate(plan), cut(plan, tmp_path, 2))


@pytest.mark.sampled(1)
@needs_wine
@pytest.mark.parametrize("name", ["clocked control", "partitions"])
def test_so_does_one_under_wine(name: str, tmp_path: Path, fmus: Path) -> None:
    windows = clocked_for_windows(fmus, tmp_path)
    case = ALL[name]
    parts = {
        part: (str(windows / f"{fmu}.fmu") if part in case.moved else fmu, *rest)
        for part, (fmu, *rest) in case.parts.items()
    }
    plan = plan_for(Case(parts, *case[1:]), tmp_path, fmus)
    assert same(simulate(plan), cut(plan, tmp_path, 2))


@pytest.mark.parametrize("name", ["clocked control", "early returns", "output clock", "partitions and plant"])
def test_ctrl_c_at_any_step_goes_on_bit_by_bit(
    name: str, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It may come in the middle of a cycle, and while a component is brought to an event."""
    plan = plan_for(ALL[name], tmp_path, fmus)
    whole, original = simulate(plan), run.step
    for steps in (1, 2, 5, 17, 18, 19, 20, 21, 46, 47):
        with Session(plan, interpreted=True) as session:
            done = [0]

            def step(*arguments: float, session: Session = session, last: int = steps, done: list[int] = done) -> int:
                done[0] += 1
                session.control[cells.STOP_REQUEST] = done[0] >= last
                return original(*arguments)

            monkeypatch.setattr(run, "step", step)
            session.advance()
            monkeypatch.undo()
            assert "interrupted by the user" in session.failure and session.resumable, steps
            write_checkpoint(session, tmp_path)
        with Session(plan) as session:
            read_checkpoint(tmp_path).restore(session)
            session.advance()
            assert same(whole, session.run()), steps


BALL = """
format = 2
stop_time = "2 s"
[solver]
tolerance = 1e-10
[components.ball]
fmu = "ball.fmu"
period = "10 ms"
[components.s]
fmu = "square.fmu"
period = "100 ms"
[[events]]
at = "700 ms"
set = { "ball.u" = 0.1 }
"""


@pytest.mark.parametrize("isolation", ["", 'isolation = "process"'])
def test_all_kinds_of_events_in_one_run_go_on_bit_by_bit(isolation: str, tmp_path: Path, fmus: Path) -> None:
    """A group of Model Exchange, time events of an FMU for co-simulation, and events of the system."""
    exchange_build.exchange(tmp_path, "ball")
    text = BALL.replace("square.fmu", str(fmus / "square.fmu"))
    text = text.replace("[components.s]", f"[components.s]\n{isolation}")
    (tmp_path / "system.toml").write_text(text, encoding="utf-8")
    plan = make_plan(load_system(str(tmp_path / "system.toml"), tmp_path))
    whole = simulate(plan)
    assert same(whole, cut(plan, tmp_path, 3))
    told = " ".join(row.what for row in whole.events)
    assert all(words in told for words in ("ball", "s has a time event", "event 1"))


def test_a_checkpoint_of_other_events_is_damaged(tmp_path: Path, fmus: Path) -> None:
    plan = plan_for(ALL["countdown"], tmp_path, fmus)
    with Session(plan) as session:
        session.advance(cycles=1)
        write_checkpoint(session, tmp_path)
    found = read_checkpoint(tmp_path)
    kept = found.events["of_fmus"]
    for other in ({"sent": {}}, {"sent": {"c": {"x": 1.0}}}, {"now": {"c": "x"}}, {"late": [["c"]]}, {"followed": "x"}):
        with Session(plan) as session, pytest.raises(InputError, match="is damaged"):
            replace(found, events={**found.events, "of_fmus": {**kept, **other}}).restore(session)
