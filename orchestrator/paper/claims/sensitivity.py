"""Claims about what the forces do when friction, damping or the number of modes change (7-9), and about steps (25)."""

from __future__ import annotations

import math

from scipy.optimize import brentq

from ..lab import Case, Lab
from .claim import Check, Finding, at_least, at_most, claim, near

MEANS = {"F_z": "F_z_mean", "F_y": "F_x_mean", "T_brush": "T_brush_mean"}


def change(case: Case, base: Case, key: str) -> float:
    """Relative change of a summary value [%]."""
    return float(100.0 * (case.summary[key] / base.summary[key] - 1.0))


@claim(7, "Friction +-20 % shifts F_y by +-18 % and T_brush in proportion; F_z varies by less than 5 %.", "section 6.2")
def friction(lab: Lab) -> Finding:
    base = lab.stand()
    less, more = (lab.stand({"brush.friction_scale": scale}) for scale in (0.8, 1.2))
    checks: list[Check] = []
    for sign, case in ((-1, less), (1, more)):
        F_y, T = (change(case, base, MEANS[name]) for name in ("F_y", "T_brush"))
        name, allowed = f"{sign * 20:+d} %", "two digits (3 %), and whether the speed is held is not said"
        checks.append(near(f"change of F_y at friction {name}", sign * 18.0, F_y, "%", 0.1, allowed))
        checks.append(near(f"change of T_brush over that of F_y at {name}", 1.0, T / F_y, "1", 0.1, "as for F_y"))
    F_z = [change(case, base, "F_z_mean") for case in (less, more)]
    checks.append(at_most("largest change of F_z", 5.0, max(abs(c) for c in F_z), "%"))
    ratios = [
        100.0 * ((1 + 0.01 * change(case, base, "F_x_mean")) / (1 + 0.01 * change(case, base, "F_z_mean")) - 1.0)
        for case in (less, more)
    ]
    return Finding(
        tuple(checks),
        f"F_y/F_z moves by {ratios[0]:+.1f} and {ratios[1]:+.1f} %, since the viscous part of Eq. 9 does not scale; "
        f"F_z itself follows friction by {F_z[0]:+.1f} and {F_z[1]:+.1f} %, since it turns the raked tips into the "
        f"hull; the product is F_y {change(less, base, 'F_x_mean'):+.1f} and {change(more, base, 'F_x_mean'):+.1f} %",
        "friction_scale multiplies mu_s and mu_c; the motor slows down as it would, which holds the changes back.",
    )


@claim(
    8, "Damping 0.01 to 0.05: peak transients down by up to 30 %, steady state changes less than 4 %.", "section 6.2"
)
def damping(lab: Lab) -> Finding:
    low, high = (lab.stand({"brush.zeta": [zeta] * 6}) for zeta in (0.01, 0.05))
    checks = []
    for name in ("F_z", "T_brush"):
        cut = 100.0 * (1.0 - high.peak(f"brush.{name}") / low.peak(f"brush.{name}"))
        checks.append(at_least(f"reduction of the peak of {name}", 0.0, cut, "%", "'up to': down, not up"))
        checks.append(at_most(f"reduction of the peak of {name}", 30.0, cut, "%"))
    for name, key in MEANS.items():
        checks.append(at_most(f"change of the mean of {name}", 4.0, abs(change(high, low, key)), "%"))
    omega, turn = float(low.calculated("brush.omega_r", 1)[0]), 2.0 * math.pi / low.summary["omega_b_mean"]
    left = [math.exp(-zeta * omega * turn) for zeta in (0.01, 0.05)]
    return Finding(
        tuple(checks),
        f"after one turn ({turn:.2f} s) exp(-zeta omega_1 t) = {left[0]:.2f} of a bristle's vibration is left at zeta "
        f"= 0.01 and {left[1]:.2f} at 0.05, so how it enters the next pass changes: mean F_z "
        f"{low.summary['F_z_mean']:.1f} -> {high.summary['F_z_mean']:.1f} N, {abs(change(high, low, 'F_z_mean')):.1f} "
        "%",
        "Peaks are the largest magnitudes of the whole run, from the first touch on.",
    )


