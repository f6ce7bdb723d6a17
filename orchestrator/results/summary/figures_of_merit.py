"""Figures of merit that a system file asks for: an operation and its signals, over a steady window or the whole run.

    [summary]
    window = { angle = "motor.angle", start = 5.0 }   # whole turns of an angle, as many as fit behind `start` [s]
    load_mean = "mean motor.load"                     # an operation and its signals

`window` may have an `end` [s] too; both are times as the run counts them. That of a run that ends at `start` or before
is its second half. Over the window:
`mean`, the time average; `rms`; `frequency`, the strongest line of the spectrum [Hz]; `share`, for what share of it a
signal is above 0. Over the whole run: `peak`, the largest magnitude; `max`; `min`; `last`; `ratio a b`, the magnitude
of a over that of b, both at the end; `positive`, for how long it is above 0 [s].
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ...plan.algorithms.registry import algorithm_of
from ...system.file.merits import merit
from ...system.model import System
from ..signals import Signal, Signals


def steady_window(signals: Signals, window: Mapping[str, Any]) -> tuple[float, float, int, bool]:
    """Begin and end of the window [s], the number of whole turns in it (0 where no angle is given), if it is steady.

    A run that ends before its window begins, or before a whole turn in it, is a transient: the window is its second
    half then.
    """
    first, end = signals.run.plan.clock.time(0), signals.run.end
    begin = max(float(window.get("start", first)), first)
    if "end" in window and begin < float(window["end"]) < end:
        end = float(window["end"])
    steady = begin < end or not window
    if begin >= end:  # a run that was made shorter, or ended early
        begin = first + (end - first) / 2
    if "angle" not in window or end <= begin:
        return begin, end, 0, steady
    angle = signals[window["angle"]]
    turned = abs(np.interp(end, angle.time, angle.values) - np.interp(begin, angle.time, angle.values))
    turns = math.floor(turned / (2 * math.pi))
    if turns == 0:
        return begin, end, 0, False
    target = abs(np.interp(end, angle.time, angle.values)) - 2 * math.pi * turns
    return float(np.interp(target, np.abs(angle.values), angle.time)), end, turns, steady


def figure_of_merit(operation: str, signals: list[Signal], begin: float, end: float) -> float:
    """One number from one or two signals; see the head of this module. One of the values of whole numbers is whole."""
    own = signals[0].values
    signal = as_numbers(signals[0])
    if operation == "mean":
        return signal.mean(begin, end)
    if operation == "rms":
        squares = Signal(signal.name, signal.unit, "", signal.time, signal.values**2)
        return math.sqrt(squares.mean(begin, end))
    if operation == "share":
        above = np.asarray(signal.values > 0.0, dtype=float)
        return Signal(signal.name, "1", "", signal.time, above).mean(begin, end)
    if operation == "positive":
        return float(np.sum(np.diff(signal.time)[signal.values[1:] > 0.0]))
    if operation == "frequency":
        return strongest_frequency(signal, begin, end)
    if operation == "ratio":
        other = abs(float(signals[1].values[-1]))
        return abs(float(signal.values[-1])) / other if other else 0.0
    exact = own if own.dtype.kind in "iu" else signal.values  # neighbours beyond 2^53 are one float
    at = {
        "peak": int(np.argmax(np.abs(signal.values))),
        "max": int(np.argmax(exact)),
        "min": int(np.argmin(exact)),
        "last": -1,
    }
    found: float = exact[at[operation]].item()
    return found


def as_numbers(signal: Signal) -> Signal:
    """The signal in floating point: the square or the magnitude of a whole number may not fit its own type."""
    if signal.values.dtype == np.float64:
        return signal
    return replace(signal, values=np.asarray(signal.values, dtype=float))


def strongest_frequency(signal: Signal, begin: float, end: float) -> float:
    """The frequency [Hz] of the highest line of the spectrum, the mean taken away; 0 if there are too few samples."""
    inside = (signal.time >= begin) & (signal.time < end)
    values = signal.values[inside]
    if len(values) < 4:
        return 0.0
    steps = np.diff(signal.time[inside])
    if np.ptp(steps) > 1e-9 * np.mean(steps):  # the spectrum needs equal steps
        even = np.linspace(begin, end, len(values), endpoint=False)
        values = np.interp(even, signal.time, signal.values)
        return float(np.fft.rfftfreq(len(values), even[1] - even[0])[_strongest(values)])
    return float(np.fft.rfftfreq(len(values), signal.time[1] - signal.time[0])[_strongest(values)])


def _strongest(values: np.ndarray) -> int:
    """Position of the highest line of the spectrum, the mean taken away."""
    spectrum = np.abs(np.fft.rfft(values - values.mean()))
    return int(np.argmax(spectrum))


def figure_units(system: System) -> dict[str, str]:
    """The figures of merit of a system that are single numbers, with their units."""
    units = {}
    for key, text in system.reporting["summary"].items():
        if key != "window":
            operation, names = merit(text)
            component, _, variable = names[0].partition(".")
            if component in system.components:
                unit = system.components[component].fmu.variables[variable].unit or "1"
            else:
                unit = algorithm_of(system).units.get(variable, "J")
            units[key] = {"frequency": "Hz", "ratio": "1", "positive": "s", "share": "1"}.get(operation, unit)
    units |= {"coupling_energy_relative": "1"} if system.bonds else {}
    return units | ({"energy_balance_relative": "1"} if system.reporting["balance"] else {})
