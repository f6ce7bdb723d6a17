"""What a battery does: voltage under load, charge, polarisation, when it is empty, independence of steps."""

from __future__ import annotations

import sys

import numpy as np

from ..testing.behaviour import Unit, close, go_on, holds, read, run, same, values
from ..testing.suite import Excitation, suite
from . import behaviour_energy
from .behaviour_energy import capacity, resistances
from .fmu import Battery


def test_at_rest_nothing_changes(unit: Unit) -> None:
    """Without current the terminals show the open-circuit voltage, and neither it nor the charge changes."""
    seen = unit.new({"i": 0.0, "i_other": 0.0}, soc_start=0.6)
    same("voltage", seen["V"], seen["V_oc"])
    before = read(seen, "V", "soc", "charge")
    same("voltage and charge after an hour", read(go_on(seen, 3600.0, 600.0), "V", "soc", "charge"), before)


def test_open_circuit_voltage_is_the_table_of_a_cell(unit: Unit) -> None:
    """V_oc is n_series times the table, straight between its points."""
    V_cell, n_series = values(unit, "V_cell", "n_series")
    for soc in (0.0, 0.04, 0.1, 0.55, 0.999, 1.0):
        expected = n_series * np.interp(soc, np.linspace(0.0, 1.0, 11), V_cell)
        close(unit, "open-circuit voltage", unit.new({"i": 0.0}, soc_start=soc)["V_oc"], expected, 1e-14)


def test_load_lowers_the_voltage_at_once_by_its_ohmic_drop(unit: Unit) -> None:
    """V_oc - V = R_0*i in the instant of the load, with either sign."""
    R_0, _ = resistances(unit)
    for i in (40.0, -10.0):
        seen = unit.new({"i": i, "i_other": 0.0}, soc_start=0.5)
        close(unit, "drop of voltage", seen["V_oc"] - seen["V"], R_0 * i, 1e-12)


def test_consumers_add_up(unit: Unit) -> None:
    """30 A here and 12 A there are 42 A: the same voltage, charge and energy."""
    names = ("V", "soc", "W_terminals")
    split, whole = (run(unit, 10.0, 0.5, {"i": i, "i_other": 42.0 - i}, soc_start=0.8) for i in (30.0, 42.0))
    same("voltage, charge and energy", read(split, *names), read(whole, *names))


def test_charge_drawn_is_current_times_time(unit: Unit) -> None:
    """soc falls by i*t/Q, and charging takes it back."""
    Q = capacity(unit)
    seen = run(unit, 600.0, 1.0, {"i": 20.0, "i_other": 0.0}, soc_start=0.9)
    close(unit, "state of charge", seen["soc"], 0.9 - 20.0 * 600.0 / Q, 1e-12)  # rounding of 600 sums
    close(unit, "charge drawn", seen["charge"], 20.0 * 600.0, 1e-9)
    seen.set(i=-40.0)
    close(unit, "state of charge after charging", go_on(seen, 300.0, 1.0)["soc"], 0.9, 1e-12)


def test_polarisation_grows_and_decays_with_its_time_constant(unit: Unit) -> None:
    """The drop beyond R_0*i is R_1*i*(1 - exp(-t/tau_1)), and decays likewise when the load is taken off."""
    (R_0, R_1), tau_1 = resistances(unit), unit.parameter("tau_1")
    seen = unit.new({"i": 50.0, "i_other": 0.0}, soc_start=0.7)
    for k in range(1, 5):
        seen.step(0.5 * tau_1)
        drop = seen["V_oc"] - seen["V"] - R_0 * 50.0
        close(unit, "polarisation", drop, R_1 * 50.0 * (1.0 - np.exp(-0.5 * k)), 1e-11)
    seen.set(i=0.0)
    seen.step(tau_1)
    left = R_1 * 50.0 * (1.0 - np.exp(-2.0)) * np.exp(-1.0)
    close(unit, "polarisation left", seen["V_oc"] - seen["V"], left, 1e-11)


def test_without_polarisation_the_voltage_answers_at_once(unit: Unit) -> None:
    """With R_1_cell = 0, V = V_oc - R_0*i at any time."""
    R_0, _ = resistances(unit)
    seen = run(unit, 30.0, 0.1, {"i": 50.0, "i_other": 0.0}, R_1_cell=0.0)
    close(unit, "drop of voltage", seen["V_oc"] - seen["V"], R_0 * 50.0, 1e-12)


def test_rated_charge_is_drawn_in_an_hour(unit: Unit) -> None:
    """The current Q/1 h empties a full battery in an hour, and not in 59 minutes."""
    seen = run(unit, 3540.0, 10.0, {"i": capacity(unit) / 3600.0, "i_other": 0.0}, V_cell_min=0.0)
    holds(seen["empty"] == 0.0, f"empty after 59 minutes, at soc = {seen['soc']:.4g}")
    holds(go_on(seen, 70.0, 10.0)["empty"] == 1.0, f"not empty after an hour, at soc = {seen['soc']:.4g}")


def test_heavy_load_makes_it_count_as_empty(unit: Unit) -> None:
    """empty is 1 as long as the voltage under load is at n_series*V_cell_min or below, and 0 again without."""
    lowest = unit.parameter("n_series") * unit.parameter("V_cell_min")
    (R_0, _), rest = resistances(unit), unit.new({"i": 0.0}, soc_start=0.3)["V"]
    for factor, expected in ((0.99, 0.0), (1.01, 1.0)):
        seen = unit.new({"i": factor * (rest - lowest) / R_0, "i_other": 0.0}, soc_start=0.3)
        holds(seen["empty"] == expected, f"empty = {seen['empty']:g} at {seen['V']:.6g} V, the limit is {lowest:.6g} V")


def test_communication_step_does_not_matter(unit: Unit) -> None:
    """1 ms and 1 s give the same voltage, charge and energies after 20 s."""
    names = ("V", "soc", "W_terminals", "W_ohmic", "W_polarisation")
    fine, coarse = (run(unit, 20.0, h, {"i": 60.0, "i_other": 3.0}, soc_start=0.905) for h in (1e-3, 1.0))
    for name in names:
        # The energy of a step is a difference of stores of a megajoule: rounding of 20000 of them.
        close(unit, name, coarse[name], fine[name], 1e-9)


EXCITATION = Excitation(1e-3, 60, {"i": (30.0, 60.0), "i_other": (2.0, 4.0)})
SUITE = suite(Battery, "i V", EXCITATION, sys.modules[__name__], behaviour_energy)
