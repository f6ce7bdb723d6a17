"""Claims about brush and vehicle together: buoyancy, thrust, losing the hull (19, 20, 23)."""

from __future__ import annotations

import numpy as np

from ..lab import Case, Lab
from ..theory.references import thruster
from .claim import Finding, at_least, at_most, claim, near


@claim(19, "The normal force is around 24 times the net buoyancy.", "section 6.4")
def buoyancy(lab: Lab) -> Finding:
    case = lab.case("nominal")
    F_z, net = abs(case.summary["F_z_mean"]), case.parameter("vehicle.net_buoyancy")
    return Finding(
        (near("F_z over net buoyancy", 24.0, F_z / net, "1", 0.05, "'around' a number of two digits (2 %), doubled"),),
        f"{F_z:.1f} N / {net:g} N = {F_z / net:.0f}; 24 would need a net buoyancy of {F_z / 24:.1f} N, Table 2 says "
        "0.3 N",
    )


def authority(case: Case, forward: float = 0.0, reverse: float = 0.0) -> dict[str, float]:
    """Largest force [N] of all thrusters at full command along surge, sway and heave, the better sense of each.

    `forward`, `reverse`: full thrust [N] of one thruster; the vehicle FMU's by default.
    """
    direction = case.parameters("vehicle.thruster_direction").reshape(-1, 3)
    forward, reverse = (
        forward or case.parameter("vehicle.k_T_forward"),
        reverse or case.parameter("vehicle.k_T_reverse"),
    )
    ahead, back = np.maximum(direction, 0.0).sum(axis=0), np.maximum(-direction, 0.0).sum(axis=0)
    best = np.maximum(forward * ahead + reverse * back, forward * back + reverse * ahead)
    return dict(zip(("surge", "sway", "heave"), best.tolist(), strict=True))


@claim(20, "Forces up to 221 N, more than twice the vehicle's thrust in some directions.", "abstract")
def thrust(lab: Lab) -> Finding:
    case = lab.case("nominal")
    F_z, forces = abs(case.summary["F_z_mean"]), authority(case)
    _, published = thruster(12)
    table = authority(case, float(published.max()), float(-published.min()))
    return Finding(
        (at_least("F_z over the thrust in the weakest direction", 2.0, F_z / min(forces.values()), "1", "'twice'"),),
        f"thrust of {', '.join(f'{name} {value:.1f} N' for name, value in forces.items())}",
        f"Thrust at 12 V, all thrusters at full command: {', '.join(f'{k} {v:.1f} N' for k, v in forces.items())}. "
        f"F_z acts in heave, where the ratio is {F_z / forces['heave']:.2f}. With the thrust table instead of the "
        "fitted curve: "
        f"{', '.join(f'{k} {v:.1f} N (ratio {F_z / v:.2f})' for k, v in table.items())}.",
    )


@claim(23, "Without active thrust the vehicle separates from the hull and loses contact.", "section 6.4")
def separation(lab: Lab) -> Finding:
    case, held = lab.case("no_thrust"), lab.case("hull_pass_paper")
    delta, force = case.signals["vehicle.delta"], case.signals["brush.F_z"]
    gap, end = -float(delta.values[-1]), case.run.end
    heave = authority(lab.case("nominal"))["heave"]
    return Finding(
        (
            at_least("distance between brush and hull at the end", 0.0, gap, "m", "'separates': the brush is clear"),
            at_most(
                "time in contact", 0.5 * end, case.summary["contact_time"], "s", "off for the longer part of the run"
            ),
            at_most(
                "mean |F_z| in the last fifth of the run",
                1.0,
                abs(force.mean(0.8 * end, end)),
                "N",
                "'loses contact': half a percent of the nominal load",
            ),
        ),
        f"{gap:.3f} m from the hull after {end:g} s, {case.summary['contact_time']:.2f} s of them in contact",
        f"Let go at the nominal penetration, the brush pushes the vehicle off within {1e3 * departure(case):.0f} ms. "
        f"Thrust alone does not help either while F_z is {abs(lab.case('nominal').summary['F_z_mean']):.0f} N: full "
        f"heave is {heave:.0f} N. In the closed loop the controller holds the hull for "
        f"{held.summary['contact_time']:.1f} s with {abs(held.summary['F_z_mean']):.0f} N.",
    )


def departure(case: Case) -> float:
    """When the undeformed brush is first clear of the hull [s]; infinite if it never is."""
    delta = case.signals["vehicle.delta"]
    clear = np.flatnonzero(delta.values < 0.0)
    return float(delta.time[clear[0]]) if len(clear) else np.inf
