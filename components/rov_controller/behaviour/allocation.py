"""What the controller gives of what it asks for: allocation, saturation, anti-windup."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Running, Unit, close, holds, read, same, values, where_known
from .pid import MEASURED, SET_POINTS, T_S, after_one_sample, wrench


def geometry(unit: Unit) -> np.ndarray:
    """B of Eq. 20: the wrench per thrust, from the thrusters' positions and directions."""
    position, direction = (np.reshape(x, (8, 3)) for x in values(unit, "thruster_position", "thruster_direction"))
    return np.vstack([direction.T, np.cross(position, direction).T])


def given(unit: Unit, seen: Running) -> np.ndarray:
    """The wrench that the commands give with the thrust curve k_T u|u|."""
    forward, reverse = values(unit, "k_T_forward", "k_T_reverse")
    u = seen["u_thruster"]
    return np.asarray(geometry(unit) @ (np.where(u > 0.0, forward, reverse) * u * np.abs(u)))


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


PRESSING: dict[str, Any] = {"F_tool": (40.0, 0.0, 160.0), "M_tool": (0.0, -2.0, 0.0)}  # beyond heave, and along


def bend(unit: Unit, **parameters: Any) -> tuple[float, float]:
    """Angle [deg] between the requested force and the given one, and the missed moment [N m]."""
    seen = after_one_sample(unit, PRESSING, mode=1, T_filter=0.0, **parameters)
    same("saturated", seen["saturated"], 1.0)
    wanted, had = np.asarray(seen["F_ref"]), given(unit, seen)
    cosine = wanted @ had[:3] / np.linalg.norm(wanted) / np.linalg.norm(had[:3])
    return float(np.degrees(np.arccos(min(1.0, cosine)))), float(np.abs(had[3:] - seen["M_ref"]).max())


def test_bounded_least_squares_keep_the_direction_of_the_force(unit: Unit) -> None:
    """At saturation the force given bends by less than 0.1 degrees; one part after the other bends it by 10."""
    angle, missed = bend(unit, bounded_least_squares=True)
    holds(angle < 0.1 and missed < 0.1, f"bent by {angle:.3g} degrees, {missed:.3g} N m missed")
    angle, _ = bend(unit, attitude_first=True)
    holds(angle > 10.0, f"one after the other bends by {angle:.3g} degrees only")


def test_bounded_least_squares_give_the_longest_force_of_that_direction(unit: Unit) -> None:
    """Ten times the wrench gives the same force, within 1 %: all that the thrusters have in this direction."""
    less = after_one_sample(unit, PRESSING, mode=1, T_filter=0.0, bounded_least_squares=True)
    more = after_one_sample(
        unit, {"F_tool": (400.0, 0.0, 1600.0), "M_tool": PRESSING["M_tool"]}, mode=1, T_filter=0.0,
        bounded_least_squares=True,
    )  # fmt: skip
    close(unit, "force", given(unit, more)[:3], given(unit, less)[:3], 0.01)
    close(unit, "largest command", np.abs(more["u_thruster"]).max(), 1.0, 1e-12)


def test_bounded_least_squares_are_the_pseudoinverse_within_the_range(unit: Unit) -> None:
    """A wrench that the pseudoinverse can give is given by the same commands."""
    inputs = {"x_ref": 0.3, "y_ref": -0.1, "z_ref": 0.2, "phi_ref": 0.1, "theta_ref": -0.1, "psi_ref": 0.2}
    commands = [
        after_one_sample(unit, inputs, bounded_least_squares=chosen, attitude_first=False)["u_thruster"]
        for chosen in (False, True)
    ]
    same("commands", commands[1], commands[0])
