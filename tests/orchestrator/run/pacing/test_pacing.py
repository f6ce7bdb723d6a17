"""A run in real time: the same bits, deadlines that do not drift, and an honest count of those that were missed.

The clock on the wall is one of ours: it moves when somebody sleeps, and by what a step is said to take.
"""

from __future__ import annotations

import ctypes
import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from car_runs import ALGORITHMS, car, same
from event_cases import planned as plan_of_mocks
from event_cases import system_of
from helpers import plan_of, rovbrush, system_text
from pressing import pressing
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.mock import MockFmu, Model, mock_fmu
from rovbrush.orchestrator.loop.operations import PACE
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.pacing import pacer, wall
from rovbrush.orchestrator.run.pacing.pace import Pace
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping

MS = 1_000_000  # ns


class Clock:
    """Stands still but when somebody sleeps, or works."""

    def __init__(self) -> None:
        self.now, self.sleeps = 5_000 * MS, list[int]()
        self.functions = wall._READ(self.read), wall._SLEEP(self.sleep)

    def read(self, _clock: int, at: int) -> int:
        seconds, parts = divmod(self.now, wall.SECOND)
        ctypes.c_int64.from_address(at).value, ctypes.c_int64.from_address(at + 8).value = seconds, parts
        return 0

    def sleep(self, _clock: int, _how: int, at: int, _left: int) -> int:
        due = ctypes.c_int64.from_address(at).value * wall.SECOND + ctypes.c_int64.from_address(at + 8).value
        self.sleeps.append(due - self.now)
        self.now = due
        return 0


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Iterator[Clock]:
    clock = Clock()
    addresses = tuple(ctypes.cast(function, ctypes.c_void_p).value for function in clock.functions)
    monkeypatch.setattr(pacer, "clock_functions", lambda: addresses)
    monkeypatch.setattr(pacer, "now", lambda: clock.now)

    def sleep(seconds: float) -> None:
        clock.now += round(seconds * wall.SECOND)

    monkeypatch.setattr(pacer.time, "sleep", sleep)
    yield clock


def worker(clock: Clock, takes: Callable[[float], float], name: str = "worker") -> MockFmu:
    """Its step takes so many ms of the clock on the wall, by its time [s]."""

    class Worker(Model):
        def step(self, time: float, length: float) -> int | None:
            clock.now += round(takes(time) * MS)
            self.values["y"] += length
            return None

    return mock_fmu(name, Worker, outputs=["y"])


def plan_with(clock: Clock, takes: Callable[[float], float], every: str = "", stop: str = "0.1") -> Plan:
    components = {"busy": (worker(clock, takes), "0.01"), "idle": (worker(clock, lambda _: 0.0), "0.005")}
    return make_plan(system_of(components, [], [], stop), every)


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("interpreted", [False, True])
def test_a_run_in_real_time_has_the_bits_of_any_other(
    algorithm: str, interpreted: bool, clock: Clock, tmp_path: Path, fmus: Path
) -> None:
    plan = car(tmp_path, fmus, algorithm, "31 ms")
    paced = make_plan(plan.system, "")
    with Session(paced, interpreted, pace=Pace()) as session:
        session.advance()
        run = session.run()
    assert same(run, simulate(plan))
    assert run.lateness is not None and run.lateness.missed == 0
    assert run.lateness.deadlines == len(clock.sleeps) > 5
    assert clock.now - 5_000 * MS == 31 * MS  # the clock on the wall is where the run is


def test_deadlines_do_not_drift_when_steps_take_their_time(clock: Clock) -> None:
    with Session(plan_with(clock, lambda _: 3.0), pace=Pace()) as session:
        session.advance()
        found = session.pacer
    assert clock.now - 5_000 * MS == 100 * MS and clock.sleeps == [7 * MS] * 10
    assert found is not None and (found.lateness().deadlines, found.lateness().missed) == (10, 0)


def test_a_missed_deadline_is_counted_with_who_needed_the_time_and_caught_up(clock: Clock) -> None:
    with Session(plan_with(clock, lambda t: 25.0 if 0.015 < t < 0.025 else 1.0), pace=Pace()) as session:
        session.advance()
        late = session.run().lateness
    assert late is not None and clock.now - 5_000 * MS == 100 * MS
    assert (late.deadlines, late.missed, late.missed_by) == (10, 2, {"busy": 2})  # at 30 ms by 15 ms, at 40 ms by 6 ms
    assert (late.worst, late.worst_at, late.worst_by) == (0.015, 0.03, "busy")
    assert {bound: count for bound, count in late.histogram.items() if count} == {1e-6: 8, 0.01: 1, 0.02: 1}
    assert late.within(0.002) == 0.8 and "warning: 2 of them were missed" in late.words()[-1]


def test_what_the_program_does_between_its_steps_counts_as_that(clock: Clock) -> None:
    with Stepping(plan_with(clock, lambda _: 1.0), pace=Pace()) as session:
        for _ in range(5):
            session.step()
            clock.now += 30 * MS
        late = session.pacer.lateness() if session.pacer else None
    assert late is not None and late.missed_by == {"between the steps": 4}


def test_policy_skip_gives_lost_time_up(clock: Clock) -> None:
    with Session(plan_with(clock, lambda t: 25.0 if t == 0.0 else 1.0), pace=Pace(policy="skip")) as session:
        session.advance()
        late = session.run().lateness
    assert late is not None and late.missed == 1
    assert clock.now - 5_000 * MS == 115 * MS


