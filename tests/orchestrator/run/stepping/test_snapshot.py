"""A session that goes back to a snapshot goes on bit for bit as if it had never left."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import clock_build
import exchange_build
import numpy as np
import pytest
from car_runs import ALGORITHMS, car
from clock_cases import CASES, SCHEDULED
from helpers import Part, edited, plan_of
from native_build import FREE3, WIRES3, built, needs_gcc
from oscillators import CVODE, METHODS, PUSHED, planned
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.system.file.reader import load_system

STOPS = {"partitions": "3 s"}  # three of its cycles


def bits(run: Run) -> tuple[object, ...]:
    events = [(row.time, row.number, row.what, row.cells.tobytes()) for row in run.events]
    return [table.tobytes() for table in run.tables], events, run.end, run.failure


def require_as_if_never_left(
    plan: Plan, disturb: Callable[[Stepping], None] = lambda _: None, undisturbed: bool = True
) -> None:
    """Snapshots at a third and two thirds, used in the wrong order and again; `disturb` is done in between.

    `undisturbed`: that snapshots were taken leaves no trace.
    """
    third = plan.clock.stop // 3
    with Stepping(plan) as session:
        session.finish(until_tick=third)
        first, at_first = session.snapshot(), bits(session.run())
        session.finish(until_tick=2 * third)
        second, taken = session.snapshot(), session.run()
        at_second = bits(taken)
        session.finish()
        whole = bits(session.run())
        again = ((first, at_first), (second, at_second), (second, at_second), (first, at_first))
        for snapshot, then in again if undisturbed else again[1:3]:  # the second one was a trace behind the first
            session.restore(snapshot)
            assert bits(session.run()) == then and session.time == snapshot.time
            disturb(session)
            session.restore(snapshot)
            session.finish()
            assert bits(session.run()) == whole
        assert bits(taken) == at_second, "a result that was taken stays as it is"
    if undisturbed:
        assert bits(simulate(plan)) == whole


@pytest.mark.parametrize("method", ["aitken", "newton"])
@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_every_algorithm_comes_back_bitwise(algorithm: str, method: str, tmp_path: Path, fmus: Path) -> None:
    plan = car(tmp_path, fmus, algorithm)
    if algorithm == "iterated":
        plan = make_plan(replace(plan.system, settings={"iteration": {"method": method}}))
    require_as_if_never_left(plan)


@needs_gcc
@pytest.mark.parametrize("name", CASES | SCHEDULED)
def test_events_clocks_and_partitions_come_back_bitwise(name: str, tmp_path: Path, clocks: Path) -> None:
    case = (CASES | SCHEDULED)[name]
    require_as_if_never_left(plan_of(tmp_path, clocks, case.parts, case.wires, stop=STOPS.get(name, case.stop)))


@pytest.fixture(scope="module")
def clocks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return clock_build.built(tmp_path_factory.mktemp("clocks"))


@pytest.mark.sampled(2)
@needs_gcc
@pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
@pytest.mark.parametrize("name", ["clocked control", "early returns", "both", "partitions"])
def test_so_do_those_in_processes_of_their_own(name: str, tmp_path: Path, clocks: Path) -> None:
    case = (CASES | SCHEDULED)[name]
    of = {key: {"isolation": "process"} for key in case.moved}
    require_as_if_never_left(plan_of(tmp_path, clocks, case.parts, case.wires, stop=STOPS.get(name, case.stop), of=of))


ISOLATED = f'isolation = "process"\n{PUSHED}'


@pytest.mark.sampled(4)
@needs_gcc
@pytest.mark.parametrize(
    ("solver", "more", "algorithm"),
    [
        *((method, "", "gauss-seidel") for method in METHODS),
        (METHODS[0], PUSHED, "gauss-seidel"),
        (METHODS[0], ISOLATED, "gauss-seidel"),
        (CVODE, "", "iterated"),
    ],
)
def test_model_exchange_comes_back_bitwise(solver: str, more: str, algorithm: str, tmp_path: Path) -> None:
    """CVODE alone has a history, which a snapshot ends for the run that goes on too."""
    plan = planned(tmp_path, solver, more=more, algorithm=algorithm, stop="3 s")
    require_as_if_never_left(plan, undisturbed=solver != CVODE or algorithm == "iterated")


@needs_gcc
def test_events_of_a_group_and_of_the_system_come_back_bitwise(tmp_path: Path, clocks: Path) -> None:
    exchange_build.exchange(tmp_path, "ball")
    text = f"""
