"""Events of FMUs for Model Exchange among other components: rows of the results, seen by others at their instants."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import exchange_build
import numpy as np
import pytest
from clock_build import clocked
from helpers import column, edited, last, plan_of, run_of
from native_build import needs_gcc
from rovbrush.orchestrator.fmu.types import decode
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.tables import EventRow, Run
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc
BALL = {"e": 0.9}
TIGHT = {"tolerance": 1e-10}


def impacts(count: int, g: float = 9.81, e: float = 0.9) -> list[float]:
    first = math.sqrt(2.0 / g)
    return [first * (1.0 + 2.0 * sum(e**i for i in range(1, k + 1))) for k in range(count)]


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("group")
    for name in ("ball", "striker", "struck", "stick_slip", "relay", "lag", "moody"):
        exchange_build.exchange(folder, name)
    for name in ("witness", "plant", "square"):
        clocked(folder / f"{name}.fmu", name)
    return folder


def cell(run: Run, row: EventRow, name: str) -> float | int:
    """A recorded signal in a row of the events."""
    keys = [".".join(key) for group in run.plan.groups for key in group.columns]
    component, variable = name.split(".", 1)
    kind = run.plan.system.components[component].fmu.type_of(variable)
    assert kind is not None
    at = keys.index(name)
    found: float | int = decode(kind, row.cells[at : at + 1])[0].item()
    return found


def rows_at(run: Run, time: float) -> list[EventRow]:
    return [row for row in run.events if row.time == time]


def told(run: Run, words: str) -> list[float]:
    """The instants of events that are said in these words."""
    return [row.time for row in run.events if words in row.what]


def changes(run: Run, name: str) -> list[float]:
    """The instants at which a recorded signal changes by what happens there."""
    times = dict.fromkeys(row.time for row in run.events)
    return [t for t in times if cell(run, rows_at(run, t)[0], name) != cell(run, rows_at(run, t)[-1], name)]


def same(first: Run, second: Run) -> bool:
    rows = [[(row.time, row.number, row.what, row.cells.tobytes()) for row in run.events] for run in (first, second)]
    return rows[0] == rows[1] and [t.tobytes() for t in first.tables] == [t.tobytes() for t in second.tables]


@pytest.mark.parametrize("method", ["dormand-prince", "cvode"])
@pytest.mark.parametrize("periods", [("10 ms", "10 ms"), ("10 ms", "1 ms"), ("3 ms", "7 ms")])
@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_impacts_of_a_ball_are_seen_by_an_fmu_with_event_mode_at_their_instants(
    algorithm: str, periods: Sequence[str], method: str, tmp_path: Path, fmus: Path
) -> None:
    parts = {"ball": ("ball", periods[0], BALL), "w": ("witness", periods[1])}
    solver = {"solver": {"method": method, **TIGHT}}
    run = run_of(tmp_path, fmus, parts, ["ball.hits -> w.n", "ball.v -> w.u (hold)"], stop="7.5 s",
                 algorithm=algorithm, **solver)  # fmt: skip
    times = told(run, "ball has an event")
    exact = impacts(len(times))
    assert len(times) >= 20 and times == pytest.approx(exact, abs=1e-9, rel=0)
    for k, time in enumerate(times):
        rows = rows_at(run, time)
        assert [row.number for row in rows] == list(range(len(rows))) and len(rows) >= 2
        before, after = rows[0], rows[-1]
        assert cell(run, before, "ball.v") < 0.0 and cell(run, before, "ball.hits") == k
        assert cell(run, after, "ball.v") == -0.9 * cell(run, before, "ball.v")
        assert cell(run, after, "w.at") == time  # the same instant, to the bit
        assert cell(run, after, "w.u_then") == cell(run, after, "ball.v")
        assert cell(run, after, "w.changes") == cell(run, after, "ball.hits") == k + 1


def test_a_discrete_signal_is_held_up_to_the_instant_of_its_event_and_not_further(tmp_path: Path, fmus: Path) -> None:
    """x' = the time of the last switch, of a component without events that can vary its step."""
    parts = {"relay": ("relay", "10 ms", {"low": 0.3, "high": 0.7}), "lag": ("lag", "10 ms"), "p": ("plant", "10 ms")}
    wires = ["lag.x -> relay.y", "relay.on -> lag.on", "relay.t_switch -> p.u"]
    run = run_of(tmp_path, fmus, parts, wires, stop="4 s", solver=TIGHT)
    switched = [0.0, *changes(run, "relay.switches"), 4.0]
    up, half = math.log(1 / 0.3), math.log(0.7 / 0.3)
    assert switched[1:-1] == pytest.approx([up + k * half for k in range(len(switched) - 2)], abs=1e-8)
    exact = math.fsum(a * (b - a) for a, b in pairwise(switched))
    assert last(run, "p.x") == pytest.approx(exact, abs=1e-12)


