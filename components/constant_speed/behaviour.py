"""What a drive that holds its speed does: no load changes it, and its energy is torque times angle."""

from __future__ import annotations

import sys

from ..testing.behaviour import Unit, close, read, run, same, values
from ..testing.suite import Excitation, suite
from .fmu import ConstantSpeed


def test_no_load_changes_the_speed(unit: Unit) -> None:
    """At constant voltage the speed is the same to the last bit, whatever the torque."""
    seen = unit.new({"V_in": unit.parameter("V_nominal"), "T_brush": 0.0}, omega_b_set=10.0)
    for T_brush in (0.0, -5.0, -50.0, 3.0):
        seen.set(T_brush=T_brush)
        seen.step(0.01)
        same("brush speed", seen["omega_b"], 10.0)


def test_speed_is_in_proportion_to_the_voltage(unit: Unit) -> None:
    """omega_b = omega_b_set*V_in/V_nominal, backwards too, and from time 0."""
    omega_b_set, V_nominal = values(unit, "omega_b_set", "V_nominal")
    for V_in in (-6.0, 0.0, 6.0, 12.0):
        seen = unit.new({"V_in": V_in, "T_brush": -3.0})
        for _ in range(2):
            close(unit, "brush speed", seen["omega_b"], omega_b_set * V_in / V_nominal, 1e-15, abs(omega_b_set))
            seen.step(0.01)


def test_power_is_torque_times_speed_without_losses(unit: Unit) -> None:
    """P_electrical = P_shaft = -T_brush*omega_b."""
    for T_brush in (-16.63, 4.0):
        seen = run(unit, 0.02, 0.01, {"V_in": 9.0, "T_brush": T_brush})
        close(unit, "powers", read(seen, "P_electrical", "P_shaft"), -T_brush * seen["omega_b"], 1e-15)


def test_energy_is_the_torque_times_the_angle(unit: Unit) -> None:
    """W_electrical and W_shaft are the sums of -T_brush*omega_b*h."""
    seen, energy = unit.new({"V_in": unit.parameter("V_nominal"), "T_brush": 0.0}, omega_b_set=10.0), 0.0
    for T_brush in (0.0, -5.0, -50.0, 3.0):
        seen.set(T_brush=T_brush)
        seen.step(0.01)
        energy -= T_brush * 10.0 * 0.01
        close(unit, "energies", read(seen, "W_electrical", "W_shaft"), energy, 1e-14, 5.5)  # rounding of four sums


def test_energy_does_not_depend_on_the_communication_step(unit: Unit) -> None:
    """At constant inputs 1 ms and 50 ms count the same energy."""
    fine, coarse = (run(unit, 0.5, h, {"V_in": 12.0, "T_brush": -8.0})["W_shaft"] for h in (1e-3, 0.05))
    close(unit, "energy", coarse, fine, 1e-13)  # rounding of 500 sums


def test_housing_holds_the_brush_torque(unit: Unit) -> None:
    """T_housing = T_brush: what holds the speed is the vehicle; J_housing is its integral."""
    seen, impulse = unit.new({"V_in": unit.parameter("V_nominal"), "T_brush": 0.0}, omega_b_set=10.0), 0.0
    before = seen["J_housing"]
    for T_brush in (0.0, -5.0, -50.0, 3.0):
        seen.set(T_brush=T_brush)
        seen.step(0.01)
        impulse += T_brush * 0.01
        same("torque of the housing", seen["T_housing"], T_brush)
        close(unit, "impulse of the housing", seen["J_housing"] - before, impulse, 1e-14, 6.0)  # the spin is about 6


def test_jump_of_the_speed_is_an_impulse_on_the_housing(unit: Unit) -> None:
    """H_spin = J_b*omega_b, and a step of the voltage throws the housing back by what the spin jumps by."""
    J_b, V = values(unit, "J_b", "V_nominal")
    seen = unit.new({"V_in": V, "T_brush": 0.0}, omega_b_set=10.0)
    before = seen["J_housing"]
    close(unit, "spin momentum", seen["H_spin"], J_b * 10.0, 1e-15)
    seen.set(V_in=0.5 * V)
    seen.step(0.01)
    close(unit, "impulse of the housing", seen["J_housing"] - before, J_b * 5.0, 1e-14)


EXCITATION = Excitation(1e-3, 30, {"V_in": (6.0, 9.0), "T_brush": (-10.0, 9.0)})
SUITE = suite(ConstantSpeed, "V_in T_brush omega_b", EXCITATION, sys.modules[__name__])
