"""What the cup brush does at the hull: signs, symmetry, exact bending, geometry of the circles, motion and tilt."""

from __future__ import annotations

import sys

import numpy as np

from ..testing.behaviour import Running, Unit, close, holds, read, run, same, values
from ..testing.suite import Excitation, suite
from . import behaviour_energy
from .fmu import CupBrush

H = 1e-3  # s, the communication step
NOMINAL = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}
STILL = NOMINAL | {"v_rov": 0.0}
ONE_TUFT = {"row_tufts": (1.0,) + (0.0,) * 7}


def loads(running: Running) -> np.ndarray:
    """F_x, F_y, F_z, T_brush, M_x, M_y."""
    return read(running, "F_x", "F_y", "F_z", "T_brush", "M_x", "M_y")


def bristles(unit: Unit) -> float:
    """Bristles of the whole brush."""
    tufts, each = values(unit, "row_tufts", "bristles_per_tuft")
    return float(np.sum(tufts) * each)


def test_brush_clear_of_the_hull_has_no_forces(unit: Unit) -> None:
    """Without contact, forces and moments are exactly 0 and nothing is lost to friction."""
    seen = run(unit, 0.05, H, NOMINAL | {"delta": -1e-3})
    same("forces and moments", loads(seen), 0.0)
    same("tufts in contact, friction work", read(seen, "contact_count", "W_friction"), 0.0)


def test_hull_pushes_the_brush_back_and_friction_resists_the_rotation(unit: Unit) -> None:
    """Pressed in, F_z is negative, and T_brush has the sign of -omega_b."""
    for omega_b in (15.7, -15.7):
        seen = run(unit, 0.01, H, STILL | {"omega_b": omega_b})
        holds(seen["F_z"] < 0.0, f"F_z = {seen['F_z']:.4g} N")
        holds(seen["T_brush"] * omega_b < 0.0, f"T_brush = {seen['T_brush']:.4g} N.m at {omega_b:g} rad/s")


def test_a_brush_that_only_turns_feels_no_side_force(unit: Unit) -> None:
    """Upright and not moving along the hull, the friction of tufts all around adds up to a torque alone."""
    seen = run(unit, 0.01, H, STILL)
    close(unit, "side forces", read(seen, "F_x", "F_y"), 0.0, 1e-10, abs(seen["F_z"]))
    close(unit, "moments about x_t and y_t", read(seen, "M_x", "M_y"), 0.0, 1e-10, abs(seen["T_brush"]))


def test_torque_is_the_radius_of_the_tips_times_their_friction(unit: Unit) -> None:
    """Pressed in by delta_0, tips slide on R_brush: T_brush = R_brush*F_y, F_y the friction of all tufts as numbers."""
    R, delta_0 = values(unit, "R_brush", "delta_0")
    seen = unit.new(STILL | {"delta": delta_0})
    # The trail of the tips hardly depends on the friction with which it was found.
    close(unit, "torque", seen["T_brush"], R * seen["F_y_sum"], 5e-4)
    close(unit, "torque of Eq. 15", seen["T_brush_eq15"], R * seen["F_y_eq11"], 1e-14)


def test_tips_trail_their_roots(unit: Unit) -> None:
    """With roots on R_brush the tips run on the smaller circle R^2 - y^2, and the torque is that much smaller."""
    R, L = values(unit, "R_brush", "L")
    seen = run(unit, 2 * H, H, STILL, delta_0=0.0)
    radius = np.sqrt(R**2 - (seen["deflection_ratio"] * L) ** 2)
    close(unit, "torque", seen["T_brush"], radius * seen["F_y_sum"], 1e-9)
    same("radius of the roots", seen["root_radius"], R)


def test_friction_over_normal_force_is_the_coefficient(unit: Unit) -> None:
    """Upright, the tufts' friction is mu(v_s) F_n with Eq. 9 at the speed of the tips."""
    mu_s, mu_c, v_0, k_v = values(unit, "mu_s", "mu_c", "v_0", "k_v")
    seen = run(unit, 2 * H, H, STILL)
    v_s = 15.7 * seen["T_brush"] / seen["F_y_sum"]
    mu = mu_c + (mu_s - mu_c) * np.exp(-((v_s / v_0) ** 2)) + k_v * v_s
    # The smoothed sign is 1 - (v_eps/v_s)^4/4.
    close(unit, "F_y/F_z", seen["F_y_sum"] / seen["F_z"], mu, 1e-7)
    close(unit, "base shear", seen["F_y_eq11"], seen["F_y_sum"], 1e-9)


def test_bristle_without_friction_carries_the_euler_load(unit: Unit) -> None:
    """Pressed straight down, a bristle buckles: pi^2 E I/(4 L^2), and a little more the farther it is bent."""
    L, d, E = values(unit, "L", "d", "E")
    euler = np.pi**3 * E * d**4 / (256.0 * L**2)
    rise = []
    for delta in (1e-4, 5e-3):
        seen = unit.new({"omega_b": 0.0, "delta": delta, "friction_scale": 0.0}, k_v=0.0)
        rise.append(-seen["F_z"] / bristles(unit) / euler)
    # Of second order, 1 + e/2 (Timoshenko and Gere 1961): 1.0006 and 1.033 here.
    close(unit, "force over the Euler load", rise, (1.0006, 1.0328), 3e-3)


