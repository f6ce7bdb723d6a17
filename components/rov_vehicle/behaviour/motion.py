"""What the vehicle does in motion: published trajectories, conservation laws, energy accounts, terminal speeds."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np

from ...testing.behaviour import Running, Unit, close, go_on, holds, read, run, values
from ..parameters import BENZON_2022, WU_2018, Parameters
from .at_rest import FREE, TILTED, WEIGHTLESS, H, rotation

HERE = Path(__file__).parent
POSE = ("x_n", "y_n", "z_n", "phi", "theta", "psi")
VELOCITY = ("u", "v", "w", "p", "q", "r")


def trajectory_agrees(unit: Unit, file: str, chosen: Parameters) -> None:
    """Pose and velocity in a table, one row each 0.25 s, under a constant force and moment."""
    table = np.loadtxt(HERE / file, delimiter=",", skiprows=1)
    parameters = {f.name: getattr(chosen, f.name) for f in dataclasses.fields(chosen)}
    del parameters["max_step"]
    seen = unit.new({"F_external": (6.0, 3.0, -4.0), "M_external": (0.3, 0.5, 0.4)}, **parameters)
    rows = [read(seen, *POSE, *VELOCITY)]
    for before, after in zip(table[:-1, 0], table[1:, 0], strict=True):
        rows.append(read(go_on(seen, after - before, H), *POSE, *VELOCITY))
    difference = np.array(rows) - table[:, 1:]
    difference[:, 3:6] = (difference[:, 3:6] + np.pi) % (2.0 * np.pi) - np.pi
    relative = np.abs(difference).max(axis=0) / np.abs(table[:, 1:]).max(axis=0)
    # Two independent public implementations agree to 1e-9; fourth order at 2.5 ms comes within 1e-8 of the excursion.
    close(unit, f"pose and velocity of {file}", relative, 0.0, 1e-7, 1.0)


def test_step_response_is_that_of_wu_2018(unit: Unit) -> None:
    """With the parameters of Wu 2018 the response to a constant wrench is that of two public implementations."""
    trajectory_agrees(unit, "vehicle_step_wu2018.csv", WU_2018)


def test_step_response_is_that_of_benzon_2022(unit: Unit) -> None:
    """The same with the parameters of von Benzon et al. 2022."""
    trajectory_agrees(unit, "vehicle_step_benzon2022.csv", BENZON_2022)


def test_net_buoyancy_lifts_the_vehicle(unit: Unit) -> None:
    """Released at rest it starts to rise with (B - W)/(m + added mass in heave)."""
    m, added_mass, net_buoyancy = values(unit, "m", "added_mass", "net_buoyancy")
    seen = run(unit, 0.1, H, {}, r_g=(0.0, 0.0, 0.0), r_b=(0.0, 0.0, 0.0))
    close(unit, "heave velocity", seen["w"], -net_buoyancy / (m + added_mass[2]) * 0.1, 0.02)  # damping takes 1 %


def test_vehicle_rises_with_the_terminal_speed_of_its_buoyancy(unit: Unit) -> None:
    """D w + D_q w^2 = B - W when it has settled."""
    D, D_q = values(unit, "D_force", "D_force_quadratic")
    seen = run(unit, 60.0, 0.02, {}, net_buoyancy=8.0)
    expected = (-D[2] + np.sqrt(D[2] ** 2 + 4.0 * D_q[2] * 8.0)) / (2.0 * D_q[2])
    close(unit, "terminal speed", -seen["w"], expected, 1e-9)


def test_thrust_and_drag_balance_at_the_terminal_speed(unit: Unit) -> None:
    """Pushed down through its centre, the vehicle reaches the speed where damping takes the whole force."""
    D, D_q = values(unit, "D_force", "D_force_quadratic")
    seen = run(unit, 60.0, 0.02, {"F_external": (0.0, 0.0, 30.0)}, net_buoyancy=0.0)
    close(unit, "damping force", D[2] * seen["w"] + D_q[2] * seen["w"] ** 2, 30.0, 1e-9)


def test_weight_below_buoyancy_rights_the_vehicle(unit: Unit) -> None:
    """Heeled and pitched, it turns back at once and comes to rest upright."""
    seen = run(unit, H, H, {}, attitude_start=(0.2, 0.3, 0.0), net_buoyancy=0.0)
    p, q = read(seen, "p", "q")
    holds(p < 0.0 and q < 0.0, f"rates p = {p:.3g}, q = {q:.3g} rad/s, expected negative")
    close(unit, "roll and pitch after 2 min", read(go_on(seen, 120.0, 0.02), "phi", "theta"), 0.0, 1e-6, 1.0)


def test_attitude_is_a_rotation_and_agrees_with_the_euler_angles(unit: Unit) -> None:
    """The quaternion keeps its length, and phi, theta, psi describe the same attitude."""
    seen = run(unit, 10.0, H, {}, **TILTED)
    close(unit, "length of the quaternion", np.linalg.norm(seen["quat"]), 1.0, 5e-16)
    phi, theta, psi = read(seen, "phi", "theta", "psi")
    expected = (-np.sin(theta), np.sin(phi) * np.cos(theta), np.sin(psi) * np.cos(theta))
    R = rotation(seen)
    close(unit, "elements of the rotation", (R[2, 0], R[2, 1], R[1, 0]), expected, 1e-14, 1.0)


def test_attitude_passes_ninety_degrees_of_pitch(unit: Unit) -> None:
    """At a constant pitch rate the rotation is exact beyond the vertical, where Euler angles turn over."""
    seen = run(unit, 1.0, H, {}, rates_start=(0.0, 2.0, 0.0), r_g=(0.0, 0.0, 0.0), **FREE, **WEIGHTLESS)
    close(unit, "quaternion", seen["quat"], (np.cos(1.0), 0.0, np.sin(1.0), 0.0), 1e-11, 1.0)
    close(unit, "pitch angle", seen["theta"], np.pi - 2.0, 1e-10)


def test_momentum_is_conserved_without_forces(unit: Unit) -> None:
    """Kirchhoff: without forces the momentum of body and added mass, M nu seen from the world, stays."""
    m, I, I_products, r_g, added, added_I = values(unit, "m", "I", "I_products", "r_g", "added_mass", "added_inertia")
    S = np.array([[0.0, -r_g[2], r_g[1]], [r_g[2], 0.0, -r_g[0]], [-r_g[1], r_g[0], 0.0]])
    xy, xz, yz = I_products
    inertia = np.diag(I) + np.array([[0.0, xy, xz], [xy, 0.0, yz], [xz, yz, 0.0]])
    M = np.block([[m * np.eye(3), -m * S], [m * S, inertia]]) + np.diag([*added, *added_I])
    seen = unit.new({}, **TILTED, **FREE, **WEIGHTLESS)

    def momenta() -> np.ndarray:
        R = rotation(seen)
        linear, angular = np.split(M @ read(seen, *VELOCITY), 2)
        return np.concatenate([R @ linear, R @ angular + np.cross(read(seen, *POSE[:3]), R @ linear)])

    before = momenta()
    go_on(seen, 10.0, H)
    close(unit, "momenta", momenta(), before, 1e-9)  # fourth order at 2.5 ms


def test_energy_is_conserved_without_damping(unit: Unit) -> None:
    """Tumbling freely under weight and buoyancy, kinetic and potential energy add up to the same sum."""
    seen = unit.new({}, **TILTED, **FREE)
    before = float(np.sum(read(seen, "E_kinetic", "E_potential")))
    go_on(seen, 5.0, H)
    close(unit, "energy", np.sum(read(seen, "E_kinetic", "E_potential")), before, 1e-8, 5.0)


def disturbed(unit: Unit, **parameters: Any) -> Running:
    """Everything at work: thrusters, tool, further forces, current, tumbling."""
    inputs: dict[str, Any] = {"F_x": -20.0, "F_z": -30.0, "M_y": -3.0, "v_c": (0.3, -0.2, 0.1)}
    inputs |= {"u_thruster": (0.3, -0.2, 0.4, 0.1, 0.6, 0.5, -0.3, 0.2), "F_external": (1.0, 2.0, 3.0)}
    return unit.new(inputs, **TILTED, **parameters)


def test_energy_is_accounted_for(unit: Unit) -> None:
    """energy_residual stays 0 with every power at work, and when the current changes."""
    seen = go_on(disturbed(unit), 4.0, H)
    for name in ("W_thruster", "W_tool", "W_external", "W_current", "W_damping"):
        holds(abs(seen[name]) > 0.5, f"{name} = {seen[name]:.3g} J; all were to be at work")
    close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-7, 100.0)  # about 100 J are moved
    seen.set(v_c=(-0.4, 0.3, 0.0))
    close(unit, "energy not accounted for", go_on(seen, 1.0, H)["energy_residual"], 0.0, 1e-7, 100.0)


def test_errors_fall_with_the_fourth_power_of_the_internal_step(unit: Unit) -> None:
    """Pose and velocity without damping, and the energy residual with it, are of fourth order in max_step."""
    # Without damping: |v| v has a kink at each reversal, which blurs the order.
    moved = [read(run(unit, 2.0, 0.02, {}, **TILTED, **FREE, max_step=dt), *POSE, *VELOCITY)
             for dt in (0.02, 0.01, 6.25e-4)]
    order = np.log2(np.abs(moved[0] - moved[2]).max() / np.abs(moved[1] - moved[2]).max())
    close(unit, "order of the integration", order, 4.0, 0.2, 1.0)
    coarse, fine = (go_on(disturbed(unit, max_step=dt), 4.0, H)["energy_residual"] for dt in (5e-3, 2.5e-3))
    close(unit, "order of the energy residual", np.log2(coarse / fine), 4.0, 0.4, 1.0)


def test_communication_step_does_not_matter(unit: Unit) -> None:
    """5 ms and 20 ms lead to the same place."""
    fine, coarse = (read(go_on(disturbed(unit), 2.0, h), *POSE, *VELOCITY) for h in (5e-3, 2e-2))
    close(unit, "pose and velocity", coarse, fine, 1e-9)


def test_drifting_with_the_current_costs_no_damping(unit: Unit) -> None:
    """At the speed of the water the vehicle goes straight on, without loss."""
    seen = run(unit, 10.0, H, {"v_c": (0.6, 0.2, 0.0)}, velocity_start=(0.6, 0.2, 0.0), net_buoyancy=0.0)
    close(unit, "way", read(seen, "x_n", "y_n"), (6.0, 2.0), 1e-12)
    close(unit, "damping work", seen["W_damping"], 0.0, 1e-20, 1.0)


def test_current_carries_the_vehicle_to_its_own_speed(unit: Unit) -> None:
    """After a long time the vehicle moves with the water."""
    # Along one axis of the body, so that no turning moment acts.
    seen = run(unit, 200.0, 0.02, {"v_c": (0.0, 0.0, 0.3)}, net_buoyancy=0.0)
    close(unit, "heave velocity", seen["w"], 0.3, 1e-3)


def test_surge_is_unstable_in_pitch_at_speed(unit: Unit) -> None:
    """The Munk moment of the added masses overcomes the righting moment: a tenth of a degree grows until it tumbles."""
    # The added masses of surge and heave differ; within 4 s it tumbles under 20 N and stays level under 2 N.
    parameters = {f.name: getattr(WU_2018, f.name) for f in dataclasses.fields(WU_2018)} | {"net_buoyancy": 0.0}
    del parameters["max_step"]
    largest = []
    for force in (2.0, 20.0):
        seen = unit.new({"F_external": (force, 0.0, 0.0)}, **parameters | {"attitude_start": (0.0, 0.002, 0.0)})
        largest.append(max(abs(go_on(seen, 0.1, H)["theta"]) for _ in range(40)))
    holds(largest[0] < 0.3, f"pitch of {largest[0]:.3g} rad under 2 N, expected to stay below 0.3")
    holds(largest[1] > 1.0, f"pitch of {largest[1]:.3g} rad only under 20 N, expected to tumble")
