"""Operating points: instants and periods of a run, and how far what is there is from being steady.

A point at which all stands still, or drifts at a steady rate (an angle that turns, a place along a path), has a
residual of 0. The residual of a signal is by how much its change over one half of the window differs from that over the
other half, relative to its size; of a periodic point its means over a period are taken for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi

import numpy as np

from ...clock import Clock, instant, seconds_text
from ...errors import InputError, nearest
from ...system.model import System
from .probe import Probe

ALLOWED = 0.02  # residual
LONGEST = 100_000  # hyperperiods in which a signal must have turned once
GOLDEN = (5.0**0.5 - 1.0) / 2.0


@dataclass(frozen=True)
class Residual:
    """Of one signal at an operating point."""

    signal: str
    value: float

    def __str__(self) -> str:
        return f"{self.signal} {self.value:.2g}"


def times_of(system: System, texts: Sequence[str]) -> list[Fraction]:
    """The times [s] that are meant, rising. Raises InputError for one outside of the run."""
    times = sorted({instant(text, "--at") for text in texts}) if texts else [system.start]
    for time in times:
        if not system.start <= time <= system.stop:
            raise InputError(
                f"--at {seconds_text(time)} is outside of the run, which goes from {seconds_text(system.start)} to "
                f"{seconds_text(system.stop)}; give a time within, or another --stop"
            )
    return times


def ticks_of(clock: Clock, start: Fraction, time: Fraction) -> int:
    """The instant of a time, ticks from the start. Raises InputError where the schedule does not begin anew there."""
    whole = clock.seconds(clock.hyperperiod)
    cycles = (time - start) / whole
    if cycles.denominator != 1:
        below = start + (time - start) // whole * whole
        raise InputError(
            f"--at {seconds_text(time)}: the schedule repeats every {seconds_text(whole)}; take "
            f"{seconds_text(below)} or {seconds_text(below + whole)}"
        )
    return int(cycles) * clock.hyperperiod


def period_in(probe: Probe, text: str) -> int:
    """The period [hyperperiods] from here on: of a stated time, or in which a signal rises by a turn (2 pi).

    The run goes on to its end. Raises InputError for an unknown signal, or one that does not turn.
    """
    if not text:
        return 0
    one = probe.plan.clock.seconds(probe.plan.clock.hyperperiod)
    name = probe.plan.system.full_name(text)
    if is_time(text):
        count = round(instant(text, "--period-of") / one)
        if count < 1:
            raise InputError(
                f"--period-of {text} is shorter than the {seconds_text(one)} in which the schedule repeats"
            )
        return count
    begin = float(probe.session.get(name))
    for count in range(1, LONGEST):
        if probe.session.tick + 2 * probe.plan.clock.hyperperiod > probe.plan.clock.stop:
            break
        probe.session.step()
        turned = abs(float(probe.session.get(name)) - begin)
        if turned >= 2.0 * pi:
            return count
    raise InputError(
        f"--period-of {name}: it does not turn by 2 pi until the run ends, at t = {probe.session.time:g} s; name an "
        'angle that rises [rad], or state the period as a time, --period-of "20 ms"'
    )


def is_time(text: str) -> bool:
    """Whether a text is meant as a time and not as a signal's name."""
    return text.strip()[:1].isdigit() or text.strip()[:1] in "+-."


def require_angle(system: System, text: str) -> list[str]:
    """The signal whose period is meant, if one is. Raises InputError for an unknown one."""
    if not text or is_time(text):
        return []
    from .channels import signals_of

    found = signals_of(system, [text], "--period-of")
    if len(found) != 1:
        raise InputError(f"--period-of {text}: name one signal{nearest(text, found)}")
    return found


def starts_in(period: int, count: int) -> list[int]:
    """Where in a period [hyperperiods] pulses begin, rising: everywhere where it has no more instants than that, else
    spread by the golden section, which no shorter rhythm in it is in step with."""
    if period <= 1:
        return [0]
    if count >= period:
        return list(range(period))
    return sorted({int(period * ((k * GOLDEN) % 1.0)) for k in range(count)})


def residuals(probe: Probe, window: int, period: int, sizes: np.ndarray) -> list[Residual]:
    """Of all signals, the largest first, over twice `window` samples and what is left of the last period.

    `period` [samples]: 0 for none. `sizes` (p,): how large a signal's deviations are at least.
    """
    rows = [probe.read()]
    for _ in range(2 * window + max(period - 1, 0)):
        probe.sample()
        rows.append(probe.read())
    found = np.array(rows)
    at = [found[k : k + max(period, 1)].mean(axis=0) for k in (0, window, 2 * window)]
    change = np.abs(at[2] - 2.0 * at[1] + at[0])
    size = np.max(np.abs([*at, sizes]), axis=0)
    values = np.where(size > 0.0, change / np.where(size > 0.0, size, 1.0), 0.0)
    pairs = [Residual(name, float(value)) for name, value in zip(probe.signals, values, strict=True)]
    return sorted(pairs, key=lambda residual: -residual.value)


def require_steady(found: Sequence[Residual], time: float, allowed: float, window: float) -> None:
    """Raise InputError, with the residuals, where they are above what is allowed."""
    worst = [residual for residual in found if not residual.value <= allowed]
    if worst:
        raise InputError(
            f"t = {time:g} s is no operating point: over {window:.3g} s signals do not keep their rates; residuals: "
            f"{', '.join(map(str, worst[:4]))} (allowed {allowed:g}). Take a time at which the system has settled, "
            "average a periodic one with --period-of, shorten the response with --length, or allow more with --residual"
        )
