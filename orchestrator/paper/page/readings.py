"""Where the paper's equations had to be read differently, with the number that shows why; all from the FMUs' values."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..lab import Case, Lab

NO_LOAD_CURRENT = 2.0  # A, typical of a motor of this size


def readings(lab: Lab) -> list[tuple[str, str, str]]:
    """Rows (where, as printed, as computed here) of the nominal run."""
    case, idle = lab.case("nominal"), lab.case("no_load")
    value = case.parameter
    L, d, E, alpha, R_brush = (value(f"brush.{name}") for name in ("L", "d", "E", "alpha", "R_brush"))
    n, N_b = int(value("brush.n")), value("brush.bristles_per_filament")
    EI = E * math.pi * d**4 / 64.0
    euler = math.pi**2 * EI / (4.0 * L**2)
    share = 221.7 / n
    stall = 12.0 / value("motor.R") * value("motor.K_t")
    ratio, stages = value("motor.gear_ratio_per_stage"), int(value("motor.gear_stages"))
    split = split_friction(case, NO_LOAD_CURRENT)
    current = idle.mean("motor.i")
    contact = case.mean("brush.contact_count")
    printed = R_brush - (R_brush - L * math.cos(alpha))
    phases = sum(math.cos(2.0 * math.pi * i / n) for i in range(n))
    return [
        (
            "Table 2 with Table 3: one bristle per filament",
            f"221.7 N over {n} filaments is {share:.2f} N each, {share / euler:.0f} times the Euler load of a bristle, "
            f"$\\pi^2 E I / (4 L^2)$ = {1e3 * euler:.1f} mN.",
            f"A filament is a bundle of N_b = {N_b:g} equal bristles (calibrated).",
        ),
        (
            "The brush: rolling, or a cup",
            "'Rolling', Eqs. 10, 14, 15 and 125 Hz mean an axis along the hull; "
            "$T_{\\text{brush}} = R_{\\text{brush}} F_y$ and $F_y / F_z = \\mu$ "
            "fit one normal to it, with all tips sliding all the time.",
            "Both are computed: filament_brush (nominal, all claims) and cup_brush (cup_nominal, claim 10).",
        ),
        (
            "Eq. 8, penetration",
            f"R_brush cancels; what is left, $L \\cos \\alpha$, is {1e3 * printed:.0f} mm at rest.",
            "Penetration of the tip into the plane at $R_{\\text{brush}} - \\delta$, from the full geometry with "
            "foreshortening.",
        ),
        (
            "Eq. 7, normal force",
            "Jumps at first touch and can pull.",
            "Never negative; the damping term rises from zero over a small depth (0 gives the printed law).",
        ),
        (
            "Eq. 9, $\\text{sgn}(v_s)$",
            "Discontinuous where the tip sticks.",
            "Smoothed below v_eps; exact to 4e-4 beyond $5\\,v_{\\text{eps}}$.",
        ),
        (
            "Eqs. 11 and 12, sums over modes",
            "Converge slowly: in statics three modes give 1.207 of a load, four give 0.843.",
            "Static correction (mode acceleration), exact in statics; the plain sums can be selected.",
        ),
        (
            "Eq. 15, torque",
            f"With equal F_y the cosines of {n} uniform phases add up to {abs(phases):.0e}.",
            f"Moments of the contact forces about the axis; {contact:.1f} of {n} filaments touch at a time.",
        ),
        (
            "Eq. 17, gear ratio",
            f"With N_g = {ratio:g} once the stalled motor gives {stall * ratio:.1f} N.m, less than 16.63 N.m.",
            f"{stages} stages, N_g = {ratio**stages:.2f}.",
        ),
        (
            "Table 3, friction of the motor",
            f"One operating point fixes one number, B_m = {value('motor.B_m'):.3g} N.m.s/rad. It means {current:.0f} A "
            f"and {idle.mean('motor.P_electrical'):.0f} W off the hull.",
            f"As fitted. B_m = {split.B_m:.2e}, for a no-load current of {NO_LOAD_CURRENT:g} A, and gear_efficiency = "
            f"{split.gear_efficiency:.2f} go through the same point, with {split.omega_b:.1f} rad/s off the hull where "
            "the paper has 20.",
        ),
        (
            "Table 3, F_y and yaw/roll torque",
            "F_y opposes the rotation: in the tool frame it lies along the sweep; T_brush is about the brush axis.",
            "F_x along the sweep, T_brush about +y_t; with the brush under the vehicle it is a pitch moment.",
        ),
        (
            "Section 4.3, cross references",
            "Names Eqs. 21 and 12 for the coupling.",
            "Eqs. 17 and 10.",
        ),
    ]


@dataclass(frozen=True)
class Split:
    """Viscous damping and gear efficiency that share what the fitted B_m takes alone, and the speed without load."""

    B_m: float
    gear_efficiency: float
    omega_b: float


def split_friction(case: Case, no_load_current: float) -> Split:
    """B_m [N.m.s/rad] of a no-load current [A], and the efficiency that leads through the run's mean load and speed."""
    value = case.parameter
    R, K_t, K_e, V = value("motor.R"), value("motor.K_t"), value("motor.K_e"), case.mean("motor.V_in")
    N_g = value("motor.gear_ratio_per_stage") ** value("motor.gear_stages")
    free = (V - R * no_load_current) / K_e  # Eq. 16 at rest
    B_m = K_t * no_load_current / free
    speed = N_g * case.mean("motor.omega_b")
    driving = K_t * (V - K_e * speed) / R - B_m * speed
    return Split(B_m, -case.mean("brush.T_brush") / (N_g * driving), free / N_g)
