"""Time 0: values propagate along the connections, loops are refused, and inputs are never set to made-up numbers."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import column, plan_of, run_of
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.simulation import simulate


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


def test_an_algebraic_loop_is_refused_by_name(tmp_path: Path, fmus: Path) -> None:
    parts = {
        "a": ("gain", "10 ms", {"k": 0.5, "offset": 1.0}),
        "b": ("gain", "10 ms", {"k": 0.7, "offset": 1.0}),
        "w": ("wave", "10 ms"),
    }
    with pytest.raises(FmuError, match=r"the inputs a\.u, b\.u and the outputs that drive them form an algebraic loop"):
        simulate(plan_of(tmp_path, fmus, parts, ["a.y -> b.u", "b.y -> a.u"]))


def test_an_input_is_never_set_before_its_source_is_known(tmp_path: Path, fmus: Path) -> None:
    """The root fails for u = 0; its source, which comes later in the order, gives 4 from the start."""
    parts = {"r": ("root", "10 ms"), "w": ("wave", "10 ms", {"c0": 4.0})}
    run = run_of(tmp_path, fmus, parts, ["w.y -> r.u"], stop="20 ms", order=["r", "w"])
    assert list(column(run, "r.y")[1]) == [0.25, 0.25, 0.25]
