"""FMUs for Model Exchange by the letter of the standard: what they are told, and what they may answer."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from exchange_groups import group_of, run, times
from native_build import needs_gcc
from rovbrush.orchestrator.integration import cells
from rovbrush.orchestrator.participant.lifecycle import State
from scipy.integrate import solve_ivp

pytestmark = needs_gcc
METHODS = ("dormand-prince", "cvode")


@pytest.mark.parametrize("refuses", [False, True])
@pytest.mark.parametrize("method", METHODS)
def test_a_step_that_goes_where_the_model_is_no_number_is_made_smaller(
    tmp_path: Path, method: str, refuses: bool
) -> None:
    """Nothing is wrong then, whatever was tried on the way."""
    with group_of(tmp_path, "drain", values=[{"refuses": refuses}], method=method, tolerance=1e-8) as group:
        group.step(0.0, 1.9)
        assert not group.failed, group.why()
        assert group.members[0].get("x") == pytest.approx(0.05**2, abs=1e-7)


@pytest.mark.parametrize("refuses", [False, True])
def test_a_step_whose_indicators_are_no_numbers_is_made_smaller(tmp_path: Path, refuses: bool) -> None:
    """An indicator that is no number is no event; the one before it is found."""
    values = [{"falls": True, "floor": 0.25, "refuses": refuses}]
    with group_of(tmp_path, "drain", values=values, tolerance=1e-8) as group:
        group.step(0.0, 2.0)
        assert not group.failed, group.why()
        assert group.members[0].get("touched") == pytest.approx(0.75, abs=1e-9)
        assert group.members[0].get("x") == pytest.approx(0.25, abs=1e-9)
        assert len(group.events()) == 1


def test_an_indicator_that_is_no_number_in_a_step_that_must_not_be_smaller_is_named(tmp_path: Path) -> None:
    values = [{"falls": True, "floor": 1e-3}]
    with group_of(tmp_path, "drain", values=values, method="rk4", step=0.3) as group:
        group.step(0.0, 0.9)
        assert not group.failed
        group.step(0.9, 0.3)
        assert "event indicator 1 is not a number" in group.why()


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("method", METHODS)
def test_all_members_hear_of_every_step_also_where_one_of_them_asks_for_an_event(
    tmp_path: Path, method: str, version: int
) -> None:
    values = [{"every": 3}, {}, {"every": 5}]
    with group_of(tmp_path, *("steps",) * 3, values=values, method=method, version=version) as group:
        run(group, 2.0, step=0.1)
        told = [member.get("n") for member in group.members]
        assert told[0] == told[1] == told[2] >= 20
        assert [member.get("last") for member in group.members] == [pytest.approx(2.0)] * 3
        assert len(times(group, indicator=cells.STEP_EVENT)) > told[0] // 3


@pytest.mark.parametrize("method", METHODS)
def test_who_asks_to_end_after_a_step_is_named(tmp_path: Path, method: str) -> None:
    with group_of(tmp_path, "steps", "steps", "steps", values=[{}, {"end": 4}, {}], method=method) as group:
        ended = [group.step(0.1 * k, 0.1) for k in range(40) if not group.asks_to_end]
        assert ended[-1]
        assert group.at_fault is group.members[1]
        assert [member.get("n") for member in group.members] == [4, 4, 4]


def test_one_that_answers_fatal_is_called_no_more_and_the_others_are_ended_well(tmp_path: Path) -> None:
    with group_of(tmp_path, "steps", "steps", values=[{}, {"fatal": True}]) as group:
        with pytest.raises(Exception, match="answered fmi2Fatal"):
            for k in range(20):
                group.members[0].step(0.1 * k, 0.1)
        group.members[1].noted("step", 3)
        assert group.members[1].state is State.DEAD


@pytest.mark.parametrize("size", [0.0, -1e3, math.inf, math.nan])
def test_a_nominal_value_that_is_none_counts_as_one(tmp_path: Path, size: float) -> None:
    with group_of(tmp_path, "steps", values=[{"size": size}], tolerance=1e-6) as group:
        run(group, 1.0, step=0.1)
        (absolute,) = group._view(cells.ABSOLUTE, 1)
        assert absolute == pytest.approx(1e-8 * (abs(size) if math.isfinite(size) and size else 1.0))


@pytest.mark.parametrize("method", ["dormand-prince", "rk4", "cvode"])
def test_a_member_is_at_the_very_instant_of_its_time_event(tmp_path: Path, method: str) -> None:
    """From 0.05 over 0.21 - 0.05 rounding leads to an instant before 0.21, at which the event is not yet due."""
    assert 0.05 + (0.21 - 0.05) < 0.21
    with group_of(tmp_path, "moody", values=[{"period": 0.21}], method=method, step=0.5) as group:
        for time, length in ((0.0, 0.05), (0.05, 0.2)):
            group.step(time, length)
            assert not group.failed, group.why()
        assert group.members[0].get("n") == 1
        assert times(group, indicator=cells.TIME_EVENT) == [0.21]


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("method", METHODS)
def test_a_pendulum_that_selects_its_states_by_itself_swings_as_by_its_angle(
    tmp_path: Path, method: str, version: int
) -> None:
    """x and x' or y and y': values and nominal values change at step events."""
    exact = solve_ivp(lambda _, s: [s[1], -9.81 * np.sin(s[0])], (0.0, 6.0), [2.5, 0.0], rtol=1e-12, atol=1e-12)
    angle = exact.y[0, -1]
    with group_of(tmp_path, "pendulum", method=method, version=version, tolerance=1e-9) as group:
        run(group, 6.0, step=0.1)
        pendulum = group.members[0]
        assert pendulum.get("changes") > 8
        assert pendulum.get("x") == pytest.approx(math.sin(angle), abs=1e-5)
        assert pendulum.get("y") == pytest.approx(-math.cos(angle), abs=1e-5)


@pytest.mark.parametrize("method", ["dormand-prince", "rk4", "cvode"])
def test_a_group_without_states_has_its_events(tmp_path: Path, method: str) -> None:
    """A relay alone: what drives it is set from outside."""
    with group_of(tmp_path, "relay", values=[{"low": -0.5, "high": 0.5}], method=method, step=0.05) as group:
        relay, found = group.members[0], []
        for k in range(20):
            relay.set("y", math.sin(k))
            group.step(0.1 * k, 0.1)
            assert not group.failed, group.why()
            found.append(bool(relay.get("on")))
        on = True
        for k, is_on in enumerate(found):
            on = math.sin(k) < -0.5 or (on and math.sin(k) < 0.5)
            assert is_on is on
