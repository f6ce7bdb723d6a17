"""What the sensors do: truth that passes through, samples, delays, gains, the accelerometer's lever arm."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from ..testing.behaviour import Running, Unit, close, read, same
from ..testing.suite import Excitation, suite
from . import behaviour_errors
from .fmu import RovSensors

PASSING = (
    "x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r", "F_tool", "M_tool",
)  # fmt: skip
SHOWN = tuple(f"{name}_m" for name in PASSING)
G = 9.80665


def truth(k: int) -> dict[str, Any]:
    """A truth of its own for each instant, angles within a turn."""
    numbers = np.sin(0.7 * k + 1.3 * np.arange(18))
    given: dict[str, Any] = {name: float(numbers[j]) for j, name in enumerate(PASSING[:12])}
    return given | {"F_tool": numbers[12:15] * 30.0, "M_tool": numbers[15:] * 5.0}


def flat(given: Mapping[str, Any]) -> np.ndarray:
    """The truth as numbers, in the order of PASSING."""
    return np.concatenate([np.atleast_1d(given[name]) for name in PASSING])


def follow(
    unit: Unit, of: Callable[[float], Mapping[str, Any]], steps: Sequence[float], **parameters: Any
) -> tuple[Running, list[np.ndarray]]:
    """What all but the accelerometer show at each communication point, the first at 0, of a truth over time."""
    t, seen = 0.0, unit.new(of(0.0), **parameters)
    rows = [read(seen, *SHOWN)]
    for h in steps:
        seen.step(h)
        t += h
        seen.set(**of(t))
        rows.append(read(seen, *SHOWN))
    return seen, rows


def test_truth_passes_through_unchanged(unit: Unit) -> None:
    """Without settings every output is its truth, at every communication point and over every step."""
    seen = unit.new(truth(0))
    for k in range(20):
        seen.set(**truth(k))
        same("readings at a communication point", read(seen, *SHOWN), flat(truth(k)))
        seen.step((0.005, 0.0005, 0.1)[k % 3])
        same("readings behind a step", read(seen, *SHOWN), flat(truth(k)))


def test_delay_is_the_time_from_truth_to_reading(unit: Unit) -> None:
    """A delay of three steps shows the truth of three steps before, to the last bit; before it arrives, the first."""
    _, rows = follow(unit, lambda t: truth(round(t / 0.01)), [0.01] * 40, delay=0.03)
    for k, row in enumerate(rows):
        same(f"readings after {k} steps", row, flat(truth(max(k - 3, 0))))


def test_delay_is_the_same_for_any_communication_step(unit: Unit) -> None:
    """A truth that rises evenly is shown as it was 37.3 ms before, with short, long and changing steps."""

    def rising(t: float) -> dict[str, Any]:
        return {name: t for name in PASSING[:12]} | {"F_tool": np.full(3, t), "M_tool": np.full(3, t)}

    for steps in ([1e-3] * 400, [0.05] * 8, [0.013, 0.002, 0.031, 0.004] * 8):
        _, rows = follow(unit, rising, steps, delay=0.0373)
        expected = np.maximum(np.cumsum([0.0, *steps]) - 0.0373, 0.0)
        # Instants are sums of steps: rounding.
        close(unit, "readings", np.array(rows).ravel(), np.repeat(expected, 18), 1e-12, 1.0)


def test_delays_add_up(unit: Unit) -> None:
    """The common delay comes on top of a sensor's own, and other sensors know only the common one."""
    _, rows = follow(unit, lambda t: truth(round(t / 0.01)), [0.01] * 20, delay=0.02, delay_depth=0.05)
    depth = SHOWN.index("z_n_m")
    for k, row in enumerate(rows):
        same("depth", row[depth], flat(truth(max(k - 7, 0)))[depth])
        same("the others", np.delete(row, depth), np.delete(flat(truth(max(k - 2, 0))), depth))


def test_longest_delays_are_kept_whole(unit: Unit) -> None:
    """A second, of two halves, in steps of 2 ms: all samples between are there."""
    _, rows = follow(unit, lambda t: truth(round(t / 0.002)), [0.002] * 1100, delay=0.5, delay_dvl=0.5)
    dvl = slice(SHOWN.index("u_m"), SHOWN.index("w_m") + 1)
    for k in (600, 1000, 1100):
        same(f"velocity after {k} steps", rows[k][dvl], flat(truth(k - 500))[dvl])


def test_steps_too_short_to_be_kept_leave_the_delay(unit: Unit) -> None:
    """With steps of a thousandth of the delay, of which not all are kept, a rising truth is late by the delay."""
    seen = unit.new({"z_n": 0.0}, delay=0.5)
    for k in range(1, 1501):
        seen.step(0.0005)
        seen.set(z_n=0.0005 * k)
    # Instants are sums of steps: rounding.
    close(unit, "depth", seen["z_n_m"], 0.25, 1e-9, 1.0)


