"""What happens in a run by `[[events]]`: at which instant, on whom, and the same whatever runs it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from event_cases import (
    FIXED,
    INTEGRAL,
    KEEP,
    RAMP,
    SUM,
    bonded,
    planned,
    ramp_into_keep,
    without_events,
)
from helpers import column
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.opened import open_result
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.results.tables import AT_START, EventRow, Run
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping

ALL_AT_ONCE = ("gauss-seidel", "jacobi")


def both(plan: Plan) -> Run:
    """The run of a plan, compiled, after a look that the interpreted one gives the same bits and events."""
    run, other = simulate(plan), simulate(plan, interpreted=True)
    assert not run.failure and not other.failure
    assert happened(run) == happened(other)
    assert [row.cells.tobytes() for row in run.events] == [row.cells.tobytes() for row in other.events]
    assert [table.tobytes() for table in run.tables] == [table.tobytes() for table in other.tables]
    return run


def happened(run: Run) -> list[tuple[float, int, str]]:
    """Time, number and (first) event of all that happened."""
    return [(row.time, row.number, row.what.partition(":")[0]) for row in told(run)]


def told(run: Run) -> list[EventRow]:
    """The rows that say what happened: those before it, and the first of a run, do not."""
    return [row for row in run.events if row.what not in ("", AT_START)]


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi", "iterated"])
def test_a_value_that_is_set_counts_from_its_instant_on(algorithm: str) -> None:
    """y' = u with u = 0, then 2 from 4 ms on, then 5 from 7 ms on."""
    events = [{"at": "4 ms", "set": {"i.u": 2.0}}, {"name": "more", "at": "7 ms", "set": {"i.u": 5}}]
    run = both(planned({"i": (INTEGRAL, "0.001"), "r": (RAMP, "0.001")}, [], events, "0.01", algorithm=algorithm))
    t, y = column(run, "i.y")
    exact = 2.0 * np.clip(t - 0.004, 0.0, 0.003) + 5.0 * np.clip(t - 0.007, 0.0, None)
    assert y.tolist() == pytest.approx(exact.tolist(), abs=1e-15)
    later = algorithm == "iterated"  # whose rows of an instant are written before its events; others' behind them
    assert column(run, "i.u")[1].tolist() == [0.0] * (4 + later) + [2.0] * 3 + [5.0] * (4 - later)
    assert happened(run) == [(0.004, 1, "event 1"), (0.007, 1, "more")]


def test_tunable_parameters_are_set_too() -> None:
    parts = {"i": (INTEGRAL, "0.001")}
    run = both(planned(parts, [], [{"at": 0, "set": {"i.u": 1}}, {"at": "5 ms", "set": {"i.k": -3}}], "0.01"))
    assert column(run, "i.y")[1][-1] == pytest.approx(0.005 - 3.0 * 0.005, abs=1e-15)


@pytest.mark.parametrize("algorithm", ALL_AT_ONCE)
def test_a_value_that_is_set_off_the_grid_counts_from_exactly_then_where_steps_can_vary(algorithm: str) -> None:
    """y' = k u: the step of 5 ms from 0 ends at 3.21 ms, and another one from there to 5 ms begins."""
    events = [{"at": "3.21 ms", "set": {"i.u": 2.0}}, {"at": "1/70 s", "set": {"i.u": -1.0, "i.k": 3.0}}]
    run = both(planned({"i": (INTEGRAL, "0.005")}, [], events, "0.02", algorithm=algorithm))
    t, y = column(run, "i.y")
    exact = 2.0 * np.clip(t - 0.00321, 0.0, 1 / 70 - 0.00321) - 3.0 * np.clip(t - 1 / 70, 0.0, None)
    assert y.tolist() == pytest.approx(exact.tolist(), abs=1e-16)
    assert [(row.time, row.number) for row in run.events] == [
        (0.0, 0), (0.00321, 0), (0.00321, 1), (1 / 70, 0), (1 / 70, 1)
    ]  # fmt: skip


