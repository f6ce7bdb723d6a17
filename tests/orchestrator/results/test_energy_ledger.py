"""The energy that the coupling makes at power bonds: per step, in total, and what it may be."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Measured, column, last, plan_of, run_of, system_text
from quarter_car import energy_made_by_holding
from rovbrush.orchestrator.cli.run_system import run_system
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.system.request import Request

WIRES = ["c.v_c -> w.v_c (hold)", "w.F -> c.F (hold)"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}
COUNTED = {**BOND, "impulse": "w.J", "displacement": "c.z_c"}


def car(tmp_path: Path, fmus: Path, bond: dict[str, Any], period: str = "5 ms", **keys: Any) -> Run:
    """The force is the one at the end of the wheel's step, with the held speed: its imbalance is known exactly."""
    parts = {"w": ("wheel", period), "c": ("chassis", period)}
    return run_of(tmp_path, fmus, parts, WIRES, bonds=[bond], of={"w": {"direct": "off"}},
                  **{"stop": "4 s", "algorithm": "jacobi", **keys})  # fmt: skip


@pytest.mark.parametrize("period", [1, 5, 10])
def test_the_energy_made_equals_the_exact_imbalance(
    period: int, tmp_path: Path, fmus: Path, measured: Measured
) -> None:
    run = car(tmp_path, fmus, COUNTED, f"{period} ms")
    made, imbalance = last(run, "coupling.strut_total"), energy_made_by_holding(period / 1000, 4000 // period)
    measured("quarter car: energy made by the coupling against the exact imbalance [J]", made - imbalance, "1e-9")
    assert abs(imbalance) > 0.1
    assert made == pytest.approx(imbalance, abs=1e-9)


def test_the_steps_add_up_to_the_total(tmp_path: Path, fmus: Path) -> None:
    run = car(tmp_path, fmus, COUNTED)
    made, total = (column(run, f"coupling.strut_{name}")[1] for name in ("made", "total"))
    assert made[0] == total[0] == 0.0 and np.ptp(made) > 0.1
    np.testing.assert_allclose(np.cumsum(made), total, atol=1e-10)
    sides = [column(run, f"coupling.strut_{name}_side")[1] for name in ("flow", "effort")]
    assert np.array_equal(sides[0] - sides[1], total)


def test_trapezoids_come_near_the_counters_as_the_steps_shrink(tmp_path: Path, fmus: Path) -> None:
    """They miss the jumps of a force that feels the held speed at once: at least first order."""
    difference = [
        last(car(tmp_path, fmus, BOND, h), "coupling.strut_total")
        - last(car(tmp_path, fmus, COUNTED, h), "coupling.strut_total")
        for h in ("2 ms", "1 ms")
    ]
    assert 0.0 < abs(difference[1]) < 0.55 * abs(difference[0])


def test_bonds_of_two_rates_are_booked_where_both_have_stepped(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "3 ms"), "c": ("chassis", "5 ms")}
    run = run_of(tmp_path, fmus, parts, ["c.v_c -> w.v_c", "w.F -> c.F"], stop="150 ms", bonds=[COUNTED], record=[])
    times, made = column(run, "coupling.strut_made")
    assert times.tolist() == pytest.approx([0.015 * k for k in range(11)])
    assert np.all(made[1:] != 0.0)


def test_the_plan_shows_the_books(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    bond = {**COUNTED, "limit": 2.0, "limit_relative": 0.01}
    text = explain(plan_of(tmp_path, fmus, parts, WIRES, bonds=[bond]))
    assert "counted exactly by w.J and exactly by c.z_c; the coupling may make 2 J and 0.01 of it" in text
    assert "coupling.strut_flow_side += c.F (1 previous c.z_c + -1 c.z_c) 1" in text
    assert "ledger" in text


@pytest.mark.parametrize(
    ("limit", "words"), [({"limit": 1.0}, "allowed are 1 J"), ({"limit_relative": 1e-3}, "allowed is 0.001")]
)
def test_too_much_energy_fails_the_run_and_keeps_the_results(
    limit: dict[str, float], words: str, tmp_path: Path, fmus: Path
) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    path = tmp_path / "car.toml"
    path.write_text(system_text(parts, WIRES, stop="4 s", algorithm="jacobi", bonds=[{**COUNTED, **limit}]))
    with pytest.raises(RunError, match=f"power bond strut: the coupling made .*{words}"):
        run_system(Request(str(path), fmus=str(fmus)), tmp_path / "out", check=False)
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["complete"] and not summary["coupling_energy"]["strut"]["within"]
    assert (tmp_path / "out" / "result.nc").is_file()


def test_a_limit_that_is_kept_is_no_failure(tmp_path: Path, fmus: Path) -> None:
    run = car(tmp_path, fmus, {**COUNTED, "limit": 100.0, "limit_relative": 0.5})
    assert summarize(run)["coupling_energy"]["strut"]["within"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"impulse": "w.I"}, "impulse = 'w.I' is no output of w, which gives w.F"),
        ({"displacement": "w.J"}, "displacement = 'w.J' is no output of c, which gives c.v_c"),
        ({"limit": -1.0}, "limit = -1.0 must be a number of J, 0 or more"),
        ({"limits": 1.0}, "unknown key 'limits'; did you mean 'limit'"),
    ],
)
def test_wrong_entries_are_refused(change: dict[str, Any], message: str, tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    with pytest.raises(InputError, match=message):
        plan_of(tmp_path, fmus, parts, WIRES, bonds=[{**COUNTED, **change}])


def test_a_component_may_not_be_called_as_the_coupling(tmp_path: Path, fmus: Path) -> None:
    parts = {"coupling": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    bond = {"name": "strut", "effort": "c.F", "flow": "coupling.v_c"}
    with pytest.raises(InputError, match="may not be called 'coupling'"):
        plan_of(tmp_path, fmus, parts, ["c.v_c -> coupling.v_c", "coupling.F -> c.F"], bonds=[bond])
