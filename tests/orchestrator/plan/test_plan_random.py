"""Random systems with every transfer and algorithm: a valid order that runs, or an error that says why not."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
from helpers import read_system
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop.operations import STEP
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Bond, Connection
from rovbrush.orchestrator.system.model import System

PERIODS = (Fraction(1, 8), Fraction(1, 4), Fraction(3, 8), Fraction(5, 8))
SPANS = (Fraction(15, 4), Fraction(4), Fraction(61, 16), Fraction(9, 16), Fraction(1, 16), Fraction(151, 40))
TRANSFERS = ("", "hold", "linear", "quadratic", "interpolate", "mean")
CLEAR = ("'mean' needs", "'interpolate' needs", "order: ", "has no meaning", "there is no 'mean' yet",
         "need one period", "no connection has one", "declare one in [[bonds]]")  # fmt: skip


@st.composite
def systems(draw: st.DrawFn) -> dict[str, Any]:
    names = [f"c{k}" for k in range(draw(st.integers(2, 4)))]
    periods = st.just(draw(st.sampled_from(PERIODS))) if draw(st.booleans()) else st.sampled_from(PERIODS)
    transfers = st.just("") if draw(st.booleans()) else st.sampled_from(TRANSFERS)
    sources = {name: draw(st.sampled_from([None, *names])) for name in names}
    if draw(st.booleans()):
        sources |= {"c0": "c1", "c1": "c0"}  # a power bond
    return {
        "periods": {name: draw(periods) for name in names},
        "sources": sources,
        "transfers": {name: draw(transfers) for name in names},
        "algorithm": draw(st.sampled_from(["jacobi", "gauss-seidel", "iterated", "ecco", "adaptive"])),
        "start": draw(st.sampled_from([Fraction(0), Fraction(2), Fraction(-1, 3)])),
        "span": draw(st.sampled_from(SPANS)),
        "order": tuple(draw(st.permutations(names))) if draw(st.booleans()) else (),
    }


def system_of(case: dict[str, Any], folder: Path, fmus: Path) -> System:
    fmu = read_system(folder, fmus, {"i": ("integrator", "1 s", {"=u": 0.0})}).components["i"].fmu
    components = {
        name: Component(name, fmu, p, {"x_start": k + 1.0}, {} if case["sources"][name] else {"u": 0.5})
        for k, (name, p) in enumerate(case["periods"].items())
    }
    connections = tuple(Connection((s, "x"), (t, "u"), case["transfers"][t]) for t, s in case["sources"].items() if s)
    bonded = case["sources"]["c0"] == "c1" and case["sources"]["c1"] == "c0"
    bonds = (Bond("both", ("c0.x", "c1.u"), ("c1.x", "c0.u"), 1.0),) if bonded else ()
    where = folder / "random.toml"
    start = case["start"]
    return System(
        "random", where, "", start + case["span"], case["algorithm"], case["order"], components, connections, bonds,
        start=start,
    )  # fmt: skip


def check_order(plan: Plan) -> None:
    """Every component steps through the cycle, and through what is left, without gap; what is interpolated reaches to
    the end of the step."""
    if plan.adaptive:  # all components step together, once or as a whole and two halves; the loop knows the lengths
        steps = [row[2:5] for row in plan.cycle.tolist() if row[0] == STEP]
        everyone = {(c, 0, 0) for c in range(len(plan.system.components))}
        assert len(steps) in (len(everyone), 3 * len(everyone))
        assert all({*map(tuple, steps[k : k + len(everyone)])} == everyone for k in range(0, len(steps), len(everyone)))
        return
    check_steps(plan, plan.cycle, plan.clock.hyperperiod)
    if plan.clock.rest:
        check_steps(plan, plan.last, plan.clock.rest)
    assert plan.clock.cycles * plan.clock.hyperperiod + plan.clock.rest == plan.clock.stop
    assert bool(len(plan.last)) == (plan.clock.rest > 0)


def check_steps(plan: Plan, rows: np.ndarray, span: int) -> None:
    """Steps are as long as their period; the last one ends with the span."""
    names, reached = list(plan.system.components), dict.fromkeys(plan.system.components, 0)
    for code, _, c, length, start, *_ in rows.tolist():
        if code != STEP:
            continue
        name = names[c]
        assert (start, length) == (reached[name], min(plan.clock.periods[name], span - start))
        for connection in plan.into(name):
            if plan.choices[connection].transfer == "interpolate":
                assert reached[connection.source[0]] >= start + length
        reached[name] += length
    assert set(reached.values()) == {span}


@settings(max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(case=systems())
def test_random_systems_have_a_valid_order_and_run_or_are_refused_clearly(
    case: dict[str, Any], tmp_path: Path, fmus: Path
) -> None:
    try:
        plan = make_plan(system_of(case, tmp_path, fmus))
    except InputError as error:
        assert any(words in str(error) for words in CLEAR), error
        return
    check_order(plan)
    run = simulate(plan)
    words = {"iterated": "did not converge", "adaptive": "no longer than the smallest allowed"}
    assert not run.failure or words.get(case["algorithm"], "none") in run.failure
    if not run.failure:
        assert run.end == float(case["start"] + case["span"])
        assert {int(ticks[-1]) for ticks in run.ticks} == {plan.clock.stop}
