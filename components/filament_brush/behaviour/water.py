"""What the water does to the brush: drag along the bristles, torque of the pack; nothing by default."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Unit, close, holds, read, run, same
from .energy import stored

H = 1e-3
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}
WET: dict[str, Any] = {"C_d": 1.1, "C_a": 1.0, "shielding": 0.2, "pack_drag": 1.0}


def test_by_default_the_water_takes_nothing(unit: Unit) -> None:
    """Without drag coefficients, torque, power and work of the water are exactly 0."""
    same("torque, power and work of the water", read(run(unit, 0.1, H, NOMINAL), "T_water", "P_water", "W_water"), 0.0)


def test_water_resists_the_turning_and_its_torque_is_part_of_the_brush_torque(unit: Unit) -> None:
    """Clear of the hull T_brush is T_water, against the turning, and takes omega_b T_water."""
    for omega_b in (15.7, -15.7):
        seen = run(unit, 0.2, H, {"omega_b": omega_b, "delta": -0.05}, **WET)
        close(unit, "torque", seen["T_brush"], seen["T_water"], 1e-14)
        holds(seen["T_water"] * omega_b < 0.0, f"T_water = {seen['T_water']:.4g} at omega_b = {omega_b:g} rad/s")
        close(unit, "power lost to the water once bristles are at rest in it", seen["P_water"], seen["P_hub"], 1e-3)


def test_torque_of_the_pack_is_the_same_with_and_without_hull(unit: Unit) -> None:
    """Without drag along the bristles T_water depends on omega_b only."""
    off, on = (run(unit, 0.05, H, NOMINAL | {"delta": d}, pack_drag=1.0)["T_water"] for d in (-0.05, 5e-3))
    close(unit, "torque of the pack", on, off, 1e-14)


def test_energy_is_accounted_for_in_water(unit: Unit) -> None:
    """Stored = hub + hull - what damping, friction, contact and water take, wherever drag is linear."""
    for linear_below in (0.0, 0.5, 1e9):
        seen = run(unit, 0.4, H, NOMINAL | {"delta_dot": 1e-3}, **WET, linear_below=linear_below)
        lost = read(seen, "W_damping", "W_friction", "W_contact", "W_water")
        holds(np.all(lost >= 0.0), "a loss is negative: {:.3g}, {:.3g}, {:.3g}, {:.3g} J".format(*lost))
        missing = stored(seen) - np.sum(read(seen, "W_hub", "W_hull")) + np.sum(lost)
        close(unit, "energy not accounted for", missing, 0.0, 1e-4, seen["W_friction"])
        close(unit, "energy_residual", seen["energy_residual"], missing, 1e-9, 1.0)


def test_drag_calms_bristles_that_left_the_hull(unit: Unit) -> None:
    """With drag, bristles off the hull keep less energy than without."""
    dry, wet = (run(unit, 0.4, H, NOMINAL, **p)["E_kinetic"] for p in ({"C_a": 1.0}, WET))
    holds(wet < 0.8 * dry, f"{wet:.3g} J in water, {dry:.3g} J without drag")


def test_forces_in_water_do_not_depend_on_the_full_form_off_the_hull(unit: Unit) -> None:
    """Drag in full off the hull too changes the impulses by little."""
    some, full = (
        read(run(unit, 0.4, H, NOMINAL, **WET, linear_below=below), "J_x", "J_z", "J_T") for below in (0.5, 0.0))
    close(unit, "impulses", some / full, np.ones(3), 0.01)
