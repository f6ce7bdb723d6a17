"""How the tool stands against the hull, and a wrench that acts along the hull's normal."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Running, Unit, close, go_on, holds
from .at_rest import TILTED, H, rotation
from .motion import disturbed

FRONT = {"R_tool_body": (0, 0, 1, 0, 1, 0, -1, 0, 0), "hull_point": (0.6, 0.0, 0.0), "hull_normal": (-1, 0, 0)}
FORCE = {"F_x": -20.0, "F_y": 3.0, "F_z": -50.0}


def test_a_turned_tool_tells_its_angles(unit: Unit) -> None:
    """Turned by an angle about x_t or y_t, tilt_x or tilt_y is that angle with its sign, and the other is 0."""
    for angle in (-0.3, 1e-9, 0.2, 1.5):
        rolled = unit.new({}, attitude_start=(angle, 0.0, 0.0))
        close(unit, "tilts, rolled", (rolled["tilt_x"], rolled["tilt_y"]), (angle, 0.0), 1e-15, 1.0)
        pitched = unit.new({}, attitude_start=(0.0, angle, 0.0))
        close(unit, "tilts, pitched", (pitched["tilt_x"], pitched["tilt_y"]), (0.0, angle), 1e-15, 1.0)


def test_tilts_are_those_of_the_normal_in_the_tool_frame(unit: Unit) -> None:
    """For any mounting tan(tilt_x) = n_y/n_z, tan(tilt_y) = -n_x/n_z, and cos(misalignment) = n_z."""
    for mounting in ({}, FRONT):
        seen = unit.new({}, **TILTED | {"attitude_start": (0.2, -0.3, 0.25)}, **mounting)
        R_tool = np.reshape(mounting.get("R_tool_body", np.eye(3)), (3, 3))
        n = R_tool.T @ rotation(seen).T @ -np.array(mounting.get("hull_normal", (0, 0, -1)), float)
        expected = (np.arctan2(n[1], n[2]), np.arctan2(-n[0], n[2]), np.arccos(n[2]))
        close(unit, "tilts", (seen["tilt_x"], seen["tilt_y"], seen["misalignment"]), expected, 1e-14, 1.0)


def along_hull(seen: Running, mounting: dict[str, Any]) -> np.ndarray:
    """World directions of F_x, F_y and F_z on the hull, as columns: x_t along the hull, across, into it."""
    into = -np.array(mounting.get("hull_normal", (0, 0, -1)), float)
    x_t = rotation(seen) @ np.reshape(mounting.get("R_tool_body", np.eye(3)), (3, 3))[:, 0]
    along = x_t - (x_t @ into) * into
    along /= np.linalg.norm(along)
    return np.column_stack([along, np.cross(into, along), into])


def test_wrench_along_the_normal_has_the_directions_of_the_hull(unit: Unit) -> None:
    """With wrench_along_normal F_z acts into the hull and F_x along it, however the vehicle is turned."""
    for mounting in ({}, FRONT):
        seen = unit.new(FORCE, **TILTED, **mounting, wrench_along_normal=True)
        for _ in range(2):
            force = rotation(seen) @ seen["F_disturb"]
            close(unit, "force of the tool", force, along_hull(seen, mounting) @ [*FORCE.values()], 1e-13)
            go_on(seen, 0.1, H)


def test_an_aligned_tool_has_the_same_wrench_either_way(unit: Unit) -> None:
    """Where z_t is the normal, wrench_along_normal changes neither the wrench nor v_rov."""
    upright = {"attitude_start": (0.0, 0.0, 0.7), "velocity_start": (0.3, 0.2, 0.1)}
    one, other = (unit.new(FORCE, **upright, wrench_along_normal=along) for along in (False, True))
    for name in ("F_disturb", "M_disturb", "v_rov", "delta_dot", "P_tool"):
        close(unit, name, other[name], one[name], 1e-14)


def test_power_of_the_wrench_is_force_times_the_motion_against_the_hull(unit: Unit) -> None:
    """With wrench_along_normal the tool gives F_z delta_dot - F_x v_rov exactly; along z_t a tilted one does not."""
    inputs = FORCE | {"F_y": 0.0}
    off = []
    for along in (True, False):
        seen = unit.new(inputs, **TILTED | {"attitude_start": (0.1, -0.2, 2.0)}, wrench_along_normal=along)
        off.append(seen["P_tool"] - (inputs["F_z"] * seen["delta_dot"] - inputs["F_x"] * seen["v_rov"]))
        if along:
            close(unit, "power of the tool", seen["P_tool"], seen["P_tool"] - off[0], 1e-13)
    holds(abs(off[1]) > 1.0, f"along z_t the powers differ by {off[1]:.3g} W only; the vehicle was tilted for that")


def test_work_along_the_normal_is_that_of_the_stages(unit: Unit) -> None:
    """The wrench follows the hull within the steps: 5 ms and 20 ms lead to the same work of a tumbling vehicle."""
    fine, coarse = (go_on(disturbed(unit, wrench_along_normal=True), 1.0, h) for h in (H, 2e-2))
    close(unit, "work of the tool", coarse["W_tool"], fine["W_tool"], 1e-9)