@pytest.mark.parametrize("algorithm", ALL_AT_ONCE)
def test_what_happens_before_the_next_instant_of_a_fixed_step_acts_there_and_not_earlier(algorithm: str) -> None:
    """The step of 5 ms from 0 is done when it ends, at 5 ms; what happens at 3 ms must not act from 0 on."""
    parts = {"i": (FIXED, "0.005"), "fast": (RAMP, "0.001")}
    run = both(planned(parts, [], [{"at": "3 ms", "set": {"i.u": 1.0}}], "0.02", algorithm=algorithm))
    assert column(run, "i.y")[1].tolist() == pytest.approx([0.0, 0.0, 0.005, 0.010, 0.015])
    assert happened(run) == [(0.005, 1, "event 1")]


def test_one_event_acts_on_each_component_at_the_instant_of_that() -> None:
    parts = {"slow": (FIXED, "0.005"), "fast": (INTEGRAL, "0.002")}
    run = both(planned(parts, [], [{"at": "3 ms", "set": {"slow.u": 1.0, "fast.u": 1.0}}], "0.02"))
    assert column(run, "fast.y")[1][-1] == pytest.approx(0.017) and column(run, "slow.y")[1][-1] == pytest.approx(0.015)
    assert [(row.time, row.what) for row in told(run)] == [
        (0.003, "event 1: fast.u = 1"), (0.005, "event 1: slow.u = 1")
    ]  # fmt: skip


@pytest.mark.parametrize("start", ["-0.003", "0.002"])
def test_times_are_those_of_the_run(start: str) -> None:
    from fractions import Fraction

    parts, events = {"i": (INTEGRAL, "0.001")}, [{"at": "4 ms", "set": {"i.u": 1.0}}]
    run = both(planned(parts, [], events, "0.01", start=Fraction(start)))
    assert column(run, "i.y")[1][-1] == pytest.approx(0.006) and happened(run) == [(0.004, 1, "event 1")]


def test_what_is_there_from_the_start_is_in_the_initialization() -> None:
    events = [{"at": 0, "set": {"s.w": 3.0}}, {"at": "-1 s", "fault": "bias", "on": "s.u", "value": 0.5}]
    plan = planned({"r": (RAMP, "0.001"), "s": (SUM, "0.001")}, ["r.y -> s.u"], events, "0.005")
    run = both(plan)
    t, y = column(run, "s.y")
    assert y.tolist() == pytest.approx((2.0 * (t + 0.5) + 3.0).tolist(), abs=1e-15)
    assert [row.time for row in told(run)] == [0.0] and told(run)[0].what.count("from the start") == 2
    with Session(plan) as session:
        assert session.get("s.y") == 4.0


def test_a_fault_that_is_over_before_the_start_does_nothing() -> None:
    plan = ramp_into_keep({"at": "-2 s", "fault": "loss", "on": "b.u", "for": "1 s"})
    assert [row.what for row in both(plan).events] == [AT_START]
    assert np.array_equal(simulate(plan).tables[0], simulate(without_events(plan)).tables[0])


FAULTS: dict[str, tuple[dict[str, Any], Any]] = {
    "hold": ({}, lambda t: np.full_like(t, 0.003)),
    "bias": ({"value": -0.25}, lambda t: t - 0.25),
    "scale": ({"value": 3.0}, lambda t: 3.0 * t),
    "loss": ({}, np.zeros_like),
    "loss of a value": ({"fault": "loss", "value": 7.0}, lambda t: np.full_like(t, 7.0)),
}


