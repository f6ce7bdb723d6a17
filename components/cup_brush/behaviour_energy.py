"""What the cup brush does with energy and time: accounts, impulses, independence of steps."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..testing.behaviour import Unit, close, go_on, holds, read, run

H = 1e-3
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}


def test_energy_is_accounted_for(unit: Unit) -> None:
    """Strain energy = hub + hull - friction - damping, also of a brush that is tilted or canted; losses are losses."""
    variants: tuple[tuple[dict[str, float], dict[str, Any]], ...] = (
        ({}, {}), ({"misalignment": 0.02}, {}), ({}, {"alpha": 0.2}), ({"v_rov": 0.4}, {}),
        ({"misalignment": 0.02}, {"alpha": 0.2, "c_c": 5.0}))  # fmt: skip
    for inputs, parameters in variants:
        balance(unit, NOMINAL | inputs, parameters, 1e-5)  # tables of the elastica and Simpson's rule


def test_energy_is_accounted_for_where_tufts_leave_the_hull(unit: Unit) -> None:
    """Tilted so far that tufts leave and touch, energy is accounted for but for what smooths their first touch."""
    balance(unit, NOMINAL | {"misalignment": 0.06}, {}, 5e-4)


def balance(unit: Unit, inputs: dict[str, float], parameters: dict[str, Any], bound: float) -> None:
    """Compare what is stored, supplied and lost after four tenths of a second."""
    seen = run(unit, 0.4, H, inputs, **parameters)
    lost = read(seen, "W_friction", "W_contact")
    holds(np.all(lost >= 0.0), "a loss is negative: {:.3g}, {:.3g} J".format(*lost))
    missing = seen["E_strain"] - np.sum(read(seen, "W_hub", "W_hull")) + np.sum(lost)
    close(unit, "energy not accounted for", missing, 0.0, bound, seen["W_friction"])
    close(unit, "energy_residual", seen["energy_residual"], missing, 1e-9, 1.0)


def test_pressing_in_costs_what_bending_stores_and_sliding_loses(unit: Unit) -> None:
    """Pressed in at a steady rate, the hull's work is the strain energy and what friction takes of the bending."""
    still = {"omega_b": 0.0, "delta": 0.0, "delta_dot": 0.01, "friction_scale": 0.0}
    seen = unit.new(still, k_v=0.0, c_c=0.0)
    for k in range(500):
        seen.set(delta=1e-5 * k)
        seen.step(H)
    holds(seen["E_strain"] > 1.0, f"{seen['E_strain']:.3g} J are stored; the bristles were to be bent")
    # Simpson's rule over the step in which the bristles buckle.
    close(unit, "hull work", seen["W_hull"], seen["E_strain"], 2e-3)


def test_energy_is_accounted_for_when_inputs_jump(unit: Unit) -> None:
    """Jumps of speed, penetration, tilt and friction do work at once, and it is booked."""
    seen = unit.new(NOMINAL, c_c=5.0)
    for k in range(400):
        seen.set(
            omega_b=15.0 + 3.0 * np.sin(0.3 * k), delta=5e-3 + 1e-3 * np.sin(0.11 * k), v_rov=0.2 * np.sin(0.05 * k),
            delta_dot=0.05 * np.cos(0.2 * k), friction_scale=1.0 + 0.4 * np.sin(0.07 * k),
            misalignment=0.01 * np.sin(0.13 * k))
        seen.step(H)
    close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-4, seen["W_friction"])


def test_powers_are_forces_times_speeds(unit: Unit) -> None:
    """P_hub = -omega_b*T_brush, and P_hull = v_rov*F_x - delta_dot*F_z where the brush stands upright."""
    seen = run(unit, 0.05, H, NOMINAL | {"delta_dot": 0.002})
    close(unit, "hub power", seen["P_hub"], -15.7 * seen["T_brush"], 1e-14)
    close(unit, "hull power", seen["P_hull"], 0.05 * seen["F_x"] - 0.002 * seen["F_z"], 1e-13)


def test_power_put_in_is_what_friction_takes(unit: Unit) -> None:
    """Upright and at constant penetration, hub and hull put in what the tips lose at their sliding speeds."""
    seen = run(unit, 0.05, H, NOMINAL)
    close(unit, "power lost", seen["P_friction"], seen["P_hub"] + seen["P_hull"], 1e-12)


def test_impulses_are_the_time_integrals_of_the_forces(unit: Unit) -> None:
    """J_x, J_y, J_z and J_T are the trapezoidal sums at 0.1 ms of a tilted brush with few tufts."""
    names, impulses = ("F_x", "F_y", "F_z", "T_brush"), ("J_x", "J_y", "J_z", "J_T")
    seen, h = unit.new(NOMINAL | {"misalignment": 0.02}, row_tufts=(3.0,) + (0.0,) * 7), 1e-4
    samples = [read(seen, *names)]
    for _ in range(1000):
        seen.step(h)
        samples.append(read(seen, *names))
    trapezoid = h * (np.sum(samples, axis=0) - 0.5 * (samples[0] + samples[-1]))
    close(unit, "impulses", read(seen, *impulses), trapezoid, 1e-5)


def test_brush_angle_is_the_integral_of_the_speed(unit: Unit) -> None:
    """theta_b = theta_b_0 + omega_b*t."""
    seen = run(unit, 0.1, H, NOMINAL, theta_b_0=0.3)
    close(unit, "brush angle", seen["theta_b"], 0.3 + 15.7 * 0.1, 1e-13)


def test_forces_do_not_depend_on_where_communication_points_fall(unit: Unit) -> None:
    """0.5, 1 and 2.5 ms give the same forces every 5 ms, and the same impulses."""
    rows = {}
    for h in (5e-4, 1e-3, 2.5e-3):
        seen = unit.new(NOMINAL | {"misalignment": 0.02}, row_tufts=(5.0,) + (0.0,) * 7)
        names = ("F_x", "F_y", "F_z", "T_brush", "J_z", "J_T")
        rows[h] = np.array([read(go_on(seen, 5e-3, h), *names) for _ in range(30)])
    scale = np.abs(rows[5e-4]).max(axis=0)
    for h in (1e-3, 2.5e-3):
        close(unit, f"forces with {1e3 * h:g} ms", (rows[h] / scale).ravel(), (rows[5e-4] / scale).ravel(), 1e-7)


def test_damping_adds_to_the_force_while_pressed_in(unit: Unit) -> None:
    """At delta_dot a tuft pushes back with c_c*delta_dot more, and that power is lost."""
    tufts = float(np.sum(unit.parameter("row_tufts")))
    slow, fast = (unit.new(NOMINAL | {"delta_dot": rate}, c_c=2.0) for rate in (0.0, 0.1))
    close(unit, "normal force", slow["F_z"] - fast["F_z"], tufts * 2.0 * 0.1, 1e-9)
    close(unit, "power lost in damping", fast["P_contact"], tufts * 2.0 * 0.1**2, 1e-9)