@claim(9, "A fourth mode changes the steady-state forces by less than 0.8 %.", "section 6.2")
def fourth_mode(lab: Lab) -> Finding:
    three, four = lab.stand(), lab.stand({"brush.N_m": 4})
    tips = {name: abs(change(four, three, key)) for name, key in MEANS.items()}
    sums = [
        lab.stand({"brush.mode_acceleration": "false", "brush.N_m": modes}).mean("brush.F_y_eq11") for modes in (3, 4)
    ]
    summed = 100.0 * abs(sums[1] / sums[0] - 1.0)
    return Finding(
        (
            at_most(
                "forces at the tips: largest change of the means of F_z, F_y, T_brush", 0.8, max(tips.values()), "%"
            ),
            at_most("the paper's F_y, sum of base shears by Eq. 11: change of the mean", 0.8, summed, "%"),
        ),
        f"Eq. 11 sums modes, and that sum converges slowly: of a load at rest three modes give 1.207, four 0.843; here "
        f"{sums[0]:.0f} -> {sums[1]:.0f} N, {summed:.1f} %",
        f"Forces at the tips, which this model passes on: {', '.join(f'{k} {v:.3f} %' for k, v in tips.items())}. "
        "Eq. 11 is what the paper calls F_y.",
    )


def stable(zeta: float) -> float:
    """The largest omega h at which classical Runge-Kutta lets a mode with damping ratio zeta not grow."""
    direction = complex(-zeta, math.sqrt(1.0 - zeta**2))

    def growth(x: float) -> float:
        z = x * direction
        return abs(1.0 + z + z**2 / 2.0 + z**3 / 6.0 + z**4 / 24.0) - 1.0

    return float(brentq(growth, 2.6, 3.2))


@claim(25, "Runge-Kutta of fourth order with adaptive steps between 1e-4 and 1e-3 s.", "section 3.6")
def steps(lab: Lab) -> Finding:
    case, loose = lab.case("nominal"), lab.stand({"brush.tolerance": 1e-5})
    shortest, longest = case.last("brush.h_micro_min"), case.parameter("brush.h_max")
    heavy = lab.stand({"brush.friction_scale": 2.0}).last("brush.h_micro_min")
    omega = float(case.calculated("brush.omega_r", 3)[2])
    limits = {zeta: f"{stable(zeta):.2f}" for zeta in (0.0, 0.01, 0.02)}
    return Finding(
        (
            at_least("shortest micro-step of the nominal run", 1e-4, shortest, "s"),
            at_most("longest micro-step allowed (h_max)", 1e-3, longest, "s"),
            at_most("omega_3 times 1e-3 s", stable(0.0), omega * 1e-3, "1", "beyond, an undamped mode grows"),
        ),
        f"contact asks for {shortest:.3g} s, below 1e-4 s; at 1e-3 s mode 3 has omega h = {omega:.0f} x 1e-3 = "
        f"{omega * 1e-3:.2f}, where the method is stable up to {limits[0.0]} without damping, {limits[0.01]} with zeta "
        f"= 0.01, {limits[0.02]} with 0.02",
        f"Order and error control are the paper's; the two ends of its range are not. Ten times the tolerance keeps "
        f"steps at {loose.last('brush.h_micro_min'):.3g} s or longer and changes the mean F_z on the test stand by "
        f"{abs(change(loose, lab.stand(), 'F_z_mean')):.1g} %, but a tolerance is not chosen for that. At twice the "
        f"friction steps go down to {heavy:.2g} s. {case.last('brush.micro_steps'):.0f} micro-steps were made in "
        f"{case.run.end:g} s, all below {2.7 / omega:.2g} s.",
    )
