"""Claims about how the nominal run comes to its means: the paper's Figs. 3 and 4 (17, 18)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..lab import Case, Lab
from .claim import Check, Finding, at_least, at_most, claim
from .table3 import table_3

BAND = 0.05  # of the mean: the usual one of a settling time


@dataclass(frozen=True)
class Transient:
    """How a signal comes to its mean, by its average over a blade pass."""

    overshoot: float  # of the average beyond the mean, as a share of it
    settled: float  # s, after which the average stays within BAND of the mean
    spread: float  # of the average about the mean in the steady window, as a share of it


def transient(case: Case, name: str) -> Transient:
    """The average over a blade pass takes out the ripple, which goes on for ever."""
    signal, mean = case.signals[f"brush.{name}"], case.summary[f"{name}_mean"]
    samples = max(1, round(1.0 / (case.summary["blade_pass_hz"] * (signal.time[1] - signal.time[0]))))
    average = np.convolve(signal.values, np.full(samples, 1.0 / samples), mode="valid") / mean
    time = signal.time[samples - 1 :]  # the end of each average
    outside = np.flatnonzero(np.abs(average - 1.0) > BAND)
    settled = float(time[outside[-1]]) if len(outside) else 0.0
    spread = float(np.max(np.abs(average[time >= case.window[0]] - 1.0)))
    return Transient(float(np.max(average)) - 1.0, settled, spread)


def time_constants(case: Case) -> dict[str, float]:
    """What decays after the first touch [s]: the bristles' first mode, and the drive's speed under load."""
    N_g = case.parameter("motor.gear_ratio_per_stage") ** case.parameter("motor.gear_stages")
    J = case.parameter("motor.J_b") + N_g**2 * case.parameter("motor.J_m")
    back_emf = case.parameter("motor.K_t") * case.parameter("motor.K_e") / case.parameter("motor.R")
    return {
        "bristle": 1.0 / float(case.parameters("brush.zeta")[0] * case.calculated("brush.omega_r", 1)[0]),
        "drive": J / (N_g**2 * (back_emf + case.parameter("motor.B_m"))),
    }


def settles(case: Case, seen: Transient) -> Check:
    """Within three of the slower time constants, which leave 5 %."""
    limit = 3.0 * max(time_constants(case).values())
    why = "no time is printed: three time constants of what decays slowest leave 5 %"
    return at_most("settled within 5 % after", limit, seen.settled, "s", why)


def told(case: Case, seen: Transient, name: str) -> str:
    signal, constants = case.signals[f"brush.{name}"], time_constants(case)
    return (
        f"Averages over a blade pass: overshoot {100 * seen.overshoot:.1f} %, within 5 % after {seen.settled:.2f} s, "
        f"within {100 * seen.spread:.2g} % of the mean in the end. Time constants: bristle 1/(zeta omega_1) = "
        f"{constants['bristle']:.2f} s, drive {constants['drive']:.2f} s. Largest single value "
        f"{case.peak(f'brush.{name}'):.4g} {signal.unit}. The run begins at 20 rad/s: a part of the overshoot is the "
        "speed's."
    )


@claim(17, "F_z: transient impact, then settling to a mean of -221 N.", "Fig. 3")
def force_transient(lab: Lab) -> Finding:
    case = lab.case("nominal")
    seen = transient(case, "F_z")
    impact = "'transient impact', no height is printed: beyond the band in which it counts as settled"
    checks = (
        at_least("overshoot of the average over a blade pass", BAND, seen.overshoot, "1", impact),
        settles(case, seen),
        table_3(case, "F_z"),
    )
    return Finding(checks, told(case, seen, "F_z"), told(case, seen, "F_z"))


@claim(18, "T_brush opposes rotation and stabilises at about -16.63 N.m.", "Fig. 4")
def torque_transient(lab: Lab) -> Finding:
    case = lab.case("nominal")
    seen, torque = transient(case, "T_brush"), case.signals["brush.T_brush"]
    checks = (
        at_most("largest T_brush after the first touch", 0.0, float(np.max(torque.values[1:])), torque.unit,
                "'opposing the motor rotation', which is positive: at every instant"),
        settles(case, seen),
        table_3(case, "T_brush"),
    )  # fmt: skip
    return Finding(checks, told(case, seen, "T_brush"), told(case, seen, "T_brush"))