def test_force_of_a_light_touch_grows_with_the_root_of_the_penetration(unit: Unit) -> None:
    """Bent a little by a side force mu P, a bristle is shortened by its square: P = sqrt(15) E I/(mu L^2) sqrt(e)."""
    L, d, E = values(unit, "L", "d", "E")
    mu, e = 0.7, 1e-5 / L
    constant = {"mu_s": mu, "mu_c": mu, "k_v": 0.0, "v_eps": 1e-4}
    seen = unit.new(STILL | {"delta": 1e-5}, **constant)
    EI = np.pi * E * d**4 / 64.0
    # Beam-columns bend more: by 1 - 2.4 % of the Euler load's share, 7 % here.
    close(unit, "force", -seen["F_z"] / bristles(unit), np.sqrt(15.0 * e) * EI / (mu * L**2), 0.05)


def test_moving_along_the_hull_drags_the_brush_with_it(unit: Unit) -> None:
    """At small v_rov/(omega_b R) the passing hull drags with half of the friction times that ratio."""
    R = unit.parameter("R_brush")
    for v_rov in (0.05, -0.05):
        seen = unit.new(NOMINAL | {"v_rov": v_rov})
        share = seen["F_x"] / (0.5 * seen["F_y_sum"] * v_rov / (15.7 * R))
        holds(-1.5 < share < -0.5, f"F_x is {share:.3g} of what plain Coulomb friction gives")
    still = unit.new({"omega_b": 0.0, "delta": 5e-3, "v_rov": 0.5})
    # All tips slide alike.
    close(unit, "F_x of a brush that is drawn", still["F_x"], -still["F_y_sum"], 1e-9)


def test_tilt_presses_one_side_deeper_and_pushes_sideways(unit: Unit) -> None:
    """Deeper at +x_t: M_y > 0 there, and its friction, along -y_t for omega_b > 0, prevails."""
    upright, tilted = (unit.new(STILL | {"misalignment": m}) for m in (0.0, 0.01))
    holds(tilted["M_y"] > 0.0 > tilted["F_y"], f"M_y = {tilted['M_y']:.3g} N.m, F_y = {tilted['F_y']:.3g} N")
    close(unit, "normal force, of second order", tilted["F_z"], upright["F_z"], 0.03)
    back = unit.new(STILL | {"misalignment": 0.01, "omega_b": -15.7})
    holds(back["F_y"] > 0.0, f"F_y = {back['F_y']:.3g} N when turning backwards")


def test_steep_tilt_lifts_tufts_off(unit: Unit) -> None:
    """Tilted by more than delta/R, tufts at -x_t leave the hull."""
    R = unit.parameter("R_brush")
    seen = unit.new(STILL | {"misalignment": 2.0 * 5e-3 / R})
    holds(0.0 < seen["contact_count"] < np.sum(unit.parameter("row_tufts")), f"{seen['contact_count']:g} in contact")


def test_mirror_images_give_mirrored_forces(unit: Unit) -> None:
    """Turning backwards, with upright bristles, reverses F_y, T_brush and M_x and leaves F_x, F_z and M_y."""
    right, left = (loads(run(unit, 0.02, H, NOMINAL | {"omega_b": s * 12.0, "misalignment": 0.01}))
                   for s in (1.0, -1.0))  # fmt: skip
    close(unit, "mirrored forces", left, right * (1.0, -1.0, 1.0, -1.0, -1.0, 1.0), 1e-7)


def test_rows_add_up(unit: Unit) -> None:
    """Two rows give the sum of two brushes with one row each."""
    parts = [(24.0, 0.0), (0.0, 16.0), (24.0, 16.0)]
    seen = [loads(run(unit, 0.02, H, NOMINAL | {"misalignment": 0.01}, row_tufts=(*tufts, *(0.0,) * 6)))
            for tufts in parts]  # fmt: skip
    close(unit, "forces and moments", seen[2], seen[0] + seen[1], 1e-12)


def test_canted_bristles_are_softer(unit: Unit) -> None:
    """Trailing bristles bend from the first touch and carry less."""
    straight, canted = (-unit.new(STILL, alpha=alpha)["F_z"] for alpha in (0.0, 0.2))
    holds(0.1 * straight < canted < straight, f"{canted:.4g} N with cant, {straight:.4g} N without")


def test_what_a_maker_must_know_follows_from_the_parameters(unit: Unit) -> None:
    """m_filaments is the mass of all rods, packing their section over the disc within the outermost row."""
    tufts, N_b, d, L, rho, R = values(unit, "row_tufts", "bristles_per_tuft", "d", "L", "rho", "R_brush")
    seen = unit.new({"omega_b": 10.0, "delta": 0.0})
    section = np.sum(tufts) * N_b * np.pi / 4.0 * d**2
    close(unit, "mass of the bristles", seen["m_filaments"], section * rho * L, 1e-14)
    close(unit, "packing", seen["packing"], section / (np.pi * R**2), 1e-14)


EXCITATION = Excitation(
    1e-3, 40,
    {"omega_b": (12.0, 6.0), "delta": (4e-3, 5e-3), "v_rov": (0.05, 0.1), "delta_dot": (0.0, 0.5),
     "friction_scale": (1.0, 0.3), "misalignment": (0.0, 0.02)},
    {"row_tufts": (8.0, 5.0) + (0.0,) * 6},
)  # fmt: skip
ESSENTIAL = "omega_b delta v_rov F_x F_z T_brush"
SUITE = suite(CupBrush, ESSENTIAL, EXCITATION, sys.modules[__name__], behaviour_energy)
