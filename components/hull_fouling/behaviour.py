"""What the hull does under a brush: work is conserved, strikes add up, fouling wears off, passes are counted."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

from ..testing.behaviour import Running, Unit, close, holds, read, same, values
from ..testing.suite import Excitation, suite
from .fmu import HullFouling

MAP = ("sliding", "shear_work", "normal_work", "strikes")
AT_REST = {"s": 0.0, "delta": 0.003, "omega_b": 15.0, "v_rov": 0.05, "F_z": -30.0, "W_friction": 0.0}
POWER = 60.0  # W
FOULED: dict[str, Any] = {"fouling_scale": (1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 1.0, 1.0), "removal_work": (2000.0,) * 8}


def sweep(running: Running, t: float, duration: float, begin: float, v: float, h: float, **inputs: float) -> float:
    """Drive along from `begin` at v with constant power, from time t on; the time at its end."""
    for _ in range(round(duration / h)):
        t += h
        begin += v * h
        running.set(s=begin, W_friction=POWER * t, **inputs)
        running.step(h)
    return t


def drive(unit: Unit, duration: float, begin: float, v: float, h: float = 0.01, **parameters: Any) -> Running:
    """A hull after one pass."""
    running = unit.new(AT_REST | {"s": begin}, **parameters)
    sweep(running, 0.0, duration, begin, v, h)
    return running


def area(unit: Unit) -> float:
    """Of a cell [m2]."""
    length, width = values(unit, "cell_length", "track_width")
    return float(length * width)


def contact(unit: Unit, delta: float) -> float:
    """The length on which undeformed tips touch [m]."""
    R = unit.parameter("R_brush")
    return float(2.0 * np.sqrt(delta * (2.0 * R - delta)))


def test_untouched_hull_stays_as_it_is(unit: Unit) -> None:
    """A brush off the hull, without friction work, changes no cell."""
    running = unit.new(AT_REST | {"delta": -0.01}, **FOULED)
    before = read(running, *MAP, "passes", "fouling")
    for k in range(20):
        running.set(s=0.05 * k, delta=-0.01)
        running.step(0.1)
    same("the map", read(running, *MAP, "passes", "fouling"), before)


def test_friction_work_is_parted_without_loss(unit: Unit) -> None:
    """Shear work over all cells, and what was beyond them, is the friction work of the brush, at any speed and step."""
    for begin, v, h in ((-0.3, 0.05, 0.01), (0.0, -0.4, 0.003), (0.4, 0.0, 0.05), (-2.0, 3.0, 0.1)):
        running = drive(unit, 3.0, begin, v, h)
        done = POWER * h * round(3.0 / h)
        on_cells = float(np.sum(running["shear_work"])) * area(unit)
        close(unit, "work on the cells", on_cells, running["W_cells"], 1e-12, done)
        close(unit, "work on the cells and beyond", running["W_cells"] + running["W_beyond"], done, 1e-12)


def test_work_is_done_where_the_brush_is(unit: Unit) -> None:
    """Under a brush that stands still the shear work is spread evenly over the contact and is 0 elsewhere."""
    running = drive(unit, 1.0, 0.5, 0.0)
    half, place = 0.5 * contact(unit, AT_REST["delta"]), running["place"]
    length, width = values(unit, "cell_length", "track_width")
    above, below = np.minimum(place + 0.5 * length, 0.5 + half), np.maximum(place - 0.5 * length, 0.5 - half)
    covered = np.maximum(above - below, 0.0)
    close(unit, "shear work", running["shear_work"], POWER * covered / (2.0 * half * length * width), 1e-10)


def test_a_point_lies_under_the_brush_for_contact_over_speed(unit: Unit) -> None:
    """Passed at v, a point is struck n*omega/(2 pi) times a second for contact/v; the tips slide at omega*R - v_rov."""
    running = drive(unit, 20.0, -0.3, 0.05)
    n, R = values(unit, "n", "R_brush")
    time = contact(unit, AT_REST["delta"]) / 0.05
    middle = (running["place"] > 0.0) & (running["place"] < 0.5)
    close(unit, "strikes", running["strikes"][middle], n * 15.0 / (2.0 * np.pi) * time, 1e-10)
    speed = 15.0 * R - 0.05
    close(unit, "way of the tips", running["sliding"][middle], speed * time, 1e-10)
    per_area = unit.parameter("track_width") * 0.05
    close(unit, "normal work", running["normal_work"][middle], 30.0 * speed / per_area, 1e-10)
    close(unit, "shear work", running["shear_work"][middle], POWER / per_area, 1e-10)


def test_communication_step_does_not_matter(unit: Unit) -> None:
    """A pass in steps of 2 ms and of 0.5 s leaves the same map."""
    fine, coarse = (drive(unit, 10.0, -0.2, 0.06, h) for h in (0.002, 0.5))
    for name in MAP:
        close(unit, name, coarse[name], fine[name], 1e-9)  # sums of 5000 differences


def test_place_may_follow_from_the_speed(unit: Unit) -> None:
    """With by_speed a hull that passes the tool at v_rov is treated as one along which the brush goes at v_rov."""
    told = drive(unit, 10.0, -0.1, 0.05)
    running = unit.new(AT_REST | {"s": -0.1}, by_speed=True)
    for k in range(1, 1001):
        running.set(W_friction=POWER * 0.01 * k)
        running.step(0.01)
    for name in MAP:
        close(unit, name, running[name], told[name], 1e-9)  # sums of 1000 steps


def test_passes_do_not_depend_on_the_communication_step(unit: Unit) -> None:
    """One pass is one pass, also where a step is longer than pass_gap."""
    gap = unit.parameter("pass_gap")
    for h in (0.25 * gap, gap, 1.5 * gap, 4.0 * gap):
        running = unit.new(AT_REST | {"s": -0.3})
        sweep(running, 0.0, 16.0 * gap, -0.3, 1.1 / (16.0 * gap), h)
        visited = running["passes"][running["place"] < 0.75]
        same(f"passes with steps of {h:g} s", visited, 1.0)


def test_passes_are_counted(unit: Unit) -> None:
    """There and back after a pause are two passes; a brush that lifts off for less than pass_gap makes no other."""
    running = unit.new(AT_REST | {"s": -0.3})
    t = sweep(running, 0.0, 8.0, -0.3, 0.1, 0.01)
    same("passes", running["passes"][8:20], 1.0)
    t = sweep(running, t, 0.5, 0.5, 0.0, 0.01, delta=-0.01)
    t = sweep(running, t, 0.5, 0.5, 0.0, 0.01, delta=0.003)
    same("passes where it lifted", running["passes"][np.argmin(np.abs(running["place"] - 0.5))], 1.0)
    sweep(running, t, 8.0, 0.5, -0.1, 0.01)
    same("passes there and back", running["passes"][8:20], 2.0)


def test_fouling_is_left_in_proportion(unit: Unit) -> None:
    """The share that is left falls evenly with the shear work and ends at 0 when removal_work has been done."""
    for duration, v in ((1.0, 0.4), (8.0, 0.05)):
        running = drive(unit, duration, 0.1, v, **FOULED)
        close(unit, "fouling left", running["fouling"], np.maximum(0.0, 1.0 - running["shear_work"] / 2000.0), 1e-14)
    length = unit.parameter("cell_length")
    close(unit, "length cleaned", running["cleaned"], length * np.sum(running["fouling"] == 0.0), 1e-12)
    holds(running["cleaned"] > 0.2, f"only {running['cleaned']:.3g} m are clean")


def test_friction_is_that_of_the_fouling_under_the_brush(unit: Unit) -> None:
    """An untouched hull has the friction of the table, averaged over the contact, beyond the cells too."""
    running = unit.new(AT_REST, **FOULED)
    for s, expected in ((0.05, 1.0), (0.35, 2.0), (-5.0, 1.0), (50.0, 1.0), (0.15, 1.5)):
        running.set(s=s, delta=0.003, W_friction=0.0)
        running.step(0.01)
        # The slope of the table over cells of finite length: by symmetry the mean is that of the middle.
        close(unit, f"friction scale at {s:g} m", running["friction_scale"], expected, 2e-2)


def test_clean_hull_has_no_extra_friction(unit: Unit) -> None:
    """Where everything is worn off the friction scale is 1, whether fouling made it rougher or smoother."""
    for scale in (3.0, 0.5):
        running = drive(unit, 20.0, 0.4, 0.0, fouling_scale=(scale,) * 8, removal_work=(1000.0,) * 8)
        close(unit, "friction scale", running["friction_scale"], 1.0, 1e-12)


EXCITATION = Excitation(
    0.02, 60,
    {"s": (0.3, 0.4), "delta": (0.001, 0.003), "omega_b": (12.0, 5.0), "v_rov": (0.0, 0.1), "F_z": (-20.0, 15.0),
     "W_friction": (50.0, 40.0)},
    {"fouling_scale": (1.0, 0.6, 0.6, 1.0, 1.0, 1.4, 1.4, 1.0)},
)  # fmt: skip
SUITE = suite(HullFouling, "s W_friction friction_scale shear_work fouling", EXCITATION, sys.modules[__name__])
