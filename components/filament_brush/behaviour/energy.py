"""What the brush does with energy and time: accounts, impulses, independence of steps, stability when sticking."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Running, Unit, close, go_on, holds, read, run, same

H = 1e-3
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}


def stored(running: Running) -> float:
    """Energy in motion, bending, the centrifugal field and the contact."""
    return float(np.sum(read(running, "E_kinetic", "E_strain", "E_centrifugal", "E_contact")))


def test_energy_is_accounted_for(unit: Unit) -> None:
    """Stored = hub + hull - damping - friction - contact; the losses never give back."""
    variants: tuple[dict[str, Any], ...] = (
        {}, {"c_c": 30.0}, {"N_m": 6, "n": 10}, {"foreshortening": False}, {"C_a": 1.0},
        {"friction_law": 1}, {"friction_law": 2}, {"n_strips": 2, "n_groups": 2, "length_spread": 0.05, "n": 20})
    for parameters in variants:
        seen = run(unit, 0.4, H, NOMINAL, **parameters)
        lost = read(seen, "W_damping", "W_friction", "W_contact")
        holds(np.all(lost >= 0.0), "a loss is negative: {:.3g}, {:.3g}, {:.3g} J".format(*lost))
        missing = stored(seen) - np.sum(read(seen, "W_hub", "W_hull")) + np.sum(lost)
        # At the default error control of the micro-steps.
        close(unit, "energy not accounted for", missing, 0.0, 1e-4, seen["W_friction"])
        close(unit, "energy_residual", seen["energy_residual"], missing, 1e-9, 1.0)


def test_energy_is_accounted_for_when_inputs_jump(unit: Unit) -> None:
    """Jumps of speed, penetration and friction do work at once, and it is booked."""
    for strips in (1, 3):
        jumping(unit, strips)


def jumping(unit: Unit, strips: int) -> None:
    """The balance of a brush of so many strips whose inputs jump at each step."""
    seen = unit.new(NOMINAL, c_c=5.0, n_strips=strips, n=20)
    for k in range(400):
        seen.set(
            tilt_x=0.02 * np.sin(0.13 * k),
            omega_b=15.0 + 3.0 * np.sin(0.3 * k), delta=5e-3 + 1e-3 * np.sin(0.11 * k), v_rov=0.2 * np.sin(0.05 * k),
            delta_dot=0.05 * np.cos(0.2 * k), friction_scale=1.0 + 0.4 * np.sin(0.07 * k))
        seen.step(H)
    close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-4, seen["W_friction"])


def test_energy_residual_falls_with_the_error_control(unit: Unit) -> None:
    """Tighter micro-steps leave less energy unaccounted for."""
    for tolerance, h_min, bound in ((1e-6, 1e-4, 1e-4), (1e-9, 1e-6, 1e-7), (1e-12, 1e-7, 2e-9)):
        seen = run(unit, 0.8, H, NOMINAL, n=1, c_c=20.0, tolerance=tolerance, h_min=h_min)
        close(unit, f"energy not accounted for at tolerance {tolerance:g}", seen["energy_residual"], 0.0, bound,
              seen["W_friction"])  # fmt: skip


def test_passivity_of_the_frictionless_brush(unit: Unit) -> None:
    """At rest, without friction and damping, a pressed filament keeps the hull's work as energy."""
    seen = run(unit, 0.05, 2.5e-4, {"omega_b": 0.0, "delta": 5e-3, "friction_scale": 0.0}, n=1, alpha=-0.4, k_v=0.0,
               zeta=(0.0,) * 6, tolerance=1e-9, h_min=1e-6)  # fmt: skip
    close(unit, "stored energy", stored(seen), seen["W_hull"], 1e-7)
    holds(np.sum(read(seen, "E_kinetic", "E_strain")) > 0.01 * stored(seen), "the filament was to be bent")


