"""What normal force the vehicle's thrusters can hold with each tool, at rest on the hull and level (Eqs. 20, 21).

A tool that presses with F_n acts on the vehicle with a wrench w_1 + F_n w: what it takes to spin in water, and what
grows with the force, friction along the hull, the torque of the brush, the lever of the tool. The thrusts F must
balance it and what acts without a tool: B F + F_n w + w_1 + w_0 = 0 with every thrust in its range. The largest F_n
is a linear program. The wrench is a straight line through those of two passes, at the force that the system holds
and at half of it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linprog

from .lab import Case, Lab

TOOLS = {
    "the paper's brush": "hull_pass_paper",
    "roller": "hull_pass",
    "two rollers that turn against each other": "counter_rotating",
    "three cups": "three_cups",
}
CURRENTS = (0.0, 0.2, 0.3)  # m/s, along the hull against the pass
AXES = ("F_x", "F_y", "F_z", "M_x", "M_y", "M_z")


@dataclass(frozen=True)
class Budget:
    """A tool: its wrench about the body origin per N of normal force (6,) and without any (6,), and the largest F_n [N]
    by current [m/s].

    `held` is the force that its system holds; `commands` repeat the runs that the wrench comes from.
    """

    tool: str
    wrench: np.ndarray
    spinning: np.ndarray
    held: float
    largest: dict[float, float]
    commands: tuple[str, ...]


def thrust_budget(lab: Lab, tools: dict[str, str] = TOOLS) -> list[Budget]:
    """The budget of each tool, with the wrench of its system's steady window."""
    found = []
    for tool, system in tools.items():
        whole = lab.case(system)
        found.append(budget(tool, whole, lab.case(system, {"mission.F_n": 0.5 * whole.parameter("mission.F_n")})))
    return found


def budget(tool: str, whole: Case, half: Case) -> Budget:
    """What two passes with different forces say of a tool."""
    forces = [-case.mean("vehicle.F_z") for case in (whole, half)]
    wrenches = [tool_wrench(case) for case in (whole, half)]
    wrench = (wrenches[0] - wrenches[1]) / (forces[0] - forces[1])
    spinning = wrenches[0] - forces[0] * wrench
    largest = {current: largest_force(whole, wrench, spinning + without_tool(whole, current)) for current in CURRENTS}
    return Budget(tool, wrench, spinning, forces[0], largest, (whole.command, half.command))


def tool_wrench(case: Case) -> np.ndarray:
    """Mean wrench of the tool about the body origin, body frame (6,) (Eq. 21)."""
    rotation = case.parameters("vehicle.R_tool_body").reshape(3, 3)
    F, M = (rotation @ [_mean(case, f"vehicle.{kind}_{axis}") for axis in "xyz"] for kind in "FM")
    return np.concatenate([F, M + np.cross(case.parameters("vehicle.r_tool"), F)])


def _mean(case: Case, name: str) -> float:
    """Mean of an input of the vehicle over the steady window, or the value that it is held at."""
    component, _, variable = name.partition(".")
    given = case.run.plan.system.components[component].inputs
    return float(given[variable]) if variable in given else case.mean(name)


def without_tool(case: Case, current: float) -> np.ndarray:
    """Weight, buoyancy and the drag of a current along the hull on a level vehicle, about the body origin (6,)."""
    p = {name: case.parameter(f"vehicle.{name}") for name in ("m", "W", "net_buoyancy", "m_tool", "buoyancy_tool")}
    at = {name: case.parameters(f"vehicle.{name}") for name in ("r_g", "r_b", "r_tool", "r_g_tool", "r_b_tool")}
    loads = (  # along world z, downwards, and where
        (p["W"], at["r_g"]),
        (-p["W"] - p["net_buoyancy"], at["r_b"]),
        (p["m_tool"] * p["W"] / p["m"], at["r_tool"] + at["r_g_tool"]),
        (-p["buoyancy_tool"], at["r_tool"] + at["r_b_tool"]),
    )
    wrench = np.zeros(6)
    for force, place in loads:
        wrench[2] += force
        wrench[3:] += np.cross(place, [0.0, 0.0, force])
    linear, quadratic = (case.parameters(f"vehicle.{name}")[0] for name in ("D_force", "D_force_quadratic"))
    wrench[0] = (linear + quadratic * abs(current)) * current  # Eq. 19 at rest over ground
    return wrench


def allocation(case: Case) -> tuple[np.ndarray, float, float]:
    """B of Eq. 20 (6, 8), and the largest thrust forward and reverse [N]."""
    position, direction = (case.parameters(f"vehicle.thruster_{x}").reshape(-1, 3) for x in ("position", "direction"))
    B = np.vstack([direction.T, np.cross(position, direction).T])
    return B, case.parameter("vehicle.k_T_forward"), case.parameter("vehicle.k_T_reverse")


def largest_force(case: Case, wrench: np.ndarray, other: np.ndarray) -> float:
    """The largest normal force [N] that some thrusts within their range balance; 0 if not even none can be.

    `wrench` acts per N of it, `other` besides, both about the body origin (6,).
    """
    B, forward, reverse = allocation(case)
    found = linprog(
        [0.0] * 8 + [-1.0],
        A_eq=np.column_stack([B, wrench]),
        b_eq=-other,
        bounds=[(-reverse, forward)] * 8 + [(0.0, None)],
    )
    return float(found.x[8]) if found.success else 0.0
