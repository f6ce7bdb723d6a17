"""What the observer finds out from motion and thrust: the disturbing wrench, and smoother velocities."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Unit, close, go_on, holds, read, same, values, where_known
from .allocation import given
from .pid import T_S


def test_disturbance_is_found_without_a_force_sensor(unit: Unit) -> None:
    """A body of the model's mass that 20 N lift: F_n becomes 20 N, by the observer's double pole in discrete time."""
    omega, M = values(unit, "omega_observer", "M_observer")
    # No command: all gains are 0, so that the thrusters do nothing and the body is carried off.
    gains = ("K_velocity", "K_velocity_i", "K_velocity_d", "K_rate", "K_rate_i", "K_rate_d")
    none = {name: (0.0,) * 3 for name in gains}
    seen = unit.new({}, **where_known(unit, T_s=T_S), mode=3, K_feedforward=0.0, **none)
    z = float(np.exp(-omega * T_S))
    for k in range(60):
        seen.set(w=-20.0 / M[2] * k * T_S)
        seen.step(T_S)
        # Of a double pole with zeros at infinity: g[k] = 20 (1 - (1 + k (1 - z)) z^k).
        close(unit, "observed force", seen["F_n"], 20.0 * (1.0 - (1.0 + k * (1.0 - z)) * z**k), 1e-9, 20.0)


def test_thrust_of_its_own_is_no_disturbance(unit: Unit) -> None:
    """A body that moves as its thrusters and their lag say is undisturbed."""
    M, lag = values(unit, "M_observer", "thruster_lag")
    seen = unit.new({}, **where_known(unit, T_s=T_S), mode=3, K_feedforward=0.0)
    w, thrust, worst = 0.0, 0.0, 0.0
    for k in range(100):
        seen.set(w=w, z_ref=0.05 * np.sin(0.2 * k))
        seen.step(T_S)
        worst = max(worst, abs(float(seen["F_n"])))
        asked = float(given(unit, seen)[2])
        keep = float(np.exp(-T_S / lag))
        w += (asked * T_S + (thrust - asked) * lag * (1.0 - keep)) / M[2]
        thrust = asked + (thrust - asked) * keep
    close(unit, "observed force", worst, 0.0, 1e-9, 1.0)


def test_known_buoyancy_is_no_disturbance(unit: Unit) -> None:
    """A body that 8 N lift, level or pitched: the observer that knows it sees no force on the hull."""
    M, lag = values(unit, "M_observer", "thruster_lag")
    keep = float(np.exp(-T_S / lag))
    for theta in (0.0, 0.3):
        up = -8.0 * np.array([-np.sin(theta), 0.0, np.cos(theta)])
        inputs = {"theta": theta, "theta_ref": theta}
        chosen: dict[str, Any] = {"mode": 3, "net_buoyancy": 8.0, "hull_normal": (0.0, 0.0, -1.0)}
        seen = unit.new(inputs, **where_known(unit, T_s=T_S), **chosen)
        v, thrust, worst = np.zeros(3), np.zeros(3), 0.0
        for _ in range(600):
            seen.set(u=float(v[0]), w=float(v[2]))
            seen.step(T_S)
            worst = max(worst, abs(float(seen["F_n"])))
            asked = given(unit, seen)[:3]
            v = v + ((asked + up) * T_S + (thrust - asked) * lag * (1.0 - keep)) / M[:3]
            thrust = asked + (thrust - asked) * keep
        close(unit, "observed force", worst, 0.0, 1e-9, 1.0)
        close(unit, "force of the thrusters", thrust, -up, 1e-3)


def test_force_reaches_its_set_point_on_a_rigid_hull_by_the_observer(unit: Unit) -> None:
    """In mode 3, at rest, the thrust that moves nothing is the force on the hull: it becomes F_n_ref."""
    seen = unit.new({"F_n_ref": 30.0, "z_ref": 0.02}, **where_known(unit, T_s=T_S), mode=3)
    for _ in range(600):
        seen.step(T_S)
    same("pressing", seen["pressing"], 1.0)
    close(unit, "observed force", seen["F_n"], 30.0, 1e-3)
    close(unit, "force of the thrusters", given(unit, seen)[2], 30.0, 1e-3)


def test_mode_3_does_not_read_the_force_sensor(unit: Unit) -> None:
    """What is measured of the tool wrench changes nothing."""
    found = []
    for F_tool in ((0.0, 0.0, 0.0), (7.0, -3.0, -50.0)):
        seen = unit.new({"F_n_ref": 30.0, "F_tool": F_tool}, **where_known(unit, T_s=T_S), mode=3)
        for k in range(50):
            seen.set(z_ref=0.02, w=0.001 * k)
            seen.step(T_S)
        found.append(read(seen, "u_thruster", "F_n"))
    same("commands and force", found[1], found[0])


def test_observed_velocity_is_corrected_at_each_sample_of_a_step(unit: Unit) -> None:
    """Inputs that are held over several samples lead to the same commands whether the step has one of them or four."""
    found = []
    for parts in (4, 1):
        seen = unit.new({}, **where_known(unit, T_s=T_S), observed_velocity=True)
        for k in range(20):
            seen.set(w=0.02 * float(np.sin(0.3 * k)))
            go_on(seen, 4.0 * T_S, 4.0 * T_S / parts)
        found.append(read(seen, "u_thruster", "F_ref"))
    close(unit, "commands and force", found[1], found[0], 1e-9, 1.0)


def test_observed_velocity_smooths_what_is_measured(unit: Unit) -> None:
    """Noise of 1 cm/s on the velocity at rest makes the force half as noisy when the observer's velocity is used."""
    noise = 0.01 * np.random.default_rng(3).normal(size=400)
    rms = []
    for observed in (False, True):
        seen = unit.new({}, **where_known(unit, T_s=T_S), observed_velocity=observed, K_velocity_d=(0.0,) * 3)
        forces = []
        for one in noise:
            seen.set(w=float(one))
            seen.step(T_S)
            forces.append(float(seen["F_ref"][2]))
        rms.append(float(np.std(forces)))
    holds(rms[1] < 0.5 * rms[0], f"{rms[1]:.3g} N with the observer, {rms[0]:.3g} N without")
