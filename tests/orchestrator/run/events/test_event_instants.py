"""Events between the instants of a plan: who can vary its step is brought there, and all else stays what it is."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from helpers import Part, column, edited, read_system
from rovbrush.orchestrator.loop.operations import PAUSE, STEP_ON
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.session.session import Session

TIMES = [Fraction(t, 10_000) for t in (7, 40, 41, 120, 133, 250, 299, 300, 417)]  # s
LATER = [{"at": "1 s", "fault": "bias", "on": "i.u", "value": 0.0}]  # behind the stop: a system with events
FIXED = {
    'canHandleVariableCommunicationStepSize="true"': 'canHandleVariableCommunicationStepSize="false"',
    ' stepSize="0.001"': "",
}


class Bells:
    """Times at which something happens that changes nothing."""

    def __init__(self, times: Sequence[Fraction]) -> None:
        self.waiting, self.rung = list(times), list[Fraction]()

    def next_instant(self) -> Fraction | None:
        return self.waiting[0] if self.waiting else None

    def happen(self, now: Fraction, passed: Collection[str] = ()) -> str:
        if not self.waiting or float(self.waiting[0]) > float(now):
            return ""
        self.rung.append(now)
        return f"bell {float(self.waiting.pop(0)):g}"


def eventful(tmp_path: Path, fmus: Path, rates: tuple[str, str], **keys: object) -> Plan:
    parts: dict[str, Part] = {"w": ("wave", rates[0], {"c1": 2.0}), "i": ("integrator", rates[1])}
    return make_plan(read_system(tmp_path, fmus, parts, ["w.y -> i.u"], stop="60 ms", events=LATER, **keys))


def rung(plan: Plan, times: Sequence[Fraction], interpreted: bool = False) -> tuple[Run, Bells]:
    bells = Bells(times)
    with Session(plan, interpreted) as session:
        assert session.events.handler is not None
        session.events.handler.others.append(bells)
        session.events.handler.plan_next()
        session.advance()
        return session.run(), bells


@pytest.mark.parametrize("algorithm", ["gauss-seidel", "jacobi"])
@pytest.mark.parametrize("rates", [("2 ms", "6 ms"), ("3 ms", "5 ms"), ("1 ms", "60 ms")])
def test_a_mean_over_steps_that_events_cut_is_as_exact_as_over_whole_ones(
    rates: tuple[str, str], algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    plan = eventful(tmp_path, fmus, rates, algorithm=algorithm)
    assert plan.events is not None and plan.events.late["i"] == "u is the mean over its whole step"
    run, bells = rung(plan, TIMES)
    assert not run.failure and bells.rung == TIMES
    time, x = column(run, "i.x")
    assert x == pytest.approx(time**2, abs=1e-15)
    assert {row.time for row in run.events} >= {float(t) for t in TIMES}


def test_an_instant_of_an_event_is_one_at_which_held_values_are_sent(tmp_path: Path, fmus: Path) -> None:
    plan = eventful(tmp_path, fmus, ("2 ms", "2 ms"), algorithm="jacobi")
    run, _ = rung(plan, TIMES)
    grid = sorted({*TIMES, *(Fraction(k, 500) for k in range(31))})
    exact = np.cumsum([0.0, *(float(2 * a * (b - a)) for a, b in pairwise(grid))])
    time, x = column(run, "i.x")
    at = {float(t): value for t, value in zip(grid, exact.tolist(), strict=True)}
    assert x == pytest.approx([at[t] for t in time.tolist()], abs=1e-15)


def test_who_cannot_vary_its_step_sees_an_event_at_its_next_instant(tmp_path: Path, fmus: Path) -> None:
    edited(fmus / "integrator.fmu", tmp_path / "fixed.fmu", {}, FIXED)
    parts: dict[str, Part] = {"w": ("wave", "2 ms", {"c1": 2.0}), "i": (str(tmp_path / "fixed.fmu"), "2 ms")}
    keys = {"stop": "60 ms", "algorithm": "jacobi"}
    plan = make_plan(read_system(tmp_path, fmus, parts, ["w.y -> i.u"], events=LATER, **keys))
    assert plan.events is not None and plan.events.stopped == ("w",)
    assert "i sees events up to 2 ms late, at its own instants: its step cannot vary" in explain(plan)
    with Session(make_plan(read_system(tmp_path, fmus, parts, ["w.y -> i.u"], **keys))) as session:
        session.advance()
        without = session.run()
    assert column(rung(plan, TIMES)[0], "i.x")[1].tolist() == column(without, "i.x")[1].tolist()


@pytest.mark.parametrize("rates", [("2 ms", "6 ms"), ("3 ms", "2 ms"), ("2 ms", "2 ms")])
def test_the_loop_and_its_interpreter_handle_events_bit_by_bit_alike(
    rates: tuple[str, str], tmp_path: Path, fmus: Path
) -> None:
    plan = eventful(tmp_path, fmus, rates)
    runs = [rung(plan, TIMES, interpreted)[0] for interpreted in (False, True)]
    assert [t.tobytes() for t in runs[0].tables] == [t.tobytes() for t in runs[1].tables]
    rows = [[(row.time, row.number, row.what, row.cells.tobytes()) for row in run.events] for run in runs]
    assert rows[0] == rows[1] and len(rows[0]) >= 2 * len(TIMES)


def test_a_system_without_events_has_the_plan_that_it_had(tmp_path: Path, fmus: Path) -> None:
    parts: dict[str, Part] = {"w": ("wave", "2 ms"), "i": ("integrator", "6 ms")}
    plain = make_plan(read_system(tmp_path, fmus, parts, ["w.y -> i.u"], stop="60 ms"))
    assert plain.events is None and not plain.at_events.bring
    assert {PAUSE, STEP_ON}.isdisjoint(plain.cycle[:, 0].tolist())
    assert len(eventful(tmp_path, fmus, ("2 ms", "6 ms")).cycle) > len(plain.cycle)
