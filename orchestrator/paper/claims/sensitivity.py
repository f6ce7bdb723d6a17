"""Claims about what the forces do when friction, damping or the number of modes change (7-9), and about steps (25)."""

from __future__ import annotations

import math

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
        checks.append(near(f"change of F_y at friction {sign * 20:+d} %", sign * 18.0, F_y, "%", 0.1))
        checks.append(near(f"change of T_brush over that of F_y at {sign * 20:+d} %", 1.0, T / F_y, "1", 0.1))
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
        checks.append(at_least(f"reduction of the peak of {name}", 0.0, cut, "%"))
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
    checks = tuple(
        at_most(f"change of the mean of {name}", 0.8, abs(change(four, three, key)), "%") for name, key in MEANS.items()
    )
    sums = [
        lab.stand({"brush.mode_acceleration": "false", "brush.N_m": modes}).mean("brush.F_y_eq11") for modes in (3, 4)
    ]
    return Finding(
        checks,
        note="Holds for the forces at the tips. The base shears summed as Eq. 11 is printed change by "
        f"{100 * abs(sums[1] / sums[0] - 1):.1f} % ({sums[0]:.0f} -> {sums[1]:.0f} N): that sum converges slowly.",
    )


@claim(25, "Runge-Kutta of fourth order with adaptive steps between 1e-4 and 1e-3 s.", "section 3.6")
def steps(lab: Lab) -> Finding:
    free, bounded = lab.case("nominal"), lab.case("nominal", {"brush.tolerance": 1e-5})
    difference = 100.0 * abs(bounded.summary["F_z_mean"] / free.summary["F_z_mean"] - 1.0)
    shortest, usual = bounded.last("brush.h_micro_min"), free.last("brush.h_micro_min")
    omega = float(free.calculated("brush.omega_r", 3)[2])
    heavy = lab.stand({"brush.friction_scale": 2.0}).last("brush.h_micro_min")
    return Finding(
        (
            at_least("shortest micro-step at tolerance 1e-5", 1e-4, shortest, "s"),
            at_most("longest micro-step allowed (h_max)", 1e-3, free.parameter("brush.h_max"), "s"),
            at_most("what these steps change in the mean F_z", 0.1, difference, "%"),
        ),
        f"contact stiffness and mode 3 bound a stable step below 1e-4 s: the shortest is {shortest:.3g} s",
        f"At the default tolerance, ten times finer, error control goes down to {usual:.3g} s, at twice the friction "
        f"to {heavy:.2g} s; {free.last('brush.micro_steps'):.0f} micro-steps were made in {free.run.end:g} s. The "
        f"upper end, 1e-3 s, is not stable with three modes: omega_3 h = {omega * 1e-3:.2f} > 2.78, the limit of the "
        f"method; steps stay below {2.7 / omega:.2g} s.",
    )
