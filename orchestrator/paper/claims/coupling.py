"""Claims about motor and brush together: a constant speed, and the energy at every level (22, 24)."""

from __future__ import annotations

import numpy as np

from ..energy_flow import stored_in_brush
from ..lab import Case, Lab
from .claim import Finding, at_least, at_most, claim

FOULED, STUCK = 2.0, 4.0  # friction_scale; at the second, the least whole number, all touching tips stick at times


def slowest_sliding(case: Case) -> float:
    """The least speed [m/s] of the touching tips, weighted by their friction, over the run."""
    lost, force = case.signals["brush.P_friction"].values, -case.signals["brush.F_x"].values
    touching = force > 1e-3 * np.max(force)
    return float(np.min(lost[touching] / force[touching]))


@claim(22, "A model with constant speed overestimates friction forces when stiction happens.", "section 6.4")
def constant_speed(lab: Lab) -> Finding:
    usual, fouled, stuck = (lab.stand({"brush.friction_scale": s} if s > 1.0 else {}) for s in (1.0, FOULED, STUCK))
    ideal = {s: lab.case("constant_speed", {"brush.friction_scale": s}, "10 s") for s in (1.0, FOULED, STUCK)}
    mu_s, v_eps = usual.parameter("brush.mu_s"), usual.parameter("brush.v_eps")

    def excess(scale: float, real: Case, key: str) -> float:
        return float(100.0 * (ideal[scale].summary[key] / real.summary[key] - 1.0))

    condition = "v_eps: below it Eq. 9, smoothed, creeps, which is how this model sticks"
    more = "'overestimates': more than the paper itself counts as no change (claim 9)"
    forces = f"F_y {stuck.summary['F_x_mean']:.1f} -> {ideal[STUCK].summary['F_x_mean']:.1f} N"
    slowest, less = (slowest_sliding(case) for case in (usual, fouled))
    speeds = f"{fouled.summary['omega_b_mean']:.1f} against {ideal[FOULED].summary['omega_b_mean']:.1f} rad/s"
    return Finding(
        (
            at_most(
                f"slowest sliding at {STUCK:g} times the friction", v_eps, slowest_sliding(stuck), "m/s", condition
            ),
            at_least("excess of F_y there", 0.8, excess(STUCK, stuck, "F_x_mean"), "%", more),
            at_least("excess of T_brush there", 0.8, excess(STUCK, stuck, "T_brush_mean"), "%", more),
        ),
        f"real motor -> constant speed: {forces}",
        f"The paper's set never sticks: tips slide at {slowest:.1f} m/s or faster, {slowest / v_eps:.0f} v_eps, and "
        f"the two models differ by {excess(1.0, usual, 'F_x_mean'):+.2f} % in F_y. Nor at twice the friction "
        f"({less:.2f} m/s): the excess there, {excess(FOULED, fouled, 'F_x_mean'):.1f} % in F_y, comes of forces that "
        f"grow with speed, {speeds}, and is no stiction. Tips stick at {STUCK:g} times the friction, mu_s = "
        f"{STUCK * mu_s:g}, where the motor is down to {stuck.summary['omega_b_mean']:.1f} rad/s: {forces}.",
    )


LOSSES = (  # of motor and brush
    "motor.W_copper",
    "motor.W_friction",
    "motor.W_gear",
    "brush.W_friction",
    "brush.W_damping",
    "brush.W_contact",
    "brush.W_water",
)


@claim(24, "Energy is conserved at every level of the hierarchy.", "section 6.3")
def energy(lab: Lab) -> Finding:
    one, case = lab.stand({"brush.n": 1}), lab.case("nominal")
    battery = case.last("motor.W_electrical")
    lost = sum(case.last(name) for name in LOSSES)
    unaccounted = battery + case.last("brush.W_hull") - lost - case.rise("motor.E_stored") - stored_in_brush(case)
    vehicle = max(abs(case.last(f"vehicle.W_{name}")) for name in ("tool", "thruster", "damping"))
    levels = {
        "one filament: residual over hub work": one.last("brush.energy_residual") / one.last("brush.W_hub"),
        "brush: residual over hub work": case.last("brush.energy_residual") / case.last("brush.W_hub"),
        "motor: residual over battery energy": case.last("motor.energy_residual") / battery,
        "vehicle: residual over its largest work": case.last("vehicle.energy_residual") / vehicle,
        "coupling: energy made at the shaft over what it carries": case.summary["coupling_energy_relative"],
        "whole: battery + hull - losses - stored, over battery": unaccounted / battery,
    }
    closed = lab.case("hull_pass_paper").summary["energy_balance_relative"]
    levels["closed loop: supplied + coupling - losses - stored, over supplied"] = closed
    checks = tuple(
        at_most(name, 1e-2, abs(value), "1", "controller and vehicle exchange every 20 and 5 ms: ten times the others")
        if value is closed
        else at_most(name, 1e-3, abs(value), "1", "'conserved': an eighth of the least change that the paper tells of")
        for name, value in levels.items()
    )
    return Finding(
        checks,
        "; ".join(f"{name} {value:.2g}" for name, value in levels.items()),
        f"Nominal run, {case.run.end:g} s: battery {battery:.0f} J, losses {lost:.0f} J, unaccounted "
        f"{unaccounted:.3g} J.",
    )