format = 2
stop_time = "2 s"
solver = {{ tolerance = 1e-10 }}
components.ball = {{ fmu = "ball.fmu", period = "10 ms" }}
components.s = {{ fmu = "{(clocks / "square.fmu").as_posix()}", period = "100 ms" }}
events = [{{ at = "700 ms", set = {{ "ball.u" = 0.1 }} }}]
"""
    (tmp_path / "system.toml").write_text(text, encoding="utf-8")
    require_as_if_never_left(make_plan(load_system(str(tmp_path / "system.toml"), tmp_path)))


@needs_gcc
@pytest.mark.parametrize("isolation", ["", "process"])
@pytest.mark.parametrize("algorithm", ["jacobi", "iterated"])
def test_values_of_every_type_that_were_set_by_hand_come_back(isolation: str, algorithm: str, tmp_path: Path) -> None:
    """Elements of arrays too, of which an FMU wants all at once, and texts that the run had not seen."""
    parts: dict[str, Part] = {"a": ("feedthrough3", "1 ms", FREE3), "b": ("feedthrough3", "2 ms")}
    system = plan_of(tmp_path, built(tmp_path), parts, WIRES3, stop="20 ms", algorithm=algorithm).system
    components = {name: replace(c, isolation=isolation) for name, c in system.components.items()}
    plan = make_plan(replace(system, components=components))
    names = [f"a.{name.removeprefix('=')}" for name in FREE3]

    def disturb(session: Stepping) -> None:
        for name in names:
            value = session.get(name)
            if isinstance(value, float):
                session.set(name, value + 1.0)
            elif isinstance(value, str):
                session.set(name, f"another at {session.time:g}")
        session.step()

    require_as_if_never_left(plan, disturb)


def gains(folder: Path, fmus: Path) -> Plan:
    """g.y = 2 g.u, with g.u free."""
    parts: dict[str, Part] = {"g": ("gain", "1 ms", {"k": 2.0, "offset": 0.0, "=u": 1.0})}
    return plan_of(folder, fmus, parts, [], stop="20 ms")


def test_what_was_set_by_hand_is_what_it_was_and_any_number_of_snapshots_may_be_held(
    tmp_path: Path, fmus: Path
) -> None:
    with Stepping(gains(tmp_path, fmus)) as session:
        kept = []
        for k in range(10):
            session.set("g.u", float(k))
            session.step()
            kept.append((session.snapshot(), session.get("g.y")))
        for snapshot, y in reversed(kept):
            session.restore(snapshot)
            assert session.get("g.y") == y and session.time == snapshot.time
            session.step()
            assert session.get("g.y") == y, "its input is what was set last before the snapshot"


def test_a_session_that_has_failed_goes_on_from_a_snapshot(tmp_path: Path, fmus: Path) -> None:
    with Stepping(gains(tmp_path, fmus)) as session:
        session.step()
        here, before = session.snapshot(), bits(session.run())
        session.fail("the operator stopped it")
        with pytest.raises(RunError):
            session.step()
        session.restore(here)
        assert bits(session.run()) == before
        session.step()
        with pytest.raises(RunError, match="no whole step before the stop"):
            session.step("20 ms")


def test_released_and_foreign_snapshots_are_refused(tmp_path: Path, fmus: Path) -> None:
    plan = gains(tmp_path, fmus)
    with Stepping(plan) as session, Stepping(plan) as other:
        with session.snapshot() as here, pytest.raises(InputError, match="is one of another session"):
            other.restore(here)
        with pytest.raises(InputError, match="was released"):
            session.restore(here)
        here.release()
        left = session.snapshot()
    assert left.released, "a session that is closed releases its own"
    with pytest.raises(RunError):
        session.restore(left)


def test_an_fmu_that_cannot_save_its_state_is_named(tmp_path: Path, fmus: Path) -> None:
    flags = {'canGetAndSetFMUstate="true"': 'canGetAndSetFMUstate="false"',
             'canSerializeFMUstate="true"': 'canSerializeFMUstate="false"'}  # fmt: skip
    edited(fmus / "wheel.fmu", tmp_path / "wheel.fmu", {}, flags)
    (tmp_path / "chassis.fmu").write_bytes((fmus / "chassis.fmu").read_bytes())
    with Stepping(car(tmp_path, tmp_path, "jacobi")) as session:
        with pytest.raises(InputError, match=r"component w: wheel.fmu cannot save its state \(canGetAndSetFMUstate"):
            session.snapshot()
        session.step()


def test_a_run_without_rows_comes_back(tmp_path: Path, fmus: Path) -> None:
    plan = make_plan(replace(car(tmp_path, fmus, "jacobi").system, record=("w.nothing",)))
    with Stepping(plan) as session:
        here, before = session.snapshot(), session.memory.z.copy()
        session.step()
        assert not np.array_equal(before, session.memory.z)
        session.restore(here)
        assert np.array_equal(before, session.memory.z)
