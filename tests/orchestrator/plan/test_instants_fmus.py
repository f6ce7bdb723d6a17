"""What is true at an instant, by FMUs in machine code, of every type and in loops that cannot be solved."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Measured, column, plan_of, run_of
from native_build import answers, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc
both_loops = pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
H, MASS, STIFFNESS, DAMPING = 1e-4, (1.0, 2.0), 40.0, 0.3
SPRING = {"k": STIFFNESS, "d": DAMPING}
WIRES = ["a.x -> f.x1", "a.v -> f.v1", "b.x -> f.x2", "b.v -> f.v2", "f.F -> a.F", "f.back -> b.F"]


def monolithic(steps: int) -> np.ndarray:
    """Position of the first mass, by explicit Euler."""
    x, v, rows = [0.1, 0.0], [0.0, 0.0], [0.1]
    for _ in range(steps):
        force = STIFFNESS * (x[1] - x[0]) + DAMPING * (v[1] - v[0])
        x = [x[0] + H * v[0], x[1] + H * v[1]]
        v = [v[0] + H * force / MASS[0], v[1] - H * force / MASS[1]]
        rows.append(x[0])
    return np.array(rows)


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_two_masses_and_their_force_are_the_monolithic_explicit_euler_solution(
    algorithm: str, tmp_path: Path, measured: Measured
) -> None:
    """With Gauss-Seidel in this order, in which the masses step before the force that they feel."""
    answers(tmp_path / "mass.fmu", "mass")
    answers(tmp_path / "force.fmu", "force")
    parts = {
        "a": ("mass", "0.1 ms", {"m": MASS[0], "x0": 0.1}),
        "b": ("mass", "0.1 ms", {"m": MASS[1]}),
        "f": ("force", "0.1 ms", SPRING),
    }
    keys = {"order": list(parts)} if algorithm == "gauss-seidel" else {}
    run = run_of(tmp_path, tmp_path, parts, WIRES, stop="10 s", algorithm=algorithm, **keys)
    error = float(np.max(np.abs(column(run, "a.x")[1] - monolithic(100_000))))
    measured(f"two masses by a force, FMUs in C, {algorithm}, 100 000 steps: largest error of x [m]", error, "1e-12")
    assert error <= 1e-12


@pytest.mark.sampled(4)
@both_loops
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel", "iterated"])
@pytest.mark.parametrize("kind", ["n", "on"])
def test_a_loop_of_whole_numbers_is_cut_at_its_last_connection_and_the_plan_says_so(
    kind: str, algorithm: str, interpreted: bool, tmp_path: Path
) -> None:
    answers(tmp_path / "c.fmu", "counter", "integers", "booleans", "reals")
    parts = {name: ("c", "1 ms") for name in "zab"}
    wires = [f"a.{kind}_out -> b.{kind}_in", f"b.{kind}_out -> a.{kind}_in", "z.y -> a.u", "z.y -> b.u"]
    plan = plan_of(tmp_path, tmp_path, parts, wires, stop="10 ms", algorithm=algorithm)
    assert f"b.{kind}_out -> a.{kind}_in" in next(line for line in explain(plan).splitlines() if " is cut at " in line)
    run = simulate(plan, interpreted)
    assert not run.failure
    a, b = (column(run, f"{name}.{kind}_out")[1].view(np.int64).tolist() for name in "ab")

    def answer(given: int, k: int) -> int:
        return given ^ (k & 1) if kind == "on" else given // 2 + k

    expected: list[tuple[int, int]] = [(0, 0)]
    for k in range(1, 11):
        first = answer(expected[-1][1], k)
        expected.append((first, answer(first, k)))
    assert list(zip(a, b, strict=True)) == expected


@both_loops
@pytest.mark.parametrize("inputs", ["mean", "end"])
def test_iterated_gives_rows_of_their_instant_and_images_of_their_step(
    inputs: str, interpreted: bool, tmp_path: Path
) -> None:
    """y = 2 n at once, n counts steps: over step k the mass feels 2 k, a row of instant k holds 2 k."""
    answers(tmp_path / "c.fmu", "counter", "mass")
    answers(tmp_path / "s.fmu", "integers", "reals")
    parts = {"c": ("c", "1 ms"), "s": ("s", "1 ms"), "z": ("s", "1 ms")}
    wires = ["c.n -> s.n_in", "s.y -> c.F", "z.y -> s.u"]
    plan = plan_of(tmp_path, tmp_path, parts, wires, stop="10 ms", algorithm="iterated", iteration={"inputs": inputs})
    run = simulate(plan, interpreted)
    assert not run.failure
    k = np.arange(11)
    assert column(run, "s.y")[1].tolist() == (2.0 * k).tolist()
    expected = np.concatenate([[0.0], np.cumsum(2.0 * k[:-1]) * 1e-3])
    assert column(run, "c.v")[1] == pytest.approx(expected, rel=1e-12, abs=1e-15)


def test_settings_of_loops_reach_the_solver_and_wrong_ones_are_refused(tmp_path: Path) -> None:
    answers(tmp_path / "s.fmu", "reals")
    parts = {name: ("s", "1 ms") for name in "ab"}
    wires = ["a.y -> b.u", "b.y -> a.u"]
    plan = plan_of(tmp_path, tmp_path, parts, wires, stop="2 ms", loops={"tolerance": 1e-6, "max_iterations": 7})
    solve = next(line for line in explain(plan).splitlines() if "solve" in line and "within" in line)
    assert "within 1e-06" in solve and "at most 7 times" in solve
    for wrong, said in (
        ({"tolerance": 0.0}, "tolerance = 0.0 must be"),
        ({"max_iterations": 0}, "max_iterations = 0 must be"),
        ({"tolerence": 1e-6}, "unknown key 'tolerence'; did you mean 'tolerance'?"),
    ):
        with pytest.raises(InputError, match=said) as error:
            plan_of(tmp_path, tmp_path, parts, wires, stop="2 ms", loops=wrong)
        assert "loops" in str(error.value) and "case.toml" in str(error.value)
