"""What the vehicle does at one moment: thrust, the tool's wrench, and the tool's place and motion against the hull."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Running, Unit, close, go_on, holds, read, run, same, values

H = 5e-3  # s, the communication step
FREE = {
    "D_force": (0.0,) * 3, "D_moment": (0.0,) * 3, "D_force_quadratic": (0.0,) * 3, "D_moment_quadratic": (0.0,) * 3
}  # fmt: skip
WEIGHTLESS = {"W": 0.0, "net_buoyancy": 0.0}
TILTED = {"attitude_start": (0.4, -0.7, 2.0), "velocity_start": (0.5, -0.3, 0.2), "rates_start": (0.6, -0.4, 0.9)}


def rotation(running: Running) -> np.ndarray:
    """Body to world, from the quaternion."""
    a, b, c, d = running["quat"]
    return np.array([
        [1 - 2 * (c * c + d * d), 2 * (b * c - d * a), 2 * (b * d + c * a)],
        [2 * (b * c + d * a), 1 - 2 * (b * b + d * d), 2 * (c * d - b * a)],
        [2 * (b * d - c * a), 2 * (c * d + b * a), 1 - 2 * (b * b + c * c)],
    ])  # fmt: skip


def described(phi: float, theta: float, psi: float) -> np.ndarray:
    """Body to world, from roll, pitch and yaw."""
    (a, b), (c, d), (e, f) = ((np.cos(angle), np.sin(angle)) for angle in (phi, theta, psi))
    return np.array([
        [e * c, e * d * b - f * a, e * d * a + f * b], [f * c, f * d * b + e * a, f * d * a - e * b], [-d, c * b, c * a]
    ])  # fmt: skip


def test_euler_angles_describe_the_attitude_at_any_pitch(unit: Unit) -> None:
    """phi, theta, psi give the rotation of the quaternion to rounding, at and about +-90 degrees of pitch too."""
    for side in (1.0, -1.0):
        for off in (0.0, 1e-16, 5e-16, 1e-12, 1e-8, 1e-3, 0.4, 0.5):
            for roll, yaw in ((0.0, 0.0), (0.7, -0.9), (-2.5, 3.0), (3.1, 2.9)):
                seen = unit.new({}, attitude_start=(roll, side * (np.pi / 2 - off), yaw))
                angles = read(seen, "phi", "theta", "psi")
                holds(all(abs(angles) <= (np.pi, np.pi / 2, np.pi)), f"angles {angles} are beyond half a turn")
                # Four roundings: of the quaternion, of the three angles and of what is compared.
                close(unit, "rotation", described(*angles).ravel(), rotation(seen).ravel(), 4e-15, 1.0)


def test_thrust_saturates_and_follows_the_sign_of_the_command(unit: Unit) -> None:
    """k_T u|u| with another k_T in reverse; beyond -1 and 1 nothing more."""
    forward, reverse = values(unit, "k_T_forward", "k_T_reverse")
    seen = run(unit, 1.0, H, {"u_thruster": (0.5, -0.5, 3.0, -3.0, 0, 0, 0, 0)})["thrust"]
    expected = (0.25 * forward, -0.25 * reverse, forward, -reverse, 0.0, 0.0, 0.0, 0.0)
    close(unit, "thrust", seen, expected, 1e-12)


def test_thrust_reaches_63_percent_after_the_lag(unit: Unit) -> None:
    """A step of the command is followed as 1 - exp(-t/thruster_lag); without lag at once."""
    forward = unit.parameter("k_T_forward")
    seen = run(unit, 0.02, H, {"u_thruster": (1,) * 8}, thruster_lag=0.02)
    close(unit, "thrust", seen["thrust"], forward * (1.0 - np.exp(-1.0)), 1e-12)
    at_once = run(unit, H, H, {"u_thruster": (1,) * 8}, thruster_lag=0.0)
    close(unit, "thrust without lag", at_once["thrust"], forward, 1e-12)


def test_wrench_of_the_thrusters_is_that_of_their_geometry(unit: Unit) -> None:
    """F_control = sum f_j d_j and M_control = sum r_j x f_j d_j."""
    r, d = (np.reshape(x, (8, 3)) for x in values(unit, "thruster_position", "thruster_direction"))
    seen = run(unit, 0.5, H, {"u_thruster": (0.3, -0.2, 0.4, 0.9, -0.6, 0.5, -0.3, 0.2)})
    forces = seen["thrust"][:, None] * d
    close(unit, "force", seen["F_control"], forces.sum(axis=0), 1e-14)
    close(unit, "moment", seen["M_control"], np.cross(r, forces).sum(axis=0), 1e-14, 10.0)


def test_thrust_authority_is_that_of_the_thrust_curve(unit: Unit) -> None:
    """Full ahead with four thrusters at 45 degrees gives sqrt(2) (k_T forward + reverse); four down give 4 k_T."""
    forward, reverse = values(unit, "k_T_forward", "k_T_reverse")
    surge = run(unit, 0.5, H, {"u_thruster": (-1, -1, 1, 1, 0, 0, 0, 0)})["F_control"][0]
    close(unit, "surge force", surge, np.sqrt(2.0) * (forward + reverse), 1e-9)  # 25 time constants of the thrust
    heave = run(unit, 0.5, H, {"u_thruster": (0, 0, 0, 0, 1, 1, 1, 1)})["F_control"][2]
    close(unit, "heave force", heave, 4.0 * forward, 1e-9)


def test_tool_wrench_is_turned_and_moved_to_the_body_origin(unit: Unit) -> None:
    """F_disturb = R F, M_disturb = r x R F + R M."""
    angle = 0.4
    R = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    r_tool = np.array([0.2, -0.1, 0.3])
    F, M = np.array([-110.9, 5.0, -221.7]), np.array([1.0, -16.63, 2.0])
    inputs = dict(zip(("F_x", "F_y", "F_z", "M_x", "M_y", "M_z"), map(float, (*F, *M)), strict=True))
    seen = unit.new(inputs, r_tool=tuple(r_tool), R_tool_body=tuple(R.ravel()))
    close(unit, "force of the tool", seen["F_disturb"], R @ F, 1e-14)
    close(unit, "moment of the tool", seen["M_disturb"], np.cross(r_tool, R @ F) + R @ M, 1e-13)


def test_penetration_is_that_of_the_geometry(unit: Unit) -> None:
    """Upright at the origin: delta = R_brush minus the way from the brush axis to the hull, and no misalignment."""
    R_brush, r_tool, hull_point = values(unit, "R_brush", "r_tool", "hull_point")
    seen = unit.new({})
    close(unit, "penetration", seen["delta"], R_brush - (hull_point[2] - r_tool[2]), 1e-14, 1.0)
    same("misalignment", seen["misalignment"], 0.0)


def test_moving_ahead_makes_the_hull_pass_backwards_under_the_tool(unit: Unit) -> None:
    """v_rov is minus the tool's own speed along x_t; along the hull, delta does not change."""
    seen = unit.new({}, velocity_start=(0.05, 0.0, 0.0))
    same("v_rov", seen["v_rov"], -0.05)
    same("delta_dot", seen["delta_dot"], 0.0)


