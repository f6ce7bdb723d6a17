"""Where a cycle goes back or on, or looks for events, its segments have machine code of their own: the same bits."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from event_cases import bonded, ramp_into_keep
from helpers import plan_of, read_system
from native_build import moody, needs_gcc
from rovbrush.orchestrator.loop.operations import ITERATE, PAUSE, REPEAT, SEGMENT
from rovbrush.orchestrator.loop.straight.text import COVERED
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.plan.speed.straight import worth_of
from rovbrush.orchestrator.run.blocks.straight_on import ALWAYS
from rovbrush.orchestrator.run.pacing.pace import FASTEST, Pace
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.studies.bench.fmus.native import ring
from rovbrush.orchestrator.system.file.reader import load_system
from test_fused import CAR, KINDS
from test_straight import require_the_same


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel", "iterated"])
def test_events_have_the_same_bits(algorithm: str) -> None:
    event = {"at": "3 ms", "for": "4 ms", "fault": "bias", "on": "b.u", "value": 2.0}
    assert "bias" in str(require_the_same(ramp_into_keep(event, algorithm=algorithm), covered=None)[4])


def test_losses_in_a_bond_have_the_same_bits() -> None:
    plan = bonded({"at": "0.03 s", "fault": "loss", "on": "q.e"}, stop="0.2")
    assert "loss" in str(require_the_same(plan, covered=None)[4])


@needs_gcc
@pytest.mark.parametrize("algorithm", ["jacobi", "iterated"])
def test_runs_that_keep_pace_have_the_same_bits(algorithm: str, tmp_path: Path) -> None:
    system = replace(load_system(str(ring(tmp_path, 3, stop="20 ms"))), algorithm=algorithm)
    plan = make_plan(system, "")
    with Session(plan, pace=Pace(FASTEST), straight=ALWAYS) as session:
        session.advance()
        assert any(program.segments for program in session._blocks._programs.values())
        paced = [table.tobytes() for table in session.run().tables]
    assert paced == require_the_same(make_plan(system))[0]


@needs_gcc
@pytest.mark.parametrize(
    "bad",
    [
        {"ON_STEP": "if (t > 0.0049) return fmi2Error;"},
        {"ON_STEP": "if (t > 0.0049) m->x = 0.0 / 0.0;"},
        {"ON_SET": "if (m->steps == 5) return fmi2Error;"},
        {"ON_GET": "if (m->steps == 5) return fmi2Fatal;"},
    ],
    ids=["error", "nan", "set", "get"],
)  # fmt: skip
def test_who_fails_in_a_segment_is_named_as_ever(bad: dict[str, str], tmp_path: Path) -> None:
    moody(tmp_path / "m.fmu", **bad)
    moody(tmp_path / "g.fmu")
    parts = {"g": ("g.fmu", "1 ms"), "m": ("m.fmu", "1 ms"), "f": ("g.fmu", "1 ms")}
    wires = ["g.x -> m.u", "m.x -> g.u", "m.y -> f.u"]
    plan = make_plan(read_system(tmp_path, tmp_path, parts, wires, "10 ms", algorithm="iterated"))
    assert "component m" in require_the_same(plan)[2]


def car(algorithm: str, folder: Path, fmus: Path) -> Plan:
    parts, wires = CAR
    if algorithm in ("ecco", "adaptive"):
        parts = {name: (fmu, "2 ms") for name, (fmu, _) in parts.items()}
    return plan_of(folder, fmus, parts, wires, stop="100 ms", algorithm=algorithm, **KINDS[algorithm])


@pytest.mark.parametrize("algorithm", KINDS)
def test_a_segment_is_of_one_instant_and_nobody_goes_on_in_its_midst(
    algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    plan = car(algorithm, tmp_path, fmus)
    codes, ticks = plan.cycle[:, 0], plan.cycle[:, 1]
    entered = plan.cycle[np.isin(codes, (ITERATE, REPEAT)), 3].tolist()
    for first, last in worth_of(plan).segments:
        assert COVERED.issuperset(codes[first:last].tolist())
        assert len(set(ticks[first:last].tolist())) == 1
        assert not any(first < m < last for m in entered)


def test_the_loop_has_a_row_for_each_segment_and_one_for_every_other_operation(tmp_path: Path, fmus: Path) -> None:
    plan = car("iterated", tmp_path, fmus)
    worth = worth_of(plan)
    with Session(plan, straight=ALWAYS) as session:
        session.advance(cycles=2)
        (program,) = session._blocks._programs.values()
    assert np.sum(program.rows[:, 0] == SEGMENT) == len(worth.segments)
    assert len(program.rows) == len(plan.cycle) - worth.operations + len(worth.segments)
    segments = np.flatnonzero(program.rows[:, 0] == SEGMENT)
    assert program.begins[segments].tolist() == [first for first, _ in worth.segments]
    assert f"{worth.operations} of {len(plan.cycle)} operations, in {len(worth.segments)} segments" in explain(plan)


def test_what_stands_between_segments_is_looked_up() -> None:
    plan = ramp_into_keep({"at": "3 ms", "fault": "bias", "on": "b.u", "value": 2.0}, algorithm="jacobi")
    pauses = np.flatnonzero(plan.cycle[:, 0] == PAUSE).tolist()
    assert pauses and not any(first <= m < last for m in pauses for first, last in worth_of(plan).segments)
