"""Event mode, clocks and partitions in a run: exact ticks, values at them, what follows what."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from clock_build import built, clocked
from helpers import column, last, plan_of, run_of
from native_build import needs_gcc
from rovbrush.orchestrator.fmu.types import decode
from rovbrush.orchestrator.results.summary import summary
from rovbrush.orchestrator.results.tables import AT_START, Run
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc

LOOP = ["p.x -> c.y", "c.u -> p.u"]


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("clocks"))


def number(run: Run, name: str) -> int:
    """The last value of an Int64 signal."""
    component, variable = name.split(".")
    kind = run.plan.system.components[component].fmu.type_of(variable)
    assert kind is not None
    return int(decode(kind, column(run, name)[1][-1:])[0])


def instants(run: Run, words: str) -> list[float]:
    """The times at which something happened that is said in these words."""
    return [row.time for row in run.events if words in row.what]


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize("period", ["1/60 s", "100 ms", "1 s"])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_a_clocked_controller_and_its_plant_are_the_recursion_whatever_the_periods(
    algorithm: str, period: str, interpreted: bool, tmp_path: Path, fmus: Path
) -> None:
    parts = {"c": ("controller", period, {"k": 6.0}), "p": ("plant", "1 ms")}
    run = run_of(tmp_path, fmus, parts, LOOP, stop="2 s", algorithm=algorithm, interpreted=interpreted)
    assert instants(run, "c.tick ticks") == [float(Fraction(k, 60)) for k in range(121)]
    assert number(run, "c.ticks") == 121
    times, x = column(run, "p.x")
    exact = [1 - 0.9 ** int(t * 60 + 1e-9) * (1 - 6 * (t - int(t * 60 + 1e-9) / 60)) for t in times]
    assert x == pytest.approx(np.array(exact), abs=1e-13)


def test_clocked_control_does_not_drift(tmp_path: Path, fmus: Path) -> None:
    parts = {"c": ("controller", "1/60 s", {"k": 6.0}), "p": ("plant", "1 ms")}
    run = run_of(tmp_path, fmus, parts, LOOP, stop="50 s")
    ticks = [float(Fraction(k, 60)) for k in range(3001)]
    assert instants(run, "c.tick ticks") == ticks and number(run, "c.ticks") == 3001
    times, at = column(run, "c.at")
    assert times.tolist() == ticks and np.all(np.abs(at - times) <= np.spacing(times))


def test_a_ball_hits_the_ground_at_the_times_of_the_closed_form(tmp_path: Path, fmus: Path) -> None:
    run = run_of(tmp_path, fmus, {"ball": ("ball", "10 ms")}, stop="2.5565 s")
    tau = math.sqrt(2 / 9.81)
    exact = [tau * (1 + 2 * sum(0.7**k for k in range(1, i + 1))) for i in range(20)]
    assert instants(run, "ball has an event") == pytest.approx(exact, abs=1e-12)
    assert number(run, "ball.bounces") == 20
    off = run_of(tmp_path, fmus, {"ball": ("ball", "10 ms")}, stop="2.5565 s", of={"ball": {"event_mode": "off"}})
    assert not off.events and last(off, "ball.hit") == pytest.approx(last(run, "ball.hit"), abs=1e-12)


def test_a_time_event_that_an_fmu_announces_happens_at_its_time(tmp_path: Path, fmus: Path) -> None:
    run = run_of(tmp_path, fmus, {"s": ("square", "100 ms")}, stop="2 s")
    times, y = column(run, "s.y")
    assert y.tolist() == [1 - 2 * (int(t / 0.25 + 1e-9) % 2) for t in times]
    assert number(run, "s.changes") == 8


def test_a_countdown_clock_ticks_after_exactly_what_its_fmu_says(tmp_path: Path, fmus: Path) -> None:
    run = run_of(tmp_path, fmus, {"c": ("countdown", "1 s", {"limit": 12})}, stop="3 s")
    exact = [float(sum((Fraction(100 + i, 1000) for i in range(k + 1)), Fraction(0))) for k in range(12)]
    assert instants(run, "c.fire ticks") == exact
    assert (last(run, "c.at"), number(run, "c.fired")) == (pytest.approx(exact[-1], abs=1e-15), 12)


def test_an_output_clock_ticks_the_clock_that_it_is_connected_with(tmp_path: Path, fmus: Path) -> None:
    parts = {"a": ("producer", "100 ms"), "b": ("consumer", "250 ms")}
    run = run_of(tmp_path, fmus, parts, ["a.crossing -> b.sample", "a.count -> b.v"], stop="10 s")
    assert instants(run, "b.sample ticks with a.crossing") == pytest.approx([k / 3 for k in range(1, 31)], abs=1e-14)
    assert (number(run, "b.ticks"), number(run, "b.sum")) == (30, 30 * 31 // 2)


def test_an_armed_countdown_fires_after_its_delay(tmp_path: Path, fmus: Path) -> None:
    parts = {"a": ("producer", "100 ms", {"f": 2.0}), "c": ("countdown", "1 s", {"first": 0})}
    run = run_of(tmp_path, fmus, parts, ["a.crossing -> c.arm"], stop="2 s")
    assert instants(run, "c.fire ticks") == [0.525, 1.025, 1.525]


def test_partitions_run_at_the_ticks_of_their_clocks(tmp_path: Path, fmus: Path) -> None:
    parts = {"a": ("partitions", "100 ms", {"=u": 1.0}), "b": ("consumer", "1 s")}
    run = run_of(tmp_path, fmus, parts, ["a.alarm -> b.sample", "a.n_burst -> b.v"], stop="2 s")
    slow = [float(Fraction(k, 30)) for k in range(61)]
    assert instants(run, "a.fast") == [k / 100 for k in range(201)] and instants(run, "a.slow") == slow
    burst = [float(Fraction(k, 30) + Fraction(5, 1000)) for k in range(2, 60, 3)]
    assert instants(run, "a.burst") == instants(run, "b.sample ticks with a.alarm") == burst
    counts = {name: number(run, f"a.n_{name}") for name in ("fast", "slow", "burst")}
    assert counts == {"fast": 201, "slow": 61, "burst": 20}
    assert last(run, "a.y") == pytest.approx(1 - 0.75**201, abs=1e-15)
    assert (number(run, "b.ticks"), number(run, "b.sum")) == (20, 210)


def test_a_partition_controls_a_plant(tmp_path: Path, fmus: Path) -> None:
    parts = {"a": ("partitions", "10 ms", {}), "p": ("plant", "1 ms")}
    run = run_of(tmp_path, fmus, parts, ["p.x -> a.u", "a.y -> p.u"], stop="1 s")
    x, y = 0.0, 0.0
    for _ in range(100):
        y += (x - y) / 4
        x += 0.01 * y
    assert last(run, "p.x") == pytest.approx(x, abs=1e-13)


@pytest.mark.parametrize("clock", ["fixed", "tunable"])
def test_an_interval_is_set_from_the_file_or_taken_over_from_a_clock(clock: str, tmp_path: Path, fmus: Path) -> None:
    tick = f'intervalVariability="{clock}" intervalDecimal="0.1" supportsFraction="true"'
    clocked(fmus / "free.fmu", "controller", tick=tick)
    run = run_of(tmp_path, fmus, {"c": ("free", "1 s")}, stop="1 s", of={"c": {"clocks": {"tick": "1/7 s"}}})
    assert instants(run, "c.tick") == [float(Fraction(k, 7)) for k in range(8)]
    parts = {"c": ("free", "1 s"), "d": ("controller", "1 s")}
    run = run_of(tmp_path, fmus, parts, ["d.tick -> c.tick"], stop="1 s")
    assert instants(run, "c.tick") == instants(run, "d.tick") == [float(Fraction(k, 60)) for k in range(61)]


def test_a_triggered_clock_ticks_with_a_periodic_one_of_another_fmu(tmp_path: Path, fmus: Path) -> None:
    parts = {"c": ("controller", "1 s"), "b": ("consumer", "1 s")}
    run = run_of(tmp_path, fmus, parts, ["c.tick -> b.sample", "c.ticks -> b.v"], stop="1 s")
    assert (number(run, "b.ticks"), number(run, "b.sum")) == (61, 61 * 62 // 2)


def test_a_value_that_changes_at_an_instant_is_an_event_for_a_discrete_input(tmp_path: Path, fmus: Path) -> None:
    """A square wave whose half period is an input: discrete, without a clock; it is set in event mode only."""
    clocked(fmus / "driven.fmu", "square", changes={"half": 'variability="discrete"'}, causalities={"half": "input"})
    alone = run_of(tmp_path, fmus, {"s": ("driven", "1 s", {"=half": 0.5})}, stop="2 s")
    assert number(alone, "s.changes") == 4
    parts = {"s": ("driven", "1 s"), "p": ("plant", "250 ms", {"x0": 1.0, "=u": 1.0})}
    run = run_of(tmp_path, fmus, parts, ["p.x -> s.half"], stop="3 s")
    assert run.plan.events is not None and run.plan.events.watched == ("p",)
    assert [row.time for row in run.events if row.number == 0] == [0.25 * k for k in range(13)]
    assert last(run, "s.half") == 4.0


def test_events_that_do_not_settle_are_an_error_with_the_rows_until_then(tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, {"s": ("square", "100 ms", {"half": 1e-300})}, stop="1 s"))
    assert run.failure.startswith(
        "the events at t = 1e-300 s do not settle: after 1000 rounds s still asks for another one"
    )


def test_a_time_event_that_is_announced_for_a_time_that_is_over_is_named_and_rows_are_kept(
    tmp_path: Path, fmus: Path
) -> None:
    run = simulate(plan_of(tmp_path, fmus, {"s": ("square", "100 ms", {"stuck": 2.0})}, stop="1 s"))
    assert run.failure.startswith("the events at t = 0.5 s do not settle")
    assert run.failure.endswith("; s announced a next event that is not behind this instant")
    assert len(run.tables[0]) == 5  # at 0, 0.1 ... 0.4 s
    assert [row.what for row in run.events if row.what not in ("", AT_START)][:2] == ["s has a time event"] * 2


def test_a_summary_tells_so_many_events_and_counts_the_others(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(summary, "MOST_TOLD", 3)
    run = run_of(tmp_path, fmus, {"s": ("square", "100 ms")}, stop="2 s")
    told = summary.summarize(run)["events"]
    assert told[:3] == [f"t = {0.25 * k:g} s: s has a time event" for k in (1, 2, 3)]
    more = [row for row in run.events if row.what not in ("", AT_START)][3:]
    assert more and told[3:] == [f"and {len(more)} more, all in the group `events` of result.nc"]
