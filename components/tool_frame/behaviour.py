"""What a frame of several tools does: sums their wrenches with their levers, and tells each how it stands and moves."""

from __future__ import annotations

import sys

import numpy as np

from ..testing.behaviour import Running, Unit, close, read, same
from ..testing.suite import Excitation, suite
from .fmu import ToolFrame

FORCES = ("F_x_tool", "F_y_tool", "F_z_tool")
MOMENTS = ("M_x_tool", "M_y_tool", "M_z_tool")
PLACES = {"x_tool": (0.2, -0.1, 0.05), "y_tool": (-0.15, 0.15, 0.3)}


def loaded(unit: Unit, **inputs: object) -> Running:
    """A frame with other loads on every tool."""
    loads = {name: 3.0 * np.cos(np.arange(3.0) + k) for k, name in enumerate((*FORCES, *MOMENTS))}
    return unit.new({**loads, **inputs}, **PLACES)


def columns(seen: Running, names: tuple[str, ...]) -> np.ndarray:
    """Vectors of three tools beside each other, a row for each tool."""
    return np.array([np.asarray(seen[name]) for name in names]).T


def test_wrench_is_the_sum_with_levers(unit: Unit) -> None:
    """F = sum of F_i, M = sum of M_i + r_i x F_i, with r_i = (x_i, y_i, 0)."""
    seen = loaded(unit)
    F, M = columns(seen, FORCES), columns(seen, MOMENTS)
    levers = np.array([PLACES["x_tool"], PLACES["y_tool"], (0.0, 0.0, 0.0)]).T
    close(unit, "force", read(seen, "F_x", "F_y", "F_z"), F.sum(axis=0), 1e-14, 9.0)
    close(unit, "moment", read(seen, "M_x", "M_y", "M_z"), (M + np.cross(levers, F)).sum(axis=0), 1e-14, 9.0)


def test_spin_momenta_add_up(unit: Unit) -> None:
    """Two brushes that turn against each other have none together."""
    seen = unit.new({"H_y_tool": (1.5, -1.5, 0.0), "H_z_tool": (0.25, 0.5, 0.125)})
    same("spin momentum about y_t", seen["H_y"], 0.0)
    same("spin momentum about z_t", seen["H_z"], 0.875)


def test_level_frame_has_all_tools_at_one_penetration(unit: Unit) -> None:
    """Without tilt and curvature every tool is as deep as the frame's point, and moves as it does."""
    seen = unit.new({"delta": 0.004, "delta_dot": -0.02, "v_rov": 0.05}, **PLACES)
    for name, expected in (("delta_tool", 0.004), ("delta_dot_tool", -0.02), ("v_rov_tool", 0.05)):
        same(name, np.asarray(seen[name]), np.full(3, expected))


def test_tilted_frame_presses_the_tools_on_one_side(unit: Unit) -> None:
    """A turn about x_t takes +y_t deeper by y sin(tilt_x), one about y_t takes +x_t out by x sin(tilt_y)."""
    for angle in (0.01, 0.3, -0.2):
        for name, deeper in (("tilt_x", np.array(PLACES["y_tool"])), ("tilt_y", -np.array(PLACES["x_tool"]))):
            seen = unit.new({"delta": 0.0, name: angle}, **PLACES)
            close(unit, f"penetrations, {name}", np.asarray(seen["delta_tool"]), np.sin(angle) * deeper, 1e-14, 1.0)
        same("what a cup brush is told", seen["misalignment"], -angle)


def test_curved_hull_falls_off_with_the_square(unit: Unit) -> None:
    """A tool 0.3 m aside is out by y^2/(2 R)."""
    seen = unit.new({"delta": 0.01}, **PLACES, hull_curvature=0.2)
    expected = 0.01 - 0.5 * 0.2 * np.square(PLACES["y_tool"])
    close(unit, "penetrations", np.asarray(seen["delta_tool"]), expected, 1e-14, 0.01)


def test_rate_of_penetration_is_its_derivative(unit: Unit) -> None:
    """delta_dot of each tool is the change of its delta while the frame turns about its own axes."""
    omega, tilt, h = np.array([0.3, -0.4, 0.0]), np.array([0.1, -0.2]), 1e-6
    n = normal(*tilt)
    seen = unit.new({"tilt_x": tilt[0], "tilt_y": tilt[1], "p": omega[0], "q": omega[1], "r": omega[2]}, **PLACES)
    depths = []
    for t in (-h, h):
        turned = n - t * np.cross(omega, n)  # a normal that stands still, seen from a frame that turns
        ahead = {"tilt_x": np.arctan2(turned[1], turned[2]), "tilt_y": np.arctan2(-turned[0], turned[2])}
        depths.append(np.asarray(unit.new({key: float(v) for key, v in ahead.items()}, **PLACES)["delta_tool"]))
    expected = (depths[1] - depths[0]) / (2.0 * h)
    close(unit, "rates", np.asarray(seen["delta_dot_tool"]), expected, 1e-8, 1.0)


def normal(tilt_x: float, tilt_y: float) -> np.ndarray:
    """The normal into the hull of two tilts."""
    n = np.array([-np.tan(tilt_y), np.tan(tilt_x), 1.0])
    unit: np.ndarray = n / np.linalg.norm(n)
    return unit


def test_tools_do_the_work_that_their_sum_does(unit: Unit) -> None:
    """On a level frame the power of all tools at their places is that of the sum at the frame's point."""
    seen = loaded(unit, delta_dot=0.1, v_rov=-0.2, p=0.3, q=-0.5, r=0.7)
    F, M = columns(seen, FORCES), columns(seen, MOMENTS)
    omega = np.array([0.3, -0.5, 0.7])
    lateral = np.array(PLACES["x_tool"]) * omega[2]
    v = np.stack([-np.asarray(seen["v_rov_tool"]), lateral, np.asarray(seen["delta_dot_tool"])], axis=1)
    whole = np.dot(read(seen, "F_x", "F_y", "F_z"), [0.2, 0.0, 0.1]) + np.dot(read(seen, "M_x", "M_y", "M_z"), omega)
    close(unit, "power", float((F * v).sum() + (M @ omega).sum()), float(whole), 1e-14, 9.0)


EXCITATION = Excitation(
    1e-3, 30,
    {"delta": (0.005, 0.003), "tilt_x": (0.0, 0.02), "q": (0.0, 0.1), "F_z_tool": (-9.0, 5.0), "M_y_tool": (-1.0, 0.5)},
)  # fmt: skip
SUITE = suite(ToolFrame, "delta F_z_tool F_z delta_tool", EXCITATION, sys.modules[__name__])
