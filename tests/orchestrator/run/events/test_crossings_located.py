"""Signals of FMUs for Model Exchange that cross a value: where, by the solver of the group, and what follows there."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import exchange_build
import pytest
from clock_build import clocked
from helpers import last, plan_of
from native_build import needs_gcc
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc
LAG = {"=push": 1.0}  # x = 1 - exp(-t)


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("crossings")
    for name in ("ball", "lag"):
        exchange_build.exchange(folder, name)
    clocked(folder / "plant.fmu", "plant")
    return folder


def planned(
    folder: Path, fmus: Path, parts: Any, *events: dict[str, Any], method: str = "dormand-prince", **keys: Any
) -> Plan:
    solver = {"method": method, "tolerance": 1e-10}
    return plan_of(folder, fmus, {**parts, "p": ("plant", "40 ms")}, events=events, solver=solver, **keys)


def told(run: Run, words: str) -> list[float]:
    return [row.time for row in run.events if words in row.what]


@pytest.mark.parametrize("method", ["dormand-prince", "cvode"])
@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_what_waits_for_a_signal_acts_where_it_crosses(algorithm: str, method: str, tmp_path: Path, fmus: Path) -> None:
    event = {"when": "lag.x > 0.5", "set": {'"p.u"': 1.0}}
    parts = {"lag": ("lag", "100 ms", LAG)}
    plan = planned(tmp_path, fmus, parts, event, method=method, algorithm=algorithm, stop="1 s")
    assert "where it crosses is found by the solver of lag; acts on p at once" in explain(plan)
    run, other = simulate(plan), simulate(plan, interpreted=True)
    assert not run.failure and [t.tobytes() for t in run.tables] == [t.tobytes() for t in other.tables]
    (seen,) = told(run, "event 1: p.u = 1")
    assert seen == pytest.approx(math.log(2.0), abs=1e-8)
    assert last(run, "p.x") == pytest.approx(1.0 - seen, abs=1e-15)


def test_a_delay_is_counted_from_there_and_a_value_that_is_crossed_again_is_seen_again(
    tmp_path: Path, fmus: Path
) -> None:
    """A ball of e = 1 falls from 1 m again and again: below 0.5 m at t1 + 2 k t0, above it at 2 t0 - t1 + 2 k t0."""
    t0, t1 = math.sqrt(2.0 / 9.81), math.sqrt(1.0 / 9.81)
    falls = {"name": "falls", "when": "ball.h < 0.5", "repeat": True, "after": "1/3 ms", "set": {'"p.u"': 1.0}}
    rises = {"name": "rises", "when": "ball.h > 0.5", "repeat": True, "set": {'"p.u"': 0.0}}
    plan = planned(tmp_path, fmus, {"ball": ("ball", "50 ms", {"e": 1.0})}, falls, rises, stop="3 s")
    run = simulate(plan)
    down, up = told(run, "falls: ball.h < 0.5"), told(run, "rises: ball.h > 0.5")
    assert down == pytest.approx([t1 + 2 * k * t0 for k in range(len(down))], abs=1e-8) and len(down) == 3
    assert up == pytest.approx([2 * t0 - t1 + 2 * k * t0 for k in range(len(up))], abs=1e-8) and len(up) == 3
    inside = sum(b - a - 1 / 3000 for a, b in zip(down, up, strict=True))
    assert last(run, "p.x") == pytest.approx(inside, abs=1e-12)


def test_how_a_run_is_cut_changes_no_crossing(tmp_path: Path, fmus: Path) -> None:
    event = {"when": "ball.h < 0.3", "repeat": True, "set": {'"p.u"': 1.0}}
    plan = planned(tmp_path, fmus, {"ball": ("ball", "50 ms")}, event, stop="2 s")
    whole = simulate(plan)
    with Session(plan) as session:
        while session.tick < plan.clock.stop:
            session.advance(cycles=1)
        cut = session.run()
    assert [t.tobytes() for t in cut.tables] == [t.tobytes() for t in whole.tables]
    assert [(r.time, r.what) for r in cut.events] == [(r.time, r.what) for r in whole.events]


def test_other_signals_are_seen_at_their_instants(tmp_path: Path, fmus: Path) -> None:
    event = {"when": "p.x > 0.1", "set": {'"lag.push"': 0.0}}
    plan = planned(tmp_path, fmus, {"lag": ("lag", "100 ms", LAG)}, event, set_u(), stop="1 s")
    assert "looked at every 40 ms and at every event" in explain(plan)
    assert told(simulate(plan), "event 1: p.x > 0.1") == [0.12]


def set_u() -> dict[str, Any]:
    return {"at": "0 s", "set": {'"p.u"': 1.0}}
