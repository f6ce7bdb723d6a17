"""The Jacobian of FMUs for Model Exchange, by directional derivatives through their connections."""

from __future__ import annotations

import sys
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import array_exchange_build
import exchange_build
import numpy as np
import pytest
from exchange_groups import group_of, run
from native_build import needs_gcc
from rovbrush.orchestrator.integration import cells
from rovbrush.orchestrator.integration.compiled import FUNCTIONS, address_of
from rovbrush.orchestrator.integration.memory import call, call_whole, number
from rovbrush.orchestrator.integration.stiff.libraries import is_there
from rovbrush.orchestrator.integration.stiff.sundials import address
from rovbrush.orchestrator.loop.machine.compiled import loop_files
from rovbrush.orchestrator.participant.model_exchange.group import Group
from rovbrush.orchestrator.participant.model_exchange.links import Link, LinkBlock
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = [needs_gcc, pytest.mark.skipif(not is_there(), reason="no CVODE on this platform")]


def jacobian_of(group: Group) -> np.ndarray:
    """What CVODE is given where the group is now; elements outside a band are nan."""
    solver, n = group._cvode, group.tables.states
    assert solver is not None and group.exact
    matrix = solver._matrix.value
    flag = call(address_of("jacobian"), group.time, solver._x.value, 0, matrix, group.pointer, 0, 0, 0)
    assert flag == 0, group.why()
    found = np.full((n, n), np.nan)
    for j in range(n):
        if group.bands:
            lower, upper = group.bands
            at = call_whole(address("SUNBandMatrix_Column"), matrix, j)
            for i in range(max(j - upper, 0), min(j + lower + 1, n)):
                found[i, j] = number(at + 8 * (i - j))
        else:
            at = call_whole(address("SUNDenseMatrix_Column"), matrix, j)
            found[:, j] = [number(at + 8 * i) for i in range(n)]
    return found


LAGS = [{"tau": 0.5, "d": 0.5, "x": 1.0}, {"tau": 0.25, "d": -0.4, "x": 2.0}, {"x": 0.7, "v": 0.3, "mu": 5.0}]


@pytest.mark.parametrize("version", [2, 3])
def test_it_goes_through_gains_and_loops_into_a_nonlinear_model(tmp_path: Path, version: int) -> None:
    """y_k = x_k + d_k u_k, u1 = 3 y2, u2 = y1 in a loop; x_k' = (u_k - x_k) / tau_k; y2 drives an oscillator."""
    loop = LinkBlock((Link((1, "y"), (0, "push"), 3.0, 1.0), Link((0, "y"), (1, "push"))), True)
    blocks = [loop, LinkBlock((Link((1, "y"), (2, "u"), -2.0),))]
    names, method = ("lag", "lag", "oscillator"), {"method": "cvode"}
    with group_of(tmp_path, *names, values=LAGS, blocks=blocks, version=version, **method) as group:
        found = jacobian_of(group)
        d1, d2, x, v, mu = 0.5, -0.4, 0.7, 0.3, 5.0
        whole = np.array([[1.0, -3.0 * d2], [-d1, 1.0]])  # of u1 and u2
        du = np.linalg.solve(whole, [[0.0, 3.0], [1.0, 0.0]])
        dy2 = np.array([0.0, 1.0]) + d2 * du[1]
        exact = np.zeros((4, 4))
        exact[0, :2] = (du[0] - [1.0, 0.0]) / 0.5
        exact[1, :2] = (du[1] - [0.0, 1.0]) / 0.25
        exact[2, 3] = 1.0
        exact[3] = [*(-2.0 * dy2), -2.0 * mu * x * v - 1.0, mu * (1.0 - x * x)]
        assert found == pytest.approx(exact, abs=1e-7)


def test_an_fmu_that_a_state_does_not_reach_is_not_asked(tmp_path: Path) -> None:
    """Of two lags behind each other the second one's state reaches the first nowhere."""
    blocks = [LinkBlock((Link((0, "y"), (1, "push")),))]
    with group_of(tmp_path, "lag", "lag", blocks=blocks, method="cvode") as group:
        before = group.counts()["directional derivatives"]
        assert jacobian_of(group) == pytest.approx(np.array([[-1.0, 0.0], [1.0, -1.0]]), abs=1e-9)
        assert group.counts()["directional derivatives"] - before == 4, "x1: y1, x1', x2'; x2: x2'"


