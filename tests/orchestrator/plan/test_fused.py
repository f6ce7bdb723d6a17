"""What the loop does in one go has the bits of the operations that it stands for, and ends where they end."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from event_cases import bonded, ramp_into_keep
from helpers import plan_of, read_system
from hypothesis import HealthCheck, given, settings
from native_build import FREE3, built, moody, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop import cells, turns
from rovbrush.orchestrator.loop.operations import COLUMNS, COPY, GET, MOVE, MOVES, RECORD, REPEAT, SET, STEP, TURNS
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.plan.speed.fused import fuse
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.pacing.pace import FASTEST, Pace
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.studies.bench.fmus.mixed import mixed_ring
from rovbrush.orchestrator.studies.bench.fmus.native import ring
from rovbrush.orchestrator.system.file.reader import load_system
from test_plan_random import system_of, systems

CAR = ({"w": ("wheel", "1 ms"), "c": ("chassis", "3 ms")}, ["c.v_c -> w.v_c", "w.F -> c.F"])
KINDS = {
    "jacobi": {}, "gauss-seidel": {}, "iterated": {"iteration": {"method": "newton"}},
    "ecco": {"bonds": [{"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}],
             "ecco": {"tolerance": 0.01, "relative": 0.01, "minimum": "50 us", "maximum": "20 ms"}},
    "adaptive": {"adaptive": {"tolerance": 0.005}},
}  # fmt: skip

WHOLE = "if (m->steps == 4) { m->x += h * m->u; return fmi2Discard; }"  # the fourth step, done to its end


def bits(run: Run) -> tuple[Any, ...]:
    events = [(row.time, row.number, row.what, row.cells.tobytes()) for row in run.events]
    return [table.tobytes() for table in run.tables], run.end, run.failure, run.ended, events


def advanced(plan: Plan, interpreted: bool, fuses: bool, pace: Pace | None = None) -> tuple[Any, ...]:
    with Session(plan, interpreted, pace=pace, fuses=fuses) as session:
        session.advance()
        return bits(session.run())


def require_the_same(plan: Plan, interpreted: bool = True, pace: Pace | None = None) -> tuple[Any, ...]:
    """In each life, with and without turns; what all of them gave."""
    lives = [(life, fuses) for life in ([False, True] if interpreted else [False]) for fuses in (False, True)]
    first, *others = [advanced(plan, *life, pace) for life in lives]
    assert all(other == first for other in others)
    return first


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(case=systems())
def test_random_systems_have_the_same_bits_and_failures(case: dict[str, Any], tmp_path: Path, fmus: Path) -> None:
    try:
        plan = make_plan(system_of(case, tmp_path, fmus))
    except InputError:
        return
    require_the_same(plan, interpreted=False)


@pytest.mark.parametrize("algorithm", KINDS)
def test_every_algorithm_has_the_same_bits_in_both_lives(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    parts, wires = CAR
    if algorithm in ("ecco", "adaptive"):
        parts = {name: (fmu, "2 ms") for name, (fmu, _) in parts.items()}
    plan = plan_of(tmp_path, fmus, parts, wires, stop="100 ms", algorithm=algorithm, **KINDS[algorithm])
    assert not require_the_same(plan)[2]
    with Session(plan) as session:
        session.advance(cycles=1)
        (program,) = session._blocks._programs.values()
        assert len(program.rows) < len(plan.cycle) and len(program.turns) >= 2


@needs_gcc
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize(
    "bad",
    [
        {"ON_STEP": "if (t > 0.0049) return fmi2Error;"},
        {"ON_STEP": "if (t > 0.0049) return fmi2Discard;"},
        {"ON_STEP": "if (t > 0.0049) m->x = 0.0 / 0.0;"},
        {"ON_SET": "if (m->steps == 5) return fmi2Error;"},
        {"ON_GET": "if (m->steps == 5) return fmi2Fatal;"},
        {"ON_STEP": WHOLE, "REACHED": "t0 + h0", "TERMINATED": "1"},
    ],
    ids=["error", "discard", "nan", "set", "get", "asks to end"],
)  # fmt: skip
def test_who_fails_in_the_middle_of_a_row_is_named_as_ever(bad: dict[str, str], algorithm: str, tmp_path: Path) -> None:
    moody(tmp_path / "m.fmu", **bad)
    moody(tmp_path / "g.fmu")
    parts = {"g": ("g.fmu", "1 ms"), "m": ("m.fmu", "1 ms"), "f": ("g.fmu", "1 ms")}
    wires = ["g.x -> m.u", "m.x -> g.u", "m.y -> f.u"]
    plan = make_plan(read_system(tmp_path, tmp_path, parts, wires, "10 ms", algorithm=algorithm))
    found = require_the_same(plan)
    assert "component m" in found[2] + found[3]


@needs_gcc
def test_fmi_1_2_and_3_and_packed_types_have_the_same_bits(tmp_path: Path) -> None:
    mixed = load_system(str(mixed_ring(tmp_path, stop="5 ms")))
    require_the_same(make_plan(replace(mixed, algorithm="jacobi")))
    built(tmp_path)
    moody(tmp_path / "g.fmu")
    rest = {name: value for name, value in FREE3.items() if name != "=Float64_in"}
    parts = {"a": ("feedthrough3", "1 ms", FREE3), "b": ("feedthrough3", "2 ms", rest), "g": ("g.fmu", "1 ms")}
    wires = ["a.Float64_out -> b.Float64_in", "b.Float64_out -> g.u"]
    require_the_same(make_plan(read_system(tmp_path, tmp_path, parts, wires, "5 ms")))


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_events_have_the_same_bits(algorithm: str) -> None:
    event = {"at": "3 ms", "for": "4 ms", "fault": "bias", "on": "b.u", "value": 2.0}
    assert "bias" in str(require_the_same(ramp_into_keep(event, algorithm=algorithm))[4])
    assert "loss" in str(require_the_same(bonded({"at": "0.03 s", "fault": "loss", "on": "q.e"}, stop="0.2"))[4])


@needs_gcc
def test_runs_that_keep_pace_have_the_same_bits(tmp_path: Path) -> None:
    system = load_system(str(ring(tmp_path, 3, stop="20 ms")))
    plan = make_plan(system, "")
    assert require_the_same(plan, interpreted=False, pace=Pace(FASTEST))[0] == require_the_same(make_plan(system))[0]


def by_hand_and_back(folder: Path, **life: Any) -> tuple[Any, ...]:
    """Steps by hand, a snapshot, another way from there, back and to the end."""
    moody(folder / "g.fmu")
    system = load_system(str(ring(folder, 3, stop="30 ms", closed=False)))
    with Stepping(make_plan(system), **life) as session:
        for k in range(10):
            session.set("c0.u", 0.1 * k)
            session.step()
        here = session.snapshot()
        session.set("c0.u", -1.0)
        session.step("5 ms")
        between = session.get("c2.y")
        session.restore(here)
        session.finish()
        return between, bits(session.run())


def stopped_and_on(folder: Path, **life: Any) -> tuple[Any, ...]:
    """A run that is asked to stop within a cycle, and goes on."""
    plan = make_plan(replace(load_system(str(ring(folder, 3, stop="10 ms"))), algorithm="jacobi"))
    with Session(plan, **life) as session:
        session.advance(cycles=3)
        session.control[cells.STOP_REQUEST] = 1
        session.advance()
        at, session.failure = (session.at.cycle, session.at.operation, session.failure), ""
        session.control[cells.STOP_REQUEST] = 0
        session.revive()
        session.advance()
        return at, bits(session.run())


@needs_gcc
def test_steps_by_hand_stops_and_snapshots_have_the_same_bits(tmp_path: Path) -> None:
    assert by_hand_and_back(tmp_path, fuses=False) == by_hand_and_back(tmp_path, fuses=True)


@needs_gcc
def test_a_stop_request_ends_both_at_the_same_operation_and_both_go_on(tmp_path: Path) -> None:
    ends = [stopped_and_on(tmp_path, fuses=fuses) for fuses in (False, True)]
    assert ends[0] == ends[1] and ends[0][0][2].startswith("interrupted")


def rows_of(*rows: tuple[int, ...]) -> np.ndarray:
    return np.array([[*row, *[0] * (len(COLUMNS) - len(row))] for row in rows], dtype=np.int64)


def test_rows_end_where_a_run_can_be_entered_or_left() -> None:
    turn = [(SET, 1, 0), (STEP, 1, 0), (GET, 1, 0)]
    rows = rows_of(
        (COPY, 0, -1), (MOVE, 0, -1), (COPY, 1, -1), *turn, (STEP, 1, 1), (RECORD, 1, -1), (REPEAT, 1, -1, 4)
    )
    found = [(row.code, row.first, row.last) for row in fuse(rows, [True, False])]
    # The stop is asked for where the instant changes, component 1 takes no turns, and REPEAT enters at operation 4.
    assert found == [(MOVES, 0, 2), (0, 2, 3), (0, 3, 4), (TURNS, 4, 6), (0, 6, 7), (0, 7, 8), (0, 8, 9)]
    found = [(row.code, row.first, row.last) for row in fuse(rows[:-1], [True, True])]
    assert found == [(MOVES, 0, 2), (TURNS, 2, 7), (0, 7, 8)]


def test_a_copy_with_gain_1_is_no_move() -> None:
    """1 z + 0 of -0.0 is 0.0."""
    z, one = np.array([-0.0, 7.0, 7.0]), np.array([1.0, 0.0])
    moves = np.zeros((2, turns.MOVE_COLUMNS), dtype=np.int64)
    moves[:, turns.TO], moves[:, turns.COEFFICIENT] = [1, 2], [0, -1]
    turns.move(moves, 0, 2, z, one)
    assert np.signbit(z).tolist() == [True, False, True]


@needs_gcc
def test_the_plan_says_what_is_done_in_one_go(tmp_path: Path) -> None:
    system = load_system(str(ring(tmp_path, 9, stop="10 ms")))
    text = explain(make_plan(replace(system, algorithm="jacobi")))
    assert "done in one go (the loop has 3 rows)\n          1-9  moves       9 transfers\n" in text
    assert "        10-36  turns       c0, c1, c2, c3, c4, 4 more" in text
    text = explain(make_plan(replace(system, algorithm="gauss-seidel")))
    assert "         1-36  turns       c0, c1, c2, c3, c4, 4 more, with 9 transfers before they are set" in text
