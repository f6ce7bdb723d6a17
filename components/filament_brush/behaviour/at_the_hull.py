"""What the brush does at the hull: signs, symmetry, the printed contact law, statics, steady means."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Running, Unit, close, go_on, holds, read, run, same, values

H = 1e-3  # s, the communication step
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}
LAMBDA = (1.875104068711961, 4.694091132974175, 7.854757438237613,
          10.995540734875467, 14.137168391046471, 17.278759532088237)  # fmt: skip


def loads(running: Running) -> np.ndarray:
    """F_x, F_z, T_brush."""
    return read(running, "F_x", "F_z", "T_brush")


def test_brush_clear_of_the_hull_has_no_forces(unit: Unit) -> None:
    """Without contact, force and torque are exactly 0 and nothing is lost to friction."""
    seen = run(unit, 0.1, H, NOMINAL | {"delta": -1e-3})
    same("force and torque", loads(seen), 0.0)
    same("filaments in contact, friction work", read(seen, "contact_count", "W_friction"), 0.0)


def test_hull_pushes_the_brush_back_and_friction_resists_the_sweep(unit: Unit) -> None:
    """Turning forward and pressed in, F_x, F_z and T_brush are all negative."""
    seen = run(unit, 0.1, H, NOMINAL)
    F_x, F_z, T_brush = loads(seen)
    holds(F_x < 0.0 and F_z < 0.0 and T_brush < 0.0, f"F_x = {F_x:.4g}, F_z = {F_z:.4g}, T_brush = {T_brush:.4g}")


def test_friction_turns_with_the_direction_of_rotation(unit: Unit) -> None:
    """Turning backwards, F_x and T_brush are positive; the hull pushes as before."""
    F_x, F_z, T_brush = loads(run(unit, 0.1, H, NOMINAL | {"omega_b": -15.7}, alpha=0.0))
    holds(F_x > 0.0 > F_z and T_brush > 0.0, f"F_x = {F_x:.4g}, F_z = {F_z:.4g}, T_brush = {T_brush:.4g}")


def test_passing_hull_drags_a_brush_at_rest_along(unit: Unit) -> None:
    """At rest, F_x has the sign of v_rov."""
    for v_rov in (0.5, -0.5):
        F_x = run(unit, 0.1, H, {"omega_b": 0.0, "delta": 5e-3, "v_rov": v_rov})["F_x"]
        holds(F_x * v_rov > 0.0, f"F_x = {F_x:.4g} N at v_rov = {v_rov:g} m/s")


def test_mirror_images_give_mirrored_forces(unit: Unit) -> None:
    """With rotation, cant, passing speed and angle reversed, F_x and T_brush are reversed and F_z is not."""
    right, left = (
        loads(run(unit, 0.05, H, {"omega_b": s * 12.0, "delta": 5e-3, "v_rov": s * 0.3}, n=6, alpha=s * -0.3,
                  theta_b_0=s * 0.1))
        for s in (1.0, -1.0)
    )
    close(unit, "mirrored force and torque", left, right * (-1.0, 1.0, -1.0), 1e-9)  # angles differ by rounding


def test_filaments_act_independently(unit: Unit) -> None:
    """Two opposite filaments give the sum of two brushes with one filament each, at every step."""
    # One communication step per degree, so that both histories are cut at the same angles.
    h = np.pi / 15.7 / 180.0
    parts = [unit.new(NOMINAL, n=1, theta_b_0=angle) for angle in (0.0, np.pi)]
    both = unit.new(NOMINAL, n=2, theta_b_0=0.0)
    largest = 0.0
    for _ in range(400):
        for running in (*parts, both):
            running.step(h)
        expected = loads(parts[0]) + loads(parts[1])
        largest = max(largest, float(np.abs(expected).max()))
        # The smallest forces are lost in 1e-9 of the peak force.
        close(unit, "force and torque", loads(both), expected, 1e-7, max(largest, 1.0))
    close(unit, "impulse", both["J_z"], parts[0]["J_z"] + parts[1]["J_z"], 1e-9)


def test_straight_filament_follows_the_printed_law(unit: Unit) -> None:
    """At first touch, straight down: F_n = k_c delta^1.5 (Eq. 7), F_f = mu(v_s) F_n (Eqs. 9, 10), torque R F_f."""
    k_c, mu_s, mu_c, v_0, k_v, R = values(unit, "k_c", "mu_s", "mu_c", "v_0", "k_v", "R_brush")
    seen = unit.new(NOMINAL, n=1, alpha=0.0, theta_b_0=0.0)
    F_n = k_c * 5e-3**1.5
    v_s = 15.7 * R - 0.05
    mu = mu_c + (mu_s - mu_c) * np.exp(-((v_s / v_0) ** 2)) + k_v * v_s
    close(unit, "normal force", -seen["F_z"], F_n, 1e-12)
    # The smoothed sign is 1 - (v_eps/v_s)^4/4.
    close(unit, "friction", -seen["F_x"], mu * F_n, 1e-8)
    close(unit, "torque", -seen["T_brush"], mu * F_n * R, 1e-8)
    close(unit, "friction power", seen["P_friction"], mu * F_n * v_s, 1e-8)


def test_largest_dry_friction_is_mu_s_where_the_peak_is_kept(unit: Unit) -> None:
    """friction_law = 1, sliding at v_eps: F_f = mu_s F_n; slower and faster it is less."""
    mu_s, v_eps, R = values(unit, "mu_s", "v_eps", "R_brush")
    found = []
    for v_s in (0.8 * v_eps, v_eps, 1.2 * v_eps):
        inputs = {"omega_b": 1.0, "delta": 5e-3, "v_rov": R - v_s}
        seen = unit.new(inputs, n=1, alpha=0.0, theta_b_0=0.0, k_v=0.0, friction_law=1)
        found.append(seen["F_x"] / seen["F_z"])
    close(unit, "friction at v_eps", found[1], mu_s, 1e-12)
    holds(found[0] < mu_s > found[2], f"mu = {found[0]:.4g} below and {found[2]:.4g} above v_eps")


def test_only_filaments_within_the_contact_arc_touch(unit: Unit) -> None:
    """Straight and radial, those touch whose cos(phi) exceeds 1 - delta/R_brush."""
    n, R = values(unit, "n", "R_brush")
    seen = unit.new({"omega_b": 0.0, "delta": 5e-3}, alpha=0.0, theta_b_0=0.0)
    phi = 2.0 * np.pi * np.arange(n) / n
    same("filaments in contact", seen["contact_count"], float(np.sum(np.cos(phi) > 1.0 - 5e-3 / R)))


def test_fouling_scales_dry_friction_and_leaves_the_first_normal_force(unit: Unit) -> None:
    """friction_scale multiplies mu_s and mu_c; the viscous part and F_z at first touch stay."""
    k_v, mu_c, R = values(unit, "k_v", "mu_c", "R_brush")
    clean, foul = (unit.new(NOMINAL | {"friction_scale": scale}) for scale in (1.0, 1.5))
    same("F_z", foul["F_z"], clean["F_z"])
    viscous = k_v * (15.7 * R - 0.05)
    # Filaments at an angle slide a little slower than v_s at the lowest point.
    close(unit, "ratio of F_x", foul["F_x"] / clean["F_x"], (1.5 * mu_c + viscous) / (mu_c + viscous), 1e-2)


def test_eigenvalues_and_frequencies_are_those_of_the_cantilever(unit: Unit) -> None:
    """cos(lambda) cosh(lambda) = -1 and omega_r = (lambda_r/L)^2 sqrt(E I/m); added mass lowers them."""
    L, d, E, rho, rho_w = values(unit, "L", "d", "E", "rho", "rho_w")
    dry, wet = unit.new({}, C_a=0.0), unit.new({}, C_a=1.0)
    close(unit, "eigenvalues", dry["lambda_r"] / LAMBDA, 1.0, 1e-14)
    omega_r = (np.array(LAMBDA) / L) ** 2 * np.sqrt(E * d**2 / (16.0 * rho))
    close(unit, "frequencies", dry["omega_r"] / omega_r, 1.0, 1e-13)
    close(unit, "frequencies in water", wet["omega_r"] / dry["omega_r"], np.sqrt(rho / (rho + rho_w)), 1e-14)


def test_pressed_filament_at_rest_obeys_beam_statics(unit: Unit) -> None:
    """Without friction and rotation the base shear is the normal force across the axis, the moment L times it."""
    L = unit.parameter("L")
    inputs = {"omega_b": 0.0, "delta": 6e-3, "v_rov": 0.0, "friction_scale": 0.0}
    seen = run(unit, 0.6, H, inputs, n=1, alpha=0.0, k_v=0.0, theta_b_0=0.2, zeta=(0.5,) * 6, foreshortening=False)
    across = seen["F_z"] * np.sin(0.2)
    holds(abs(across) > 0.2, f"{across:.3g} N across the filament; it was to be bent")
    # With half of critical damping, exp(-0.5*163*0.6) is left of the transient.
    close(unit, "base shear", seen["F_y_eq11"], -across, 1e-6)
    close(unit, "base moment", seen["M_b_eq12"], across * L, 1e-6)


def steady(unit: Unit, inputs: dict[str, float], **parameters: Any) -> tuple[Running, np.ndarray]:
    """After eight revolutions: the brush, and the means over the ninth from its impulses."""
    h = 2.0 * np.pi / 15.7 / 400.0
    seen = run(unit, 3200 * h, h, inputs, **parameters)
    before = read(seen, "J_x", "J_z", "J_T")
    go_on(seen, 400 * h, h)
    return seen, (read(seen, "J_x", "J_z", "J_T") - before) / (400 * h)


def test_steady_forces_are_those_of_the_energy_balance(unit: Unit) -> None:
    """Over a revolution, hub work -omega_b*T and hull work v_rov*F_x are what friction, contact and damping take."""
    names = ("W_friction", "W_contact", "W_damping")
    h = 2.0 * np.pi / 15.7 / 400.0
    seen = run(unit, 3200 * h, h, NOMINAL)
    lost, turned = read(seen, *names).sum(), read(seen, "J_x", "J_T")
    go_on(seen, 400 * h, h)
    J_x, J_T = read(seen, "J_x", "J_T") - turned
    # What is left of the settling, a factor of 0.37 per revolution, still changes the stored energy.
    close(unit, "loss of a revolution", read(seen, *names).sum() - lost, -15.7 * J_T + 0.05 * J_x, 1e-4)


def test_less_friction_gives_less_drag(unit: Unit) -> None:
    """In the steady state F_x falls with friction, and so does the torque."""
    _, full = steady(unit, NOMINAL)
    _, less = steady(unit, NOMINAL | {"friction_scale": 0.8})
    holds(0.6 < less[0] / full[0] < 0.95, f"F_x falls to {less[0] / full[0]:.3f} at 0.8 of the friction")
    holds(0.6 < less[2] / full[2] < 0.95, f"T_brush falls to {less[2] / full[2]:.3f} at 0.8 of the friction")


def test_ripple_has_the_blade_pass_frequency(unit: Unit) -> None:
    """In the steady state F_z ripples n times per revolution."""
    n = unit.parameter("n")
    seen, _ = steady(unit, NOMINAL)
    samples = []
    for _ in range(400):
        seen.step(2.0 * np.pi / 15.7 / 400.0)
        samples.append(seen["F_z"])
    spectrum = np.abs(np.fft.rfft(samples - np.mean(samples)))
    same("ripples per revolution", int(np.argmax(spectrum)), int(n))