@pytest.mark.parametrize("kind", FAULTS)
@pytest.mark.parametrize("on", ["b.u", "a.y"], ids=["input", "output"])
@pytest.mark.parametrize("algorithm", ALL_AT_ONCE)
def test_a_fault_is_what_it_says_while_it_lasts_and_nothing_else(kind: str, on: str, algorithm: str) -> None:
    """a steps before b: with Gauss-Seidel b.u is a.y at the end of the step, with Jacobi that at its beginning."""
    keys, broken = FAULTS[kind]
    run = both(ramp_into_keep({"at": "3 ms", "for": "4 ms", "fault": kind, "on": on, **keys}, algorithm=algorithm))
    t, u = column(run, "b.u")
    sent = t if algorithm == "gauss-seidel" else np.maximum(t - 0.001, 0.0)
    held = 0.003 if algorithm == "gauss-seidel" else 0.002  # what the step to 3 ms had
    sent = np.where((t == 0.003) | (t == 0.007), t, sent)  # their rows are those behind what happens there
    inside = (t > 0.0025) & (t < 0.0065)
    wanted = np.where(inside, np.full_like(t, held) if kind == "hold" else broken(sent), sent)
    assert u.tolist() == pytest.approx(wanted.tolist(), abs=1e-15)
    assert column(run, "a.y")[1].tolist() == pytest.approx(t.tolist(), abs=1e-15)  # what a gives is not touched
    assert [(time, number) for time, number, _ in happened(run)] == [(0.003, 1), (0.007, 1)]


def test_faults_of_one_input_follow_each_other_in_the_order_of_the_file() -> None:
    both_of_them = [{"name": name, "at": 0, "fault": name, "on": "b.u", "value": 2.0} for name in ("scale", "bias")]
    t, u = column(both(ramp_into_keep(*both_of_them)), "b.u")
    assert u.tolist() == pytest.approx((2.0 * t + 2.0).tolist())
    t, u = column(both(ramp_into_keep(*both_of_them[::-1])), "b.u")
    assert u.tolist() == pytest.approx((2.0 * (t + 2.0)).tolist())


@pytest.mark.parametrize("transfer", ["mean", "linear", "quadratic"])
def test_inputs_that_are_averaged_or_extrapolated_break_as_well(transfer: str) -> None:
    periods = ("0.001", "0.004") if transfer == "mean" else ("0.004", "0.001")
    parts = {"a": (RAMP, periods[0]), "b": (KEEP, periods[1])}
    fault = {"at": "4 ms", "fault": "bias", "on": "b.u", "value": 100.0}
    plan = planned(parts, ["a.y -> b.u"], [fault], "0.02", transfer=transfer)
    (t, u), (_, sound) = column(both(plan), "b.u"), column(simulate(without_events(plan)), "b.u")
    assert u.tolist() == pytest.approx((sound + 100.0 * (t > 0.0045)).tolist(), abs=1e-12)


@pytest.mark.parametrize("algorithm", ALL_AT_ONCE)
def test_an_output_that_answers_at_once_answers_to_the_broken_input(algorithm: str) -> None:
    parts = {"s": (SUM, "0.001"), "r": (RAMP, "0.001")}
    fault = {"at": "3 ms", "fault": "scale", "on": "s.u", "value": -1.0}
    run = both(planned(parts, ["r.y -> s.u"], [fault], "0.01", algorithm=algorithm))
    t, y = column(run, "s.y")
    assert y.tolist() == pytest.approx((np.where(t > 0.0025, -2.0, 2.0) * t).tolist(), abs=1e-15)


def test_a_loop_is_solved_with_the_fault_in_it() -> None:
    """s.u = 0.25 q.y, q.u = s.y: with a bias b on s.u, s.y = 2 (0.25 q.y + b) + w and q.y = s.y."""
    from collections.abc import Iterable

    from rovbrush.orchestrator.fmu.mock import Model, mock_fmu

    class Quarter(Model):
        def get(self, names: Iterable[str]) -> list[float]:
            self.values["y"] = 0.25 * self.values["u"]
            return super().get(names)

    quarter = mock_fmu("quarter", Quarter, ["u"], ["y"], feedthrough={"y": ["u"]})
    parts = {"s": (SUM, "0.001"), "q": (quarter, "0.001"), "r": (RAMP, "0.001")}
    fault = {"at": 0, "fault": "bias", "on": "s.u", "value": 1.0}
    run = both(planned(parts, ["q.y -> s.u", "s.y -> q.u", "r.y -> s.w"], [fault], "0.01"))
    t, y = column(run, "s.y")
    assert y.tolist() == pytest.approx(((2.0 + t) / 0.5).tolist(), abs=1e-9)


