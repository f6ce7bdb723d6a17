"""What a cleaning pass does: phases, set-points without jumps, force, fouling along the way."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..testing.behaviour import Unit, close, holds, read, same, values
from ..testing.suite import Excitation, suite
from .fmu import Mission

SET_POINTS = ("x_ref", "y_ref", "z_ref", "v_ref", "F_n_ref", "phase")  # eight columns
PASS = {
    "T_s": 0.02, "along": (-1.0, 0.0, 0.0), "into_hull": (0.0, 0.0, 1.0), "t_start": 1.0, "standoff": 0.05,
    "depth": 0.0022, "v_approach": 0.02, "t_settle": 3.0, "length": 1.0, "v_clean": 0.05, "t_release": 1.0,
    "v_leave": 0.05, "leave": 0.1, "F_n": 40.0,
}  # fmt: skip
END = 40.0  # s, behind the last phase


def fly(unit: Unit, duration: float = END, h: float = 0.02, at: Sequence[float] = (0.0, 0.0, 0.0),
        **changes: Any) -> np.ndarray:
    """Set-points after each step, a row each; the vehicle stays where it is."""
    seen = unit.new(dict(zip(("x_n", "y_n", "z_n"), at, strict=True)), **PASS | changes)
    rows = []
    for _ in range(round(duration / h)):
        seen.step(h)
        rows.append(read(seen, *SET_POINTS))
    return np.array(rows)


def test_pass_begins_where_the_vehicle_is(unit: Unit) -> None:
    """At time 0, and until t_start, the set-point is the vehicle's own position."""
    start = (1.0, 2.0, 3.0)
    seen = unit.new(dict(zip(("x_n", "y_n", "z_n"), start, strict=True)), **PASS)
    for _ in range(40):
        same("position set-point", read(seen, "x_ref", "y_ref", "z_ref"), start)
        seen.step(0.02)


def test_pass_goes_through_its_phases_in_order(unit: Unit) -> None:
    """Phases 0 to 7 follow each other; the pass takes length/v_clean and ends off the hull."""
    rows = fly(unit)
    phase = rows[:, 7]
    same("phases", np.unique(phase), np.arange(8.0))
    holds(np.all(np.diff(phase) >= 0.0), "a phase came back")
    close(unit, "last set-point", rows[-1, :3], (-1.0, 0.0, 0.05 - 0.1), 1e-15, 1.0)
    close(unit, "depth during the pass", rows[phase == 3.0, 2], 0.05 + 0.0022, 1e-14)
    # A sample more or less where phases meet.
    close(unit, "time of the pass [s]", np.sum(phase == 3.0) * 0.02, 20.0, 0.04, 1.0)


def test_force_is_asked_for_at_the_hull_only(unit: Unit) -> None:
    """F_n_ref is F_n from the approach to the end of the pass, and 0 when the vehicle leaves and before it comes."""
    rows = fly(unit)
    force, phase = rows[:, 6], rows[:, 7]
    same("force at the hull", force[(phase >= 1.0) & (phase <= 4.0)], 40.0)
    same("force away from the hull", force[(phase == 0.0) | (phase >= 6.0)], 0.0)


def test_velocity_is_the_rate_of_the_set_point(unit: Unit) -> None:
    """v_ref is the derivative of the position set-point, which never jumps."""
    rows = fly(unit)
    rate = np.diff(rows[:, :3], axis=0) / 0.02
    steady = np.diff(rows[:, 7]) == 0.0
    inside = steady[:-1] & steady[1:]
    # Differences of positions of 1 m over 0.02 s: 1e-16/0.02.
    close(unit, "velocity set-point", rate[:-1][inside].ravel(), rows[:-2, 3:6][inside].ravel(), 1e-12, 1.0)
    holds(np.abs(rate).max() <= 0.05 * (1.0 + max(unit.tolerance, 1e-9)), "the set-point jumps")


def test_force_falls_evenly_before_the_vehicle_leaves(unit: Unit) -> None:
    """In the release phase the force goes to 0 at the rate F_n/t_release."""
    rows = fly(unit, t_release=2.0)
    falling = rows[rows[:, 7] == 5.0, 6]
    holds(abs(len(falling) - 100) <= 1, f"the release takes {len(falling)} samples, expected 100")
    close(unit, "change of the force per sample", np.diff(falling), -40.0 * 0.02 / 2.0, 1e-9)


def test_phases_of_no_length_are_passed_over(unit: Unit) -> None:
    """With times and lengths of 0 the pass still ends in phase 7, and no set-point is infinite."""
    rows = fly(unit, 5.0, t_start=0.0, t_settle=0.0, t_release=0.0, length=0.0, standoff=0.0)
    holds(np.all(np.isfinite(rows)), "a set-point is not finite")
    same("last phase", rows[-1, 7], 7.0)


def test_set_points_do_not_depend_on_the_communication_step(unit: Unit) -> None:
    """Samples are taken every T_s, whether the communication step is shorter or longer."""
    fine = fly(unit, 10.0)
    for h in (0.005, 0.1):
        every = round(1.0 / h)
        same(f"set-points each second with steps of {h:g} s", fly(unit, 10.0, h)[every - 1 :: every], fine[49::50])


def test_way_is_measured_along_the_pass(unit: Unit) -> None:
    """s is the distance from the start along the pass; across it, it does not count."""
    seen = unit.new({"x_n": 1.0, "y_n": 2.0, "z_n": 3.0}, **PASS | {"along": (0.6, 0.8, 0.0)})
    seen.set(x_n=1.6, y_n=2.8, z_n=4.0)
    seen.step(0.02)
    close(unit, "way", seen["s"], 1.0, 1e-14)


def test_friction_is_linear_between_places_and_constant_beyond(unit: Unit) -> None:
    """friction_scale interpolates the table of fouling over the way s."""
    places, scales = (0.0, 0.1, 0.2, 0.3, 0.3, 0.5, 0.6, 0.7), (1.0, 0.6, 0.6, 1.0, 2.0, 2.0, 1.4, 1.2)
    seen = unit.new({"x_n": 0.0, "y_n": 0.0, "z_n": 0.0}, **PASS, fouling_place=places, fouling_scale=scales)
    for s in (-1.0, 0.0, 0.05, 0.1, 0.17, 0.26, 0.4, 0.55, 0.7, 3.0):
        seen.set(x_n=-s)  # the pass goes along -x
        seen.step(0.02)
        close(unit, "friction scale", seen["friction_scale"], np.interp(s, places, scales), 1e-12)


def test_friction_at_the_start_is_that_of_the_table(unit: Unit) -> None:
    """At the start the friction is that of the table at s = 0."""
    first = values(unit, "fouling_place", "fouling_scale")
    seen = unit.new({"x_n": 5.0, "y_n": 0.0, "z_n": 0.0})
    close(unit, "friction scale at the start", seen["friction_scale"], np.interp(0.0, *first), 1e-12)


EXCITATION = Excitation(
    0.05, 60, {"x_n": (-0.3, 0.4), "y_n": (0.0, 0.1)},
    {"fouling_scale": (1.0, 0.6, 0.6, 1.0, 1.0, 1.4, 1.4, 1.0), "t_start": 0.1, "t_settle": 0.1, "length": 0.03},
)  # fmt: skip
ESSENTIAL = "x_n y_n z_n x_ref y_ref z_ref v_ref friction_scale"
SUITE = suite(Mission, ESSENTIAL, EXCITATION, sys.modules[__name__])