def test_who_cannot_vary_its_step_sees_it_at_its_next_instant_and_the_plan_says_so(tmp_path: Path, fmus: Path) -> None:
    fixed = {'canHandleVariableCommunicationStepSize="true"': 'canHandleVariableCommunicationStepSize="false"'}
    edited(fmus / "plant.fmu", tmp_path / "plant.fmu", {}, fixed)
    parts = {"ball": ("ball", "10 ms", BALL), "p": (str(tmp_path / "plant.fmu"), "10 ms")}
    plan = plan_of(tmp_path, fmus, parts, ["ball.hits -> p.u"], stop="0.6 s", algorithm="jacobi", solver=TIGHT)
    assert "p sees events up to 10 ms late, at its own instants: its step cannot vary" in explain(plan)
    run = simulate(plan)
    assert last(run, "p.x") == pytest.approx(0.6 - math.ceil(impacts(1)[0] * 100) / 100, abs=1e-12)


def test_those_that_a_slower_group_averages_pass_it_and_the_plan_says_so(tmp_path: Path, fmus: Path) -> None:
    parts = {"ball": ("ball", "10 ms", BALL), "p": ("plant", "1 ms")}
    plan = plan_of(tmp_path, fmus, parts, ["ball.hits -> p.u", "p.x -> ball.u"], stop="0.6 s", solver=TIGHT)
    assert "ball is passed by p, as ball.u is the mean over its whole step" in explain(plan)
    held = plan_of(tmp_path, fmus, parts, ["ball.hits -> p.u", "p.x -> ball.u (hold)"], stop="0.6 s", solver=TIGHT)
    assert "first to the instants of others, by parts of its steps: ball" in explain(held)
    assert not simulate(plan).failure


@pytest.mark.parametrize("transfer", ["hold", "linear", "quadratic"])
@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_a_group_that_goes_ahead_is_extrapolated_from_its_own_instants(
    algorithm: str, transfer: str, tmp_path: Path, fmus: Path
) -> None:
    """A plant x' = u every 1 ms, u from a lag y = 1 - exp(-t) every 10 ms; held it is that of the group's last part."""
    parts = {"lag": ("lag", "10 ms", {"=push": 1.0}), "relay": ("relay", "10 ms"), "p": ("plant", "1 ms")}
    wires = ["lag.x -> relay.y", f"lag.x -> p.u ({transfer})"]
    plan = plan_of(tmp_path, fmus, parts, wires, stop="1 s", algorithm=algorithm, solver=TIGHT)
    assert plan.events is not None and set(plan.events.ahead) == {"lag", "relay"}
    run = simulate(plan)
    assert last(run, "p.x") == pytest.approx(
        math.exp(-1.0), abs=4e-4 if transfer == "hold" else 3e-5
    )  # 5 h^2 / 12 of x1 - x0 by lines


def test_the_plan_says_who_steps_before_a_source_of_events(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("witness", "10 ms"), "ball": ("ball", "10 ms", BALL)}
    wires, words = ["ball.hits -> w.n"], "w: before ball in the order, sees its events at the next instant"
    assert words not in explain(plan_of(tmp_path, fmus, parts, wires, stop="0.6 s", solver=TIGHT))
    stated = plan_of(tmp_path, fmus, parts, wires, stop="0.6 s", order=["w", "ball"], solver=TIGHT)
    assert words in explain(stated)
    run = simulate(stated)
    assert cell(run, run.events[-1], "w.at") == 0.46  # the impact is at 0.4515 s


PUCKS = ["b.x -> a.x2", "b.v -> a.v2", "a.J -> b.J", "a.n -> b.n"]


@pytest.mark.parametrize("method", ["dormand-prince", "cvode"])
def test_two_pucks_that_hit_each_other_keep_momentum_and_energy(method: str, tmp_path: Path, fmus: Path) -> None:
    parts = {
        "a": ("striker", "10 ms", {"m": 2.0, "m2": 0.5, "wall": -1.0, "side": -1.0, "v": 1.0}),
        "b": ("struck", "10 ms", {"m": 0.5, "wall": 1.5, "x": 1.0}),
    }
    run = run_of(tmp_path, fmus, parts, PUCKS, stop="6 s", solver={"method": method})
    hits = changes(run, "a.n")
    assert len(hits) >= 4
    for time in hits:
        before, after = rows_at(run, time)[0], rows_at(run, time)[-1]
        p = [2.0 * cell(run, row, "a.v") + 0.5 * cell(run, row, "b.v") for row in (before, after)]
        energy = [cell(run, row, "a.v") ** 2 + 0.25 * cell(run, row, "b.v") ** 2 for row in (before, after)]
        assert p[0] == pytest.approx(p[1], abs=1e-12) and energy == pytest.approx([1.0, 1.0], abs=1e-12)


