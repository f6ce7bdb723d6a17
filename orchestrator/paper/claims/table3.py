"""Claims about the nominal run: Table 3, its torque balance, and its speeds (6, 10-16)."""

from __future__ import annotations

import numpy as np

from ...results.summary.summary import comparison
from ..lab import Case, Lab
from .claim import Check, Finding, at_most, claim, near

DEFAULT_TOLERANCE = 0.05  # where the system file states none


REASONS = {  # for the tolerances
    "F_z": "fitted exactly; 1 % is less than any doubt that the claims name",
    "omega_b": "fitted exactly; printed to 0.6 %",
    "F_y": "fitted with T_brush, which contradicts it by 2.2 % (claim 10)",
    "T_brush": "fitted with F_y, which contradicts it by 2.2 % (claim 10)",
    "q": "printed to two digits, 3 %",
}


def table_3(case: Case, label: str) -> Check:
    """A row of Table 3 with the tolerance that the system file states."""
    row = next(r for r in comparison(case.run, dict(case.summary)) if r["label"] == label)
    tolerance = row.get("tolerance", DEFAULT_TOLERANCE)
    return near(f"mean {label}", row["reference"], row["value"], row["unit"], tolerance, REASONS[label], row["key"])


@claim(6, "Blade-pass frequency 125 Hz at 15.7 rad/s.", "section 3.5")
def blade_pass(lab: Lab) -> Finding:
    case = lab.case("nominal")
    n, speed = case.parameter("brush.n"), case.summary["omega_b_mean"]
    digits = "printed to 0.4 %, the speed it follows from to 0.6 %"
    return Finding(
        (
            near("strongest line in the spectrum of F_z", 125.0, case.summary["blade_pass_hz"], "Hz", 0.01, digits),
            near("n omega_b/(2 pi)", 125.0, n * speed / (2 * np.pi), "Hz", 0.01, digits),
        )
    )


@claim(10, "T_brush equals R_brush F_y within 0.15 %.", "section 6.3")
def torque_balance(lab: Lab) -> Finding:
    case, cup = lab.case("nominal"), lab.case("cup_nominal")
    F_z, F_x, T = (abs(case.summary[key]) for key in ("F_z_mean", "F_x_mean", "T_brush_mean"))
    T_cup, F_y = abs(cup.summary["T_brush_mean"]), abs(cup.summary["F_y_mean"])
    R_cup, y = cup.parameter("brush.R_brush"), cup.parameter("brush.L") * cup.summary["max_deflection_ratio"]
    R, delta = case.parameter("brush.R_brush"), float(case.run.plan.system.components["brush"].inputs["delta"])
    arm = (T - (R - delta) * F_x) / F_z
    printed = 100.0 * abs(0.15 * 110.9 / 16.63 - 1.0)
    return Finding(
        (
            at_most("rolling brush: T_brush and R_brush F_y differ by", 0.15, 100.0 * abs(T / (R * F_x) - 1.0), "%"),
            at_most("cup brush: they differ by", 0.15, 100.0 * abs(T_cup / (R_cup * F_y) - 1.0), "%"),
        ),
        f"friction acts at R_brush - delta and the normal force ahead of the axis: {R - delta:.3f} m x {F_x:.1f} N + "
        f"{1e3 * arm:.1f} mm x {F_z:.1f} N = {T:.2f} N.m, while R_brush F_y = {R * F_x:.2f} N.m; the printed pair "
        f"(0.15 m x 110.9 N = {0.15 * 110.9:.3f} N.m) agrees to {printed:.2f} %, as a product of itself does",
        "A rolling brush cannot meet both by one set of forces. A cup brush, its axis normal to the hull, does by its "
        f"geometry: tips slide in circles of R_brush and friction has no other arm, {R_cup:g} m x {F_y:.1f} N = "
        f"{T_cup:.2f} N.m, where F_y is the friction of all tufts added as numbers (as vectors "
        f"{cup.mean('brush.F_x'):.1f} N are left). Tips trail their roots by {1e3 * y:.0f} mm: "
        "with the roots on R_brush the torque would be "
        f"{100 * (1 - np.sqrt(1 - (y / R_cup) ** 2)):.1f} % less.",
    )


@claim(11, "Steady normal force F_z = -221.7 N.", "Table 3")
def normal_force(lab: Lab) -> Finding:
    return Finding((table_3(lab.case("nominal"), "F_z"),))


@claim(12, "Steady brush torque T_brush = -16.63 N.m.", "Table 3")
def brush_torque(lab: Lab) -> Finding:
    note = "F_y and T_brush contradict each other (claim 10); the fit shares the difference."
    return Finding((table_3(lab.case("nominal"), "T_brush"),), note=note)


@claim(13, "Steady tangential force F_y = -110.9 N.", "Table 3")
def tangential_force(lab: Lab) -> Finding:
    return Finding((table_3(lab.case("nominal"), "F_y"),), note="F_y of the paper is F_x in the tool frame.")


@claim(14, "Loaded brush speed 15.7 rad/s.", "Table 3")
def loaded_speed(lab: Lab) -> Finding:
    return Finding((table_3(lab.case("nominal"), "omega_b"),), note="Fitted through the motor's viscous damping B_m.")


@claim(15, "Steady induced pitch rate q = -0.17 rad/s.", "Table 3")
def pitch_rate(lab: Lab) -> Finding:
    case = lab.case("nominal")
    linear, square = case.parameters("vehicle.D_moment")[1], case.parameters("vehicle.D_moment_quadratic")[1]
    moment, T = 0.17 * (linear + square * 0.17), abs(case.summary["T_brush_mean"])
    return Finding(
        (table_3(case, "q"),),
        f"a steady rate of 0.17 rad/s needs a net moment of 0.17 ({linear:g} + {square:g} x 0.17) = {moment:.3f} N.m, "
        f"{100 * moment / T:.1f} % of T_brush = {T:.1f} N.m, and turns the vehicle over every {2 * np.pi / 0.17:.0f} "
        "s; a controlled attitude has mean rate 0",
        f"Largest pitch rate at first touch: {case.summary['pitch_rate_peak']:.2f} rad/s. It depends on r_tool, which "
        "the paper does not give.",
    )


@claim(16, "The speed drops from 20 rad/s without load to 15.7 rad/s.", "section 6.4")
def speed_drop(lab: Lab) -> Finding:
    case, free = lab.case("nominal"), lab.case("no_load")
    R, K_t, V = case.parameter("motor.R"), case.parameter("motor.K_t"), 12.0
    N_g = case.parameter("motor.gear_ratio_per_stage") ** case.parameter("motor.gear_stages")
    drop = R * 16.63 / (N_g * V * K_t)
    return Finding(
        (
            near(
                "speed without load", 20.0, free.summary["omega_b_mean"], "rad/s", 0.02, "printed to two digits, 2.5 %"
            ),
            near(
                "speed under load",
                15.7,
                case.summary["omega_b_mean"],
                "rad/s",
                0.01,
                REASONS["omega_b"],
                "omega_b_mean",
            ),
        ),
        f"Eqs. 16 and 17 give a relative drop R T/(N_g V K_t) = {R:g} x 16.63/({N_g:.2f} x {V:g} x {K_t:g}) = "
        f"{drop:.3f} whatever B_m is: 15.7 rad/s under load means {15.7 / (1 - drop):.2f} without, not 20",
        "The drop itself, by back-EMF, is there.",
    )
