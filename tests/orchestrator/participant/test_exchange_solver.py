"""Integration of FMUs for Model Exchange: orders, tolerances, loops, bands, stiffness, and what goes wrong."""

from __future__ import annotations

import itertools
import math
from pathlib import Path

import exchange_build
import pytest
from exchange_groups import group_of, run, times
from native_build import needs_gcc
from rovbrush.orchestrator.participant.model_exchange.links import Link, LinkBlock

pytestmark = needs_gcc


def end_of_oscillator(folder: Path, **settings: object) -> tuple[float, dict[str, int]]:
    with group_of(folder, "oscillator", **settings) as group:
        run(group, 5.0, step=0.1)
        return group.members[0].get("x"), dict(group.counts())


def test_the_fixed_step_method_is_of_fourth_order(tmp_path: Path) -> None:
    exact, _ = end_of_oscillator(tmp_path, method="dormand-prince", tolerance=1e-12)
    errors = [abs(end_of_oscillator(tmp_path, method="rk4", step=h)[0] - exact) for h in (0.1, 0.05, 0.025)]
    orders = [math.log2(a / b) for a, b in itertools.pairwise(errors)]
    assert all(3.7 < order < 4.6 for order in orders)


@pytest.mark.parametrize("method", ["dormand-prince", "cvode"])
def test_a_tighter_tolerance_gives_a_smaller_error(tmp_path: Path, method: str) -> None:
    exact, _ = end_of_oscillator(tmp_path, method="dormand-prince", tolerance=1e-13)
    errors = [abs(end_of_oscillator(tmp_path, method=method, tolerance=t)[0] - exact) for t in (1e-4, 1e-7, 1e-10)]
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 1e-8


def test_a_model_that_proves_stiff_is_handed_to_cvode(tmp_path: Path) -> None:
    with group_of(tmp_path, "oscillator", values=[{"mu": 1000.0}]) as group:
        run(group, 20.0, step=1.0)
        assert group.method == "cvode"
        assert group.counts()["evaluations"] < 5000
        with group_of(tmp_path, "oscillator", values=[{"mu": 1000.0}], method="cvode", tolerance=1e-9) as exact:
            run(exact, 20.0, step=1.0)
            assert group.members[0].get("x") == pytest.approx(exact.members[0].get("x"), rel=1e-5)


def test_a_model_that_is_not_stiff_is_not_handed_over(tmp_path: Path) -> None:
    with group_of(tmp_path, "oscillator") as group:
        run(group, 20.0, step=1.0)
        assert group.method == "dormand-prince"


