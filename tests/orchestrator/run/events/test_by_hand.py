"""What is done by hand between two steps is bit by bit what a scenario has at the same time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from event_cases import INTEGRAL, KEEP, RAMP, SUM, bonded, planned
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.loop.cells import POLICY, STOP_LATE
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.pacing.pace import FASTEST, Pace
from rovbrush.orchestrator.run.recording.observers import NEVER, Piece
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.system.file.events.added import with_scenarios

ALGORITHMS = ("gauss-seidel", "jacobi", "iterated")
FAULTS: dict[str, dict[str, Any]] = {
    "hold": {}, "bias": {"value": -0.25}, "scale": {"value": 3.0}, "loss": {"value": 7.0},
    "noise": {"value": 0.1, "seed": 5},
}  # fmt: skip
TIMES = ("0", "0.006", "0.018", "0.03")
STOP = "0.036"
Table = Mapping[str, Any]


def several_rates(events: Sequence[Table], algorithm: str) -> Plan:
    """A ramp, what answers at once, what keeps and what integrates, at 2, 1, 3 and 6 ms."""
    parts = {"r": (RAMP, "0.002"), "s": (SUM, "0.001"), "k": (KEEP, "0.003"), "i": (INTEGRAL, "0.006")}
    wires = ["r.y -> s.u", "s.y -> k.u", "k.y -> i.u"]
    return planned(parts, wires, events, STOP, algorithm=algorithm)


def stepped(plan: Plan, acts: Mapping[str, Any]) -> tuple[Run, str]:
    """A run by hand; `acts`: by time, what is done then to the session."""
    with Stepping(plan) as session:
        while session.time < session.stop:
            for time, act in acts.items():
                if float(Fraction(time)) == session.time:
                    act(session)
            session.step()
        return session.run(), session.scenario()


def bits(run: Run) -> list[bytes]:
    assert not run.failure
    return [table.tobytes() for table in run.tables]


def event_cells(run: Run) -> list[tuple[float, bytes]]:
    """The rows of events, as cells: their words name what was done by hand otherwise."""
    return [(row.time, row.cells.tobytes()) for row in run.events if row.time > 0.0]


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("time", TIMES)
@pytest.mark.parametrize("kind", FAULTS)
@pytest.mark.parametrize("on", ["s.u", "k.y"])
def test_a_fault_by_hand_gives_the_rows_of_one_at_that_time(kind: str, on: str, time: str, algorithm: str) -> None:
    fault = {"name": "broken", "fault": kind, "on": on, **FAULTS[kind]}
    plan = several_rates([{**fault, "by_hand": True}], algorithm)
    by_hand, _ = stepped(plan, {time: lambda session: session.happen("broken")})
    by_time = simulate(several_rates([{**fault, "at": f"{time} s", "initial": False}], algorithm))
    assert bits(by_hand) == bits(by_time) != bits(simulate(plan))
    assert event_cells(by_hand) == event_cells(by_time)
    assert [row.what.partition(":")[0] for row in by_hand.events if "broken" in row.what] == ["broken"]


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("lasting", [None, "0.009"], ids=["ended by hand", "ends by itself"])
@pytest.mark.parametrize("kind", FAULTS)
def test_a_fault_that_ends_by_hand_or_after_its_time_is_one_with_that_end(
    kind: str, lasting: str | None, algorithm: str
) -> None:
    fault = {"name": "broken", "fault": kind, "on": "s.u", **FAULTS[kind]}
    last = {"for": lasting} if lasting else {}
    acts = {"0.006": lambda session: session.happen("broken")}
    if not lasting:
        acts["0.018"] = lambda session: session.end("broken")
    by_hand, _ = stepped(several_rates([{**fault, **last, "by_hand": True}], algorithm), acts)
    ends = {"until": "0.018"} if not lasting else last
    by_time = simulate(several_rates([{**fault, **ends, "at": "0.006"}], algorithm))
    assert bits(by_hand) == bits(by_time)
    assert event_cells(by_hand) == event_cells(by_time)


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("time", TIMES)
@pytest.mark.parametrize("name", ["i.k", "s.w"], ids=["tunable", "answered at once"])
def test_setting_by_hand_what_events_set_is_such_an_event(name: str, time: str, algorithm: str) -> None:
    def events(**when: Any) -> list[Table]:
        return [{"name": "to", "set": {name: 0.375}, **when}]

    plan = several_rates(events(by_hand=True), algorithm)
    happened, _ = stepped(plan, {time: lambda session: session.happen("to")})
    as_set, _ = stepped(plan, {time: lambda session: session.set(name, 0.375)})
    by_time = simulate(several_rates(events(at=f"{time} s", initial=False), algorithm))
    assert bits(happened) == bits(as_set) == bits(by_time) != bits(simulate(plan))
    assert event_cells(happened) == event_cells(as_set) == event_cells(by_time)


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
def test_other_free_inputs_count_from_the_next_step_and_the_instant_keeps_its_row(algorithm: str) -> None:
    """What answers at once shows that: an event changes its output at the instant, `set` a step later."""
    plain = several_rates([], algorithm)
    as_set, text = stepped(plain, {"0.006": lambda session: session.set("s.w", 0.375)})
    by_time = simulate(several_rates([{"at": "0.006", "set": {"s.w": 0.375}}], algorithm))
    fast = next(k for k, group in enumerate(plain.groups) if ("s", "y") in group.columns)
    at = plain.groups[fast].columns.index(("s", "y"))
    other = by_time.plan.groups[fast].columns.index(("s", "y"))
    rows, events = as_set.tables[fast][:, at], by_time.tables[fast][:, other]
    assert (rows != events).nonzero()[0].tolist() == [6]
    assert "[[events]]" not in text


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_what_was_done_by_hand_replays_as_a_scenario_bit_by_bit(algorithm: str, tmp_path: Path) -> None:
    events = [
        {"name": "pull", "by_hand": True, "fault": "bias", "on": "s.u", "value": 0.125, "for": "0.012"},
        {"name": "noisy", "by_hand": True, "fault": "noise", "on": "k.u", "value": 0.1, "seed": 3},
        {"name": "w", "by_hand": True, "set": {"s.w": 0.0}},
        {"name": "late", "at": "0.02", "fault": "scale", "on": "i.u", "value": 2.0},
    ]  # fmt: skip
    acts = {
        "0": lambda s: (s.set("s.w", 1 / 3), s.happen("noisy")),
        "0.006": lambda s: (s.happen("pull"), s.set("s.w", 0.1)),
        "0.012": lambda s: (s.happen("pull"), s.end("noisy")),
        "0.03": lambda s: (s.set("s.w", 5), s.set("s.w", 7.0), s.happen("noisy")),
    }
    plan = several_rates(events, algorithm)
    by_hand, text = stepped(plan, acts)
    assert text.count("[[events]]") == 6 and 'until = "24 ms"' in text
    (tmp_path / "done.toml").write_text(text, encoding="utf-8")
    system = with_scenarios(plan.system, [tmp_path / "done.toml"])
    assert bits(simulate(make_plan(system))) == bits(by_hand)
    alone = with_scenarios(several_rates(events[3:], algorithm).system, [tmp_path / "done.toml"])
    assert bits(simulate(make_plan(alone))) == bits(by_hand)


def test_a_result_that_was_taken_keeps_its_rows_when_something_is_done_at_its_last_instant() -> None:
    plan = several_rates([{"name": "w", "by_hand": True, "set": {"s.w": 9.0}}], "jacobi")
    with Stepping(plan) as session:
        session.step()
        before = session.result()
        rows = [table.copy() for table in before.run.tables]
        session.happen("w")
        after = session.result()
    assert [t.tobytes() for t in before.run.tables] == [t.tobytes() for t in rows]
    assert [len(t) for t in after.run.tables] == [len(t) for t in rows]
    assert after["s.y"].values[-1] == before["s.y"].values[-1] + 9.0


def test_an_observer_sees_the_row_of_such_an_instant_again() -> None:
    seen: list[tuple[list[int], list[int]]] = []

    class Looks:
        def due(self, tick: int) -> int:
            return NEVER

        def see(self, piece: Piece) -> None:
            seen.append((piece.first, [len(table) for table in piece.tables]))

    plan = planned({"s": (SUM, "0.001")}, [], [{"name": "w", "by_hand": True, "set": {"s.w": 9.0}}], "0.01")
    session = Stepping(plan)
    session.observers.append(Looks())
    session.step()
    session.happen("w")
    session.step()
    session.close()
    assert seen == [([0], [2]), ([1], [2])]


def test_with_steps_that_vary_it_happens_where_a_step_has_ended() -> None:
    plan = bonded({"name": "w", "by_hand": True, "fault": "bias", "on": "q.e", "value": 0.5}, algorithm="ecco")
    with Stepping(plan) as session:
        session.step()
        time = session.time
        session.happen("w")
        session.finish()
        run = session.run()
    assert not run.failure and [row.time for row in run.events if "w:" in row.what] == [time]


WRONG = {
    "unknown": (lambda s: s.happen("brokn"), "happen brokn: no event is called 'brokn'; did you mean 'broken'"),
    "of a time": (lambda s: s.happen("timed"), "happen timed: it happens at 30 ms and not by hand"),
    "of a crossing": (lambda s: s.end("crossed"), r"end crossed: it happens when s.y > 1 and not by hand"),
    "end of values": (lambda s: s.end("w"), "end w: it sets values, which stay"),
    "over": (lambda s: s.happen("over"), "happen over: it lasts until 1 ms, which is over"),
    "driven": (lambda s: s.set("s.u", 1.0), "driven by the connection"),
    "no number": (lambda s: s.set("s.w", "deep"), "s.w = deep is not a finite number"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_cannot_be_done_by_hand_is_one_error_and_the_run_goes_on(case: str) -> None:
    act, message = WRONG[case]
    events = [
        {"name": "broken", "by_hand": True, "fault": "hold", "on": "s.u"},
        {"name": "over", "by_hand": True, "fault": "hold", "on": "s.u", "until": "1 ms"},
        {"name": "timed", "at": "30 ms", "fault": "hold", "on": "s.u"},
        {"name": "crossed", "when": "s.y > 1", "fault": "hold", "on": "s.u"},
        {"name": "w", "by_hand": True, "set": {"s.w": 0.0}},
    ]
    plan = several_rates(events, "jacobi")
    with Stepping(plan) as session:
        session.step()
        with pytest.raises(InputError, match=message):
            act(session)
        session.finish()
        assert bits(session.run()) == bits(simulate(plan))
        with pytest.raises(RunError, match="before the stop"):
            session.happen("broken")


def test_a_run_without_a_hand_does_nothing_of_it_and_the_plan_says_who_waits() -> None:
    plan = several_rates([{"name": "broken", "by_hand": True, "fault": "hold", "on": "s.u"}], "jacobi")
    later = {"at": "1 s", "fault": "hold", "on": "s.u"}  # behind the stop
    assert bits(simulate(plan)) == bits(simulate(several_rates([later], "jacobi")))
    assert "broken: by hand: s.u stays as it is (hold)" in explain(plan)


def test_a_deadline_that_was_waited_for_is_not_waited_for_or_counted_again() -> None:
    """With a policy that would end the run for it."""
    fault = {"name": "broken", "by_hand": True, "fault": "bias", "on": "s.u", "value": 1.0}
    system = several_rates([fault], "jacobi").system
    with Stepping(make_plan(system, ""), pace=Pace(FASTEST)) as session:
        assert session.pacer is not None
        session.step()
        session.pacer.control[POLICY] = STOP_LATE
        before = session.pacer.lateness().deadlines
        session.happen("broken")
        assert session.get("s.u") == session.get("r.y") + 1.0
        assert session.pacer.lateness().deadlines == before > 0
        assert session.pacer.control[POLICY] == STOP_LATE and not session.failure


@pytest.mark.parametrize("algorithm", ALGORITHMS)
@pytest.mark.parametrize("kind", FAULTS)
def test_what_is_done_where_something_else_happened_is_as_if_both_happened_at_once(kind: str, algorithm: str) -> None:
    """Another fault ends at that instant: what is held is what was there before all of it."""
    other = {"name": "other", "at": "0.006", "fault": "bias", "on": "r.y", "value": 0.5, "until": "0.018"}
    fault = {"name": "broken", "fault": kind, "on": "k.u", **FAULTS[kind]}
    acts = {"0.018": lambda session: session.happen("broken")}
    by_hand, _ = stepped(several_rates([other, {**fault, "by_hand": True}], algorithm), acts)
    by_time = simulate(several_rates([other, {**fault, "at": "0.018"}], algorithm))
    assert bits(by_hand) == bits(by_time)
