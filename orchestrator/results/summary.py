"""What a system file asks to be reported of a run: figures of merit over a steady window, and comparisons.

    [summary]
    window = { angle = "motor.angle", start = 5.0 }   # whole turns of an angle, as many as fit behind `start` [s]
    load_mean = "mean motor.load"                     # an operation and its signals

`window` may have an `end` [s] too; that of a run that ends at `start` or before is its second half. Over the window:
`mean`, the time average; `rms`; `frequency`, the strongest line of the spectrum [Hz]. Over the whole run: `peak`, the
largest magnitude; `max`; `min`; `last`; `ratio a b`, the magnitude of a over that of b, both at the end; `positive`,
for how long it is above 0 [s].

    [balance]                                           # energies that components count, over the whole run
    supplied = ["motor.W_electrical"]                   # and `lost`, `stored`; what the bonds made is added
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import InputError, nearest
from ..plan.algorithms.registry import algorithm_of
from ..processes import peak_memory
from ..system.model import System
from .energy import balance, ledger, over_limits
from .signals import Signal, Signals
from .tables import Run

OPERATIONS = {
    "mean": 1, "rms": 1, "frequency": 1, "peak": 1, "max": 1, "min": 1, "last": 1, "ratio": 2, "positive": 1,
}  # and how many signals  # fmt: skip


def check_summary(run_or_plan_names: set[str], reporting: Mapping[str, Any], origin: str) -> None:
    """Raise InputError before the run for a figure of merit that could not be computed after it."""
    for key, names in reporting["balance"].items():
        if key not in ("supplied", "lost", "stored") or not isinstance(names, list):
            raise InputError(f"{origin}: balance {key}: lists named supplied, lost and stored are allowed")
        for name in names:
            if name not in run_or_plan_names:
                raise InputError(f"{origin}: balance {key}: '{name}' is not recorded{nearest(name, run_or_plan_names)}")
    for key, text in reporting["summary"].items():
        if key == "window":
            names = [text["angle"]] if "angle" in text else []
        else:
            operation, *names = str(text).split()
            if operation not in OPERATIONS:
                raise InputError(
                    f"{origin}: summary {key} = {text!r}: unknown operation '{operation}'"
                    f"{nearest(operation, OPERATIONS)}"
                )
            if len(names) != OPERATIONS[operation]:
                raise InputError(
                    f"{origin}: summary {key} = {text!r}: {operation} takes {OPERATIONS[operation]} signals"
                )
        for name in names:
            if name not in run_or_plan_names:
                raise InputError(
                    f"{origin}: summary {key} = {text!r}: '{name}' is not recorded{nearest(name, run_or_plan_names)}"
                )


def steady_window(signals: Signals, window: Mapping[str, Any]) -> tuple[float, float, int, bool]:
    """Begin and end of the window [s], the number of whole turns in it (0 where no angle is given), if it is steady.

    A run that ends before its window begins, or before a whole turn in it, is a transient: the window is its second
    half then.
    """
    end = signals.run.end
    begin = float(window.get("start", 0.0))
    if "end" in window and begin < float(window["end"]) < end:
        end = float(window["end"])
    steady = begin < end or not window
    if begin >= end:  # a run that was made shorter, or ended early
        begin = end / 2
    if "angle" not in window or end <= begin:
        return begin, end, 0, steady
    angle = signals[window["angle"]]
    turned = abs(np.interp(end, angle.time, angle.values) - np.interp(begin, angle.time, angle.values))
    turns = math.floor(turned / (2 * math.pi))
    if turns == 0:
        return begin, end, 0, False
    target = abs(np.interp(end, angle.time, angle.values)) - 2 * math.pi * turns
    return float(np.interp(target, np.abs(angle.values), angle.time)), end, turns, steady


def summarize(run: Run) -> dict[str, Any]:
    """All figures of merit of a run, as JSON-ready numbers; incomplete runs say so."""
    signals = Signals(run)
    specification = dict(run.plan.system.reporting["summary"])
    window = specification.pop("window", {})
    begin, end, turns, steady = steady_window(signals, window)
    result: dict[str, Any] = {"complete": not run.failure}
    if run.failure:
        result["failure"] = run.failure
    if run.notes:
        result["notes"] = list(run.notes)
    for key, text in specification.items():
        operation, *names = str(text).split()
        result[key] = figure_of_merit(operation, [signals[name] for name in names], begin, end)
    ledgers = [ledger(signals, bond) for bond in run.plan.system.bonds]
    if ledgers:
        carried = max(x.carried for x in ledgers)
        result["coupling_energy_relative"] = max(abs(x.made) for x in ledgers) / carried if carried else 0.0
        result["coupling_energy"] = {
            x.name: {
                "effort_side_J": x.effort_side, "flow_side_J": x.flow_side, "made_J": x.made,
                "within": not over_limits([x], [bond]),
            } for x, bond in zip(ledgers, run.plan.system.bonds, strict=True)
        }  # fmt: skip
    entry = run.plan.system.reporting["balance"]
    if entry:
        books = balance(signals, entry, ledgers)
        result["energy_balance_relative"] = books.relative
        result["energy_balance"] = {
            f"{key}_J": getattr(books, key) for key in ("supplied", "lost", "stored", "coupling", "residual")
        }
    result["window_s"] = [begin, end]
    if window:
        result["steady"] = steady
    if "angle" in window:
        result["window_turns"] = turns
    result |= coupling(run, signals)
    result |= {"simulated_s": run.end, "wall_s": run.wall, "real_time_factor": run.end / run.wall if run.wall else 0.0}
    return result | {"start_s": run.start, "peak_memory_MB": peak_memory()}


def coupling(run: Run, signals: Signals) -> dict[str, Any]:
    """How many macro steps the run took, and how the algorithm did: iterations, residuals, loops at time 0."""
    clock = run.plan.clock
    steps = round(run.end / clock.time(min(clock.periods.values())))
    found: dict[str, Any] = {"macro_steps": len(run.ticks_of(0)) - 1 if run.plan.adaptive else steps}
    found |= run.plan.algorithm.figures(lambda name: signals[f"coupling.{name}"].values)
    if run.started.loops:
        found["initial_loops"] = run.started.loops
        found["initial_loop_residual"] = max(run.started.loops.values())
    return found


def figure_units(system: System) -> dict[str, str]:
    """The figures of merit of a system that are single numbers, with their units."""
    units = {}
    for key, text in system.reporting["summary"].items():
        if key != "window":
            operation, name = str(text).split()[:2]
            component, _, variable = name.partition(".")
            if component in system.components:
                unit = system.components[component].fmu.variables[variable].unit or "1"
            else:
                unit = algorithm_of(system).units.get(variable, "J")
            units[key] = {"frequency": "Hz", "ratio": "1", "positive": "s"}.get(operation, unit)
    return units | ({"coupling_energy_relative": "1"} if system.bonds else {})


def figure_of_merit(operation: str, signals: list[Signal], begin: float, end: float) -> float:
    """One number from one or two signals; see the head of this module."""
    signal = signals[0]
    if operation == "mean":
        return signal.mean(begin, end)
    if operation == "rms":
        squares = Signal(signal.name, signal.unit, "", signal.time, signal.values**2)
        return math.sqrt(squares.mean(begin, end))
    if operation == "positive":
        return float(np.sum(np.diff(signal.time)[signal.values[1:] > 0.0]))
    if operation == "frequency":
        return strongest_frequency(signal, begin, end)
    if operation == "ratio":
        other = abs(float(signals[1].values[-1]))
        return abs(float(signal.values[-1])) / other if other else 0.0
    at = {
        "peak": int(np.argmax(np.abs(signal.values))),
        "max": int(np.argmax(signal.values)),
        "min": int(np.argmin(signal.values)),
        "last": -1,
    }
    return float(signal.values[at[operation]])


def strongest_frequency(signal: Signal, begin: float, end: float) -> float:
    """The frequency [Hz] of the highest line of the spectrum, the mean taken away; 0 if there are too few samples."""
    values = signal.values[(signal.time >= begin) & (signal.time < end)]
    if len(values) < 4:
        return 0.0
    steps = np.diff(signal.time)
    if np.ptp(steps) > 1e-9 * np.mean(steps):  # the spectrum needs equal steps
        even = np.linspace(begin, end, len(values), endpoint=False)
        values = np.interp(even, signal.time, signal.values)
        return float(np.fft.rfftfreq(len(values), even[1] - even[0])[_strongest(values)])
    return float(np.fft.rfftfreq(len(values), signal.time[1] - signal.time[0])[_strongest(values)])


def _strongest(values: np.ndarray) -> int:
    """Position of the highest line of the spectrum, the mean taken away."""
    spectrum = np.abs(np.fft.rfft(values - values.mean()))
    return int(np.argmax(spectrum))


def comparison(run: Run, summary: Mapping[str, Any]) -> list[dict[str, Any]]:
    """One row per `[[compare]]` entry: label, unit, reference, value, ratio, and whether it is within its tolerance.

    Of a run that did not become steady nothing can be said: `within` is None.
    """
    rows = []
    for entry in run.plan.system.reporting["compare"]:
        value, reference = summary[entry["value"]], float(entry["reference"])
        ratio = value / reference if reference else math.nan
        tolerance = entry.get("tolerance")
        unknown = tolerance is None or not summary.get("steady", True)
        within = None if unknown else bool(abs(ratio - 1) <= tolerance)
        rows.append({**entry, "key": entry["value"], "value": value, "ratio": ratio, "within": within})
    return rows
