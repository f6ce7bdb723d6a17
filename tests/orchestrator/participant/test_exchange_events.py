"""Events of FMUs for Model Exchange against their closed forms, with each method."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from exchange_groups import group_of, run, times
from native_build import needs_gcc
from rovbrush.orchestrator.integration import cells
from rovbrush.orchestrator.participant.model_exchange.links import Link, LinkBlock

pytestmark = needs_gcc
METHODS = ("dormand-prince", "cvode")
PUCKS = [LinkBlock((Link((1, "x"), (0, "x2")),)), LinkBlock((Link((1, "v"), (0, "v2")),)),
         LinkBlock((Link((0, "J"), (1, "J")),)), LinkBlock((Link((0, "n"), (1, "n")),))]  # fmt: skip


def impacts(g: float, e: float, h0: float, count: int) -> list[float]:
    first = math.sqrt(2.0 * h0 / g)
    found = [first]
    for k in range(1, count):
        found.append(found[-1] + 2.0 * e**k * first)
    return found


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("method", METHODS)
def test_twenty_impacts_of_a_ball_are_within_a_nanosecond(tmp_path: Path, method: str, version: int) -> None:
    with group_of(tmp_path, "ball", values=[{"e": 0.9}], version=version, method=method, tolerance=1e-10) as group:
        run(group, 8.0)
        exact = impacts(9.81, 0.9, 1.0, 20)
        assert times(group)[:20] == pytest.approx(exact, abs=1e-9, rel=0)
        assert group.members[0].get("hits") == len(times(group))


def test_a_ball_with_fixed_steps_bounces_at_the_exact_times(tmp_path: Path) -> None:
    with group_of(tmp_path, "ball", method="rk4", step=0.002) as group:
        run(group, 2.4)
        exact = impacts(9.81, 0.7, 1.0, 6)
        assert times(group)[:6] == pytest.approx(exact, abs=1e-12, rel=0)  # a parabola: the method is exact


def test_a_ball_that_comes_to_rest_stays_there(tmp_path: Path) -> None:
    with group_of(tmp_path, "ball", values=[{"v_rest": 0.1}]) as group:
        run(group, 4.0)
        assert group.members[0].get("h") == 0.0
        assert group.members[0].get("v") == 0.0


@pytest.mark.parametrize("method", METHODS)
def test_two_pucks_in_two_fmus_keep_momentum_and_energy(tmp_path: Path, method: str) -> None:
    masses = {"m": 2.0, "m2": 0.5, "wall": -1.0, "side": -1.0}, {"m": 0.5, "wall": 1.5}

    def begin(members: list) -> None:
        members[0].set_all({"x2": 1.0, "v2": 0.0})

    values = [{**masses[0], "v": 1.0}, {**masses[1], "x": 1.0}]
    with group_of(tmp_path, "striker", "struck", values=values, blocks=PUCKS, initial=begin, method=method) as group:
        a, b = group.members
        at = []
        for k in range(600):
            before = 2.0 * a.get("v") + 0.5 * b.get("v")
            hits, seen = a.get("n"), len(group.events())
            group.step(0.01 * k, 0.01)
            assert not group.failed, group.why()
            walls = sum(e.indicator == 0 for e in group.events()[seen:])
            if a.get("n") != hits and not walls:
                at.append(group.time)
                assert 2.0 * a.get("v") + 0.5 * b.get("v") == pytest.approx(before, abs=1e-12)
            assert a.get("v") ** 2 + 0.25 * b.get("v") ** 2 == pytest.approx(1.0, abs=1e-12)
            assert b.get("x") >= a.get("x") - 1e-12
        assert len(at) >= 4
        assert times(group, "striker", 1)[0] == pytest.approx(1.0, abs=1e-12)
        assert times(group, "struck", 0)[0] == pytest.approx(1.0 + 0.5 / 1.6, abs=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_a_block_on_a_belt_sticks_and_slips_at_the_exact_times(tmp_path: Path, method: str) -> None:
    static, kinetic, belt = 1.0, 0.6, 0.2
    slipping = 2.0 * math.pi - 2.0 * math.atan((static - kinetic) / belt)
    sticking = 2.0 * (static - kinetic) / belt
    exact, t = [], static / belt
    for _ in range(4):
        exact += [t, t + slipping]
        t += slipping + sticking
    switches: list[float] = []
    with group_of(tmp_path, "stick_slip", method=method, tolerance=1e-10) as group:

        def watch(_: float) -> None:
            count = group.members[0].get("switches")
            if count > len(switches):
                switches.append(group.members[0].get("t_switch"))

        run(group, exact[-1] + 0.1, watch=watch)
        assert switches == pytest.approx(exact, abs=1e-8, rel=0)


@pytest.mark.parametrize("method", METHODS)
def test_a_relay_in_one_fmu_switches_a_lag_in_another(tmp_path: Path, method: str) -> None:
    blocks = [LinkBlock((Link((1, "x"), (0, "y")),)), LinkBlock((Link((0, "on"), (1, "on")),))]
    values = [{"low": 0.3, "high": 0.7}, {}]
    with group_of(tmp_path, "relay", "lag", values=values, blocks=blocks, method=method, tolerance=1e-10) as group:
        switches: list[float] = []

        def watch(_: float) -> None:
            if group.members[0].get("switches") > len(switches):
                switches.append(group.members[0].get("t_switch"))

        run(group, 4.0, watch=watch)
        up, down = math.log(1 / 0.3), math.log(0.7 / 0.3)
        again = math.log(0.7 / 0.3)
        exact = [up, up + down, up + down + again, up + 2 * down + again]
        assert switches == pytest.approx(exact, abs=1e-8, rel=0)


def test_time_events_are_hit_exactly(tmp_path: Path) -> None:
    with group_of(tmp_path, "moody", values=[{"period": 0.03}]) as group:
        run(group, 1.0, step=0.01)
        assert times(group, indicator=cells.TIME_EVENT) == pytest.approx([0.03 * k for k in range(1, 34)], rel=4e-16)
        assert group.members[0].get("n") == 33


def test_a_step_event_follows_the_step_after_which_it_was_asked_for(tmp_path: Path) -> None:
    for method in METHODS:
        with group_of(tmp_path, "moody", values=[{"fault": 7}], method=method) as group:
            run(group, 1.0, step=0.1)
            assert len(times(group, indicator=cells.STEP_EVENT)) == 1
            assert group.members[0].get("rounds") == 2  # the first event and this one


def test_other_states_behind_an_event_bring_their_values_and_nominals(tmp_path: Path) -> None:
    for method in METHODS:
        with group_of(tmp_path, "moody", values=[{"fault": 8, "at": 0.5}], method=method) as group:
            run(group, 1.0, step=0.1)
            assert group.members[0].get("x") == pytest.approx(1e6 * (1.0 + 0.5) + 1e6 * 0.5, rel=1e-6)
            assert group._arrays[cells.NOMINAL][0] == 1e6