def test_an_output_that_is_a_state_needs_no_call(tmp_path: Path) -> None:
    blocks = [LinkBlock((Link((0, "x"), (1, "push"), 4.0),))]
    with group_of(tmp_path, "lag", "lag", blocks=blocks, method="cvode") as group:
        assert jacobian_of(group) == pytest.approx(np.array([[-1.0, 0.0], [4.0, -1.0]]), abs=1e-9)
        assert group.counts()["directional derivatives"] == 3


def cascade(folder: Path, count: int, output: str, **settings: Any) -> AbstractContextManager[Group]:
    """Lags one behind the other, ever slower. `output`: x is the state alone, y may answer at once to what pushes."""
    blocks = [LinkBlock((Link((k, output), (k + 1, "push")),)) for k in range(count - 1)]
    values = [{"tau": 1e-4 * (k + 1), "push": 1.0 if k == 0 else 0.0} for k in range(count)]
    return group_of(folder, *("lag",) * count, values=values, blocks=blocks, method="cvode", **settings)


def test_a_band_through_connections_is_filled_by_as_many_seeds_as_it_is_wide(tmp_path: Path) -> None:
    with cascade(tmp_path, 20, "x") as group:
        assert group.bands == (1, 0)
        rates = np.array([1e4 / (k + 1) for k in range(20)])
        exact = np.diag(-rates) + np.diag(rates[1:], -1)
        found = jacobian_of(group)
        inside = ~np.isnan(found)
        assert inside.sum() == 39
        assert found[inside] == pytest.approx(exact[inside], rel=1e-5)
        assert group.counts()["directional derivatives"] <= 2 * 20, "two seeds, each through all members"


def test_it_saves_evaluations_of_the_right_hand_side(tmp_path: Path) -> None:
    """A column by differences is an evaluation of all FMUs."""
    counts, ends = {}, {}
    for exact in (True, False):
        with cascade(tmp_path, 8, "y", tolerance=1e-8) as group:
            assert group.exact and group.bands is None
            group.replace_cvode(exact)
            run(group, 0.1)
            counts[exact], ends[exact] = group.counts(), group.members[-1].get("x")
    assert ends[True] == pytest.approx(ends[False], rel=1e-6)
    assert counts[True]["directional derivatives"] > 0 == counts[False]["directional derivatives"]
    assert counts[True]["evaluations"] + 2 * 8 <= counts[False]["evaluations"], "at least two Jacobians"


def test_one_that_offers_none_makes_the_group_take_differences(tmp_path: Path) -> None:
    blocks = [LinkBlock((Link((0, "y"), (1, "push")),))]
    with group_of(tmp_path, "lag", "plain_lag", blocks=blocks, values=[{"push": 1.0}], method="cvode") as group:
        assert not group.exact
        run(group, 1.0)
        assert group.counts()["directional derivatives"] == 0


def test_one_that_refuses_them_is_named(tmp_path: Path) -> None:
    with group_of(tmp_path, "refuses", method="cvode") as group:
        group.step(0.0, 0.1)
        assert group.failed
        assert "fmi2GetDirectionalDerivative answered fmi2Error" in group.why()


@pytest.mark.parametrize(
    ("second", "words"),
    [("lag", "Jacobian of directional derivatives through all connections"),
     ("plain_lag", "Jacobian of differences, as b offers no directional derivatives")],
)  # fmt: skip
def test_the_plan_says_what_the_jacobian_is_made_of(tmp_path: Path, second: str, words: str) -> None:
    for name in ("lag", second):
        exchange_build.exchange(tmp_path, name)
    text = 'format = 2\nstop_time = "1 s"\nconnections = ["a.y -> b.push"]\n[solver]\nmethod = "cvode"\n'
    for name, fmu in (("a", "lag"), ("b", second)):
        text += f'[components.{name}]\nfmu = "{fmu}.fmu"\nperiod = "10 ms"\n'
    path = tmp_path / "system.toml"
    path.write_text(text, encoding="utf-8")
    assert words in explain(make_plan(load_system(str(path), tmp_path)))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_compiled_function_is_known_by_all_sources_that_it_is_made_of(name: str) -> None:
    """Otherwise an older one would be taken from the cache when one of them changes."""
    module = sys.modules[FUNCTIONS[name][0].__module__]
    known = {path.resolve() for path in loop_files(Path(module.__file__ or ""))}
    waiting, used = [module], set()
    while waiting:
        one = waiting.pop()
        for value in vars(one).values():
            home = sys.modules.get(getattr(value, "__module__", None) or "")
            if callable(value) and home and "orchestrator.integration" in home.__name__ and home not in used:
                used.add(home)
                waiting.append(home)
    assert {Path(one.__file__ or "").resolve() for one in used} <= known