@pytest.mark.parametrize("algorithm", [*ALL_AT_ONCE, "iterated"])
def test_noise_is_that_of_its_seed_whatever_the_order(algorithm: str) -> None:
    noise = {"at": 0, "fault": "noise", "on": "a.y", "value": 0.5, "seed": 11}
    parts = {"a": (RAMP, "0.001"), "b": (KEEP, "0.001")}
    runs = [both(planned(dict(order), ["a.y -> b.u"], [noise], "3", algorithm=algorithm, order=tuple(dict(order))))
            for order in (parts.items(), reversed(parts.items()))]  # fmt: skip
    drawn = []
    for run in runs:
        plan = planned(dict(parts), ["a.y -> b.u"], [], "3", algorithm=algorithm, order=tuple(run.plan.system.order))
        drawn.append(column(run, "b.u")[1] - column(simulate(plan), "b.u")[1])
    assert drawn[0].tolist() == pytest.approx(drawn[1].tolist(), abs=1e-12)
    n = drawn[0][1:]
    assert abs(np.mean(n)) < 5 * 0.5 / np.sqrt(len(n)) and np.std(n) == pytest.approx(0.5, rel=0.1)
    assert abs(np.corrcoef(n[1:], n[:-1])[0, 1]) < 5 / np.sqrt(len(n))
    other = simulate(ramp_into_keep({**noise, "seed": 12}, stop="3", algorithm=algorithm))
    assert not np.array_equal(column(other, "b.u")[1], column(runs[0], "b.u")[1])


CROSSINGS = [
    ({"when": "r.y > 0.0035"}, [0.004]),
    ({"when": "r.y > 0.0035", "after": "2.5 ms"}, [0.0065]),
    ({"when": "saw.y > 0.5"}, [0.003]),
    ({"when": "saw.y > 0.5", "repeat": True}, [0.003, 0.007, 0.011]),
    ({"when": "saw.y < 0.5", "repeat": True}, [0.005, 0.009]),
    ({"when": "r.y > 99"}, []),
    ({"when": "r.y > -1"}, []),  # beyond it from the start
]


@pytest.mark.parametrize(("when", "times"), CROSSINGS)
@pytest.mark.parametrize("algorithm", ALL_AT_ONCE)
def test_a_crossing_acts_when_it_is_seen_once_or_every_time(
    when: dict[str, Any], times: list[float], algorithm: str
) -> None:
    from rovbrush.orchestrator.fmu.mock import Model, mock_fmu

    class Saw(Model):
        """1 for two steps of four, 0 for the others."""

        def step(self, time: float, length: float) -> int | None:
            self.values["y"] = float(round((time + length) / 0.001) % 4 >= 3 or round((time + length) / 0.001) % 4 == 0)
            self.values["y"] *= time + length > 0.0015
            return None

    saw = mock_fmu("saw", Saw, [], ["y"])
    parts = {"r": (RAMP, "0.001"), "saw": (saw, "0.001"), "i": (INTEGRAL, "0.001")}
    run = both(planned(parts, [], [{**when, "set": {"i.u": 1.0}}], "0.0125", algorithm=algorithm))
    assert [row.time for row in told(run) if "event 1: i.u = 1" in row.what.split("; ")] == times
    first = times[0] if times else 0.0125
    assert column(run, "i.y")[1][-1] == pytest.approx(0.0125 - first, abs=1e-15)


