"""The open loop of the force along the normal, measured with the loop closed.

A small sine on the force along the normal, at the plant's input, is answered by the thrusters: with F their force and
d the added one, L(i omega) = -F/(F + d). Where its magnitude crosses 1 its angle says the phase margin, and how much
delay turns it to -1; where it crosses the negative real axis, how much gain. Brush, pitch of the vehicle, samples and
lags are all in it, and sines of many frequencies at once are as good as one after the other while they are small.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...results.signals import Signal, Signals
from ...results.tables import Run, require_complete
from ...run.planned import planned
from ...run.simulation import simulate
from ...studies.linear.margins.open_loop import Loop
from ...system.inputs.series_file import with_inputs
from ...system.model import System

AMPLITUDE = 0.25  # N, of each sine: a hundredth of the force on the hull, so that the brush stays at its working point
OMEGA = np.geomspace(1.0, 90.0, 30)  # rad/s
ROWS = 1e-3  # s, distance of the rows of the added force
BEGIN, LENGTH = 8.0, 12.0  # s, on the hull, under way


def coefficients(signal: Signal, omega: np.ndarray, begin: float, length: float) -> np.ndarray:
    """Complex amplitudes of a signal at frequencies [rad/s] that have whole periods in `length` [s]."""
    chosen = (signal.time >= begin - 1e-9) & (signal.time < begin + length - 1e-9)
    at = signal.time[chosen]
    result: np.ndarray = 2.0 / len(at) * (np.exp(-1j * np.outer(omega, at)) @ signal.values[chosen])
    return result


def open_loop(
    system: System, omega: Sequence[float] | np.ndarray = OMEGA, amplitude: float = AMPLITUDE, axis: int = 3
) -> tuple[Loop, float]:
    """The open loop at frequencies [rad/s], moved to whole periods in LENGTH; and the brush's stiffness [N/m] there.

    The sines begin with the run. `axis`: of the body, 1 to 3, along the normal into the hull. The stiffness is that of
    the slowest sine's answers. Raises RunError, and InputError for a system without such a force or too short.
    """
    omega = 2.0 * np.pi / LENGTH * np.unique(np.maximum(1.0, np.round(np.asarray(omega) * LENGTH / (2.0 * np.pi))))
    # Schroeder's phases keep the sum of many sines small.
    phases = -np.pi * np.arange(len(omega)) ** 2 / len(omega)
    time = np.arange(0.0, BEGIN + LENGTH + ROWS, ROWS)
    force = amplitude * np.cos(np.outer(time, omega) + phases).sum(axis=1)
    signals = Signals(ran(system, time, force, axis))
    control = signals[f"vehicle.F_control[{axis}]"]
    answer = coefficients(control, omega, BEGIN, LENGTH)
    # A step holds the mean of the sine over it, which is a little less than the sine.
    step = float(control.time[1] - control.time[0])
    added = amplitude * np.exp(1j * phases) * np.sinc(omega * step / (2.0 * np.pi)) ** 2
    pressed, moved = (
        coefficients(signals[f"vehicle.{name}"], omega[:1], BEGIN, LENGTH)[0] for name in ("F_z", "delta")
    )
    return Loop(omega, -answer / (answer + added)), float(-(pressed / moved).real)


def ran(system: System, time: np.ndarray, force: np.ndarray, axis: int) -> Run:
    """A run with a further force [N] on the vehicle over time [s], along an axis of the body."""
    return require_complete(simulate(planned(with_inputs(system, {f"vehicle.F_external[{axis}]": (time, force)}))))
