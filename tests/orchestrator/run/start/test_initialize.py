"""Time 0: values propagate along the connections, loops are solved, and inputs are never set to made-up numbers."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import column, plan_of, run_of
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.start import loops as start_loops
from rovbrush.orchestrator.run.start.loops import StartLoop


def test_feedthrough_chains_settle_whatever_the_order_of_the_file(tmp_path: Path, fmus: Path) -> None:
    gain = ("gain", "10 ms", {"k": 2.0, "offset": 1.0})
    parts = {"c": gain, "b": gain, "a": gain, "w": ("wave", "10 ms", {"c0": 5.0})}
    wires = ["w.y -> a.u", "a.y -> b.u", "b.y -> c.u"]
    for keys in ({}, {"order": ["c", "b", "a", "w"]}, {"algorithm": "jacobi"}):
        run = run_of(tmp_path, fmus, parts, wires, stop="10 ms", **keys)
        assert [column(run, f"{name}.y")[1][0] for name in "wabc"] == [5.0, 11.0, 23.0, 47.0]


def test_a_loop_through_a_state_settles(tmp_path: Path, fmus: Path) -> None:
    parts = {"g": ("gain", "10 ms", {"k": -1.0, "offset": 0.0}), "i": ("integrator", "10 ms", {"x_start": 3.0})}
    run = run_of(tmp_path, fmus, parts, ["i.x -> g.u", "g.y -> i.u"])
    assert column(run, "g.y")[1][0] == -3.0


LOOP = ["a.y -> b.u", "b.y -> a.u"]


def test_an_algebraic_loop_is_solved_and_its_residual_is_reported(tmp_path: Path, fmus: Path) -> None:
    """a = k b + 1, b = k a + 1: sweeps would settle slowly for 0.9 and never for 3."""
    for k in (0.9, 3.0, -2.0):
        parts = {name: ("gain", "10 ms", {"k": k, "offset": 1.0}) for name in "ab"}
        run = run_of(tmp_path, fmus, parts, LOOP, stop="10 ms")
        assert column(run, "a.y")[1][0] == pytest.approx(1.0 / (1.0 - k), rel=1e-9)
        assert list(run.started.loops) == ["loop b.u, a.u"] and run.started.loops["loop b.u, a.u"] <= 1e-9


def test_a_nonlinear_loop_is_solved(tmp_path: Path, fmus: Path) -> None:
    """r = 1/u and u = 2 r - 1/2: 2 r^2 - r/2 = 1, from the FMU's start value 1 to the positive root."""
    parts = {"r": ("root", "10 ms"), "g": ("gain", "10 ms", {"k": 2.0, "offset": -0.5})}
    run = run_of(tmp_path, fmus, parts, ["r.y -> g.u", "g.y -> r.u"], stop="10 ms")
    assert column(run, "r.y")[1][0] == pytest.approx((0.5 + (0.25 + 8.0) ** 0.5) / 4.0, rel=1e-9)


def test_what_comes_behind_a_loop_gets_its_solution(tmp_path: Path, fmus: Path) -> None:
    gain = ("gain", "10 ms", {"k": 0.5, "offset": 1.0})
    parts = {"last": gain, "a": gain, "b": gain, "w": ("wave", "10 ms", {"c0": 3.0}), "first": gain}
    plan = plan_of(tmp_path, fmus, parts, ["a.y -> last.u", *LOOP, "w.y -> first.u"], stop="10 ms")
    labels = [block.label for block in plan.start]
    assert labels.index("loop b.u, a.u") < labels.index("a.y -> last.u")
    assert "loop b.u, a.u (solved as a whole)" in explain(plan)
    assert column(simulate(plan), "last.y")[1][0] == pytest.approx(2.0)


def test_a_loop_without_solution_is_refused_by_name(tmp_path: Path, fmus: Path) -> None:
    parts = {name: ("gain", "10 ms", {"k": 1.0, "offset": 1.0}) for name in "ab"}
    with pytest.raises(FmuError, match=r"the algebraic loop b\.u, a\.u has no solution .* residual"):
        simulate(plan_of(tmp_path, fmus, parts, LOOP))


def test_an_input_is_never_set_before_its_source_is_known(tmp_path: Path, fmus: Path) -> None:
    """The root fails for u = 0; its source, which comes later in the order, gives 4 from the start."""
    parts = {"r": ("root", "10 ms"), "w": ("wave", "10 ms", {"c0": 4.0})}
    run = run_of(tmp_path, fmus, parts, ["w.y -> r.u"], stop="20 ms", order=["r", "w"])
    assert list(column(run, "r.y")[1]) == [0.25, 0.25, 0.25]


@pytest.mark.parametrize("k, singular", [(1.0, True), (-1.0, True), (0.5, False), (-2.0, False)])
def test_a_loop_that_any_value_solves_is_told(k: float, singular: bool, tmp_path: Path, fmus: Path) -> None:
    """a = k b, b = k a: with k = 1 or -1 any value solves it, also that which the FMUs start with."""
    parts = {name: ("gain", "10 ms", {"k": k, "offset": 0.0}) for name in "ab"}
    run = run_of(tmp_path, fmus, parts, LOOP, stop="10 ms")
    told = [note for note in run.notes if "loop b.u, a.u has more than one solution" in note]
    assert len(told) == singular and column(run, "a.y")[1].tolist() == [0.0, 0.0]


def test_a_large_ring_takes_some_passes_along_it_and_not_one_for_each_input(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Sixty gains in a ring, of which the inputs of all were unknowns before: 61 passes for every derivative."""
    names, passes = [f"g{k}" for k in range(60)], []
    sent = StartLoop.sent
    monkeypatch.setattr(StartLoop, "sent", lambda loop, inputs: passes.append(len(inputs)) or sent(loop, inputs))
    parts = {name: ("gain", "10 ms", {"k": 0.99, "offset": 1.0}) for name in names}
    wires = [f"{a}.y -> {b}.u" for a, b in zip(names, [*names[1:], names[0]], strict=True)]
    run = run_of(tmp_path, fmus, parts, wires, stop="10 ms")
    assert column(run, "g7.y")[1][0] == pytest.approx(100.0, rel=1e-9)
    assert set(passes) == {1} and len(passes) < 30


def test_outputs_that_depend_on_inputs_by_their_description_only_are_no_equations(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A gain of 0 depends on its input as far as anybody knows; what it sends is what it sends."""
    monkeypatch.setattr(start_loops, "needed", lambda *_: pytest.fail("a solver is not needed"))
    parts = {name: ("gain", "10 ms", {"k": 0.0, "offset": 3.0}) for name in "ab"}
    run = run_of(tmp_path, fmus, parts, LOOP, stop="10 ms")
    assert column(run, "a.y")[1].tolist() == [3.0, 3.0] and run.started.loops == {"loop b.u, a.u": 0.0}


def test_the_values_that_are_sent_at_first_are_not_tried_where_they_are_no_solution(tmp_path: Path, fmus: Path) -> None:
    """r = 1/u, which fails at u = 0, and u = 2 r - 2: from the start value u = 1 comes u = 0, the solution is
    sqrt(3) - 1."""
    parts = {"r": ("root", "10 ms"), "g": ("gain", "10 ms", {"k": 2.0, "offset": -2.0})}
    run = run_of(tmp_path, fmus, parts, ["g.y -> r.u", "r.y -> g.u"], stop="10 ms")
    assert column(run, "g.y")[1][0] == pytest.approx(3.0**0.5 - 1.0, rel=1e-9)
