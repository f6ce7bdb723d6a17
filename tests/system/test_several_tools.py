"""Two rollers that turn against each other, three cups: what cancels between them, what is left to the thrusters."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import Measured
from rovbrush.orchestrator.paper.lab import Case, Lab
from rovbrush.orchestrator.paper.thrust_budget import TOOLS, Budget, allocation, largest_force, thrust_budget

HELD = 20.0  # N, what every system presses with


@pytest.fixture(scope="module")
def lab(fmus: Path) -> Lab:
    return Lab(fmus)


@pytest.fixture(scope="module")
def pair(lab: Lab) -> Case:
    return lab.case("counter_rotating")


@pytest.fixture(scope="module")
def cups(lab: Lab) -> Case:
    return lab.case("three_cups")


@pytest.fixture(scope="module")
def budgets(lab: Lab) -> dict[str, Budget]:
    return {one.tool: one for one in thrust_budget(lab)}


@pytest.mark.evidence
def test_a_pair_that_turns_against_itself_cancels_friction_torque_and_spin(pair: Case, measured: Measured) -> None:
    one = abs(pair.mean("brush.F_x")), abs(pair.mean("brush.T_brush")), pair.peak("motor.H_spin")
    left = abs(pair.mean("vehicle.F_x")), abs(pair.mean("vehicle.M_y")), pair.peak("vehicle.H_y")
    for name, whole, rest in zip(("friction", "moment", "spin momentum"), one, left, strict=True):
        measured(f"counter_rotating: {name} left, of that of one brush", rest / whole, "0.1")
        assert rest < 0.1 * whole and whole > 0.1


@pytest.mark.evidence
def test_cups_leave_no_friction_along_the_hull(cups: Case, measured: Measured) -> None:
    """A cup that turns cancels its own friction; what is left is what moving along the hull takes."""
    left = abs(cups.mean("vehicle.F_x")) / abs(cups.mean("vehicle.F_z"))
    measured("three_cups: friction along the hull over the normal force", left, "0.05")
    assert left < 0.05
    turning = [cups.mean(f"motor{x}.omega_b") for x in ("", "_2", "_3")]
    assert turning[0] > 0.0 > turning[1] and turning[2] > 0.0


@pytest.mark.evidence
@pytest.mark.parametrize("name", ["counter_rotating", "three_cups"])
def test_the_force_is_held_and_the_energy_closes(lab: Lab, name: str, measured: Measured) -> None:
    case = lab.case(name)
    force = -case.mean("vehicle.F_z")
    measured(f"{name}: normal force held, of that asked for", force / HELD, "0.98 to 1.02")
    measured(f"{name}: energy residual over what was supplied", case.summary["energy_balance_relative"], "1e-3")
    assert force == pytest.approx(HELD, rel=0.02)
    assert case.summary["energy_balance_relative"] < 1e-3
    assert case.summary["contact_time"] > 25.0


@pytest.mark.evidence
def test_the_frame_tells_each_tool_where_it_is(pair: Case) -> None:
    """The rollers are 0.32 m apart: their penetrations differ by the pitch of the vehicle times that."""
    behind, ahead, turned = (
        pair.signals[f"frame.{name}"].values for name in ("delta_tool[1]", "delta_tool[2]", "misalignment")
    )
    assert np.max(np.abs(ahead - behind)) > 1e-5
    assert behind - ahead == pytest.approx(-0.32 * np.sin(turned), rel=1e-5, abs=1e-12)  # tilt_x is small


@pytest.mark.evidence
def test_what_the_thrusters_can_hold_rises_from_roller_to_pair(budgets: dict[str, Budget], measured: Measured) -> None:
    assert list(budgets) == list(TOOLS)
    for tool, one in budgets.items():
        for current, force in one.largest.items():
            measured(f"thrust budget: {tool}, current {current:g} m/s, largest normal force [N]", force, "above 0")
        assert all(force > one.held for force in one.largest.values())
    pair, roller = budgets["two rollers that turn against each other"], budgets["roller"]
    assert pair.largest[0.0] > 1.5 * roller.largest[0.0]


@pytest.mark.evidence
def test_a_pure_push_is_what_the_vertical_thrusters_give(pair: Case) -> None:
    """Without levers and without a current the largest force is the sum of the vertical thrusters at full command."""
    B, forward, reverse = allocation(pair)
    vertical = np.abs(B[2])
    best = max((vertical * forward).sum(), (vertical * reverse).sum())
    push = largest_force(pair, np.array([0.0, 0.0, -1.0, 0.0, 0.0, 0.0]), np.zeros(6))
    assert push == pytest.approx(best, rel=0.1)


@pytest.mark.evidence
def test_a_force_beyond_the_budget_saturates_and_one_within_does_not(
    lab: Lab, budgets: dict[str, Budget], measured: Measured
) -> None:
    """At rest on the hull, before the pass begins (8 s)."""
    largest = budgets["roller"].largest[0.2]
    within, beyond = (lab.case("hull_pass", {"mission.F_n": share * largest}, "8 s") for share in (0.85, 1.15))
    held = [-case.signals["vehicle.F_z"].mean(7.0, 8.0) / largest for case in (within, beyond)]
    measured("roller: force held over the budget, 0.85 of it asked for", held[0], "0.85")
    measured("roller: force held over the budget, 1.15 of it asked for", held[1], "below 1.02")
    assert held[0] == pytest.approx(0.85, abs=0.02)
    assert held[1] < 1.02