def test_angle_is_delayed_through_its_jump(unit: Unit) -> None:
    """Yaw that goes on behind pi, from 3.1 to -3.1, is at pi when it is shown half a step later."""
    seen = unit.new({"psi": 3.1}, delay_attitude=0.005)
    seen.step(0.01)
    seen.set(psi=-3.1)
    close(unit, "distance from pi", np.pi - abs(seen["psi_m"]), 0.0, 1e-12, 1.0)


def test_samples_are_taken_at_their_rate_and_hold(unit: Unit) -> None:
    """At 20 per second a new reading comes every 50 ms, the truth of that instant, and holds."""
    _, rows = follow(unit, lambda t: truth(round(t / 0.01)), [0.01] * 60, rate_gyro=20.0)
    gyro = slice(SHOWN.index("p_m"), SHOWN.index("r_m") + 1)
    for k, row in enumerate(rows):
        same(f"rates after {k} steps", row[gyro], flat(truth(5 * (k // 5)))[gyro])
        same("velocity", row[6:9], flat(truth(k))[6:9])


def test_samples_arrive_after_the_delay(unit: Unit) -> None:
    """A sample of every 50 ms with a delay of 70 ms is shown from 70 to 120 ms after it was taken."""
    _, rows = follow(unit, lambda t: truth(round(t / 0.01)), [0.01] * 60, rate_force=20.0, delay_force=0.07)
    for k, row in enumerate(rows):
        same(f"wrench after {k} steps", row[12:], flat(truth(5 * max((k - 7) // 5, 0)))[12:])


def test_gain_and_bias_are_those_of_each_sensor(unit: Unit) -> None:
    """A reading is the sensor's gain times the truth plus its bias; the common gain multiplies both."""
    errors = {"gain_dvl": 1.01, "bias_dvl": (0.1, 0.2, 0.3), "gain_depth": 0.9, "bias_depth": -0.5, "gain": 1.5}
    seen = unit.new(truth(3), **errors)
    given = truth(3)
    for j, name in enumerate(("u", "v", "w")):
        close(unit, "velocity", seen[f"{name}_m"], 1.5 * (1.01 * given[name] + 0.1 * (j + 1)), 1e-14)
    close(unit, "depth", seen["z_n_m"], 1.5 * (0.9 * given["z_n"] - 0.5), 1e-14)
    close(unit, "tool force", seen["F_tool_m"], 1.5 * given["F_tool"], 1e-14)


def test_accelerometer_at_rest_feels_the_weight(unit: Unit) -> None:
    """At rest the specific force is g upward: -g along the body's z when level, and turned with the body."""
    g = unit.parameter("g")
    for phi, theta in ((0.0, 0.0), (0.4, 0.0), (0.0, -0.7), (-2.0, 1.1)):
        up = np.array([np.sin(theta), -np.cos(theta) * np.sin(phi), -np.cos(theta) * np.cos(phi)])
        close(unit, "specific force", unit.new({"phi": phi, "theta": theta})["f_m"], g * up, 1e-14)


def test_accelerometer_falling_freely_feels_nothing(unit: Unit) -> None:
    """With the acceleration of gravity the specific force is 0."""
    seen = unit.new({"nu_dot": (0.0, 0.0, unit.parameter("g"), 0.0, 0.0, 0.0)})
    close(unit, "specific force", seen["f_m"], np.zeros(3), 1e-14, G)


def test_accelerometer_on_an_arm_feels_the_turning(unit: Unit) -> None:
    """At r from the origin of a turning body it feels omega x (omega x r), and alpha x r when the rate changes."""
    omega, alpha, r = np.array([0.3, -0.5, 0.9]), np.array([1.0, 2.0, -3.0]), np.array([0.2, -0.1, 0.05])
    still = {"p": omega[0], "q": omega[1], "r": omega[2], "nu_dot": (0.0, 0.0, 0.0, *alpha)}
    seen = unit.new(still, r_imu=tuple(r), g=0.0)
    expected = np.cross(omega, np.cross(omega, r)) + np.cross(alpha, r)
    close(unit, "specific force", seen["f_m"], expected, 1e-14)


def test_accelerometer_feels_the_acceleration_of_the_body(unit: Unit) -> None:
    """At the origin it feels the acceleration over ground as it is, whatever the velocity and the rates."""
    seen = unit.new({"nu_dot": (0.3, 1.0, -0.2, 0.0, 0.0, 0.0), "u": 2.0, "r": 0.5}, g=0.0)
    close(unit, "specific force", seen["f_m"], (0.3, 1.0, -0.2), 1e-14)


EXCITATION = Excitation(
    0.005, 60,
    {name: (0.1, 0.5) for name in PASSING[:12]} | {"nu_dot": (0.0, 0.3), "F_tool": (-20.0, 9.0), "M_tool": (0.0, 2.0)},
    {"rate_dvl": 15.0, "delay_dvl": 0.1, "noise_dvl": 0.01, "dropout_dvl": 0.2, "delay": 0.012, "rate_gyro": 200.0,
     "noise_gyro": 0.002, "noise_force": 0.3, "quantum_depth": 0.002, "rate_depth": 50.0},
)  # fmt: skip
SUITE = suite(RovSensors, " ".join(SHOWN), EXCITATION, sys.modules[__name__], behaviour_errors)
