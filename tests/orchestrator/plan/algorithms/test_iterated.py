"""Macro steps that are repeated from saved states until the coupling is consistent."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Measured, column, edited, last, plan_of, run_of
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from test_quarter_car import worst

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
AITKEN, NEWTON = {"method": "aitken"}, {"method": "newton"}


def car(
    tmp_path: Path, fmus: Path, chassis: str, wheel: str, iteration: dict[str, Any], wires: list[str] = WIRES
) -> Run:
    parts = {"w": ("wheel", wheel), "c": ("chassis", chassis)}
    return run_of(tmp_path, fmus, parts, wires, stop="4 s", algorithm="iterated", iteration=iteration)


@pytest.mark.parametrize("iteration", [AITKEN, NEWTON], ids=["aitken", "newton"])
def test_iterated_coupling_is_second_order_where_jacobi_is_first(
    iteration: dict[str, Any], tmp_path: Path, fmus: Path, measured: Measured
) -> None:
    errors = [worst(car(tmp_path, fmus, h, h, iteration)) for h in ("4 ms", "2 ms", "1 ms")]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    measured(f"quarter car, iterated with {iteration['method']}: observed order", float(orders[-1]), "2 +- 0.2")
    assert orders == pytest.approx(2.0, abs=0.2)
    parts = ({"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}, {"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")})
    jacobi = [worst(run_of(tmp_path, fmus, p, WIRES, stop="4 s", algorithm="jacobi")) for p in parts]
    measured("quarter car, Jacobi: observed order", float(np.log2(jacobi[0] / jacobi[1])), "1 +- 0.2")
    assert np.log2(jacobi[0] / jacobi[1]) == pytest.approx(1.0, abs=0.2)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("chassis", "wheel"), [("5 ms", "1 ms"), ("1 ms", "5 ms"), ("5 ms", "4 ms")])
def test_several_rates_are_second_order(chassis: str, wheel: str, tmp_path: Path, fmus: Path) -> None:
    halves = [f"{float(text.split()[0]) / 2:g} ms" for text in (chassis, wheel)]
    errors = [worst(car(tmp_path, fmus, *periods, AITKEN)) for periods in ((chassis, wheel), halves)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.2)


def test_both_methods_find_the_same_solution(tmp_path: Path, fmus: Path) -> None:
    tight = [{**method, "tolerance": 1e-11} for method in (AITKEN, NEWTON)]
    values = [column(car(tmp_path, fmus, "5 ms", "2.5 ms", i), "c.z_c")[1] for i in tight]
    np.testing.assert_allclose(values[0], values[1], rtol=0.0, atol=1e-10)


def test_iterations_and_residual_are_recorded(tmp_path: Path, fmus: Path) -> None:
    run = car(tmp_path, fmus, "5 ms", "1 ms", {"tolerance": 1e-7})
    count, residual = (column(run, f"coupling.{name}")[1] for name in ("iterations", "residual"))
    assert len(count) == 801 and np.all((count[1:] >= 1) & (count[1:] <= 50))
    assert 0.0 < np.max(residual) <= 1e-7


def test_compiled_loop_and_interpreter_agree_bitwise(tmp_path: Path, fmus: Path) -> None:
    for iteration in (AITKEN, NEWTON):
        parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "5 ms")}
        plan = plan_of(tmp_path, fmus, parts, WIRES, stop="100 ms", algorithm="iterated", iteration=iteration)
        tables = [simulate(plan, interpreted).tables for interpreted in (False, True)]
        assert all(a.tobytes() == b.tobytes() for a, b in zip(*tables, strict=True))


def test_newton_solves_a_loop_on_which_a_fixed_point_diverges(tmp_path: Path, fmus: Path) -> None:
    """a = 3 b + 1, b = 3 a + 1 at every instant; the fixed point triples its error in each pass."""
    parts = {name: ("gain", "10 ms", {"k": 3.0, "offset": 1.0}) for name in "ab"}
    wires = ["a.y -> b.u", "b.y -> a.u"]
    keys: dict[str, Any] = {"stop": "100 ms", "algorithm": "iterated"}
    run = run_of(tmp_path, fmus, parts, wires, iteration=NEWTON, **keys)
    assert last(run, "a.y") == pytest.approx(-0.5, abs=1e-6)


def test_not_converging_is_an_error_with_time_residual_and_input(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    iteration = {"tolerance": 1e-12, "max_iterations": 2}
    plan = plan_of(tmp_path, fmus, parts, WIRES, stop="1 s", algorithm="iterated", iteration=iteration)
    run = simulate(plan)
    assert "did not converge in the step to t = 0.005 s: residual" in run.failure
    assert "after 2 iterations (aitken, tolerance 1e-12)" in run.failure
    assert run.end == 0.0 and [len(table) for table in run.tables] == [1]


def test_the_coupling_makes_no_energy(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    bond = {"name": "spring and damper", "effort": "c.F", "flow": "w.v_c"}
    keys: dict[str, Any] = {"stop": "2 s", "algorithm": "iterated", "iteration": {"tolerance": 1e-11}}
    run = run_of(tmp_path, fmus, parts, WIRES, bonds=[bond], **keys)
    assert abs(last(run, "coupling.spring_and_damper_total")) < 1e-6
    assert np.max(np.abs(column(run, "coupling.spring_and_damper_flow_side")[1])) > 10.0


def test_a_sampled_controller_keeps_its_rhythm(tmp_path: Path, fmus: Path) -> None:
    """The passes repeat its steps from its saved state: what it gives is as without iteration."""
    inputs = {f"={n}": 0.0 for n in ("T_brush",)}
    free = (
        *("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "q", "r", "x_ref", "y_ref", "z_ref", "phi_ref"),
        *("theta_ref", "psi_ref", "v_ref", "V_ref", "F_n_ref", "F_tool", "M_tool"),
    )
    parts = {
        "plant": ("dc_motor", "1 ms", {"=V_in": 6.0, **inputs}),
        "control": ("rov_controller", "2 ms", {f"={name}": 0.0 for name in free}),
    }
    runs = [run_of(tmp_path, fmus, parts, ["plant.omega_m -> control.p"], stop="20 ms", algorithm=algorithm)
            for algorithm in ("jacobi", "iterated")]  # fmt: skip
    for name in ("control.p", "control.u_thruster[1]", "plant.omega_m"):
        assert np.array_equal(*(column(run, name)[1] for run in runs))


def test_the_plan_shows_what_is_repeated(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "5 ms")}
    text = explain(plan_of(tmp_path, fmus, parts, WIRES, stop="1 s", algorithm="iterated"))
    assert "algorithm iterated: each macro step repeated from saved states (aitken, at most 50 times)" in text
    for words in (
        "save        the state of w",
        "restore     the state of c",
        "repeat      from operation",
        "unknown c.F",
    ):
        assert words in text


def test_an_fmu_without_saved_states_is_refused_by_name_and_flag(tmp_path: Path, fmus: Path) -> None:
    wheel = edited(
        fmus / "wheel.fmu", tmp_path / "mute.fmu", {},
        {'canGetAndSetFMUstate="true"': 'canGetAndSetFMUstate="false"',
         'canSerializeFMUstate="true"': 'canSerializeFMUstate="false"'},
    )  # fmt: skip
    parts = {"w": (str(wheel), "5 ms"), "c": ("chassis", "5 ms")}
    message = r"component w: algorithm 'iterated' needs to restore .*mute\.fmu.*canGetAndSetFMUState = false"
    with pytest.raises(InputError, match=message):
        plan_of(tmp_path, fmus, parts, WIRES, algorithm="iterated")


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({"iteration": {"method": "newtn"}}, "unknown method 'newtn'; did you mean 'newton'"),
        ({"iteration": {"tolerance": 0.0}}, "tolerance = 0.0 must be a number above 0"),
        ({"iteration": {"max_iterations": 2.5}}, "max_iterations = 2.5 must be a whole number"),
        ({"iteration": {"tol": 1.0}}, "unknown key 'tol'"),
        ({"algorithm": "iterate"}, "unknown algorithm 'iterate'; did you mean 'iterated'"),
    ],
)
def test_wrong_settings_are_refused(keys: dict[str, Any], message: str, tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    with pytest.raises(InputError, match=message):
        plan_of(tmp_path, fmus, parts, WIRES, **{"algorithm": "iterated", **keys})


def test_a_stated_transfer_has_no_meaning_here(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    with pytest.raises(InputError, match="'linear' has no meaning; leave it out"):
        plan_of(tmp_path, fmus, parts, ["c.v_c -> w.v_c (linear)", "w.F -> c.F"], algorithm="iterated")


def test_ctrl_c_leaves_whole_macro_steps(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "5 ms")}
    plan = plan_of(tmp_path, fmus, parts, WIRES, stop="4 s", algorithm="iterated")
    run = simulate(plan, progress=lambda _: signal.raise_signal(signal.SIGINT))
    assert run.failure == f"interrupted by the user at t = {run.end:.9g} s" and 0.0 < run.end < 4.0
    for name in ("w.F", "c.F", "coupling.iterations"):
        assert column(run, name)[0][-1] == run.end