@pytest.mark.parametrize("method", ["dormand-prince", "cvode"])
def test_a_block_on_a_belt_sticks_and_slips_at_the_exact_times(method: str, tmp_path: Path, fmus: Path) -> None:
    slipping, sticking = 2.0 * math.pi - 2.0 * math.atan(0.4 / 0.2), 2.0 * 0.4 / 0.2
    exact = [5.0 + k * (slipping + sticking) + more for k in range(3) for more in (0.0, slipping)]
    solver = {"method": method, **TIGHT}
    run = run_of(tmp_path, fmus, {"s": ("stick_slip", "10 ms")}, stop=f"{exact[-1] + 0.1:.3g} s", solver=solver)
    assert changes(run, "s.switches") == pytest.approx(exact, abs=1e-8, rel=0)


def test_time_events_of_a_group_happen_at_their_times(tmp_path: Path, fmus: Path) -> None:
    parts = {"m": ("moody", "10 ms", {"period": 0.033}), "w": ("witness", "10 ms")}
    run = run_of(tmp_path, fmus, parts, ["m.n -> w.n"], stop="1 s")
    times = told(run, "m has a time event")
    assert times == pytest.approx([0.033 * k for k in range(1, 31)], rel=4e-16)
    assert [cell(run, rows_at(run, t)[-1], "w.at") for t in times] == times


def eventful(folder: Path, fmus: Path, algorithm: str) -> Plan:
    """A ball, what sees it, an FMU with time events of its own, and one without any."""
    parts = {
        "ball": ("ball", "10 ms", BALL), "w": ("witness", "4 ms"), "s": ("square", "15 ms", {"half": 0.0701}),
        "p": ("plant", "6 ms"),
    }  # fmt: skip
    wires = ["ball.hits -> w.n", "s.y -> w.u (hold)", "ball.hits -> p.u", "p.x -> ball.u (hold)"]
    return plan_of(folder, fmus, parts, wires, stop="1.5 s", algorithm=algorithm)


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_a_run_is_the_same_bits_compiled_interpreted_and_cut(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    plan = eventful(tmp_path, fmus, algorithm)
    whole = simulate(plan)
    assert not whole.failure and len(told(whole, "ball has an event")) >= 2
    assert last(whole, "w.w") == pytest.approx(1.5 - 2 * _low(1.5, 0.0701), abs=1e-12)
    assert same(whole, simulate(plan, interpreted=True))
    with Session(plan) as session:
        while session.tick < plan.clock.stop:
            session.advance(cycles=1)
        assert same(whole, session.run())


def _low(stop: float, half: float) -> float:
    """How long a square wave is below 0."""
    whole = int(stop / half)
    return whole // 2 * half + (stop - whole * half if whole % 2 else 0.0)


@pytest.mark.parametrize("isolation", ["none", "process"])
def test_event_mode_off_and_other_algorithms_handle_events_inside(isolation: str, tmp_path: Path, fmus: Path) -> None:
    of = {"ball": {"event_mode": "off", "isolation": isolation}}
    off = run_of(tmp_path, fmus, {"ball": ("ball", "10 ms", BALL)}, stop="2 s", of=of)
    on = run_of(tmp_path, fmus, {"ball": ("ball", "10 ms", BALL)}, stop="2 s")
    assert not off.events and on.events
    assert column(off, "ball.h")[1] == pytest.approx(column(on, "ball.h")[1], abs=1e-6)
    parts = {"ball": ("ball", "10 ms", BALL)}
    iterated = run_of(tmp_path, fmus, parts, stop="2 s", algorithm="iterated")
    assert not iterated.events and iterated.plan.events is None
    assert np.array_equal(column(iterated, "ball.hits")[1], column(on, "ball.hits")[1])


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize(("at", "last_row"), [(0.55, 0.55), (0.553, 0.55), (1.0, 1.0)])
def test_who_asks_to_end_at_an_event_leaves_the_rows_of_its_instant(
    at: float, last_row: float, interpreted: bool, tmp_path: Path, fmus: Path
) -> None:
    parts = {"m": ("moody", "10 ms", {"fault": 6, "at": at}), "p": ("plant", "10 ms")}
    with Session(plan_of(tmp_path, fmus, parts, ["m.x -> p.u (hold)"], stop="1 s"), interpreted) as session:
        session.advance()
        run = session.run()
    assert not run.failure and f"asked to end the simulation at t = {at:g} s" in str(run.ended)
    for name in ("m.x", "p.x"):
        time, _ = column(run, name)
        assert time[-1] == last_row and len(time) == round(100 * last_row) + 1
    assert last(run, "m.x") == pytest.approx(last_row, abs=1e-12) and run.events[-1].time == at