def tool_moves(unit: Unit, R: Any, point: Any, normal: Any) -> None:
    """Penetration, its rate, the passing speed and the misalignment of a tool mounted by R, before a hull plane."""
    h = 1e-4
    mounting = {"R_tool_body": R, "hull_point": point, "hull_normal": normal, "r_tool": (0.2, 0.1, -0.1)}
    seen = unit.new({}, **TILTED | mounting)
    matrix, r_tool = np.reshape(R, (3, 3)).astype(float), np.array(mounting["r_tool"])
    before = rotation(seen) @ r_tool
    angle = np.arccos(-np.dot(rotation(seen) @ matrix[:, 2], normal))
    close(unit, "misalignment", seen["misalignment"], angle, 1e-12)
    delta = seen["delta"]
    close(unit, "penetration", delta, unit.parameter("R_brush") - np.dot(normal, before - point), 1e-14, 1.0)
    go_on(seen, h, h)
    velocity = (rotation(seen) @ r_tool + read(seen, "x_n", "y_n", "z_n") - before) / h
    # A difference over 0.1 ms: half the acceleration (about 5 m/s2) times h.
    close(unit, "rate of the penetration", seen["delta_dot"], (seen["delta"] - delta) / h, 1e-3, 1.0)
    close(unit, "passing speed", seen["v_rov"], -velocity @ rotation(seen) @ matrix[:, 0], 1e-3, 1.0)


def test_tool_kinematics_hold_for_any_mounting(unit: Unit) -> None:
    """Under the vehicle, at the bow and on top: penetration, rate, passing speed and misalignment by geometry."""
    tool_moves(unit, (1, 0, 0, 0, 1, 0, 0, 0, 1), (0.0, 0.0, 0.445), (0, 0, -1))
    tool_moves(unit, (0, 0, 1, 0, 1, 0, -1, 0, 0), (0.6, 0.0, 0.0), (-1, 0, 0))
    tool_moves(unit, (-1, 0, 0, 0, 1, 0, 0, 0, -1), (0.0, 0.0, -0.5), (0, 0, 1))
