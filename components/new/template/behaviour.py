"""What the body does, claimed on its interface only: these tests run on all its FMUs, and on anybody else's."""

from __future__ import annotations

import sys
from math import exp

from ...testing.behaviour import Unit, close, run, values
from ...testing.suite import Excitation, suite
from .fmu import Template

H = 1e-2  # s, the communication step


def test_without_force_it_stays_at_rest(unit: Unit) -> None:
    """From rest, without force, it does not move."""
    close(unit, "way", run(unit, 1.0, H, {"F": 0.0}, v_start=0.0)["s"], 0.0, 1e-12, 1.0)


def test_speed_rises_to_force_over_drag(unit: Unit) -> None:
    """After t the speed is F/d*(1 - exp(-t d/m)), in either direction."""
    m, d = values(unit, "m", "d")
    for F in (8.0, -3.0):
        seen = run(unit, 2.0, H, {"F": F}, v_start=0.0)
        close(unit, "speed", seen["v"], F / d * (1.0 - exp(-2.0 * d / m)), 1e-12)


def test_without_force_it_stops_after_its_stopping_distance(unit: Unit) -> None:
    """Let go with v_start it comes to rest after m*v_start/d."""
    m, d = values(unit, "m", "d")
    seen = run(unit, 40.0 * m / d, 0.5 * m / d, {"F": 0.0}, v_start=2.0)
    close(unit, "way", seen["s"], 2.0 * m / d, 1e-12)


def test_communication_step_does_not_matter(unit: Unit) -> None:
    """1 ms and 0.1 s give the same way and energy after 2 s."""
    fine, coarse = (run(unit, 2.0, h, {"F": 8.0}) for h in (1e-3, 0.1))
    for name in ("s", "W_drag"):
        close(unit, name, coarse[name], fine[name], 1e-10)  # rounding of 2000 sums


def test_energy_is_accounted_for(unit: Unit) -> None:
    """energy_residual stays 0: work is drag and kinetic energy."""
    seen = run(unit, 5.0, H, {"F": 8.0}, v_start=-1.0)
    close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-10, abs(seen["W_in"]))


EXCITATION = Excitation(H, 60, {"F": (5.0, 9.0)})
SUITE = suite(Template, "F v", EXCITATION, sys.modules[__name__])
