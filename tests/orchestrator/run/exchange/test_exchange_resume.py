"""A run with FMUs for Model Exchange that is taken up again: the same bits, or a word that they are not."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import exchange_build
import pytest
from native_build import answers, needs_gcc
from oscillators import CVODE, METHODS, PUSHED, RESTARTED, planned
from rovbrush.orchestrator import load
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.carry_out import carry_out
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.request import Request

pytestmark = [needs_gcc, pytest.mark.sampled(4)]
SAID = "CVODE began anew at the checkpoint at t = "


class Ends:
    """What a run is in the end: whole, with a checkpoint in its middle, and taken up there."""

    def __init__(self, plan: Plan, folder: Path) -> None:
        self.notes: dict[str, list[str]] = {}
        with Session(plan) as session:
            self.whole = self._end("whole", session)
        with Session(plan) as first:
            first.advance(until_tick=plan.clock.stop // 2)
            write_checkpoint(first, folder)
            self.forgotten = first.forgotten
            self.kept = self._end("kept", first)
        with Session(plan) as second:
            read_checkpoint(folder).restore(second)
            self.resumed = self._end("resumed", second)

    def _end(self, which: str, session: Session) -> bytes:
        session.advance()
        assert not session.failure
        self.notes[which] = session.run().notes
        return session.memory.z.tobytes()


@pytest.mark.sampled(8)
@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi", "iterated"])
@pytest.mark.parametrize("more", ["", PUSHED])
@pytest.mark.parametrize("solver", METHODS)
def test_a_run_that_goes_on_gives_the_same_bits_or_says_that_it_does_not(
    tmp_path: Path, solver: str, more: str, algorithm: str
) -> None:
    """CVODE alone has a history, and none where it begins anew anyhow: at inputs that change, in iterations."""
    ends = Ends(planned(tmp_path, solver, more=more, algorithm=algorithm), tmp_path)
    assert ends.resumed == ends.kept, "a checkpoint costs the run that goes on what it costs the one that is taken up"
    forgets = solver == CVODE and not more and algorithm != "iterated"
    assert (ends.whole == ends.resumed) is not forgets
    for which in ("kept", "resumed"):
        assert any(SAID in note for note in ends.notes[which]) is forgets
    assert not any(SAID in note for note in ends.notes["whole"])
    assert bool(ends.forgotten) is (solver == CVODE and algorithm != "iterated"), "what comes then nobody knows"


def test_what_a_run_says_of_a_lost_history_tells_when_how_often_and_what_mends_it(tmp_path: Path) -> None:
    plan = planned(tmp_path, CVODE)
    with Session(plan) as session:
        for part in (4, 2):
            session.advance(until_tick=plan.clock.stop // part)
            write_checkpoint(session, tmp_path)
        session.advance()
        (note,) = session.run().notes
    assert note.startswith("o, f: CVODE began anew at the checkpoint at t = 2")
    assert "and at 1 later checkpoint" in note and "restart = true under [solver] makes them so" in note


def test_a_model_that_proves_stiff_before_the_checkpoint_goes_on_with_cvode(tmp_path: Path) -> None:
    """Its note is not lost with the run that wrote the checkpoint."""
    path = tmp_path / "system.toml"
    text = _alone(path, 1e-6, "none").read_text() + "parameters = { mu = 1000.0 }\n"
    path.write_text(text.replace('"5 s"', '"20 s"'), encoding="utf-8")
    ends = Ends(make_plan(load_system(str(path), tmp_path)), tmp_path)
    assert ends.kept == ends.resumed
    for which in ("whole", "kept", "resumed"):
        assert any("steps were limited by stability" in note for note in ends.notes[which])


@pytest.mark.parametrize(("solver", "tells"), [(CVODE, True), (RESTARTED, False), ("", False)])
def test_ctrl_c_says_whether_the_run_goes_on_bit_by_bit(tmp_path: Path, solver: str, tells: bool) -> None:
    def press(_: float) -> None:
        signal.raise_signal(signal.SIGINT)

    plan = planned(tmp_path, solver, stop="1000 s")
    finished = carry_out(plan, tmp_path, Request(system="system.toml"), progress=press)
    assert "go on with `rovbrush run --resume" in finished.resume
    assert ("CVODE has no history then" in finished.resume) is tells


def test_the_plan_tells_where_cvode_begins_anew(tmp_path: Path) -> None:
    for algorithm, solver, words in (
        ("gauss-seidel", CVODE, "begun anew at checkpoints, so that a run with them"),
        ("gauss-seidel", RESTARTED, "begun anew at every communication point"),
        ("iterated", CVODE, "begun anew at every step, which may be taken back"),
    ):
        assert words in explain(planned(tmp_path, solver, algorithm=algorithm))
    assert "begun anew" not in explain(planned(tmp_path, ""))


@pytest.mark.sampled(2)
@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
@pytest.mark.parametrize("solver", METHODS)
def test_one_in_a_process_of_its_own_is_integrated_as_the_system_says_and_tells_the_same(
    tmp_path: Path, solver: str
) -> None:
    here = Ends(planned(tmp_path, solver), tmp_path)
    apart = Ends(planned(tmp_path, solver, more='isolation = "process"'), tmp_path)
    assert (apart.whole == apart.resumed) is (here.whole == here.resumed)
    assert apart.kept == apart.resumed
    assert bool(apart.forgotten) is bool(here.forgotten)
    assert any(note.startswith(f"o: {SAID}") for note in apart.notes["resumed"]) is (solver == CVODE)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
def test_one_in_a_process_of_its_own_keeps_the_tolerance_of_the_system(tmp_path: Path) -> None:
    path = tmp_path / "system.toml"
    exact, *found = (
        load(_alone(path, tolerance, isolation)).run()["o.x"].values[-1]
        for tolerance, isolation in ((1e-12, "none"), (1e-3, "none"), (1e-3, "process"))
    )
    assert found[0] == found[1] != exact


def _alone(path: Path, tolerance: float, isolation: str) -> Path:
    exchange_build.exchange(path.parent, "oscillator")
    path.write_text(
        f'format = 2\nstop_time = "5 s"\n[solver]\ntolerance = {tolerance}\n[components.o]\nfmu = "oscillator.fmu"\n'
        f'period = "1 s"\nisolation = "{isolation}"\n',
        encoding="utf-8",
    )
    return path


@pytest.mark.parametrize("algorithm", ["iterated", "adaptive"])
@pytest.mark.parametrize("solver", ["", CVODE])
def test_a_group_that_is_taken_back_is_as_exact_as_one_that_is_not(tmp_path: Path, solver: str, algorithm: str) -> None:
    """A mass outside on a lagged spring force inside, stepped back and forth."""
    import numpy as np
    from scipy.linalg import expm

    answers(tmp_path / "mass.fmu", "mass")
    exchange_build.exchange(tmp_path, "lag")
    more = '[adaptive]\ntolerance = 1e-6\nminimum = "10 us"\nmaximum = "10 ms"\n' if algorithm == "adaptive" else ""
    path = tmp_path / "system.toml"
    path.write_text(
        f'format = 2\nstop_time = "1 s"\nalgorithm = "{algorithm}"\n'
        f'connections = ["mass.x -> lag.push", "lag.x -> mass.F"]\n[solver]\ntolerance = 1e-8\n{solver}\n{more}'
        '[components.mass]\nfmu = "mass.fmu"\nperiod = "1 ms"\nparameters = { x0 = 1.0 }\n'
        '[components.lag]\nfmu = "lag.fmu"\nperiod = "1 ms"\nparameters = { tau = 0.1 }\n',
        encoding="utf-8",
    )
    result = load(path).run()
    exact = expm(np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [10.0, 0.0, -10.0]])) @ [1.0, 0.0, 0.0]
    assert float(result["mass.x"][-1]) == pytest.approx(exact[0], rel=5e-3)
    assert float(result["lag.x"][-1]) == pytest.approx(exact[2], rel=5e-3)
