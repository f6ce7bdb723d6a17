"""What the controller does: PID identities, allocation, saturation and anti-windup, sampling."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

from ..testing.behaviour import Running, Unit, close, holds, read, same, values, where_known
from ..testing.suite import Excitation, suite
from . import behaviour_force
from .fmu import RovController

T_S = 0.02
MEASURED = ("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r")
SET_POINTS = ("x_ref", "y_ref", "z_ref", "phi_ref", "theta_ref", "psi_ref")


def after_one_sample(unit: Unit, inputs: dict[str, Any], **parameters: Any) -> Running:
    """A controller behind its first sample."""
    seen = unit.new(inputs, **where_known(unit, T_s=T_S), **parameters)
    seen.step(T_S)
    return seen


def geometry(unit: Unit) -> np.ndarray:
    """B of Eq. 20: the wrench per thrust, from the thrusters' positions and directions."""
    position, direction = (np.reshape(x, (8, 3)) for x in values(unit, "thruster_position", "thruster_direction"))
    return np.vstack([direction.T, np.cross(position, direction).T])


def given(unit: Unit, seen: Running) -> np.ndarray:
    """The wrench that the commands give with the thrust curve k_T u|u|."""
    forward, reverse = values(unit, "k_T_forward", "k_T_reverse")
    u = seen["u_thruster"]
    return np.asarray(geometry(unit) @ (np.where(u > 0.0, forward, reverse) * u * np.abs(u)))


def wrench(seen: Running) -> np.ndarray:
    """What the controller asks of the thrusters."""
    return read(seen, "F_ref", "M_ref")


def test_no_error_gives_no_command(unit: Unit) -> None:
    """At its set-points and at rest the vehicle gets no thrust."""
    same("thruster commands", after_one_sample(unit, {})["u_thruster"], 0.0)


def test_first_sample_is_the_product_of_the_gains(unit: Unit) -> None:
    """F = K_velocity*(K_position*(ref - position) - v) in the first sample, before any integral; M likewise."""
    K_position, K_velocity, K_attitude, K_rate = values(unit, "K_position", "K_velocity", "K_attitude", "K_rate")
    inputs = {"x_ref": 0.1, "y_ref": -0.05, "z_ref": 0.02, "x_n": 0.03, "y_n": 0.01, "z_n": -0.04}
    seen = after_one_sample(unit, inputs | {"u": 0.03, "w": -0.01, "p": 0.01, "q": 0.02, "r": -0.03})
    expected = K_velocity * (K_position * (0.07, -0.06, 0.06) - (0.03, 0.0, -0.01))
    close(unit, "force", seen["F_ref"], expected, 1e-12)
    close(unit, "moment against the rates", seen["M_ref"], K_rate * (-0.01, -0.02, 0.03), 1e-12)
    for axis, angle in enumerate(("phi", "theta", "psi")):
        expected = K_rate * K_attitude * 0.06 * (np.arange(3) == axis)
        seen = after_one_sample(unit, {f"{angle}_ref": 0.1, angle: 0.04})
        close(unit, "moment against an angle", seen["M_ref"], expected, 1e-12)


def test_integral_grows_with_the_error(unit: Unit) -> None:
    """At a constant velocity error the force grows by K_velocity_i*error*T_s per sample."""
    K_velocity_i = unit.parameter("K_velocity_i")
    seen = after_one_sample(unit, {"u": 0.05, "v": -0.02})
    before = seen["F_ref"].copy()
    for _ in range(10):
        seen.step(T_S)
    close(unit, "growth of the force", seen["F_ref"] - before, 10 * T_S * K_velocity_i * (-0.05, 0.02, 0.0), 1e-12)


def test_acceleration_is_damped(unit: Unit) -> None:
    """A change of the measured velocity is answered by -K_velocity_d*acceleration on top of the other terms."""
    asked = []
    for K_d in (0.0, 2.0):
        seen = after_one_sample(unit, {}, K_velocity_d=(K_d,) * 3)
        seen.set(u=0.01)
        seen.step(T_S)
        asked.append(seen["F_ref"])
    close(unit, "damping force", asked[1] - asked[0], (-2.0 * 0.01 / T_S, 0.0, 0.0), 1e-12)