def test_powers_are_forces_times_speeds(unit: Unit) -> None:
    """P_hub = -omega_b*T_brush, P_hull = v_rov*F_x - delta_dot*F_z."""
    seen = run(unit, 0.05, H, NOMINAL | {"delta_dot": 0.002})
    close(unit, "hub power", seen["P_hub"], -15.7 * seen["T_brush"], 1e-14)
    close(unit, "hull power", seen["P_hull"], 0.05 * seen["F_x"] - 0.002 * seen["F_z"], 1e-13)


def test_impulses_are_the_time_integrals_of_the_forces(unit: Unit) -> None:
    """J_z is the trapezoidal sum of F_z at 0.1 ms."""
    seen, h = unit.new(NOMINAL), 1e-4
    samples = [seen["F_z"]]
    for _ in range(1000):
        seen.step(h)
        samples.append(seen["F_z"])
    trapezoid = h * (np.sum(samples) - 0.5 * (samples[0] + samples[-1]))
    close(unit, "impulse", seen["J_z"], trapezoid, 1e-4)  # the force has kinks where filaments touch


def test_brush_angle_is_the_integral_of_the_speed(unit: Unit) -> None:
    """theta_b = theta_b_0 + omega_b*t."""
    seen = run(unit, 0.1, H, NOMINAL, theta_b_0=0.3, n=2)
    close(unit, "brush angle", seen["theta_b"], 0.3 + 15.7 * 0.1, 1e-13)


def test_forces_do_not_depend_on_where_communication_points_fall(unit: Unit) -> None:
    """0.5, 1 and 2.5 ms give the same forces every 5 ms; with converged micro-steps much more closely."""
    for tight, bound in (({}, 1e-4), ({"tolerance": 1e-10, "h_min": 1e-7, "n": 8}, 2e-5)):
        rows = {}
        for h in (5e-4, 1e-3, 2.5e-3):
            seen = unit.new(NOMINAL, **tight)
            rows[h] = np.array([read(go_on(seen, 5e-3, h), "F_x", "F_z", "T_brush") for _ in range(30)])
        scale = np.abs(rows[5e-4]).max(axis=0)
        for h in (1e-3, 2.5e-3):
            # Error control at the default tolerance; the maps of free flight differ by 1e-5.
            close(unit, f"forces with {1e3 * h:g} ms", (rows[h] / scale).ravel(), (rows[5e-4] / scale).ravel(), bound)


def test_sticking_stays_stable(unit: Unit) -> None:
    """Creeping far below v_eps, where friction is a stiff damper, the filaments stay bent and finite."""
    for v_eps in (0.02, 1e-3):
        seen = run(unit, 0.05, H, {"omega_b": 0.01, "delta": 5e-3}, v_eps=v_eps, bristles_per_filament=500.0)
        holds(seen["deflection_ratio_max"] < 1.0, f"a deflection of {seen['deflection_ratio_max']:.3g} L")
        close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-2, seen["W_friction"])


def test_kinetic_fractions_sum_to_one_and_vanish_beyond_the_retained_modes(unit: Unit) -> None:
    """kinetic_fraction shares the kinetic energy among the N_m modes."""
    fraction = run(unit, 0.05, H, NOMINAL, N_m=4)["kinetic_fraction"]
    close(unit, "sum of the shares", np.sum(fraction), 1.0, 1e-12)
    same("shares of modes 5 and 6", fraction[4:], 0.0)


def test_any_number_of_filaments_and_modes_runs(unit: Unit) -> None:
    """1 to 300 filaments with 1 to 6 modes give finite forces."""
    for n, N_m in ((1, 1), (3, 2), (300, 4), (2, 6)):
        seen = run(unit, 0.02, H, NOMINAL, n=n, N_m=N_m)
        holds(np.all(np.isfinite(read(seen, "F_x", "F_z", "T_brush", "energy_residual"))), f"n = {n}, N_m = {N_m}")
