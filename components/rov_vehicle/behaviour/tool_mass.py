"""What the mass of the tool, its weight and its buoyancy do to the vehicle that carries it."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Unit, close, go_on, holds, read, run, values
from .at_rest import FREE, TILTED, WEIGHTLESS, H, rotation
from .motion import POSE, VELOCITY, disturbed

TOOL: dict[str, Any] = {
    "m_tool": 4.5, "r_g_tool": (0.02, -0.05, 0.03), "I_tool": (0.05, 0.04, 0.06),
    "I_products_tool": (0.004, -0.002, 0.003), "buoyancy_tool": 30.0, "r_b_tool": (0.01, 0.02, -0.04),
    "r_tool": (0.15, 0.04, 0.3),
}  # fmt: skip


def matrix(moments: Any, products: Any) -> np.ndarray:
    """Inertia matrix of its diagonal and its products xy, xz, yz."""
    xy, xz, yz = products
    return np.diag(moments) + np.array([[0.0, xy, xz], [xy, 0.0, yz], [xz, yz, 0.0]])


def one_body(unit: Unit) -> dict[str, Any]:
    """Parameters of a vehicle without a tool whose mass, inertia, weight and buoyancy are those of vehicle and TOOL."""
    m, I, products, r_g, r_b = values(unit, "m", "I", "I_products", "r_g", "r_b")
    W, net_buoyancy = values(unit, "W", "net_buoyancy")
    m_tool, W_tool, B, B_tool = TOOL["m_tool"], TOOL["m_tool"] * W / m, W + net_buoyancy, TOOL["buoyancy_tool"]
    place, floats = (np.add(TOOL["r_tool"], TOOL[name]) for name in ("r_g_tool", "r_b_tool"))
    total = matrix(I, products) + matrix(TOOL["I_tool"], TOOL["I_products_tool"])
    total += m_tool * (place @ place * np.eye(3) - np.outer(place, place))
    return {
        "m": m + m_tool, "W": W + W_tool, "net_buoyancy": B + B_tool - W - W_tool, "r_tool": TOOL["r_tool"],
        "I": tuple(np.diag(total)), "I_products": (total[0, 1], total[0, 2], total[1, 2]),
        "r_g": tuple((m * np.array(r_g) + m_tool * place) / (m + m_tool)),
        "r_b": tuple((B * np.array(r_b) + B_tool * floats) / (B + B_tool)),
    }  # fmt: skip


def test_tool_makes_one_body_with_the_vehicle(unit: Unit) -> None:
    """Vehicle and tool move as one body of the summed mass, inertia, weight and buoyancy (parallel axes)."""
    both, one = (go_on(disturbed(unit, **parameters), 2.0, H) for parameters in (TOOL, one_body(unit)))
    for names in (POSE, VELOCITY, ("E_kinetic", "L", "nu_dot")):
        close(unit, f"{names[0]} .. {names[-1]}", read(both, *names), read(one, *names), 1e-11)  # roundings of 2 s


def test_tool_in_air_weighs_its_mass_and_in_water_less_by_its_buoyancy(unit: Unit) -> None:
    """From rest, tool and vehicle sink with (m_tool W/m - buoyancy_tool - net_buoyancy) over all mass in heave."""
    m, W, net_buoyancy, added_mass = values(unit, "m", "W", "net_buoyancy", "added_mass")
    centred = {"r_tool": (0.0,) * 3, "r_g": (0.0,) * 3, "r_b": (0.0,) * 3, "m_tool": 4.5}
    for buoyancy in (0.0, 30.0):
        seen = unit.new({}, **centred, buoyancy_tool=buoyancy)
        down = 4.5 * W / m - buoyancy - net_buoyancy
        close(unit, "acceleration in heave", seen["nu_dot"][2], down / (m + 4.5 + added_mass[2]), 1e-12)


def test_heavy_tool_below_rights_the_vehicle_with_its_weight_in_water(unit: Unit) -> None:
    """Rolled, its moment about the body origin is (weight - buoyancy) of the tool times its place."""
    W, m = values(unit, "W", "m")
    parameters = {"r_g": (0.0,) * 3, "r_b": (0.0,) * 3, "r_tool": (0.0, 0.0, 0.3), "m_tool": 4.5, "buoyancy_tool": 10.0}
    seen = unit.new({}, **parameters, attitude_start=(0.3, 0.0, 0.0), net_buoyancy=0.0)
    lever = (4.5 * W / m - 10.0) * 0.3
    close(unit, "energy of the weight", seen["E_potential"], -lever * np.cos(0.3), 1e-14)
    holds(seen["nu_dot"][3] < 0.0, f"it rolls on with {seen['nu_dot'][3]:.3g} rad/s2")


def test_energy_is_accounted_for_with_a_tool(unit: Unit) -> None:
    """energy_residual stays 0 with a heavy tool off the middle, whichever way its wrench acts."""
    for along_normal in (False, True):
        seen = go_on(disturbed(unit, **TOOL, wrench_along_normal=along_normal), 4.0, H)
        close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-7, 100.0)  # about 100 J are moved


def test_angular_impulses_account_for_the_angular_momentum_with_a_tool(unit: Unit) -> None:
    """L changes by J_tool + J_other with a heavy tool off the middle, whichever way its wrench acts."""
    for along_normal in (False, True):
        seen = disturbed(unit, **TOOL, wrench_along_normal=along_normal, position_start=(0.3, -1.0, 2.0))
        before = seen["L"]
        go_on(seen, 2.0, H)
        size = max(float(np.max(np.abs(seen[name]))) for name in ("J_tool", "J_other"))
        close(unit, "angular momentum", seen["L"] - before, seen["J_tool"] + seen["J_other"], 2e-6, size)


def test_momentum_is_conserved_with_a_tool(unit: Unit) -> None:
    """Without forces, L stays while vehicle, tool and added mass tumble."""
    seen = unit.new({}, **TILTED, **FREE, **WEIGHTLESS, **TOOL | {"buoyancy_tool": 0.0})
    before = seen["L"]
    close(unit, "angular momentum", go_on(seen, 10.0, H)["L"], before, 1e-7)  # fourth order at 2.5 ms


def test_acceleration_is_the_change_of_the_velocity_over_ground(unit: Unit) -> None:
    """nu_dot turned into the world is the change of the velocity there, and of p, q, r in the body."""
    h = 1e-4
    seen = disturbed(unit, **TOOL, thruster_lag=0.0)
    go_on(seen, h, h)  # without lag thrusts jump at the first step
    world, rates = rotation(seen) @ read(seen, *VELOCITY[:3]), read(seen, *VELOCITY[3:])
    first, turned = seen["nu_dot"], rotation(seen)
    go_on(seen, h, h)
    moved = turned.T @ (rotation(seen) @ read(seen, *VELOCITY[:3]) - world)
    change = np.concatenate([moved, read(seen, *VELOCITY[3:]) - rates])
    # Over 0.1 ms the acceleration changes by some percent of a m/s2.
    close(unit, "acceleration", change / h, first, 1e-3)


def test_acceleration_at_rest_is_that_of_the_loads(unit: Unit) -> None:
    """A force through the centre of a resting vehicle accelerates it by F/(m + added mass)."""
    m, added_mass = values(unit, "m", "added_mass")
    neutral = {"net_buoyancy": 0.0, "r_g": (0.0,) * 3, "r_b": (0.0,) * 3}
    seen = run(unit, 0.0, H, {"F_external": (3.0, 0.0, 0.0)}, **neutral)
    close(unit, "acceleration", seen["nu_dot"], (3.0 / (m + added_mass[0]), 0, 0, 0, 0, 0), 1e-14)
