"""A shorter last step in pieces, by hand, from a checkpoint, on disk and as a recording: the same bits."""

from __future__ import annotations

from pathlib import Path

import pytest
from car_runs import ALGORITHMS, WIRES, car
from helpers import rovbrush, system_text
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import RunError
from rovbrush.orchestrator.exchange.recordings.replay import replay
from rovbrush.orchestrator.loop import cells
from rovbrush.orchestrator.results.files.netcdf import write_netcdf
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.recording import recorder
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate


@pytest.mark.sampled(3)
@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_a_run_in_pieces_and_by_hand_is_that_in_one(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, algorithm, "301 ms")
    whole = simulate(plan)
    with Session(plan) as session:
        session.advance(cycles=3)
        session.advance(until_tick=plan.clock.stop // 2)
        write_checkpoint(session, tmp_path)
        session.advance()
        assert session.tick == plan.clock.stop and session.time == 0.301
        assert [t.tobytes() for t in session.run().tables] == [t.tobytes() for t in whole.tables]
    with Session(plan) as session:
        read_checkpoint(tmp_path).restore(session)
        session.advance()
        assert [t.tobytes() for t in session.run().tables] == [t.tobytes() for t in whole.tables]
    with load(tmp_path / "case.toml", fmus=fmus).start() as stepping:
        while stepping.time < stepping.stop:
            stepping.step()
        assert stepping.time == 0.301
        assert [t.tobytes() for t in stepping.result().run.tables] == [t.tobytes() for t in whole.tables]
        with pytest.raises(RunError, match="no whole step before the stop"):
            stepping.step()


def test_a_step_of_a_stated_length_is_never_a_shorter_one(tmp_path: Path, fmus: Path) -> None:
    car(tmp_path, fmus, "jacobi", "10 ms")
    with load(tmp_path / "case.toml", fmus=fmus).start() as stepping:
        stepping.step("9 ms")
        with pytest.raises(RunError, match="no whole step before the stop"):
            stepping.step("3 ms")
        stepping.step()
        assert stepping.time == 0.01
    seen: list[float] = []
    load(tmp_path / "case.toml", fmus=fmus).run(observe=lambda time, _: seen.append(time), every="6 ms")
    assert seen == [0.0, 0.006, 0.01]


@pytest.mark.parametrize("algorithm", ["jacobi", "iterated", "iterated to the end"])
def test_ctrl_c_within_the_last_steps_goes_on_bitwise(
    algorithm: str, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from rovbrush.orchestrator.loop import run as loop_run
    from rovbrush.orchestrator.loop import turns

    plan = car(tmp_path, fmus, algorithm, "11 ms")
    with Session(plan, interpreted=True) as session:
        session.advance(cycles=3)

        def step(*arguments: float) -> int:
            session.control[cells.STOP_REQUEST] = 1
            return original(*arguments)

        original = loop_run.step
        monkeypatch.setattr(loop_run, "step", step)
        monkeypatch.setattr(turns, "step", step)
        session.advance()
        monkeypatch.undo()
        assert "interrupted" in session.failure and session.at.operation > 0 and session.at.cycle == 3
        write_checkpoint(session, tmp_path)
    with Session(plan) as session:
        read_checkpoint(tmp_path).restore(session)
        session.advance()
        assert [t.tobytes() for t in session.run().tables] == [t.tobytes() for t in simulate(plan).tables]


def test_rows_on_disk_are_those_in_memory(tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plan = car(tmp_path, fmus, "gauss-seidel", "301 ms")
    whole = simulate(plan)
    write_netcdf(whole, tmp_path / "a.nc")
    monkeypatch.setattr(recorder, "IN_MEMORY", 0)
    monkeypatch.setattr(recorder, "PIECE", 2000)
    with Session(plan, file=tmp_path / "rows.nc") as session:
        session.advance()
        streamed = session.run()
        assert [t.tobytes() for t in streamed.tables] == [t.tobytes() for t in whole.tables]
        assert [t.tolist() for t in streamed.ticks] == [t.tolist() for t in whole.ticks]
        times = [Signals(streamed)[name].time[-1] for name in ("w.F", "c.z_c")]
    assert times == [0.301, 0.301]


@pytest.mark.parametrize("transfer", ["", " (linear)"], ids=["held", "linear"])
def test_a_recording_has_the_shorter_step_and_replays(
    transfer: str, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "case.toml").write_text(
        system_text(
            {"w": ("wheel", "2 ms"), "c": ("chassis", "5 ms")}, [f"{WIRES[0]}{transfer}", WIRES[1]], stop="301 ms"
        )
    )
    out = tmp_path / "out"
    arguments = ("run", tmp_path / "case.toml", "--fmus", fmus, "--out", out, "--record-boundary", "c")
    assert rovbrush(monkeypatch, *arguments) == 0
    assert {v.text for v in replay(fmus / "chassis.fmu", out, rtol=0.0).require_within()} == {"equal"}
