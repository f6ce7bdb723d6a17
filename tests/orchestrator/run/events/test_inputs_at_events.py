"""Inputs that are set at events only: from `[[events]]`, from tables, by hand, and broken on their way."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import exchange_build
import numpy as np
import pytest
from clock_build import clocked
from helpers import last, plan_of, run_of
from native_build import needs_gcc
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("inputs")
    for name in ("witness", "plant", "square", "controller"):
        clocked(folder / f"{name}.fmu", name)
    for name in ("lag", "ball"):
        exchange_build.exchange(folder, name)
    return folder


def final(run: Run, name: str) -> Any:
    """The last value of a signal, in its own type."""
    return Signals(run)[name].values[-1]


def set_at(time: str, **values: Any) -> dict[str, Any]:
    names = {key: f'"{key.replace("_", ".", 1)}"' for key in values}  # quoted: a key with a point
    return {"at": time, "set": {names[key]: value for key, value in values.items()}}


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
@pytest.mark.parametrize("interpreted", [False, True])
def test_an_event_off_the_grid_acts_at_its_time_on_all_that_can_be_brought_there(
    interpreted: bool, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    """A plant x' = u, a lag of Model Exchange x' = (push - x) / tau, and a discrete input that is set in event mode."""
    time = 0.0123456789
    parts = {"p": ("plant", "10 ms"), "lag": ("lag", "10 ms"), "w": ("witness", "7 ms")}
    events = [set_at(f"{time} s", p_u=2.0, lag_push=1.0, lag_tau=0.5, w_n=5, w_u=3.0)]
    run = run_of(tmp_path, fmus, parts, stop="0.1 s", events=events, algorithm=algorithm, interpreted=interpreted,
                 solver={"tolerance": 1e-10})  # fmt: skip
    left = 0.1 - time
    assert last(run, "p.x") == pytest.approx(2.0 * left, abs=1e-16)
    assert last(run, "lag.x") == pytest.approx(1.0 - math.exp(-left / 0.5), abs=1e-9)
    assert (final(run, "w.at"), final(run, "w.changes"), final(run, "w.u_then")) == (time, 1, 3.0)
    assert last(run, "w.w") == pytest.approx(3.0 * left, abs=1e-16)
    assert [(row.time, row.number) for row in run.events][:3] == [(0.0, 0), (time, 0), (time, 1)]


def stepped(plan: Plan) -> Run:
    run, other = simulate(plan), simulate(plan, interpreted=True)
    assert not run.failure and [t.tobytes() for t in run.tables] == [t.tobytes() for t in other.tables]
    return run


def test_a_table_of_a_discrete_input_is_an_event_at_each_of_its_rows(tmp_path: Path, fmus: Path) -> None:
    rows = {"time": [0.0, 0.0123, 0.05, 1 / 15, 0.1], "values": [0, 3, 3, 8, 8]}
    plan = plan_of(tmp_path, fmus, {"w": ("witness", "10 ms")}, stop="0.1 s", of={"w": {"inputs": {"n": rows}}})
    run = stepped(plan)
    assert (final(run, "w.changes"), final(run, "w.n"), final(run, "w.at")) == (2, 8, 1 / 15)
    told = [row.time for row in run.events if "w.n takes another row" in row.what]
    assert told == [0.0123, 0.05, 1 / 15, 0.1]


def test_a_clocked_input_takes_at_each_tick_the_last_row_of_its_table(tmp_path: Path, fmus: Path) -> None:
    """u = k (r - y) at the ticks, every 1/60 s."""
    rows = {"time": [0.0, 0.02, 0.04, 0.1], "values": [0.0, 1.0, 5.0, 5.0]}
    of = {"c": {"inputs": {"y": rows}}}
    run = stepped(plan_of(tmp_path, fmus, {"c": ("controller", "5 ms", {"r": 0.0})}, stop="0.1 s", of=of))
    ticks = [row for row in run.events if "c.tick ticks" in row.what]
    keys = [".".join(key) for group in run.plan.groups for key in group.columns]
    given = [row.cells[keys.index("c.y")] for row in ticks]
    assert given == [0.0, 0.0, 1.0, 5.0, 5.0, 5.0, 5.0]
    assert [row.cells[keys.index("c.u")] for row in ticks] == pytest.approx([-y for y in given])


def test_what_is_set_by_hand_is_an_event_at_once_or_waits_for_the_clock(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("witness", "10 ms"), "c": ("controller", "10 ms", {"r": 0.0})}
    with Session(plan_of(tmp_path, fmus, parts, stop="0.1 s")) as session:
        session.advance(cycles=3)
        session.set("w.n", 7)
        session.set("c.y", 2.0)
        assert session.get("w.at") == 0.03 and session.get("w.changes") == 1
        assert session.get("c.u") == 0.0
        session.advance(cycles=1)
        assert session.get("c.u") == -2.0  # its tick was at 2/60 s
        session.advance()
        run = session.run()
        session.set("w.n", 9)  # behind the stop nothing happens any more
        assert len(session.run().events) == len(run.events)
    assert not run.failure and final(run, "w.changes") == 1
    assert [row.time for row in run.events if "w.n is set" in row.what] == [0.03]


@pytest.mark.parametrize("kind", ["loss", "hold"])
def test_a_signal_breaks_on_its_way_to_an_input_that_is_set_at_events(kind: str, tmp_path: Path, fmus: Path) -> None:
    """A square wave counts its changes every 0.25 s; from 0.6 s to 1.1 s the count does not arrive."""
    fault = {"at": "0.6 s", "until": "1.1 s", "fault": kind, "on": "w.n"}
    parts = {"s": ("square", "50 ms"), "w": ("witness", "50 ms")}
    run = stepped(plan_of(tmp_path, fmus, parts, ["s.changes -> w.n"], stop="1.4 s", events=[fault]))
    keys = [".".join(key) for group in run.plan.groups for key in group.columns]
    cells = [(row.time, int(row.cells.view(np.int64)[keys.index("w.n")])) for row in run.events]
    inside = {n for time, n in cells if 0.6 < time < 1.1}
    assert inside == {0 if kind == "loss" else 2}
    assert final(run, "w.n") == 5
    assert cells[-1][1] == 5


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_the_part_of_a_step_before_an_event_holds_what_its_source_has_where_the_step_begins(
    algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    """Of q' = p.x and l' = p.x - l, which both step before p: q as the faster one, l beside a ball, which has events.

    l is read again at each instant, as it answers to p.x at once."""
    parts = {
        "p": ("plant", "10 ms", {"=u": 1.0}), "q": ("plant", "5 ms"), "l": ("lag", "10 ms"),
        "ball": ("ball", "10 ms", {"g": 0.0}),
    }  # fmt: skip
    events = [set_at("123.4 ms", p_u=2.0)]
    run = run_of(tmp_path, fmus, parts, ["p.x -> q.u (hold)", "p.x -> l.push"], stop="130 ms", algorithm=algorithm,
                 events=events, solver={"tolerance": 1e-12})  # fmt: skip
    lag = 0.0
    for push, length in [*((0.01 * k, 0.01) for k in range(12)), (0.12, 0.0034), (0.1234, 0.0066)]:
        lag = push + (lag - push) * math.exp(-length)
    assert last(run, "q.x") == pytest.approx(0.0066 + 0.12 * 0.0034 + 0.1234 * 0.0066, abs=1e-15)
    assert last(run, "l.x") == pytest.approx(lag, abs=1e-12)


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_noise_is_that_of_the_whole_step_where_an_event_cuts_it(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    parts = {"p": ("plant", "10 ms", {"x0": 1.0}), "q": ("plant", "5 ms"), "r": ("plant", "10 ms")}
    noise = {"at": 0, "fault": "noise", "on": "q.u", "value": 0.1, "seed": 1}
    cuts = [set_at(f"{t} ms", r_u=1.0) for t in (3.4, 7.7, 8.8, 13.4, 26.1)]  # of another component
    runs = [
        run_of(tmp_path, fmus, parts, ["p.x -> q.u (hold)"], stop="30 ms", algorithm=algorithm, events=[noise, *more])
        for more in ([], cuts)
    ]
    whole, cut = (Signals(run)["q.x"].values for run in runs)
    assert cut == pytest.approx(whole, abs=1e-16) and len(set(np.diff(whole))) == len(whole) - 1


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
@pytest.mark.parametrize("transfer", ["linear", "quadratic", "interpolate"])
@pytest.mark.parametrize("periods", [("10 ms", "5 ms"), ("15 ms", "5 ms"), ("10 ms", "4 ms")])
def test_an_event_of_others_leaves_what_an_input_is_between_the_samples_of_its_source(
    periods: tuple[str, str], transfer: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    """The source is bent, by a table; the events cut the steps of all, and touch neither."""
    table = {"time": [0.0, 0.2], "values": [0.0, 6.0]}
    parts = {"p": ("plant", periods[0], {"=u": table}), "q": ("plant", periods[1]), "r": ("plant", periods[1])}
    wires = [f"p.x -> q.u ({transfer})"]
    given: dict[str, Any] = {"connections": wires, "stop": "0.2 s", "algorithm": algorithm}
    events = [set_at(f"{time} s", r_u=1.0) for time in (0.0234, 0.0571, 0.0573, 0.1034)]
    whole = run_of(tmp_path, fmus, parts, **given)
    cut = stepped(plan_of(tmp_path, fmus, parts, **given, events=events))
    for name in ("q.x", "q.u"):
        here, there = (Signals(run)[name].values for run in (whole, cut))
        assert np.abs(here - there).max() <= 1e-15 and np.ptp(here) > 1e-3
