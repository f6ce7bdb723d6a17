"""What all loops together bear: delay and gain are raised until the answer to a kick no longer decays."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...errors import RunError
from ...results.files.manifest import plain_value
from ...results.signals import Signals
from ...system.model import System
from .open_loop import BEGIN, LENGTH, ran

KICK, KICK_TIME = 8.0, 0.1  # N, s: some centimetres per second
FORCE_GAINS = ("K_force", "K_force_i", "K_force_d", "K_force_a")


def decays(system: System, axis: int = 3) -> bool:
    """Does the answer to a kick at BEGIN die out, contact kept? Sensors without noise; not in a run that ends early."""
    time = np.array([0.0, BEGIN, BEGIN, BEGIN + KICK_TIME, BEGIN + KICK_TIME, BEGIN + LENGTH])
    try:
        signals = Signals(ran(system, time, np.array([0.0, 0.0, KICK, KICK, 0.0, 0.0]), axis))
    except RunError:
        return False
    delta = signals["vehicle.delta"]
    after = delta.time >= BEGIN
    early = delta.values[after & (delta.time < BEGIN + 2.0)]
    late = delta.values[delta.time >= BEGIN + LENGTH - 3.0]
    return bool(np.all(delta.values[after] > 0.0) and late.std() < 0.5 * early.std())


def largest(kept: Callable[[float], bool], low: float, high: float, resolution: float) -> float:
    """The largest value for which the loop decays, by halving low .. high; low itself if it decays nowhere."""
    if kept(high):
        return high
    while high - low > resolution:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if kept(middle) else (low, middle)
    return low


def delay_limit(system: System, longest: float = 0.2, resolution: float = 2e-3) -> float:
    """Delay [s] common to all sensors until which the answer to a kick decays. Raises InputError without `sensors`."""
    return largest(lambda d: decays(system.with_values({"sensors.delay": d}, "margins")), 0.0, longest, resolution)


def gain_limit(system: System, most: float = 12.0, resolution: float = 0.1) -> float:
    """Factor on all gains of the force loop until which the answer to a kick decays."""
    gains = {name: start_of(system, "controller", name) for name in FORCE_GAINS}

    def scaled(factor: float) -> bool:
        values = {f"controller.{name}": factor * gain for name, gain in gains.items()}
        return decays(system.with_values(values, "margins"))

    return largest(scaled, 1.0, most, resolution)


def start_of(system: System, component: str, name: str) -> float:
    """The value of a parameter in a system: its own, or that of the FMU."""
    part = system.components[component]
    return float(part.parameters.get(name, plain_value(part.fmu.variables[name].start)))