def test_policy_stop_ends_the_run_and_keeps_its_rows(clock: Clock) -> None:
    with Session(plan_with(clock, lambda t: 12.0 if t > 0.045 else 1.0), pace=Pace(policy="stop")) as session:
        session.advance()
        run = session.run()
    assert run.failure == (
        "the deadline of t = 0.06 s was missed by 2 ms (--realtime-policy stop); the most time before it was needed by "
        "busy"
    )
    assert run.end == 0.06 and [len(table) for table in run.tables] == [13, 7]


@pytest.mark.parametrize(("factor", "wall_ms"), [(10.0, 10), (0.1, 1000), (3.0, pytest.approx(100 / 3, abs=1e-6))])
def test_a_factor_is_the_speed_of_the_simulation(factor: float, wall_ms: float, clock: Clock) -> None:
    with Session(plan_with(clock, lambda _: 0.0), pace=Pace(factor)) as session:
        session.advance()
    assert (clock.now - 5_000 * MS) / MS == wall_ms  # 0.1: deadlines 100 ms apart are waited for in pieces


def test_another_speed_and_a_pause_count_from_where_the_run_is(clock: Clock) -> None:
    with Stepping(plan_with(clock, lambda _: 0.0), pace=Pace()) as session:
        assert session.pacer is not None
        session.step()
        session.pacer.factor = 2.0
        session.step()
        assert clock.now - 5_000 * MS == 15 * MS
        clock.now += 3_000 * MS
        session.pacer.rebase()
        session.step()
        assert clock.now - 5_000 * MS == 3_020 * MS and session.pacer.lateness().missed == 0
        with pytest.raises(InputError, match="real-time factor 0: take a number from 1e-06"):
            session.pacer.factor = 0.0


def test_deadlines_stand_in_the_plan_where_they_are_asked_for(clock: Clock) -> None:
    def instants(every: str, stop: str = "0.1") -> list[int]:
        plan = plan_with(clock, lambda _: 0.0, every, stop)
        ms = plan.clock.seconds(1) * 1000
        return [int(row[1] * ms) for row in plan.cycle.tolist() if row[0] == PACE and row[2] < 0]

    assert instants("") == [10] and instants("5 ms") == [5, 10]
    for wrong in ("3 ms", "20 ms", "2.5 ms"):
        with pytest.raises(InputError, match="take a multiple of the shortest period 5 ms that divides 10 ms"):
            instants(wrong)
    slow = {"a": (worker(clock, lambda _: 0.0), "0.03"), "b": (worker(clock, lambda _: 0.0), "0.07")}
    plan = make_plan(system_of(slow, [], [], "0.21"), "")
    assert plan.clock.seconds(plan.deadlines) * 1000 == 30  # the hyperperiod of 210 ms is too long to wait for


def test_an_interrupt_ends_a_run_in_real_time_in_good_order(clock: Clock, tmp_path: Path, fmus: Path) -> None:
    plan = make_plan(plan_of(tmp_path, fmus, pressing(5)).system, "")
    with Session(plan, pace=Pace()) as session:
        session.advance()
        run = session.run()
    assert (run.end, run.failure) == (0.006, "interrupted by the user at t = 0.006 s")


@pytest.mark.parametrize(("period", "deadlines"), [("1 ms", 100), ("50 ms", 2)])
def test_the_real_clock_is_kept_as_well(
    period: str, deadlines: int, tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    """How well is a matter of the machine: not earlier is one of ours, wherever it waits."""
    path = tmp_path / "case.toml"
    path.write_text(system_text({"w": ("wave", period, {"c1": 1.0})}, [], stop="100 ms"))
    assert rovbrush(monkeypatch, "run", path, "--fmus", fmus, "--out", tmp_path / "out", "--real-time") == 0
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["real_time"]["deadlines"] == deadlines
    assert summary["wall_s"] > 0.05  # without it about a thousandth of that
    assert f"real time x 1: {deadlines} deadlines" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--realtime-policy", "stop"], "--realtime-policy stop is for a run in real time; add --real-time"),
        (["--fifo", "3"], "--fifo 3 is for a run in real time"),
        (["--real-time", "0"], "real-time factor 0"),
        (["--real-time=fast"], "--real-time fast: a factor is a number"),
        (["--real-time", "--realtime-policy", "halt"], "realtime policy 'halt': there are warn, stop and skip"),
        (["--real-time", "--deadlines", "7 ms"], "take a multiple of the shortest period 1 ms"),
        (["--real-time", "--fifo", "100"], "SCHED_FIFO has priorities from 1 to 99, not 100"),
        (["--real-time", "--cores", "a"], "--cores a: write whole numbers"),
        (["--real-time", "--cores", "4000"], "the run cannot be held on processors 4000"),
    ],
)
def test_what_has_no_meaning_is_one_error(
    options: list[str],
    said: str,
    tmp_path: Path,
    fmus: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    path = tmp_path / "case.toml"
    path.write_text(system_text({"w": ("wave", "1 ms", {"c1": 1.0})}, [], stop="10 ms"))
    assert rovbrush(monkeypatch, "run", path, "--fmus", fmus, "--out", tmp_path / "out", *options) == 2
    assert said in " ".join(capsys.readouterr().err.split())


def test_deadlines_and_a_pace_go_together(clock: Clock) -> None:
    with pytest.raises(InputError, match="this plan has deadlines: give the run a pace"):
        Session(plan_with(clock, lambda _: 0.0))
    plan = plan_of_mocks({"a": (worker(clock, lambda _: 0.0), "0.001")}, [], [], "0.005")
    with pytest.raises(InputError, match="this plan has no deadlines"):
        Session(plan, pace=Pace())
