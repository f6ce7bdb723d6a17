"""What the controller does: PID identities, allocation, saturation and anti-windup, sampling."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Running, Unit, close, holds, read, same, values, where_known

T_S = 0.02
MEASURED = ("x_n", "y_n", "z_n", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r")
SET_POINTS = ("x_ref", "y_ref", "z_ref", "phi_ref", "theta_ref", "psi_ref")


def after_one_sample(unit: Unit, inputs: dict[str, Any], **parameters: Any) -> Running:
    """A controller behind its first sample."""
    seen = unit.new(inputs, **where_known(unit, T_s=T_S), **parameters)
    seen.step(T_S)
    return seen


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
