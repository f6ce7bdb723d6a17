"""What the controller does when control of the force begins and ends, and when the hull turns against the vehicle."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Unit, close, holds, same, values, where_known
from .pid import T_S, after_one_sample

BEGIN, END, LAST = 50, 200, 220
CHOSEN: dict[str, Any] = {
    "mode": 2, "T_filter": 0.0, "K_feedforward": 0.0, "K_force": 0.1, "K_force_d": 400.0, "K_force_a": 5.0
}  # fmt: skip


def jumps(unit: Unit, **parameters: Any) -> tuple[float, float]:
    """Jumps of the force into the hull in the sample that finds contact at 0.01 m/s, and in that which loses it."""
    seen = unit.new({"v_ref": (0.0, 0.0, 0.01), "w": 0.01}, **where_known(unit, T_s=T_S), **CHOSEN, **parameters)
    forces = []
    for k in range(LAST):
        inside = BEGIN <= k < END
        seen.set(F_tool=(0.0, 0.0, -15.0 if inside else 0.0), F_n_ref=20.0, w=0.01 if k <= BEGIN else 0.0, z_ref=0.01)
        seen.step(T_S)
        same("pressing", seen["pressing"], float(inside))
        forces.append(float(seen["F_ref"][2]))
    change = np.abs(np.diff(forces))
    return float(change[BEGIN - 1]), float(change[END - 1])


def test_contact_is_taken_over_and_given_back_without_a_jump(unit: Unit) -> None:
    """With `bumpless` neither contact found nor contact lost makes a jump; without, damping and PID come at once."""
    K_velocity, K_position, K_velocity_i = values(unit, "K_velocity", "K_position", "K_velocity_i")
    found, lost = jumps(unit, bumpless=True)
    grows = K_velocity_i[2] * K_position[2] * 0.01 * T_S  # the PID's own integral, in one sample
    holds(found <= 1.01 * grows, f"a jump of {found:.4g} N at first contact")
    close(unit, "jump at the loss of contact", lost, 0.0, 1e-12, 1.0)
    found, lost = jumps(unit, bumpless=False)
    close(unit, "jump at first contact without", found, 400.0 * 0.01 - 0.1 * 5.0, 0.02)
    close(unit, "jump at the loss without", lost, K_velocity[2] * (0.01 + K_position[2] * 0.01) - 0.1 * 5.0, 0.2)


def test_added_mass_acts_along_the_normal_only(unit: Unit) -> None:
    """While pressing, K_force_a takes K_force_a times the change of velocity in a sample, over T_s, off the force."""
    asked = []
    for K_force_a in (0.0, 5.0):
        inputs = {"F_tool": (0.0, 0.0, -20.0), "F_n_ref": 20.0}
        seen = after_one_sample(unit, inputs, mode=2, T_filter=0.0, K_force_a=K_force_a)
        seen.set(u=0.01, w=0.01)
        seen.step(T_S)
        asked.append(np.asarray(seen["F_ref"]))
    close(unit, "added force", asked[1] - asked[0], (0.0, 0.0, -5.0 * 0.01 / T_S), 1e-9)


def test_normal_of_the_hull_is_turned_into_the_body_frame(unit: Unit) -> None:
    """With `hull_normal` in the world the force is measured and controlled along it, whatever the attitude."""
    theta = 0.2
    normal = np.array([-np.sin(theta), 0.0, np.cos(theta)])  # down, seen from a body that is pitched up
    inputs = {"theta": theta, "theta_ref": theta, "F_tool": tuple(-20.0 * normal), "F_n_ref": 30.0}
    for hull_normal, expected in (((0.0, 0.0, -1.0), 20.0), ((0.0, 0.0, 0.0), 20.0 * np.cos(theta))):
        seen = after_one_sample(unit, inputs, mode=2, T_filter=0.0, hull_normal=hull_normal)
        close(unit, "force into the hull", seen["F_n"], expected, 1e-12)
    seen = after_one_sample(unit, inputs, mode=2, T_filter=0.0, hull_normal=(0.0, 0.0, -1.0), K_feedforward=0.0)
    before = np.asarray(seen["F_ref"])
    seen.step(T_S)
    step = np.asarray(seen["F_ref"]) - before  # what the integral of the force grows by
    close(unit, "direction of the force", step / np.linalg.norm(step), normal, 1e-12)
