"""A session that goes back to a snapshot goes on bitwise as if it had never left."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import exchange_build
import numpy as np
import pytest
from car_runs import ALGORITHMS, WIRES, car, same
from clock_build import built as clocks_built
from clock_cases import CASES, SCHEDULED, plan_for
from helpers import Part, plan_of
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator import InputError, Model, RunError, load
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.system.file.reader import load_system

ALL = CASES | SCHEDULED


def happened(run: Run) -> list[tuple[float, int, str]]:
    return [(row.time, row.number, row.what) for row in run.events]


def steps(session: Stepping, count: int) -> None:
    """So many, or to the stop: some cases have few."""
    for _ in range(count):
        if session.time < session.stop:
            session.step()


def require_same_branches(plan: Plan) -> None:
    """Two snapshots, the run to its end behind both, and each of them gone back to more than once, in any order."""
    whole = simulate(plan)
    cycles = len(whole.tables[0]) - 1 if plan.adaptive else -(-plan.clock.stop // plan.cycle_ticks)
    with Stepping(plan) as session:
        start = session.snapshot()
        steps(session, max(cycles // 3, 1))
        first = session.snapshot()
        steps(session, max(cycles // 4, 1))
        second = session.snapshot()
        session.finish()
        ends = [session.run()]
        for snapshot in (first, second, start, second, first):
            session.restore(snapshot)
            assert session.time == snapshot.time and not session.over
            steps(session, 1)
            session.restore(snapshot)
            session.finish()
            ends.append(session.run())
        for end in ends:
            assert not end.failure and same(end, whole)
            assert [(e.time, e.number, e.what) for e in end.events] == [
                (e.time, e.number, e.what) for e in whole.events
            ]


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_every_algorithm_goes_back_bitwise(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    require_same_branches(car(tmp_path, fmus, algorithm, "100 ms"))


def test_iteration_by_newton_goes_back_bitwise(tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, "iterated", "100 ms")
    require_same_branches(make_plan(replace(plan.system, settings={"iteration": {"method": "newton"}})))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
def test_fmus_in_processes_of_their_own_go_back_bitwise(tmp_path: Path, fmus: Path) -> None:
    parts: dict[str, Part] = {"w": ("wheel", "1 ms"), "c": ("chassis", "3 ms")}
    isolated = {"w": {"isolation": "process"}, "c": {"isolation": "process"}}
    require_same_branches(plan_of(tmp_path, fmus, parts, WIRES, stop="60 ms", of=isolated))


@needs_gcc
@pytest.mark.parametrize("name", ALL)
def test_events_and_clocks_go_back_bitwise(name: str, tmp_path: Path) -> None:
    require_same_branches(plan_for(ALL[name], tmp_path, clocks_built(tmp_path)))


@needs_gcc
@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
@pytest.mark.parametrize("name", ["clocked control", "countdown"])
def test_events_in_processes_of_their_own_go_back_bitwise(name: str, tmp_path: Path) -> None:
    require_same_branches(plan_for(ALL[name], tmp_path, clocks_built(tmp_path), isolation="process"))


EXCHANGE = """
format = 2
stop_time = "2 s"
[solver]
{solver}
[components.o]
fmu = "oscillator.fmu"
period = "50 ms"
parameters = {{ mu = 5.0 }}
[components.f]
fmu = "forced.fmu"
period = "70 ms"
[[events]]
name = "pushed"
at = "1.1 s"
set = {{ "o.u" = 2.0 }}
"""


@needs_gcc
@pytest.mark.parametrize("solver", ['method = "dormand-prince"', 'method = "rk4"\nstep = "3 ms"',
                                    'method = "cvode"\nrestart = true'])  # fmt: skip
def test_model_exchange_with_events_of_the_system_goes_back_bitwise(solver: str, tmp_path: Path) -> None:
    for name in ("oscillator", "forced"):
        exchange_build.exchange(tmp_path, name)
    path = tmp_path / "system.toml"
    path.write_text(EXCHANGE.format(solver=solver), encoding="utf-8")
    require_same_branches(make_plan(load_system(str(path), tmp_path)))


@needs_gcc
@pytest.mark.parametrize("kind", ["feedthrough2", "feedthrough3"])
def test_values_set_by_hand_go_back_too(kind: str, tmp_path: Path) -> None:
    """Whatever type they have: what is set behind a snapshot has never been."""
    free, wires = (FREE2, WIRES2) if kind == "feedthrough2" else (FREE3, WIRES3)
    parts: dict[str, Part] = {"a": (kind, "1 ms", free), "b": (kind, "2 ms")}
    plan = plan_of(tmp_path, built(tmp_path), parts, wires, stop="40 ms")
    loose = [(name, variable) for name, component in plan.system.components.items()
            for variable in component.fmu.names("input")
            if (name, variable) not in plan.layout.inputs]  # fmt: skip
    assert loose
    with Stepping(plan) as session:
        steps(session, 3)
        known = {key: session.get(".".join(key)) for key in loose}
        snapshot = session.snapshot()
        session.finish()
        expected = session.run()
        session.restore(snapshot)
        for (name, variable), value in known.items():
            session.set(f"{name}.{variable}", _other(value))
        steps(session, 2)
        session.restore(snapshot)
        assert {key: session.get(".".join(key)) for key in loose} == known
        assert not session.set_by_hand
        session.finish()
        assert same(session.run(), expected)


def _other(value: Any) -> Any:
    """Another value of the same type."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int | float):
        return 2 if value == 1 else 1
    return type(value)() if value else (b"x" if isinstance(value, bytes) else "x")


def one(folder: Path, fmus: Path, **of: Any) -> Model:
    """An integrator whose input is free."""
    plan = plan_of(folder, fmus, {"i": ("integrator", "2 ms", {"=u": 0.0})}, [], stop="20 ms", **of)
    return load(plan.system.path, fmus=fmus)


def test_a_session_by_hand_goes_back(tmp_path: Path, fmus: Path) -> None:
    with one(tmp_path, fmus).start() as session:
        begin, ends = session.snapshot(), []
        for u in (1.0, -2.0, 1.0):
            session.restore(begin)
            session.set("i.u", u)
            for _ in range(10):
                session.step()
            ends.append(session.get("i.x"))
            table = session.result()["i.x"].values
            assert table[-1] == ends[-1] and len(table) == 11
        assert ends[0] == ends[2] != ends[1]


def test_results_that_were_taken_stay_as_they_are(tmp_path: Path, fmus: Path) -> None:
    with one(tmp_path, fmus).start() as session:
        begin = session.snapshot()
        session.set("i.u", 1.0)
        session.step()
        first = session.result()
        kept = np.array(first["i.x"].values)
        session.restore(begin)
        session.set("i.u", 5.0)
        session.step()
        assert np.array_equal(first["i.x"].values, kept)


def test_it_goes_back_from_its_end(tmp_path: Path, fmus: Path) -> None:
    with one(tmp_path, fmus).start() as session:
        begin = session.snapshot()
        session.finish()
        with pytest.raises(RunError):
            session.step()
        session.restore(begin)
        session.step()
        assert session.time == 0.002


def test_what_cannot_be_is_said(tmp_path: Path, fmus: Path) -> None:
    with one(tmp_path, fmus).start() as session, one(tmp_path, fmus).start() as other:
        snapshot = session.snapshot()
        assert "at 0 s" in repr(snapshot)
        with pytest.raises(InputError, match="of another session"):
            other.restore(snapshot)
        snapshot.release()
        with pytest.raises(InputError, match="was released"):
            session.restore(snapshot)
    with pytest.raises(RunError, match="closed"):
        session.snapshot()
