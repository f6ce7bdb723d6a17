"""Means that are exact because the source counts the integral, through real FMUs: a force that beats pushes a mass."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from event_cases import KEEP, RAMP, planned
from helpers import column, last, plan_of, run_of
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.mock import Model, mock_fmu
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.connection import Bond, Connection

WIRE = "s.F -> t.F (mean of s.p)"
BOTH = ["jacobi", "gauss-seidel"]


def impulse(t: np.ndarray) -> np.ndarray:
    """Of the force that `push` gives by default."""
    return np.asarray(t + 3.0 / 900.0 * (1.0 - np.cos(900.0 * t)))


def pushed(folder: Path, fmus: Path, wire: str, fast: str, slow: str, **keys: object) -> Run:
    """Compiled, after a look that the interpreted run gives the same bits."""
    parts = {"s": ("push", fast), "t": ("mass1", slow)}
    case = {"stop": "0.35 s", **keys}
    run, other = (run_of(folder, fmus, parts, [wire], interpreted=i, **case) for i in (False, True))
    assert [table.tobytes() for table in run.tables] == [table.tobytes() for table in other.tables]
    return run


def given(run: Run) -> tuple[np.ndarray, np.ndarray]:
    """Instants of the target, and the impulse that it has been given so far."""
    t, F = column(run, "t.F")
    return t, np.concatenate([[0.0], np.cumsum(F[1:] * np.diff(t))])


@pytest.mark.parametrize("algorithm", BOTH)
@pytest.mark.parametrize(("fast", "slow"), [("1 ms", "7 ms"), ("7 ms", "7 ms"), ("0.5 ms", "10 ms")])
def test_mean_of_a_counter_is_its_rise_over_the_step(
    fast: str, slow: str, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    """To rounding, of a beat of 7 ms that a trapezoidal rule misses."""
    run = pushed(tmp_path, fmus, WIRE, fast, slow, algorithm=algorithm, order=["s", "t"])
    t, F = column(run, "t.F")
    np.testing.assert_allclose(F[1:], np.diff(impulse(t)) / np.diff(t), rtol=1e-12)


@pytest.mark.parametrize("algorithm", BOTH)
@pytest.mark.parametrize(("fast", "slow", "every"), [("1 ms", "5 ms", 1), ("3 ms", "5 ms", 3), ("5 ms", "5 ms", 1)])
def test_impulse_given_is_the_impulse_counted_at_instants_of_both(
    fast: str, slow: str, every: int, algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    run = pushed(tmp_path, fmus, WIRE, fast, slow, algorithm=algorithm, order=["s", "t"])
    t, taken = given(run)
    np.testing.assert_allclose(taken[::every], impulse(t)[::every], rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize("algorithm", BOTH)
def test_what_is_given_before_the_source_has_stepped_is_taken_back_by_the_next_mean(
    algorithm: str, tmp_path: Path, fmus: Path
) -> None:
    """It lacks what the last extrapolation does, not a sum of all: that of the line through F at both ends before."""
    run = pushed(tmp_path, fmus, WIRE, "5 ms", "5 ms", algorithm=algorithm, order=["t", "s"])
    t, taken = given(run)
    F = 1.0 + 3.0 * np.sin(900.0 * t)
    line = 0.005 * (F[1:-1] + 0.5 * (F[1:-1] - F[:-2]))
    np.testing.assert_allclose(taken[2:], impulse(t)[1:-1] + line, rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize("algorithm", BOTH)
def test_trapezoidal_mean_of_the_same_beat_is_wrong(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    """What the counter is for: the error of the usual mean falls with the square of the period, this one has none."""
    errors = {}
    for wire in ("s.F -> t.F (mean)", WIRE):
        run = pushed(tmp_path, fmus, wire, "1 ms", "5 ms", algorithm=algorithm, order=["s", "t"])
        t, F = column(run, "t.F")
        errors[wire] = float(np.max(np.abs(F[1:] - np.diff(impulse(t)) / np.diff(t))))
    assert errors["s.F -> t.F (mean)"] > 0.05
    assert errors[WIRE] < 1e-11


@pytest.mark.parametrize("algorithm", BOTH)
def test_a_shorter_last_step_takes_the_rise_over_its_own_length(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    run = pushed(tmp_path, fmus, WIRE, "1 ms", "5 ms", algorithm=algorithm, order=["s", "t"], stop="23 ms")
    t, F = column(run, "t.F")
    assert t[-1] - t[-2] == pytest.approx(0.003)
    np.testing.assert_allclose(F[1:], np.diff(impulse(t)) / np.diff(t), rtol=1e-12)


def test_iterated_takes_the_rise_too(tmp_path: Path, fmus: Path) -> None:
    for fast, slow in (("1 ms", "5 ms"), ("5 ms", "5 ms"), ("10 ms", "5 ms")):
        run = pushed(tmp_path, fmus, WIRE, fast, slow, algorithm="iterated")
        t, taken = given(run)
        every = 2 if fast == "10 ms" else 1
        np.testing.assert_allclose(taken[::every], impulse(t)[::every], rtol=1e-11, atol=1e-13)


def test_the_end_of_a_step_is_no_mean(tmp_path: Path, fmus: Path) -> None:
    parts = {"s": ("push", "5 ms"), "t": ("mass1", "5 ms")}
    for keys in ({"algorithm": "iterated", "iteration": {"inputs": "end"}}, {"algorithm": "adaptive"}):
        with pytest.raises(InputError, match="'mean' has no meaning; leave it out"):
            plan_of(tmp_path, fmus, parts, [WIRE], **keys)


def test_the_plan_names_the_counter_and_what_is_done(tmp_path: Path, fmus: Path) -> None:
    text = explain(plan_of(tmp_path, fmus, {"s": ("push", "1 ms"), "t": ("mass1", "5 ms")}, [WIRE]))
    (line,) = (line for line in text.splitlines() if line.startswith("  s.F -> t.F ") and "mean" in line)
    assert "mean        stated in the system file; exactly, by the rise of s.p" in line
    assert "rise        integral for t.F += 200 (s.p - previous s.p)" in text


class Counted(Model):
    """F = 2 t + u, with its integral; whatever parts its step is made of."""

    def step(self, time: float, length: float) -> int | None:
        end = time + length
        self.values["J"] = self.values.get("J", 0.0) + end**2 - time**2 + length * self.values["u"]
        self.values["F"] = 2.0 * end + self.values["u"]
        return None


COUNTED = mock_fmu("counted", Counted, ["u"], ["F", "J"])


@pytest.mark.parametrize("algorithm", BOTH)
def test_parts_of_steps_that_an_event_cuts_count_once(algorithm: str) -> None:
    """u = 7 from 2.5 ms on, within a step of the source: the mean from 0 to 4 ms is (J(4 ms) - 0)/4 ms."""
    parts = {"a": (COUNTED, "0.001"), "r": (RAMP, "0.0005"), "b": (KEEP, "0.004")}
    event = {"when": "r.y > 0.0024", "set": {"a.u": 7.0}}
    plan = planned(parts, ["a.F -> b.u"], [event], "0.012", algorithm=algorithm, transfer="mean", order=("r", "a", "b"))
    exact = (Connection(("a", "F"), ("b", "u"), "mean", counter="J"),)
    plan = make_plan(replace(plan.system, connections=exact))
    run, other = simulate(plan), simulate(plan, interpreted=True)
    assert not run.failure and [t.tobytes() for t in run.tables] == [t.tobytes() for t in other.tables]
    t, u = column(run, "b.u")
    J = np.interp(t, *column(run, "a.J"))
    np.testing.assert_allclose(u[1:], np.diff(J) / 0.004, rtol=1e-12)
    assert last(run, "a.J") == pytest.approx(0.012**2 + 7.0 * (0.012 - 0.0025), rel=1e-9)


class Steady(Model):
    """y = 1, with its integral; whatever parts its step is made of."""

    def step(self, time: float, length: float) -> int | None:
        self.values |= {"y": 1.0, "Y": self.values.get("Y", 0.0) + length}
        return None


@pytest.mark.parametrize("algorithm", BOTH)
def test_counters_of_bonds_count_once_where_an_event_cuts_a_step(algorithm: str) -> None:
    steady = mock_fmu("steady", Steady, ["u"], ["y", "Y"])
    parts = {"r": (RAMP, "0.0005"), "a": (steady, "0.001"), "b": (steady, "0.001"), "k": (KEEP, "0.001")}
    bond = Bond("x", ("a.y", "b.u"), ("b.y", "a.u"), 1.0, "a.Y", "b.Y")
    found = []
    for events in ([], [{"when": "r.y > 0.0024", "set": {"k.u": 7.0}}]):
        plan = planned(parts, ["a.y -> b.u", "b.y -> a.u"], events, "0.01", algorithm=algorithm, bonds=(bond,))
        run = simulate(plan)
        assert not run.failure and bool(plan.events) == bool(events)
        found.append([last(run, f"coupling.x_{side}_side") for side in ("effort", "flow")])
    assert found[1] == pytest.approx(found[0], rel=1e-12)