def test_a_rod_decays_as_its_lowest_mode_by_a_band(tmp_path: Path) -> None:
    cells = 200
    path = exchange_build.chain(tmp_path, cells, both=True)
    rate = 4.0 * 100.0 * math.sin(math.pi / (2 * (cells + 1))) ** 2
    with group_of(tmp_path, paths=[path], tolerance=1e-8) as group:
        assert group.method == "cvode"
        assert group.bands == (1, 1)
        assert group.exact
        run(group, 1.0, step=0.1)
        middle = math.sin(math.pi * (cells // 2 + 1) / (cells + 1))
        assert group.members[0].get("y") == pytest.approx(middle * math.exp(-rate), abs=1e-6)


def test_a_chain_of_two_lags_is_its_closed_form(tmp_path: Path) -> None:
    for method in ("dormand-prince", "cvode"):
        blocks = [LinkBlock((Link((0, "x"), (1, "push"), 3.0, 1.0),))]
        values = [{"push": 1.0, "tau": 0.5}, {"tau": 0.25}]
        with group_of(tmp_path, "lag", "lag", blocks=blocks, values=values, method=method, tolerance=1e-10) as group:
            run(group, 1.0)
            first = 1.0 - math.exp(-2.0)
            second = 4.0 + 3.0 * math.exp(-4.0) * 1.0 - 6.0 * math.exp(-2.0) - math.exp(-4.0)
            assert group.members[0].get("x") == pytest.approx(first, abs=1e-8)
            assert group.members[1].get("x") == pytest.approx(second, abs=1e-8)


def test_a_loop_of_direct_dependences_is_solved_in_each_evaluation(tmp_path: Path) -> None:
    """y1 = x1 + d1 u1, u1 = y2, y2 = x2 + d2 u2, u2 = y1: u1 = (x2 + d2 x1) / (1 - d1 d2)."""
    links = (Link((1, "y"), (0, "push")), Link((0, "y"), (1, "push")))
    values = [{"d": 0.5, "x": 1.0}, {"d": -0.4, "x": 2.0}]
    with group_of(tmp_path, "lag", "lag", blocks=[LinkBlock(links, True)], values=values, tolerance=1e-10) as group:
        run(group, 0.5)
        a, b = group.members
        x1, x2 = a.get("x"), b.get("x")
        assert a.get("push") == pytest.approx((x2 - 0.4 * x1) / 1.2, rel=1e-12)
        assert b.get("push") == pytest.approx((x1 + 0.5 * x2) / 1.2, rel=1e-12)
        # x1' = (x2 - 0.4 x1) / 1.2 - x1, x2' = (x1 + 0.5 x2) / 1.2 - x2
        import numpy as np
        from scipy.linalg import expm

        matrix = np.array([[-0.4 / 1.2 - 1.0, 1.0 / 1.2], [1.0 / 1.2, 0.5 / 1.2 - 1.0]])
        assert [x1, x2] == pytest.approx(expm(0.5 * matrix) @ [1.0, 2.0], abs=1e-9)


def test_inputs_that_jump_at_every_point_cost_no_accuracy(tmp_path: Path) -> None:
    """A solver that goes on over a jump is wrong without a word; each of ours begins anew."""
    for method in ("dormand-prince", "cvode"):
        with group_of(tmp_path, "lag", method=method, tolerance=1e-8) as group:
            x, lag = 0.0, group.members[0]
            for k in range(100):
                push = math.sin(12.9898 * k) * 10.0
                lag.set("push", push)
                group.step(0.1 * k, 0.1)
                x = push + (x - push) * math.exp(-0.1)
                assert lag.get("x") == pytest.approx(x, abs=1e-6)


def test_going_back_gives_the_same_bits(tmp_path: Path) -> None:
    for method in ("dormand-prince", "cvode"):
        with group_of(tmp_path, "ball", method=method, restart=True) as group:
            ball = group.members[0]
            run(group, 0.4)
            kept = ball.save()
            ends = []
            for _ in range(2):
                for k in range(40, 60):
                    group.step(0.01 * k, 0.01)
                ends.append((ball.get("h"), ball.get("v")))
                ball.restore(kept)
            assert ends[0] == ends[1]
            ball.forget(kept)


FAULTS = {
    1: "derivative der(x) is not finite, however small the step",
    2: "fmi2GetDerivatives answered fmi2Discard",
    3: "it chatters: more than 1000 events in one step, the last of event indicator 1",
    4: "an event does not settle: after 100 rounds",
    5: "fmi2GetDerivatives answered fmi2Error",
}


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("method", ["dormand-prince", "cvode"])
def test_what_goes_wrong_is_named_with_its_time(tmp_path: Path, method: str, fault: int) -> None:
    values = [{"fault": fault}]
    with group_of(tmp_path, "moody", values=values, method=method) as group:
        for k in range(10):
            group.step(0.1 * k, 0.1)
            if group.failed:
                break
        assert FAULTS[fault] in group.why() or "CVODE gives up" in group.why()
        assert group.failed
        assert group.time == pytest.approx(0.55, abs=0.06)


@pytest.mark.parametrize("fault", [6, 9])
def test_a_member_that_asks_to_end_ends_the_step_there(tmp_path: Path, fault: int) -> None:
    with group_of(tmp_path, "moody", values=[{"fault": fault}]) as group:
        ended = [group.step(0.1 * k, 0.1) for k in range(6)]
        assert ended == [False] * 5 + [True]
        assert 0.55 <= group.time <= 0.6
        assert not group.failed


def test_more_chattering_than_this_is_no_error(tmp_path: Path) -> None:
    with group_of(tmp_path, "ball", values=[{"e": 0.99}]) as group:
        run(group, 2.0, step=1.0)
        assert len(times(group)) >= 2


@pytest.mark.parametrize("version", [2, 3])
def test_directional_derivatives_make_the_jacobian_where_they_are_offered(tmp_path: Path, version: int) -> None:
    with group_of(tmp_path, "oscillator", values=[{"mu": 100.0}], version=version, method="cvode") as group:
        assert group.exact
        run(group, 5.0, step=0.5)
        ours = group.members[0].get("x")
    with group_of(tmp_path, "oscillator", values=[{"mu": 100.0}], version=version, method="cvode") as group:
        group.replace_cvode(exact=False)
        run(group, 5.0, step=0.5)
        assert ours == pytest.approx(group.members[0].get("x"), rel=1e-5)