def test_states_and_inputs_that_are_arrays_are_taken_whole(tmp_path: Path) -> None:
    """A rod whose wall is another rod's middle: FMI 3.0 sets and derives arrays at once only."""
    rod = array_exchange_build.rod3(tmp_path / "rod.fmu")
    blocks = [LinkBlock((Link((0, "y"), (1, "u[2]"), 3.0),))]
    with group_of(tmp_path, paths=[rod, rod], blocks=blocks, version=3, method="cvode", tolerance=1e-8) as group:
        n = array_exchange_build.CELLS
        inside = 100.0 * (np.diag([-2.0] * n) + np.diag([1.0] * (n - 1), 1) + np.diag([1.0] * (n - 1), -1))
        exact = np.kron(np.eye(2), inside)
        exact[2 * n - 1, n // 2] = 300.0
        found = jacobian_of(group)
        known = ~np.isnan(found)
        assert found[known] == pytest.approx(exact[known], abs=1e-3)
        assert known[exact != 0.0].all()
        group.members[0].set("u[1]", 1.0)
        run(group, 30.0, step=0.5)
        ends = [member.get("y") for member in group.members]
        middle = 1.0 - (n // 2 + 1) / (n + 1)
        assert ends == pytest.approx([middle, 3.0 * middle * (n // 2 + 1) / (n + 1)], abs=1e-4)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(6))
def test_it_is_that_of_differences_in_networks_at_random(tmp_path: Path, seed: int) -> None:
    """Lags that may answer at once and oscillators, each input driven by any output: chains, loops, both."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(3, 8))
    kinds = ["lag" if k == 0 or rng.random() < 0.7 else "oscillator" for k in range(count)]
    text, connections = "", []
    for k, kind in enumerate(kinds):
        exchange_build.exchange(tmp_path, kind)
        values = f"d = {rng.uniform(-0.6, 0.6):.3f}, tau = {rng.uniform(0.1, 2.0):.3f}" if kind == "lag" else "mu = 2.0"
        text += f'[components.c{k}]\nfmu = "{kind}.fmu"\nperiod = "10 ms"\nparameters = {{ {values} }}\n'
        source = int(rng.integers(count))
        output = "y" if rng.random() < 0.7 else "x"
        connections.append(f'"c{source}.{output} -> c{k}.{"push" if kind == "lag" else "u"}"')
    path = tmp_path / "system.toml"
    head = f'format = 2\nstop_time = "1 s"\nconnections = [{", ".join(connections)}]\n[solver]\nmethod = "cvode"\n'
    path.write_text(head + text, encoding="utf-8")
    with Session(make_plan(load_system(str(path), tmp_path))) as session:
        session.advance(cycles=3)
        group = session.group
        assert group is not None
        found, n = jacobian_of(group), group.tables.states
        states, rates = group._view(cells.X, n).copy(), np.zeros(n)
        columns = []
        for j in range(n):
            ends = []
            for sign in (1.0, -1.0):
                moved = states.copy()
                moved[j] += sign * 1e-6
                at = int(moved.ctypes.data), int(rates.ctypes.data)
                assert call(address_of("evaluate"), group.pointer, group.time, *at) == 0
                ends.append(rates.copy())
            columns.append((ends[0] - ends[1]) / 2e-6)
        assert found == pytest.approx(np.array(columns).T, abs=1e-5, rel=1e-5)