def test_set_point_velocity_and_rate_are_limited(unit: Unit) -> None:
    """However far the set-point, no more than v_max and rate_max are asked for."""
    v_max, rate_max, K_velocity, K_rate = values(unit, "v_max", "rate_max", "K_velocity", "K_rate")
    seen = after_one_sample(unit, {"x_ref": 30.0, "y_ref": -40.0, "psi_ref": 3.0})
    close(unit, "force", seen["F_ref"], K_velocity * v_max * (0.6, -0.8, 0.0), 1e-12)
    close(unit, "moment", seen["M_ref"], K_rate * rate_max * (0.0, 0.0, 1.0), 1e-12)


def test_moving_set_point_is_followed_without_lag(unit: Unit) -> None:
    """At the set-point and with its velocity nothing is asked for."""
    seen = after_one_sample(unit, {"v_ref": (0.1, 0.0, 0.0), "u": 0.1})
    close(unit, "requested wrench", wrench(seen), 0.0, 1e-12, 1.0)


def test_feasible_wrench_is_given_exactly(unit: Unit) -> None:
    """What the thrusters can give, they give: B k_T u|u| is the requested wrench in all six directions."""
    inputs = {"x_ref": 0.3, "y_ref": -0.1, "z_ref": 0.2, "phi_ref": 0.1, "theta_ref": -0.1, "psi_ref": 0.2}
    for attitude_first in (True, False):
        seen = after_one_sample(unit, inputs, attitude_first=attitude_first)
        close(unit, "wrench of the thrusters", given(unit, seen), wrench(seen), 1e-13)
        same("saturated", seen["saturated"], 0.0)


def test_saturation_keeps_the_moment_and_bends_the_force(unit: Unit) -> None:
    """Beyond the thrusters' range the moment comes first, force gets what is left, and it is told."""
    inputs, gains = {"z_ref": 10.0, "theta_ref": 0.2}, {"K_velocity": (1e3,) * 3}
    seen = after_one_sample(unit, inputs, **gains)
    close(unit, "moment", given(unit, seen)[3:], seen["M_ref"], 1e-12)
    holds(100.0 < given(unit, seen)[2] < seen["F_ref"][2], "the force is not what is left")
    close(unit, "largest command", np.abs(seen["u_thruster"]).max(), 1.0, 1e-12)
    same("saturated, saturation_count", read(seen, "saturated", "saturation_count"), 1.0)
    clipped = after_one_sample(unit, inputs, attitude_first=False, **gains)
    holds(abs(given(unit, clipped)[4]) < 0.1 * abs(seen["M_ref"][1]), "clipping keeps the moment")


def test_commands_never_exceed_one(unit: Unit) -> None:
    """Whatever is measured, -1 <= u_thruster <= 1."""
    rng = np.random.default_rng(1)
    for attitude_first in (True, False):
        seen = unit.new({}, **where_known(unit, T_s=T_S), attitude_first=attitude_first)
        for _ in range(200):
            seen.set(**dict(zip((*MEASURED, *SET_POINTS), map(float, rng.normal(size=18) * 2.0), strict=True)))
            seen.step(T_S)
            largest = np.abs(seen["u_thruster"]).max()
            holds(largest <= 1.0 + 1e-12, f"a command of {largest:.6g}")


def test_saturated_integrals_do_not_wind_up(unit: Unit) -> None:
    """After 5 s at saturation, back-calculation leaves less than half of the integral that builds up without it."""
    left = []
    for K_windup in (5.0, 0.0):
        seen = unit.new({"x_ref": 100.0}, **where_known(unit, T_s=T_S), K_windup=K_windup, K_velocity=(400.0,) * 3)
        for _ in range(250):
            seen.step(T_S)
        holds(seen["saturation_count"] > 200.0, "the thrusters were to be saturated")
        seen.set(x_ref=0.0)
        seen.step(T_S)
        left.append(float(seen["F_ref"][0]))
    holds(left[0] < 0.5 * left[1], f"{left[0]:.5g} N are left with back-calculation, {left[1]:.5g} N without")


