"""What the brush does across its width and within its bundles: strips, groups of free length; counts of contact."""

from __future__ import annotations

import numpy as np

from ...testing.behaviour import Running, Unit, close, go_on, holds, read, run, same, values

H = 1e-3
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}
FORCES = ("F_x", "F_z", "T_brush")


def test_undisturbed_strips_and_equal_groups_are_one_brush(unit: Unit) -> None:
    """Without tilt, curvature and spread any number of them gives the forces of one, and no M_x and M_z."""
    whole = run(unit, 0.05, H, NOMINAL, n=10)
    parts = run(unit, 0.05, H, NOMINAL, n=10, n_strips=3, n_groups=2)
    close(unit, "forces in parts", read(parts, *FORCES), read(whole, *FORCES), 1e-12)
    close(unit, "moments", read(parts, "M_x", "M_z"), (0.0, 0.0), 1e-12, abs(whole["F_z"]))


def test_a_tilted_brush_is_two_halves_that_are_pressed_in_differently(unit: Unit) -> None:
    """Each strip has the penetration delta + w sin(tilt_x) - w^2 hull_curvature/2; the moments are the strips'."""
    width = unit.parameter("width")
    tilt, curvature, w = 0.008, 0.1, width / 4.0
    both = unit.new(NOMINAL | {"tilt_x": tilt}, n=10, n_strips=2, hull_curvature=curvature)
    near, far = (
        unit.new(NOMINAL | {"delta": 5e-3 + side * w * np.sin(tilt) - 0.5 * curvature * w**2}, n=10)
        for side in (1.0, -1.0)
    )
    for running in (both, near, far):
        go_on(running, 0.04, H)  # when a filament touches
    close(unit, "forces", read(both, *FORCES), 0.5 * (read(near, *FORCES) + read(far, *FORCES)), 1e-10)
    close(unit, "M_x", both["M_x"], 0.5 * w * (near["F_z"] - far["F_z"]), 1e-10)
    close(unit, "M_z", both["M_z"], -0.5 * w * (near["F_x"] - far["F_x"]), 1e-10)
    close(unit, "impulse of M_x", both["J_Mx"], 0.5 * w * (near["J_z"] - far["J_z"]), 1e-10)
    close(unit, "impulse of M_z", both["J_Mz"], -0.5 * w * (near["J_x"] - far["J_x"]), 1e-10)
    holds(both["M_x"] < 0.0, f"the hull turns the brush back: M_x = {both['M_x']:.4g} N.m at a positive tilt_x")


def test_contact_is_counted(unit: Unit) -> None:
    """In a revolution each filament strikes once; it slides with the speed of its tip along an arc of contact."""
    R, n = values(unit, "R_brush", "n")
    steps = 397  # no multiple of the filaments, which would all be sampled at the same places of their way
    h = 2.0 * np.pi / 15.7 / steps
    seen: Running = run(unit, 4 * steps * h, h, NOMINAL)
    strikes, slid, friction = read(seen, "strikes", "sliding_distance", "W_friction")
    lengths, count, speed = [], 0.0, 0.0
    for _ in range(steps):
        seen.step(h)
        lengths.append(seen["contact_length"])
        count += seen["contact_count"] * seen["v_sliding"] * h
        speed = max(speed, seen["v_sliding"])
    same("strikes of a revolution", seen["strikes"] - strikes, float(n))
    # The outputs are samples of what the count integrates; a filament that leaves does so between two.
    close(unit, "sliding distance", seen["sliding_distance"] - slid, count, 5e-3)
    holds(15.7 * (R - 5e-3) - 0.05 < speed < 1.3 * 15.7 * R, f"tips slide at {speed:.4g} m/s")
    chord = 2.0 * np.sqrt(R**2 - (R - 5e-3) ** 2)
    holds(0.5 * chord < np.mean(lengths) < 1.5 * chord, f"contact is {np.mean(lengths):.3g} m long, chord {chord:.3g}")
    holds(seen["W_friction"] > friction, "sliding takes work")


def test_what_a_maker_must_know_follows_from_the_parameters(unit: Unit) -> None:
    """m_filaments is the mass of n N_b rods, packing their section over the surface of the hub, 2 pi R_h width."""
    N_b, d, L, rho, n, width = values(unit, "bristles_per_filament", "d", "L", "rho", "n", "width")
    seen = unit.new(NOMINAL)
    section = n * N_b * np.pi / 4.0 * d**2
    close(unit, "mass of the bristles", seen["m_filaments"], section * rho * L, 1e-14)
    close(unit, "packing", seen["packing"], section / (2.0 * np.pi * seen["R_h"] * width), 1e-14)
