"""What a system file asks to be reported of a run: figures of merit over a steady window, and comparisons.

    [summary]
    window = { angle = "brush.theta_b", start = 5.0 }   # whole turns of an angle, as many as fit behind `start` [s]
    F_z_mean = "mean brush.F_z"                         # mean | peak | max | min | last, then a signal

Means are time averages over the window; peak is the largest magnitude of the whole run, max and min likewise.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from .energy import ledger
from .errors import InputError, nearest
from .process import peak_memory
from .signals import Signals
from .simulation import Run

OPERATIONS = ("mean", "peak", "max", "min", "last")


def check_summary(run_or_plan_names: set[str], reporting: Mapping[str, Any], origin: str) -> None:
    """Raise InputError before the run for a figure of merit that could not be computed after it."""
    for key, text in reporting["summary"].items():
        if key == "window":
            names = [text["angle"]] if "angle" in text else []
        else:
            operation, _, name = str(text).partition(" ")
            if operation not in OPERATIONS:
                raise InputError(f"{origin}: summary {key} = {text!r}: unknown operation '{operation}'{nearest(operation, OPERATIONS)}")
            names = [name]
        for name in names:
            if name not in run_or_plan_names:
                raise InputError(f"{origin}: summary {key} = {text!r}: '{name}' is not recorded{nearest(name, run_or_plan_names)}")


def steady_window(signals: Signals, window: Mapping[str, Any]) -> tuple[float, float, float]:
    """Begin and end of the window [s] and the number of whole turns in it (0 where no angle is given)."""
    end = signals.run.end
    begin = min(float(window.get("start", 0.0)), end)
    if "angle" not in window or end <= begin:
        return begin, end, 0
    angle = signals[window["angle"]]
    turned = abs(np.interp(end, angle.time, angle.values) - np.interp(begin, angle.time, angle.values))
    turns = math.floor(turned / (2 * math.pi))
    if turns == 0:
        return begin, end, 0
    target = abs(angle.values[-1]) - 2 * math.pi * turns
    return float(np.interp(target, np.abs(angle.values), angle.time)), end, turns


def summarize(run: Run) -> dict[str, Any]:
    """All figures of merit of a run, as JSON-ready numbers; incomplete runs say so."""
    signals = Signals(run)
    specification = dict(run.plan.system.reporting["summary"])
    begin, end, turns = steady_window(signals, specification.pop("window", {}))
    result: dict[str, Any] = {"complete": not run.failure}
    if run.failure:
        result["failure"] = run.failure
    for key, text in specification.items():
        operation, _, name = str(text).partition(" ")
        signal = signals[name]
        value = {
            "mean": lambda s=signal: s.mean(begin, end),
            "peak": lambda s=signal: s.values[np.argmax(np.abs(s.values))],
            "max": lambda s=signal: s.values.max(),
            "min": lambda s=signal: s.values.min(),
            "last": lambda s=signal: s.values[-1],
        }[operation]()  # fmt: skip
        result[key] = float(value)
    ledgers = [ledger(signals, bond) for bond in run.plan.system.bonds]
    if ledgers:
        carried = max(max(abs(x.effort_side), abs(x.flow_side)) for x in ledgers)
        result["coupling_energy_relative"] = max(abs(x.made) for x in ledgers) / carried if carried else 0.0
        result["coupling_energy"] = {x.name: {"effort_side_J": x.effort_side, "flow_side_J": x.flow_side, "made_J": x.made} for x in ledgers}
    result["window_s"] = [begin, end]
    result["window_turns"] = turns
    clock = run.plan.clock
    result["macro_steps"] = round(run.end / clock.time(min(clock.periods.values())))
    result |= {"simulated_s": run.end, "wall_s": run.wall, "real_time_factor": run.end / run.wall if run.wall else 0.0}
    return result | {"start_s": run.start, "peak_memory_MB": peak_memory()}


def comparison(run: Run, summary: Mapping[str, Any]) -> list[dict[str, Any]]:
    """One row per `[[compare]]` entry: label, unit, reference, value, ratio, and whether it is within its tolerance."""
    rows = []
    for entry in run.plan.system.reporting["compare"]:
        value, reference = summary[entry["value"]], float(entry["reference"])
        ratio = value / reference if reference else math.nan
        tolerance = entry.get("tolerance")
        within = None if tolerance is None else bool(abs(ratio - 1) <= tolerance)
        rows.append({**entry, "key": entry["value"], "value": value, "ratio": ratio, "within": within})
    return rows