def test_a_fault_begun_again_lasts_from_then_on() -> None:
    """It begins at 3 ms and at 6 ms, for 5 ms each time: until 11 ms."""
    events = [{"name": "a", "when": "x.y > 0.5", "repeat": True, "fault": "loss", "on": "b.u", "for": "5 ms"}]
    from rovbrush.orchestrator.fmu.mock import Model, mock_fmu

    class Beat(Model):
        def step(self, time: float, length: float) -> int | None:
            self.values["y"] = float(round((time + length) / 0.001) in (3, 6))
            return None

    parts = {"x": (mock_fmu("beat", Beat, [], ["y"]), "0.001"), "a": (RAMP, "0.001"), "b": (KEEP, "0.001")}
    t, u = column(both(planned(parts, ["a.y -> b.u"], events, "0.015")), "b.u")
    assert u.tolist() == pytest.approx(np.where((t > 0.0025) & (t < 0.0105), 0.0, t).tolist(), abs=1e-15)


def test_events_of_one_instant_act_in_the_order_of_the_file() -> None:
    events = [{"at": "2 ms", "set": {"i.u": 1.0}}, {"at": "2 ms", "set": {"i.u": 5.0}}]
    run = both(planned({"i": (INTEGRAL, "0.001")}, [], events, "0.004"))
    assert [row.what for row in told(run)] == ["event 1: i.u = 1; event 2: i.u = 5"]
    assert column(run, "i.y")[1][-1] == pytest.approx(0.01)


def test_iterated_acts_at_macro_steps_and_repeats_nothing_of_it() -> None:
    parts = {"a": (RAMP, "0.001"), "b": (KEEP, "0.004")}
    fault = {"at": "1 ms", "fault": "bias", "on": "b.u", "value": 10.0}
    run = both(planned(parts, ["a.y -> b.u"], [fault], "0.012", algorithm="iterated"))
    assert happened(run) == [(0.004, 1, "event 1")]
    assert column(run, "b.u")[1].tolist() == pytest.approx([0.0, 0.002, 10.006, 10.010], abs=1e-9)


@pytest.mark.parametrize("algorithm", ["ecco", "adaptive"])
def test_steps_that_vary_end_where_an_event_is(algorithm: str) -> None:
    events = [{"at": "0.1234 s", "fault": "loss", "on": "q.e", "until": "0.5001 s"}]
    run = both(bonded(*events, algorithm=algorithm))
    t, e = column(run, "q.e")
    assert happened(run) == [(0.1234, 1, "event 1"), (0.5001, 1, "event 1")]
    assert {0.1234, 0.5001, 1.0} <= set(t.tolist())
    assert np.all(e[(t > 0.1234) & (t <= 0.5001)] == 0.0) and np.all(e[(t <= 0.1234) | (t > 0.5001)] > 0.0)
    assert np.min(np.diff(t)) > 0.0


@pytest.mark.parametrize("algorithm", ["ecco", "adaptive"])
def test_steps_that_vary_see_a_crossing_and_its_delay_exactly(algorithm: str) -> None:
    run = both(bonded({"when": "r.y > 0.2", "after": "33.3 ms", "fault": "hold", "on": "p.e"}, algorithm=algorithm))
    seen, acts = (row.time for row in told(run))
    assert 0.2 < seen <= acts and acts == pytest.approx(seen + 0.0333, abs=1e-5)
    t, e = column(run, "p.e")
    assert len(set(e[t > acts].tolist())) == 1


def test_rows_of_events_are_a_group_of_the_results_and_lines_of_the_summary(tmp_path: Path) -> None:
    run = both(ramp_into_keep({"name": "dead", "at": "3 ms", "fault": "loss", "on": "b.u"}))
    result = Result(run)
    result.run.plan.system.reporting.update(summary={}, balance={}, compare=[], figures=[])  # type: ignore[attr-defined]
    assert result.summary["events"] == ["t = 0.003 s: dead: b.u is 0 (loss)"]
    result.save(tmp_path)
    found = open_result(tmp_path)
    assert list(found.datasets) == ["every_1_ms"]
    for events in (found.events, result.events):
        assert events["time"].values.tolist() == [0.0, 0.003, 0.003] and events["number"].values.tolist() == [0, 0, 1]
        assert events["what"].values.tolist() == [AT_START, "", "dead: b.u is 0 (loss)"]
        assert events["a.y"].values.tolist() == [0.0, 0.003, 0.003]  # all that is recorded, at that moment
        assert events["b.u"].values.tolist() == [0.0, 0.003, 0.0]  # before it, and behind it


