"""What a brush motor does with energy: passivity, losses, accounts, the gear; and how all its tests set it up."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..testing.behaviour import Running, Unit, close, holds, read, run, values, where_known

H = 1e-3  # s, the communication step
LONG = 5e-3  # s, for runs into the steady state


def plain(unit: Unit, **changes: Any) -> dict[str, Any]:
    """No gear loss and no current limit, where the unit has them at all; and the changes."""
    return where_known(unit, gear_efficiency=1.0, current_limit=0.0) | changes


def ratio(unit: Unit) -> float:
    """The gear ratio; a unit without a number of stages has one."""
    stages = unit.parameter("gear_stages") if unit.supports("gear_stages") else 1
    return float(unit.parameter("gear_ratio_per_stage") ** stages)


def constants(unit: Unit) -> tuple[float, float]:
    """K_t and K_e; a unit that has one constant for both has it under either name, they are equal in SI."""
    names = [name for name in ("K_t", "K_e") if unit.supports(name)] or ["K_t"]
    return unit.parameter(names[0]), unit.parameter(names[-1])


def settled(unit: Unit, V_in: float, T_brush: float, **changes: Any) -> Running:
    """In the steady state: at least 20 of the slower time constant, which is about J R/(K_t K_e)."""
    (R, J_m, J_b), (K_t, K_e) = values(unit, "R", "J_m", "J_b"), constants(unit)
    slow = (J_m + J_b / ratio(unit) ** 2) * R / (K_t * K_e)
    return run(unit, np.ceil(25.0 * slow), LONG, {"V_in": V_in, "T_brush": T_brush}, **plain(unit, **changes))


def test_energy_never_comes_out_of_nothing(unit: Unit) -> None:
    """Passivity: from rest, the energy taken in at both ends, int (V_in i + T_brush omega_b) dt, is never negative."""
    seen = unit.new({"V_in": 0.0, "T_brush": 0.0}, **where_known(unit, i_start=0.0, omega_b_start=0.0))
    supplied, largest = 0.0, 0.0
    h = 2e-4
    inputs = [(12.0, -5.0)] * 1000 + [(0.0, 20.0)] * 500 + [(0.0, 0.0)] * 1000 + [(-12.0, -20.0)] * 500
    before = np.array([0.0, 0.0])
    for effort in inputs:
        seen.set(V_in=effort[0], T_brush=effort[1])
        seen.step(h)
        after = read(seen, "i", "omega_b")
        supplied += 0.5 * h * float(np.dot(effort, before + after))
        before, largest = after, max(largest, supplied)
        # The trapezoidal rule at a third of L_a/R: a percent of the energy in the inductance, below 1e-3 of the whole.
        holds(supplied >= -1e-3 * largest, f"{-supplied:.4g} J have come out of a motor that began at rest")


def test_motor_gives_less_than_it_takes_in(unit: Unit) -> None:
    """In the steady state the shaft gets less than V_in*i when the motor drives, and the other way round."""
    seen = settled(unit, 12.0, -10.0)
    taken, given = 12.0 * seen["i"], 10.0 * seen["omega_b"]
    holds(0.0 < given < taken, f"driving: {taken:.5g} W in at the terminals, {given:.5g} W out at the shaft")
    seen = settled(unit, 1.0, 10.0)
    taken, given = 10.0 * seen["omega_b"], -1.0 * seen["i"]
    holds(0.0 < given < taken, f"driven: {taken:.5g} W in at the shaft, {given:.5g} W out at the terminals")


def test_carried_load_costs_more_than_it_gives(unit: Unit) -> None:
    """A load that the motor carries for 6 s at 12 V gets less power than V_in*i, whatever the parameters."""
    for T_brush in (-5.0, -10.0, -20.0, -40.0):
        seen = run(unit, 6.0, LONG, {"V_in": 12.0, "T_brush": T_brush})
        taken, given = 12.0 * seen["i"], -T_brush * seen["omega_b"]
        holds(given < taken, f"{taken:.5g} W in, {given:.5g} W out at {T_brush:g} N.m")


def test_steady_losses_are_copper_and_friction(unit: Unit) -> None:
    """In the steady state V_in*i - shaft power = R i^2 + B_m omega_m^2."""
    R, B_m = values(unit, "R", "B_m")
    seen = settled(unit, 12.0, -10.0)
    lost = R * seen["i"] ** 2 + B_m * (ratio(unit) * seen["omega_b"]) ** 2
    close(unit, "loss", 12.0 * seen["i"] - 10.0 * seen["omega_b"], lost, 1e-8)


def test_energy_is_accounted_for(unit: Unit) -> None:
    """energy_residual stays 0, with and without gear loss and current limit."""
    for parameters in ({}, {"gear_efficiency": 0.7}, {"gear_efficiency": 0.7, "current_limit": 60.0}):
        seen = run(unit, 3.0, LONG, {"V_in": 12.0, "T_brush": -10.0}, **plain(unit, **parameters))
        holds(seen["W_electrical"] > 1000.0, f"12 V and 10 N.m took in {seen['W_electrical']:.4g} J only in 3 s")
        # Fourth-order quadrature of the start-up; where the gear loss fades out it is not smooth.
        close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 5e-8, seen["W_electrical"])


def test_energies_are_the_integrals_of_the_powers(unit: Unit) -> None:
    """W_electrical, W_copper, W_friction, W_gear and W_shaft grow at the rates P_*."""
    names = ("electrical", "copper", "friction", "gear", "shaft")
    seen = run(unit, 0.3, H, {"V_in": 12.0, "T_brush": -10.0}, **where_known(unit, gear_efficiency=0.8))
    power, energy, h = [read(seen, *(f"P_{x}" for x in names))], read(seen, *(f"W_{x}" for x in names)), 1e-3
    for _ in range(200):
        seen.step(h)
        power.append(read(seen, *(f"P_{x}" for x in names)))
    # The trapezoidal rule over a smooth rise with the time constant 0.2 s: h^2/12 of its curvature.
    grown = read(seen, *(f"W_{x}" for x in names)) - energy
    close(unit, "energies", grown, h * (np.sum(power, axis=0) - 0.5 * (power[0] + power[-1])), 1e-5)


def test_shaft_power_is_torque_times_speed(unit: Unit) -> None:
    """P_shaft = -T_brush*omega_b, and in the steady state all powers add up."""
    seen = settled(unit, 12.0, -16.63)
    close(unit, "shaft power", seen["P_shaft"], 16.63 * seen["omega_b"], 1e-12)
    lost = seen["P_copper"] + seen["P_friction"] + seen["P_gear"] + seen["P_shaft"]
    close(unit, "sum of the powers", lost, seen["P_electrical"], 1e-8)


def test_gear_efficiency_is_the_ratio_of_output_to_input_power(unit: Unit) -> None:
    """P_shaft = efficiency*(P_shaft + P_gear) when the motor drives; the loss costs speed."""
    lossy = settled(unit, 12.0, -16.63, gear_efficiency=0.8)
    close(unit, "efficiency", lossy["P_shaft"] / (lossy["P_shaft"] + lossy["P_gear"]), 0.8, 1e-9)
    holds(lossy["omega_b"] < settled(unit, 12.0, -16.63)["omega_b"], "a gear with losses is not slower")


def test_gear_loses_power_when_the_brush_drives_the_motor(unit: Unit) -> None:
    """Driven by the brush, the gear keeps (1 - efficiency) of the power that comes in at the shaft."""
    seen = settled(unit, 0.0, 10.0, gear_efficiency=0.8)
    holds(seen["omega_b"] > 0.0 > seen["P_shaft"], "the brush does not drive the motor")
    close(unit, "gear loss", seen["P_gear"], -0.2 * seen["P_shaft"], 1e-9)
