"""The plan is explicit data, and it does what Jacobi and Gauss-Seidel mean."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from event_cases import KEEP
from event_cases import planned as plan_of_mocks
from helpers import column, last, plan_of, read_system, run_of
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop.operations import NAMES
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.model import System

CONTROLLER_REST = (  # the inputs of the controller but for `p`
    *("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "q", "r"),
    *("x_ref", "y_ref", "z_ref", "phi_ref", "theta_ref", "psi_ref", "v_ref", "V_ref", "F_n_ref"),
    *("F_tool", "M_tool"),
)
SOURCE = ("wave", "1 ms", {"c1": 1.0})
TARGET = ("integrator", "2 ms")


def steps(plan: Plan) -> list[str]:
    """The cycle as text: `1 ms: step fast`."""
    names = [*plan.system.components, "-"]
    return [f"{plan.clock.time(int(row[1])) * 1e3:g}: {NAMES[row[0]]} {names[row[2]]}" for row in plan.cycle]


def test_two_rates_give_this_list_of_operations(tmp_path: Path, fmus: Path) -> None:
    plan = plan_of(tmp_path, fmus, {"slow": TARGET, "fast": SOURCE}, ["fast.y -> slow.u"], algorithm="gauss-seidel")
    assert plan.order == ("fast", "slow")
    assert steps(plan) == [
        "1: step fast", "1: push fast", "1: get fast", "1: accumulate fast", "1: record -",
        "2: step fast", "2: push fast", "2: get fast", "2: accumulate fast",
        "2: mean slow", "2: set slow", "2: step slow", "2: get slow", "2: record -", "2: record -",
    ]  # fmt: skip


def test_jacobi_forms_inputs_at_the_beginning_of_the_step(tmp_path: Path, fmus: Path) -> None:
    parts = {"slow": ("integrator", "2 ms", {"=u": 1.0}), "fast": ("integrator", "1 ms")}
    plan = plan_of(tmp_path, fmus, parts, ["slow.x -> fast.u (hold)"], algorithm="jacobi")
    assert steps(plan) == [
        "0: copy fast",
        "1: set fast", "1: step fast", "1: get fast", "1: record -", "1: copy fast",
        "2: set fast", "2: step fast", "2: get fast", "2: step slow", "2: get slow",
        "2: record -", "2: record -",
    ]  # fmt: skip


def test_defaults_come_with_their_reason(tmp_path: Path, fmus: Path) -> None:
    parts = {"slow": ("integrator", "2 ms"), "fast": ("integrator", "1 ms"), "twin": ("integrator", "1 ms")}
    plan = plan_of(tmp_path, fmus, parts, ["fast.x -> slow.u", "slow.x -> fast.u", "fast.x -> twin.u"])
    chosen = {c.label: (choice.transfer, choice.reason) for c, choice in plan.choices.items()}
    assert [v[0] for v in chosen.values()] == ["mean", "hold", "hold"]
    assert "impulse" in chosen["fast.x -> slow.u"][1] and "slow to fast: held" in chosen["slow.x -> fast.u"][1]


def test_a_sampled_output_is_held_by_default(tmp_path: Path, fmus: Path) -> None:
    inputs = {"=u": 0.0, "=temperature": 0.0, "=speed": 0.0}
    parts = {"p": ("plain", "2 ms", inputs), "a": ("integrator", "1 ms"), "b": ("integrator", "1 ms")}
    plan = plan_of(tmp_path, fmus, parts, ["p.sampled -> a.u", "p.y -> b.u"])
    assert [(choice.transfer, choice.former) for choice in plan.choices.values()] == [("hold", ""), ("hold", "linear")]


def test_a_component_with_sampled_inputs_only_steps_at_the_beginning_of_its_period(tmp_path: Path, fmus: Path) -> None:
    held = {f"={name}": 0.0 for name in CONTROLLER_REST}
    parts = {
        "plant": ("dc_motor", "1 ms", {"=V_in": 0.0, "=T_brush": 0.0}),
        "control": ("rov_controller", "2 ms", held),
    }
    plan = plan_of(tmp_path, fmus, parts, ["plant.omega_m -> control.p"])
    assert plan.samplers == ("control",)
    assert steps(plan) == [
        "0: copy control", "0: set control", "0: step control", "0: get control",
        "1: step plant", "1: get plant", "1: record -", "2: step plant", "2: get plant", "2: record -", "2: record -",
    ]  # fmt: skip
    step = plan.cycle[2]
    assert plan.clock.time(int(step[4])) == 0.0 and plan.clock.time(int(step[3])) == 2e-3


def test_averaging_into_a_sampled_component_is_refused(tmp_path: Path, fmus: Path) -> None:
    held = {f"={name}": 0.0 for name in CONTROLLER_REST}
    parts = {
        "plant": ("dc_motor", "1 ms", {"=V_in": 0.0, "=T_brush": 0.0}),
        "control": ("rov_controller", "2 ms", held),
    }
    with pytest.raises(InputError, match="control samples its inputs, so 'mean' has no meaning"):
        plan_of(tmp_path, fmus, parts, ["plant.omega_m -> control.p (mean)"])


def test_sources_come_before_targets_and_fast_before_slow(tmp_path: Path, fmus: Path) -> None:
    parts = {
        "d": ("integrator", "2 ms"),
        "c": ("integrator", "1 ms"),
        "b": ("integrator", "1 ms"),
        "a": ("integrator", "1 ms", {"=u": 1.0}),
    }
    assert plan_of(tmp_path, fmus, parts, ["a.x -> b.u", "b.x -> c.u", "c.x -> d.u"]).order == ("a", "b", "c", "d")


N, STEP = 8, 0.25  # all numbers below are exact in binary


def chain(tmp_path: Path, fmus: Path, **keys: Any) -> list[float]:
    parts = {"a": ("integrator", "250 ms", {"=u": 1.0}), "b": ("integrator", "250 ms"), "c": ("integrator", "250 ms")}
    run = run_of(tmp_path, fmus, parts, ["a.x -> b.u", "b.x -> c.u"], stop="2 s", **keys)
    return [last(run, f"{name}.x") for name in "abc"]


def summed(values: list[float]) -> list[float]:
    """Running sum times the step, from 0."""
    return [STEP * sum(values[:k]) for k in range(N + 1)]


def test_jacobi_delays_every_connection_by_a_step(tmp_path: Path, fmus: Path) -> None:
    a = [STEP * k for k in range(N + 1)]
    b = summed(a)
    assert chain(tmp_path, fmus, algorithm="jacobi") == [a[-1], b[-1], summed(b)[-1]]


def test_gauss_seidel_passes_new_values_down_the_order(tmp_path: Path, fmus: Path) -> None:
    a = [STEP * k for k in range(N + 1)]
    b = [STEP * sum(a[: k + 1]) for k in range(N + 1)]
    assert chain(tmp_path, fmus, algorithm="gauss-seidel") == [a[-1], b[-1], STEP * sum(b)]


def test_gauss_seidel_against_the_order_is_jacobi(tmp_path: Path, fmus: Path) -> None:
    against = chain(tmp_path, fmus, algorithm="gauss-seidel", order=["c", "b", "a"])
    assert against == chain(tmp_path, fmus, algorithm="jacobi")


def test_a_stated_order_that_puts_slow_before_fast_is_refused(tmp_path: Path, fmus: Path) -> None:
    parts = {"slow": ("integrator", "2 ms", {"=u": 1.0}), "fast": ("integrator", "1 ms", {"=u": 1.0})}
    with pytest.raises(InputError, match=r"order: slow is slower than fast and must come after it \(case.toml\)"):
        plan_of(tmp_path, fmus, parts, order=["slow", "fast"])


def test_mean_from_slow_to_fast_is_refused_with_the_line(tmp_path: Path, fmus: Path) -> None:
    parts = {"slow": ("integrator", "2 ms", {"=u": 1.0}), "fast": ("integrator", "1 ms")}
    with pytest.raises(InputError, match=r"slow\.x -> fast\.u: 'mean' needs .*2 ms against 1 ms.*case\.toml, line 3"):
        plan_of(tmp_path, fmus, parts, ["slow.x -> fast.u (mean)"])


def test_periods_that_hardly_ever_meet_are_refused(tmp_path: Path, fmus: Path) -> None:
    parts = {"a": ("integrator", "1 us", {"=u": 1.0}), "b": ("integrator", "2.000001 s", {"=u": 1.0})}
    with pytest.raises(InputError, match=r"repeat only every 2.000001 s.*choose periods with a common multiple"):
        plan_of(tmp_path, fmus, parts, stop="2.000001 s")


# --- random systems against the definitions ---

PERIODS = (Fraction(1, 8), Fraction(1, 4), Fraction(3, 8), Fraction(5, 8))
LENGTH = 30  # ticks of 1/8 s


@st.composite
def systems(draw: st.DrawFn) -> dict[str, Any]:
    count = draw(st.integers(1, 4))
    names = [f"c{k}" for k in range(count)]
    transfers = st.sampled_from(["", "hold", "linear", "quadratic", "mean"])
    return {
        "periods": {name: draw(st.sampled_from(PERIODS)) for name in names},
        "sources": {name: draw(st.sampled_from([None, *names])) for name in names},
        "transfers": {name: draw(transfers) for name in names},
        "algorithm": draw(st.sampled_from(["jacobi", "gauss-seidel"])),
        "order": tuple(draw(st.permutations(names))) if draw(st.booleans()) else (),
    }


def by_definition(case: dict[str, Any], plan: Plan) -> dict[str, list[float]]:
    """x of every integrator at its own samples, from the meaning of the words and the full history of all samples."""
    period = {name: int(p * 8) for name, p in case["periods"].items()}
    choice = {c.target[0]: t.transfer for c, t in plan.choices.items()}
    x = {name: {0: float(k + 1)} for k, name in enumerate(period)}
    received = dict.fromkeys(period, 0.0)  # impulse handed over so far by `mean`, in ticks

    def line(name: str, s: int, at: float) -> float:
        before = x[name][max(s - period[name], 0)]
        return x[name][s] + (x[name][s] - before) * (at - s) / period[name]

    def parabola(name: str, s: int, start: int, H: int) -> float:
        h = period[name]
        known = [x[name][max(s - k * h, 0)] for k in range(3)]
        through = np.poly1d(np.polyfit([0.0, -1.0, -2.0], known, 2)).integ()
        return float(through((start + H - s) / h) - through((start - s) / h)) * h / H

    def integral(name: str, s: int) -> float:
        h = period[name]
        return sum(h * (x[name][k] + x[name][k + h]) / 2 for k in range(0, s, h))

    for tick in range(1, LENGTH + 1):
        due = [name for name in plan.order if tick % period[name] == 0]
        for name in due:
            source, start, H = case["sources"][name], tick - period[name], period[name]
            u = 0.5
            if source is not None:
                latest = max(
                    k
                    for k in x[source]
                    if k <= (start if case["algorithm"] == "jacobi" and choice[name] != "mean" else tick)
                )
                if choice[name] == "hold":
                    u = x[source][latest]
                elif choice[name] == "linear":
                    u = line(source, latest, start + H / 2)
                elif choice[name] == "quadratic":
                    u = parabola(source, latest, start, H)
                else:
                    u = (
                        integral(source, latest)
                        + (tick - latest) * line(source, latest, (tick + latest) / 2)
                        - received[name]
                    ) / H
                    received[name] += u * H
            x[name][tick] = x[name][start] + H / 8 * u
    return {name: [x[name][k] for k in sorted(x[name])] for name in period}


@settings(max_examples=80, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(case=systems())
def test_random_multirate_systems_follow_the_definitions_or_are_refused(
    case: dict[str, Any], tmp_path: Path, fmus: Path
) -> None:
    template = read_system(tmp_path, fmus, {"i": ("integrator", "1 s", {"=u": 0.0})}).components["i"].fmu
    components = {
        name: Component(name, template, p, {"x_start": k + 1.0}, {} if case["sources"][name] else {"u": 0.5})
        for k, (name, p) in enumerate(case["periods"].items())
    }  # fmt: skip
    connections = tuple(Connection((s, "x"), (t, "u"), case["transfers"][t]) for t, s in case["sources"].items() if s)
    system = System(
        "random",
        tmp_path / "random.toml",
        "",
        Fraction(LENGTH, 8),
        case["algorithm"],
        case["order"],
        components,
        connections,
    )
    try:
        plan = make_plan(system)
    except InputError as error:
        bad_mean = any(
            c.transfer == "mean" and components[c.source[0]].period > components[c.target[0]].period
            for c in connections
        )
        bad_order = any(
            components[a].period > components[b].period for a, b in zip(case["order"], case["order"][1:], strict=False)
        )
        assert ("'mean' needs" in str(error) and bad_mean) or ("order" in str(error) and bad_order)
        return
    assert sorted(plan.order) == sorted(components)
    ordered = [components[name].period for name in plan.order]
    assert ordered == sorted(ordered)
    run = simulate(plan)
    assert not run.failure
    for name, expected in by_definition(case, plan).items():
        seen = column(run, f"{name}.x")[1]
        np.testing.assert_allclose(seen, expected, rtol=1e-11, atol=1e-11)


def test_many_components_that_exchange_little_are_planned() -> None:
    """What is counted is what there is: not every connection at every step."""
    count = 2_400
    parts = {f"m{k}": (KEEP, "0.001") for k in range(count)}
    plan = plan_of_mocks(parts, [f"m{k}.y -> m{k + 1}.u" for k in range(count - 1)], [], "0.01", algorithm="jacobi")
    assert len(plan.cycle) < 10 * count
