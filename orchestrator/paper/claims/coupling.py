"""Claims about motor and brush together: a constant speed, and the energy at every level (22, 24)."""

from __future__ import annotations

from ..energy_flow import stored_in_brush
from ..lab import Lab
from .claim import Finding, at_least, at_most, claim

STICTION = 2.0  # friction_scale of a patch that holds


@claim(22, "A model with constant speed overestimates friction forces when stiction happens.", "section 6.4")
def constant_speed(lab: Lab) -> Finding:
    real = lab.stand({"brush.friction_scale": STICTION})
    ideal, usual = (lab.case("constant_speed", {"brush.friction_scale": s}, "10 s") for s in (STICTION, 1.0))
    checks, seen = [], []
    for name, key in (("F_y", "F_x_mean"), ("T_brush", "T_brush_mean")):
        excess = 100.0 * (ideal.summary[key] / real.summary[key] - 1.0)
        checks.append(at_least(f"excess of {name} at twice the friction", 5.0, excess, "%"))
        seen.append(f"{name} {real.summary[key]:.1f} -> {ideal.summary[key]:.1f}")
    same = 100.0 * (usual.summary["F_x_mean"] / lab.stand().summary["F_x_mean"] - 1.0)
    return Finding(
        tuple(checks),
        f"constant speed changes {', '.join(seen)}",
        f"Friction doubled: the motor slows to {real.summary['omega_b_mean']:.1f} rad/s; real motor -> constant "
        f"speed: {', '.join(seen)}. At nominal friction and the same speed the two differ by {same:+.2f} % in F_y.",
    )


LOSSES = (  # of motor and brush
    "motor.W_copper",
    "motor.W_friction",
    "motor.W_gear",
    "brush.W_friction",
    "brush.W_damping",
    "brush.W_contact",
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
    checks = tuple(at_most(name, 1e-2 if value is closed else 1e-3, abs(value), "1") for name, value in levels.items())
    return Finding(
        checks,
        "; ".join(f"{name} {value:.2g}" for name, value in levels.items()),
        f"Nominal run, {case.run.end:g} s: battery {battery:.0f} J, losses {lost:.0f} J, unaccounted "
        f"{unaccounted:.3g} J.",
    )
