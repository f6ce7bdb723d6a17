"""The angular momentum of the whole system: what the brush gains in spin, the vehicle loses, through the housing."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from helpers import Measured
from rovbrush.orchestrator.paper.angular_momentum import FREE, TUMBLING, balance, order, with_periods
from rovbrush.orchestrator.paper.lab import Lab
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

PEAK_PITCH_RATE = 2.54  # rad/s, of `no_thrust`: an independent code with Newton's law for the housing


@pytest.fixture(scope="module")
def lab(fmus: Path) -> Lab:
    return Lab(fmus)


@pytest.fixture(scope="module")
def let_go(lab: Lab) -> Run:
    return lab.case("no_thrust").run


def test_angular_momentum_about_the_brush_axis_is_kept_when_the_brush_starts(lab: Lab, measured: Measured) -> None:
    """On a free body, without water and weight: nobody gives any, what one gains the other loses."""
    books = balance(lab.case("open_water", FREE).run)
    residual = books.relative("y")
    measured("open water, free body: angular momentum about the brush axis, over the largest", residual, "1e-9")
    assert residual < 1e-9
    assert np.max(books.spin[:, 1]) > 10.0 and np.min(books.vehicle[:, 1]) < -10.0
    assert not np.any(books.other) and not np.any(books.contact)


def test_angular_momentum_about_three_axes_is_kept_while_the_vehicle_tumbles(lab: Lab, measured: Measured) -> None:
    """At the shipped periods; all three axes take part."""
    books = balance(lab.case("open_water", {**FREE, **TUMBLING}).run)
    measured("open water, tumbling: angular momentum about three axes, over the largest", books.relative(), "1e-5")
    assert books.relative() < 1e-5
    assert np.all(np.ptp(books.spin, axis=0) > 1.0)


def test_what_the_exchange_loses_of_it_falls_with_the_square_of_the_periods(lab: Lab, measured: Measured) -> None:
    found = order(lab)
    measured("open water, tumbling: order of the angular momentum in the periods", found, "2 +- 0.25")
    assert found == pytest.approx(2.0, abs=0.25)


def test_held_spin_is_of_first_order_and_a_plain_mean_of_the_torque_loses_impulse(lab: Lab, measured: Measured) -> None:
    """What the connections of the shipped systems are for: the mean of the spin, and the counter of the torque."""
    system = lab.case("open_water", {**FREE, **TUMBLING}).run.plan.system
    usual = with_periods(lab, {**FREE, **TUMBLING}, Fraction(1)).relative()
    for name, change in (("H_spin", {"transfer": "hold"}), ("T_housing", {"counter": ""})):
        wires = tuple(replace(c, **change) if c.source == ("motor", name) else c for c in system.connections)
        run = require_complete(simulate(make_plan(replace(system, connections=wires))))
        worse = balance(run).relative() / usual
        measured(f"open water, tumbling: residual with another connection of {name}, times ours", worse, "> 10")
        assert worse > 10.0


def test_brush_torque_in_place_of_that_of_the_housing_breaks_the_balance(fmus: Path) -> None:
    """As the paper has it: the vehicle does not feel the start at all."""
    system = planned(assemble("open_water", FREE, "1 s", fmus)).system
    wires = tuple(
        replace(c, source=("brush", "T_brush"), transfer="", counter="") if c.source[1] == "T_housing" else c
        for c in system.connections
    )
    books = balance(require_complete(simulate(make_plan(replace(system, connections=wires)))))
    assert books.relative("y") > 0.9 and not np.any(books.vehicle)


def test_contact_of_the_brush_is_in_the_balance(let_go: Run, measured: Measured) -> None:
    """Let go on the hull: pushed off, pitching, with water and weight."""
    books = balance(let_go)
    measured("no_thrust: angular momentum about three axes, over the largest", books.relative(), "1e-5")
    assert books.relative() < 1e-5
    assert np.max(np.abs(books.contact)) > 0.5 and np.max(np.abs(books.other)) > 0.5


def test_vehicle_let_go_pitches_as_fast_as_newton_wants(let_go: Run, measured: Measured) -> None:
    peak = abs(summarize(let_go)["pitch_rate_peak"])
    measured("no_thrust: largest pitch rate over that of an independent code", peak / PEAK_PITCH_RATE, "1 +- 0.02")
    assert peak == pytest.approx(PEAK_PITCH_RATE, rel=0.02)
