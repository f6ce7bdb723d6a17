"""Where vehicle, brush, hull and forces of a run are at a row of instants, as points to draw."""

from __future__ import annotations

import numpy as np
from scipy.integrate import cumulative_trapezoid
from scipy.spatial.transform import Rotation

from ..lab import Case

FRAMES = 150
BODY = np.array([0.457, 0.575, 0.254])  # m, outer size of a BlueROV2; for the picture only
BRUSH_WIDTH = 0.2  # m, for the picture only
LONGEST = 0.5  # m, of an arrow
SPOKES = 12


class Motion:
    """What is drawn of a run at the instants `time`, in the world as the eye has it: north, west, up."""

    def __init__(self, case: Case, frames: int = FRAMES) -> None:
        self.case = case
        self.time = np.linspace(0.0, case.run.end, frames)
        self.position = np.array([self.at(f"vehicle.{axis}_n") for axis in "xyz"]).T
        quaternion = np.array([self.at(f"vehicle.quat[{k}]") for k in (1, 2, 3, 4)]).T
        self.attitude = Rotation.from_quat(quaternion, scalar_first=True).as_matrix()
        self.mounting = case.parameters("vehicle.R_tool_body").reshape(3, 3)
        self.r_tool, self.radius = case.parameters("vehicle.r_tool"), case.parameter("vehicle.R_brush")
        self.angle = self.at("brush.theta_b")
        zero = np.zeros(frames)
        self.tool_force = np.array([self.average("brush.F_x"), zero, self.average("brush.F_z")]).T
        self.thrust = np.array([self.average(f"vehicle.F_control[{k}]") for k in (1, 2, 3)]).T
        both = np.concatenate([self.tool_force, self.thrust])
        self.largest = max(float(np.linalg.norm(both, axis=1).max()), 1e-9)  # N

    def at(self, name: str) -> np.ndarray:
        """A signal at the instants, (frames,)."""
        signal = self.case.signals[name]
        result: np.ndarray = np.interp(self.time, signal.time, signal.values)
        return result

    def average(self, name: str) -> np.ndarray:
        """A signal averaged over each instant's share of time, so that a ripple does not alias, (frames,)."""
        signal = self.case.signals[name]
        integral = cumulative_trapezoid(signal.values, signal.time, initial=0.0)
        step = self.time[1] - self.time[0]
        edges = np.clip([self.time - 0.5 * step, self.time + 0.5 * step], 0.0, self.time[-1])
        result: np.ndarray = np.diff(np.interp(edges, signal.time, integral), axis=0)[0] / np.diff(edges, axis=0)[0]
        return result

    def box(self, k: int) -> np.ndarray:
        """Corners of the vehicle, (8, 3)."""
        corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * BODY
        return seen(self.position[k] + corners @ self.attitude[k].T)

    def axis(self, k: int) -> np.ndarray:
        """Centre of the brush in the world, (3,)."""
        centre: np.ndarray = self.position[k] + self.attitude[k] @ self.r_tool
        return centre

    def tool(self, k: int, points: np.ndarray) -> np.ndarray:
        """Points of the tool frame in the world as seen, (n, 3)."""
        return seen(self.axis(k) + points @ (self.attitude[k] @ self.mounting).T)

    def brush(self, k: int) -> np.ndarray:
        """Two rims with spokes between, as one line with gaps, (n, 3)."""
        turn = np.linspace(0.0, 2.0 * np.pi, 37)
        rim = np.array([np.sin(turn), np.zeros(37), np.cos(turn)]).T * self.radius
        gap, half = np.full((1, 3), np.nan), np.array([0.0, 0.5 * BRUSH_WIDTH, 0.0])
        lines = [rim - half, gap, rim + half, gap]
        for phi in self.angle[k] + 2.0 * np.pi * np.arange(SPOKES) / SPOKES:
            tip = np.array([np.sin(phi), 0.0, np.cos(phi)]) * self.radius
            lines += [np.array([-half, tip - half, tip + half, half]), gap]
        return self.tool(k, np.concatenate(lines))

    def arrow(self, k: int, which: str) -> np.ndarray:
        """Foot and head of a force arrow, (2, 3)."""
        R = self.attitude[k]
        if which == "brush":
            foot, force = self.axis(k), R @ self.mounting @ self.tool_force[k]
        else:
            foot, force = self.position[k], R @ self.thrust[k]
        return seen(np.array([foot, foot + LONGEST / self.largest * force]))

    def hull(self) -> np.ndarray:
        """Corners of the part of the hull plane under the path, (4, 3)."""
        point, normal = self.case.parameters("vehicle.hull_point"), self.case.parameters("vehicle.hull_normal")
        normal = normal / np.linalg.norm(normal)
        along = np.eye(3)[np.argmin(np.abs(normal))]
        along = along - normal * (along @ normal)
        along = along / np.linalg.norm(along)
        across = np.cross(normal, along)
        low, high = ((f(self.position @ np.array([along, across]).T, axis=0)) for f in (np.min, np.max))
        base = point - along * (along @ point) - across * (across @ point)
        corners = [base + along * a + across * b for a in (low[0] - 0.6, high[0] + 0.6)
                   for b in (low[1] - 0.6, high[1] + 0.6)]  # fmt: skip
        return seen(np.array(corners))


def seen(points: np.ndarray) -> np.ndarray:
    """North, east, down as north, west, up: plotly draws its third axis upwards."""
    result: np.ndarray = points * np.array([1.0, -1.0, -1.0])
    return result
