"""What a brush motor does: signs, analytic solutions of the circuit, current limit, independence of steps."""

from __future__ import annotations

import sys

import numpy as np
from scipy.linalg import expm

from ..testing.behaviour import Unit, close, go_on, holds, read, run, values, where_known
from ..testing.suite import Excitation, suite
from . import behaviour_energy, behaviour_housing
from .behaviour_energy import H, constants, plain, ratio, settled
from .fmu import DcMotor


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
    R, (K_t, K_e) = unit.parameter("R"), constants(unit)
    stalled = settled(unit, 12.0, -K_t * 12.0 / R * ratio(unit))
    close(unit, "stall current", stalled["i"], 12.0 / R, 1e-9)
    # What is left of the transient after 25 time constants: e^-25 of 20 rad/s.
    close(unit, "speed at stall", stalled["omega_b"], 0.0, 1e-9, 12.0 / K_e / ratio(unit))


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
    (R, B_m), (K_t, K_e) = values(unit, "R", "B_m"), constants(unit)
    omega_m = 12.0 * K_t / (K_e * K_t + R * B_m)
    close(unit, "no-load speed", settled(unit, 12.0, 0.0)["omega_b"], omega_m / ratio(unit), 1e-9)


def test_speed_falls_with_the_load_as_the_circuit_says(unit: Unit) -> None:
    """Under load omega_m = (V K_t/R + T_brush/N_g)/(K_e K_t/R + B_m)."""
    (R, B_m), (K_t, K_e) = values(unit, "R", "B_m"), constants(unit)
    for T_brush in (-16.63, 5.0):
        omega_m = (12.0 * K_t / R + T_brush / ratio(unit)) / (K_e * K_t / R + B_m)
        close(unit, "loaded speed", settled(unit, 12.0, T_brush)["omega_b"], omega_m / ratio(unit), 1e-9)


def test_step_response_is_the_matrix_exponential(unit: Unit) -> None:
    """Current and speed after 1, 10 and 100 ms from rest are those of the linear circuit."""
    R, L_a, B_m, J_m, J_b = values(unit, "R", "L_a", "B_m", "J_m", "J_b")
    K_t, K_e = constants(unit)
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
    close(unit, "air-gap torque", seen["T_motor"], constants(unit)[0] * seen["i"], 1e-14)


def test_gear_ratio_is_the_ratio_of_the_speeds(unit: Unit) -> None:
    """omega_m = N_g*omega_b, at any time."""
    seen = run(unit, 0.05, H, {"V_in": 12.0, "T_brush": -5.0})
    close(unit, "motor speed", seen["omega_m"], ratio(unit) * seen["omega_b"], 1e-14)


def test_current_limit_holds_and_releases(unit: Unit) -> None:
    """The current stays at its limit while the motor speeds up, in both directions, and the end speed is the same."""
    (B_m, J_m, J_b), (K_t, _) = values(unit, "B_m", "J_m", "J_b"), constants(unit)
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
    (R, B_m), (K_t, K_e) = values(unit, "R", "B_m"), constants(unit)
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
SUITE = suite(DcMotor, "V_in T_brush omega_b", EXCITATION, sys.modules[__name__], behaviour_energy, behaviour_housing)
