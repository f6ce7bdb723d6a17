"""What a brush motor does: analytic solutions of the circuit, passivity, energy accounts, gear, current limit."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
from scipy.linalg import expm

from ..behaviour import Running, Unit, close, go_on, holds, read, run, values, where_known
from ..behaviour_suite import Excitation, suite
from .fmu import DcMotor

H = 1e-3  # s, the communication step
LONG = 5e-3  # s, for runs into the steady state


def plain(unit: Unit, **changes: Any) -> dict[str, Any]:
    """No gear loss and no current limit, where the unit has them at all; and the changes."""
    return where_known(unit, gear_efficiency=1.0, current_limit=0.0) | changes


def ratio(unit: Unit) -> float:
    """The gear ratio; a unit without a number of stages has one."""
    return float(unit.parameter("gear_ratio_per_stage") ** (unit.parameter("gear_stages") if unit.supports("gear_stages") else 1))


def settled(unit: Unit, V_in: float, T_brush: float, **changes: Any) -> Running:
    """In the steady state: at least 20 of the slower time constant, which is about J R/(K_t K_e)."""
    R, K_t, K_e, J_m, J_b = values(unit, "R", "K_t", "K_e", "J_m", "J_b")
    slow = (J_m + J_b / ratio(unit) ** 2) * R / (K_t * K_e)
    return run(unit, np.ceil(25.0 * slow), LONG, {"V_in": V_in, "T_brush": T_brush}, **plain(unit, **changes))


def test_nothing_moves_without_voltage_and_load(unit: Unit) -> None:
    """From rest, without voltage and load, the brush stays at rest."""
    close(unit, "brush speed", run(unit, 0.1, H, {"V_in": 0.0, "T_brush": 0.0})["omega_b"], 0.0, 1e-12, 10.0)


def test_voltage_turns_the_brush_forward_and_torque_pushes_it(unit: Unit) -> None:
    """Positive voltage turns the brush forward; T_brush acts on it along +omega_b: negative slows it down."""
    slowed, free, pushed = (run(unit, 0.2, H, {"V_in": 12.0, "T_brush": T})["omega_b"] for T in (-2.0, 0.0, 2.0))
    holds(free > 0.0, f"12 V give {free:.6g} rad/s, expected a positive speed")
    holds(slowed < free < pushed, f"speeds with T_brush = -2, 0, 2 N.m: {slowed:.6g}, {free:.6g}, {pushed:.6g} rad/s, "
          "expected rising; is the sign of T_brush turned round?")


def test_motor_is_the_same_in_both_directions(unit: Unit) -> None:
    """With voltage and torque reversed, the speed is reversed."""
    ahead, back = (run(unit, 0.1, H, {"V_in": s * 9.0, "T_brush": s * -3.0})["omega_b"] for s in (1.0, -1.0))
    close(unit, "speed in reverse", back, -ahead, 1e-12)


def test_stall_current_is_voltage_over_resistance(unit: Unit) -> None:
    """Under the load K_t*V/R*N_g the motor comes to rest with the current V/R."""
    R, K_t = values(unit, "R", "K_t")
    stalled = settled(unit, 12.0, -K_t * 12.0 / R * ratio(unit))
    close(unit, "stall current", stalled["i"], 12.0 / R, 1e-9)
    # What is left of the transient after 25 time constants: e^-25 of 20 rad/s.
    close(unit, "speed at stall", stalled["omega_b"], 0.0, 1e-9, 12.0 / unit.parameter("K_e") / ratio(unit))


def test_current_rises_with_the_time_constant_of_the_armature(unit: Unit) -> None:
    """With a rotor too heavy to move, the current after t is V/R*(1 - exp(-t R/L_a))."""
    R, L_a = values(unit, "R", "L_a")
    seen = unit.new({"V_in": 12.0, "T_brush": 0.0}, **plain(unit, J_m=1.0))
    for k in range(1, 4):
        seen.step(L_a / R)
        # Within 2 ms the heavy rotor reaches K_t*150*0.002 = 5e-3 rad/s: a back-EMF of 6e-6 of the voltage.
        close(unit, "current", seen["i"], 12.0 / R * (1.0 - np.exp(-k)), 2e-5, 12.0 / R)


def test_no_load_speed_is_that_of_the_circuit(unit: Unit) -> None:
    """Without load omega_m = V K_t/(K_e K_t + R B_m)."""
    R, K_t, K_e, B_m = values(unit, "R", "K_t", "K_e", "B_m")
    omega_m = 12.0 * K_t / (K_e * K_t + R * B_m)
    close(unit, "no-load speed", settled(unit, 12.0, 0.0)["omega_b"], omega_m / ratio(unit), 1e-9)


def test_speed_falls_with_the_load_as_the_circuit_says(unit: Unit) -> None:
    """Under load omega_m = (V K_t/R + T_brush/N_g)/(K_e K_t/R + B_m)."""
    R, K_t, K_e, B_m = values(unit, "R", "K_t", "K_e", "B_m")
    for T_brush in (-16.63, 5.0):
        omega_m = (12.0 * K_t / R + T_brush / ratio(unit)) / (K_e * K_t / R + B_m)
        close(unit, "loaded speed", settled(unit, 12.0, T_brush)["omega_b"], omega_m / ratio(unit), 1e-9)


def test_step_response_is_the_matrix_exponential(unit: Unit) -> None:
    """Current and speed after 1, 10 and 100 ms from rest are those of the linear circuit."""
    R, L_a, K_t, K_e, B_m, J_m, J_b = values(unit, "R", "L_a", "K_t", "K_e", "B_m", "J_m", "J_b")
    N_g = ratio(unit)
    J = J_m + J_b / N_g**2
    A = np.array([[-R / L_a, -K_e / L_a], [K_t / J, -B_m / J]])
    steady = np.linalg.solve(A, -np.array([12.0 / L_a, -5.0 / N_g / J]))
    for h in (H, 0.5 * H):
        seen = unit.new({"V_in": 12.0, "T_brush": -5.0}, **plain(unit))
        t = 0.0
        for until in (0.001, 0.01, 0.1):
            go_on(seen, until - t, h)
            t = until
            i, omega_m = steady - expm(A * t) @ steady
            # Fourth order at a tenth of L_a/R: 1.3e-7 of the scale.
            close(unit, "current of the step response", seen["i"], i, 1e-6, 12.0 / R)
            close(unit, "speed of the step response", seen["omega_b"], omega_m / N_g, 1e-6, 12.0 / K_e / N_g)


def test_torque_is_the_torque_constant_times_the_current(unit: Unit) -> None:
    """T_motor = K_t*i."""
    seen = run(unit, 0.05, H, {"V_in": 12.0, "T_brush": -5.0})
    close(unit, "air-gap torque", seen["T_motor"], unit.parameter("K_t") * seen["i"], 1e-14)


def test_gear_ratio_is_the_ratio_of_the_speeds(unit: Unit) -> None:
    """omega_m = N_g*omega_b, at any time."""
    seen = run(unit, 0.05, H, {"V_in": 12.0, "T_brush": -5.0})
    close(unit, "motor speed", seen["omega_m"], ratio(unit) * seen["omega_b"], 1e-14)


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
    """In the steady state the shaft gets less than V_in*i when the motor drives, the terminals less when it is driven."""
    seen = settled(unit, 12.0, -10.0)
    taken, given = 12.0 * seen["i"], 10.0 * seen["omega_b"]
    holds(0.0 < given < taken, f"driving: {taken:.5g} W in at the terminals, {given:.5g} W out at the shaft")
    seen = settled(unit, 1.0, 10.0)
    taken, given = 10.0 * seen["omega_b"], -1.0 * seen["i"]
    holds(0.0 < given < taken, f"driven: {taken:.5g} W in at the shaft, {given:.5g} W out at the terminals")


def test_carried_load_costs_more_than_it_gives(unit: Unit) -> None:
    """A load that the motor carries for 6 s at 12 V gets less power than V_in*i, whatever the parameters."""
    for T_brush in (-2.0, -5.0, -10.0):
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
    for parameters in ({}, {"gear_efficiency": 0.7}, {"current_limit": 60.0}):
        seen = run(unit, 3.0, LONG, {"V_in": 12.0, "T_brush": -10.0}, **plain(unit, **parameters))
        holds(seen["W_electrical"] > 1000.0, f"12 V and 10 N.m took in {seen['W_electrical']:.4g} J only in 3 s")
        # Fourth-order quadrature of the start-up; the band where the gear loss fades out is not smooth: some digits less.
        close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-7, seen["W_electrical"])


def test_energies_are_the_integrals_of_the_powers(unit: Unit) -> None:
    """W_electrical, W_copper, W_friction, W_gear and W_shaft grow at the rates P_*."""
    names = ("electrical", "copper", "friction", "gear", "shaft")
    seen = run(unit, 0.3, H, {"V_in": 12.0, "T_brush": -10.0}, **where_known(unit, gear_efficiency=0.8))
    power, energy, h = [read(seen, *(f"P_{x}" for x in names))], read(seen, *(f"W_{x}" for x in names)), 1e-3
    for _ in range(200):
        seen.step(h)
        power.append(read(seen, *(f"P_{x}" for x in names)))
    # The trapezoidal rule over a smooth rise with the time constant 0.2 s: h^2/12 of its curvature.
    close(unit, "energies", read(seen, *(f"W_{x}" for x in names)) - energy, h * (np.sum(power, 0) - 0.5 * (power[0] + power[-1])), 1e-5)


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


def test_current_limit_holds_and_releases(unit: Unit) -> None:
    """The current stays at its limit while the motor speeds up, in both directions, and the end speed is the same."""
    K_t, B_m, J_m, J_b = values(unit, "K_t", "B_m", "J_m", "J_b")
    J = J_m + J_b / ratio(unit) ** 2
    free = settled(unit, 12.0, 0.0)["omega_b"]
    for sign in (1.0, -1.0):
        limited = plain(unit, current_limit=60.0)
        held = run(unit, 0.05, H, {"V_in": sign * 12.0, "T_brush": 0.0}, **limited)
        close(unit, "limited current", held["i"], sign * 60.0, 1e-8)
        # Constant torque on a damped flywheel; the first 0.3 ms of 50 ms are the current's rise.
        expected = sign * K_t * 60.0 / B_m * (1.0 - np.exp(-B_m / J * 0.05)) / ratio(unit)
        close(unit, "speed at the limit", held["omega_b"], expected, 5e-3)
        released = settled(unit, sign * 12.0, 0.0, current_limit=60.0)
        close(unit, "speed after the limit", released["omega_b"], sign * free, 1e-7)


def test_communication_step_does_not_matter(unit: Unit) -> None:
    """1 ms and 5 ms give the same current and speed after 0.1 s."""
    for parameters in ({}, where_known(unit, current_limit=70.0)):
        fine, coarse = (read(run(unit, 0.1, h, {"V_in": 12.0, "T_brush": -5.0}, **parameters), "i", "omega_b")
                        for h in (1e-3, 5e-3))
        close(unit, "current and speed", coarse, fine, 1e-9)  # internal steps coincide; the rounding of h differs


def test_small_inductance_is_no_trouble(unit: Unit) -> None:
    """With 1 uH, a time constant of 12.5 us, a step of 10 ms still gives the speed of the circuit."""
    R, K_t, K_e, B_m = values(unit, "R", "K_t", "K_e", "B_m")
    omega_m = (12.0 * K_t / R - 16.63 / ratio(unit)) / (K_e * K_t / R + B_m)
    seen = run(unit, 5.0, 0.01, {"V_in": 12.0, "T_brush": -16.63}, **plain(unit, L_a=1e-6))
    close(unit, "loaded speed", seen["omega_b"], omega_m / ratio(unit), 1e-9)


def test_internal_steps_are_of_fourth_order(unit: Unit) -> None:
    """The error of the current falls with the fourth power of max_step."""
    current = [run(unit, 2e-3, H, {"V_in": 12.0, "T_brush": -5.0}, **plain(unit, max_step=dt))["i"]
               for dt in (4e-5, 2e-5, 2e-6)]
    order = np.log2(abs(current[0] - current[2]) / abs(current[1] - current[2]))
    close(unit, "order of the integration", order, 4.0, 0.15, 1.0)


EXCITATION = Excitation(H, 60, {"V_in": (6.0, 9.0), "T_brush": (-8.0, 9.0)})
SUITE = suite(DcMotor, "V_in T_brush omega_b", EXCITATION, sys.modules[__name__])
