"""What the controller does with the measured tool wrench: its filter, feedforward, the force along the normal."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Unit, close, holds, read, same, values, where_known

T_S = 0.02
WRENCH: dict[str, Any] = {"F_tool": (-10.0, 2.0, -30.0), "M_tool": (0.5, -6.0, 0.2)}


def test_filter_of_the_wrench_is_a_first_order_lag(unit: Unit) -> None:
    """F_n follows a step of the measured force as 1 - exp(-t/T_filter), at any communication step; 0 is at once."""
    for h in (0.005, 0.02):
        seen = unit.new(WRENCH, T_filter=0.04)
        for k in range(1, 20):
            seen.step(h)
            close(unit, "filtered force", seen["F_n"], 30.0 * (1.0 - np.exp(-k * h / 0.04)), 1e-12)
    seen = unit.new(WRENCH, T_filter=0.0)
    seen.step(T_S)
    same("force without a filter", seen["F_n"], 30.0)


def test_plain_pid_does_not_look_at_the_tool(unit: Unit) -> None:
    """In mode 0 the measured wrench and the force set-point change nothing."""
    commands = []
    for tool in ({}, WRENCH | {"F_n_ref": 40.0}):
        seen = unit.new(tool, **where_known(unit, T_s=T_S), mode=0)
        for k in range(50):
            seen.set(x_ref=0.1, q=0.01 * k)
            seen.step(T_S)
        commands.append(seen["u_thruster"])
    same("commands", commands[1], commands[0])


def test_feedforward_asks_for_the_opposite_of_the_wrench(unit: Unit) -> None:
    """In mode 1 the request is -K_feedforward times the measured wrench, at rest at the set-point."""
    for share in (0.5, 1.0):
        seen = unit.new(WRENCH, **where_known(unit, T_s=T_S), mode=1, T_filter=0.0, K_feedforward=share)
        seen.step(T_S)
        expected = -share * np.array([*WRENCH["F_tool"], *WRENCH["M_tool"]])
        close(unit, "requested wrench", read(seen, "F_ref", "M_ref"), expected, 1e-12)


def test_force_reaches_its_set_point_on_a_rigid_hull(unit: Unit) -> None:
    """In mode 2, on a hull that gives back what the thrusters press with, the force becomes F_n_ref."""
    seen = unit.new({"F_n_ref": 40.0}, **where_known(unit, T_s=T_S), mode=2)
    force = 10.0
    for _ in range(500):
        seen.set(F_tool=(0.0, 0.0, -force))
        seen.step(T_S)
        force = float(seen["F_ref"][2])
    same("pressing", seen["pressing"], 1.0)
    close(unit, "force after 10 s", force, 40.0, 2.5e-5)  # 10 s are 20 time constants 1/K_force_i


def test_force_control_is_blind_to_position_along_the_normal_and_not_across_it(unit: Unit) -> None:
    """While pressing, a set-point error along the normal changes nothing, one across it does."""
    K_position, K_velocity = values(unit, "K_position", "K_velocity")

    def later(**references: float) -> np.ndarray:
        seen = unit.new(WRENCH | {"F_n_ref": 30.0}, **where_known(unit, T_s=T_S), mode=2)
        for _ in range(100):
            seen.step(T_S)
        seen.set(**references)
        seen.step(T_S)
        return np.asarray(seen["F_ref"])

    still = later()
    same("force along the normal", later(z_ref=0.5)[2], still[2])
    close(unit, "force across the normal", later(x_ref=0.01)[0] - still[0], K_velocity[0] * K_position[0] * 0.01, 1e-9)


def test_taking_over_and_giving_back_make_no_jump(unit: Unit) -> None:
    """The first pressing sample goes on from the PID's force; the last gives back what the PID itself asks for."""
    K_position, K_velocity, K_velocity_i = values(unit, "K_position", "K_velocity", "K_velocity_i")
    speed = K_position[2] * 0.05  # asked for by a set-point 50 mm inside the hull
    inputs = {"F_tool": (0.0, 0.0, -20.0), "z_ref": 0.05}
    seen = unit.new(inputs, **where_known(unit, T_s=T_S), mode=2, T_filter=0.0, K_feedforward=0.0)
    forces = []
    for k in range(300):
        pressing = 50 <= k < 200
        seen.set(F_n_ref=20.0 if pressing else 0.0)
        seen.step(T_S)
        same("pressing", seen["pressing"], float(pressing))
        forces.append(float(seen["F_ref"][2]))
    change = np.abs(np.diff(forces))
    holds(change[49] <= 2.2 * K_velocity_i[2] * speed * T_S, f"a jump of {change[49]:.4g} N at first contact")
    close(unit, "change when it gives back", change[199], K_velocity[2] * speed, 1e-9)


def test_force_control_waits_for_contact_and_ends_below_half_of_it(unit: Unit) -> None:
    """Pressing begins above contact_force and ends below half of it."""
    seen = unit.new({"F_n_ref": 40.0}, **where_known(unit, T_s=T_S), mode=2, T_filter=0.0, contact_force=5.0)
    states = []
    for force in (0.0, 4.9, 5.1, 3.0, 2.4, 4.9):
        seen.set(F_tool=(0.0, 0.0, -force))
        seen.step(T_S)
        states.append(seen["pressing"])
    same("pressing", states, [0.0, 0.0, 1.0, 1.0, 0.0, 0.0])


def test_normal_can_point_anywhere(unit: Unit) -> None:
    """F_n is the measured force against the normal, whichever way that points."""
    inputs = {"F_tool": (-25.0, 0.0, 0.0), "F_n_ref": 40.0}
    seen = unit.new(inputs, **where_known(unit, T_s=T_S), mode=2, normal=(1.0, 0.0, 0.0), T_filter=0.0)
    seen.step(T_S)
    same("force into the hull", seen["F_n"], 25.0)
    same("pressing", seen["pressing"], 1.0)


def test_integral_of_the_force_does_not_wind_up(unit: Unit) -> None:
    """A force beyond the thrusters for 10 s leaves little behind; without back-calculation it leaves much."""
    left = []
    for K_windup in (5.0, 0.0):
        seen = unit.new({"F_tool": (0.0, 0.0, -20.0)}, **where_known(unit, T_s=T_S), mode=2, K_windup=K_windup)
        for k in range(600):
            seen.set(F_n_ref=400.0 if k < 500 else 20.0)
            seen.step(T_S)
        left.append(float(seen["F_ref"][2]))
    holds(left[0] < 200.0 < left[1], f"{left[0]:.5g} N are left with back-calculation, {left[1]:.5g} N without")