def test_a_session_by_hand_sees_events_and_sets_the_same_inputs() -> None:
    events = [{"at": "3 ms", "set": {"i.u": 1.0}}, {"at": "7 ms", "set": {"i.u": 0.0}}]
    plan = planned({"i": (INTEGRAL, "0.001")}, [], events, "0.01")
    with Stepping(plan) as session:
        for tick in range(10):
            if tick in (1, 5):
                session.set("i.u", 10.0)
                session.set("i.u", 100.0)  # by the shorter way
            session.step()
        y = session.result().run
    assert column(y, "i.y")[1].tolist() == pytest.approx(np.cumsum([0, 0, 1e2, 1e2, 1, 1, 1e2, 1e2, 0, 0, 0]) * 1e-3)


def test_how_a_run_is_cut_changes_no_event() -> None:
    events = [{"when": "a.y > 0.0035", "after": "2 ms", "fault": "hold", "on": "b.u", "for": "3 ms"},
              {"at": "5 ms", "fault": "noise", "on": "b.u", "value": 1.0}]  # fmt: skip
    plan = ramp_into_keep(*events, stop="0.02")
    whole = both(plan)
    with Session(plan) as session:
        while session.tick < plan.clock.stop:
            session.advance(cycles=3)
        assert happened(session.run()) == happened(whole)
        assert session.run().tables[0].tobytes() == whole.tables[0].tobytes()


def test_the_plan_is_not_changed_by_a_run() -> None:
    plan = ramp_into_keep({"at": "3 ms", "fault": "scale", "on": "b.u", "value": 2.0})
    before = plan.cycle.tobytes(), plan.coefficients.tobytes()
    first, second = simulate(plan), simulate(plan)
    assert first.tables[0].tobytes() == second.tables[0].tobytes()
    assert before == (plan.cycle.tobytes(), plan.coefficients.tobytes())
    assert KEEP.made


def test_rows_of_events_beyond_memory_go_to_disk_and_all_are_in_the_results(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from rovbrush.orchestrator.results.files import netcdf
    from rovbrush.orchestrator.run.recording import happened as store

    noise = {"at": 0, "fault": "noise", "on": "b.u", "value": 10.0}
    again = {"when": "b.y > 0", "repeat": True, "fault": "hold", "on": "b.u", "for": "1 ms"}
    plan = ramp_into_keep(noise, again, stop="0.3")
    whole = simulate(plan)
    assert len(whole.events) > 200
    monkeypatch.setattr(store, "IN_MEMORY", 5 * (8 * 3 + store.BESIDE))
    monkeypatch.setattr(netcdf, "PIECE", 7)
    with Session(plan, file=tmp_path / "rows.nc") as session:
        session.advance(cycles=100)
        part = session.run()
        session.advance()
        run = session.run()
        assert session.events.happened._stored > 100
        rows = [[(row.time, row.number, row.what, row.cells.tobytes()) for row in r.events] for r in (whole, run, part)]
        assert rows[0] == rows[1] and rows[2] == rows[0][: len(rows[2])] and 0 < len(rows[2]) < len(rows[0])
        assert run.events[-1].time == whole.events[-1].time and [r.time for r in run.events[2:4]]
        netcdf.write_netcdf(run, tmp_path / "result.nc")
    import xarray

    found = xarray.open_dataset(tmp_path / "result.nc", group="events")
    assert found["what"].values.tolist() == [row.what for row in whole.events]
    column_of = plan.groups[0].columns.index(("b", "u"))
    assert found["b.u"].values.tolist() == [row.cells[column_of] for row in whole.events]