def test_outputs_are_constant_between_samples(unit: Unit) -> None:
    """With four communication steps in a sampling period the commands change at every fourth, and only there."""
    seen = unit.new({"x_ref": 1.0}, T_s=T_S)
    commands = []
    for k in range(12):
        seen.set(x_n=0.01 * k)
        seen.step(T_S / 4)
        commands.append(seen["u_thruster"])
    blocks = np.array(commands).reshape(3, 4, 8)
    same("commands between samples", blocks, np.broadcast_to(blocks[:, :1], blocks.shape))
    holds(np.all(np.any(blocks[1:, 0] != blocks[:-1, 0], axis=1)), "a sample changed nothing")


def test_number_of_samples_does_not_depend_on_the_communication_step(unit: Unit) -> None:
    """A sample each T_s, whether the communication step is a third, one or five of them."""
    inputs = {"x_ref": 10.0, "y_ref": 10.0, "z_ref": 10.0, "theta_ref": 1.0, "u": -5.0}
    for h in (T_S / 3, T_S, 5 * T_S):
        seen = unit.new(inputs, T_s=T_S, K_velocity_i=(1e4,) * 3)  # saturated in every sample
        for _ in range(round(3.0 / h)):
            seen.step(h)
        same(f"samples in 3 s with steps of {h:g} s", seen["saturation_count"], 150.0)


def test_brush_voltage_follows_its_set_point(unit: Unit) -> None:
    """V_in is V_ref: at time 0 already, then from sample to sample."""
    seen = unit.new({"V_ref": 12.0}, **where_known(unit, T_s=T_S))
    same("voltage at the start", seen["V_in"], 12.0)
    seen.set(V_ref=9.0)
    seen.step(T_S)
    same("voltage after a sample", seen["V_in"], 9.0)


def test_attitude_error_is_the_shortest_rotation(unit: Unit) -> None:
    """Pure pitch is answered by a pure pitch moment, beyond 90 degrees too, where the Euler angles turn over."""
    for theta in (0.5, 1.4, 1.7, 3.0):
        flipped = theta > np.pi / 2
        angles = (np.pi, np.pi - theta, np.pi) if flipped else (0.0, theta, 0.0)
        inputs = dict(zip(("phi", "theta", "psi"), angles, strict=True))
        seen = after_one_sample(unit, inputs, rate_max=10.0, K_attitude=(1.0,) * 3, K_rate=(1.0,) * 3)
        close(unit, "moment", seen["M_ref"], (0.0, -theta, 0.0), 1e-12)


def test_position_error_is_turned_into_the_body_frame(unit: Unit) -> None:
    """Heading east, a set-point in the north lies to port."""
    inputs = {"psi": np.pi / 2, "psi_ref": np.pi / 2, "x_ref": 0.3}
    seen = after_one_sample(unit, inputs, K_velocity=(1.0,) * 3, K_position=(1.0,) * 3)
    close(unit, "force", seen["F_ref"], (0.0, -0.3, 0.0), 1e-14)


EXCITATION = Excitation(
    0.01, 80,
    {"x_n": (0.0, 0.3), "z_n": (0.1, 0.6), "phi": (0.0, 0.9), "theta": (0.0, 1.6), "psi": (0.0, 3.1), "u": (0.0, 0.2),
     "q": (0.0, 0.3), "psi_ref": (0.4, 0.3), "V_ref": (11.0, 1.0), "F_tool": (-20.0, 30.0), "M_tool": (-5.0, 4.0),
     "F_n_ref": (40.0, 30.0), "v_ref": (0.0, 0.1)},
    {"mode": 2},
)  # fmt: skip
ESSENTIAL = "x_n y_n z_n phi theta psi u v w p q r u_thruster V_in"
SUITE = suite(RovController, ESSENTIAL, EXCITATION, sys.modules[__name__], behaviour_force)
