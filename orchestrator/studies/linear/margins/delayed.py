"""What runs say of a delay margin: a delay is put into the broken loop, and halved down to where a kick neither grows
nor dies out.

From the state at the operating point the run goes on without a delay until what the delay is to bring back has been
seen. From there it goes twice with the delay, kicked to either side for a quarter of a period; half the difference is
how the kick goes on, clean of drift, of ripple and of noise that is the same in both. Nothing of the linear model is in
it but where to look first, and how long.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, log, pi

import numpy as np

from ....errors import RunError
from ....run.stepping.snapshot import Snapshot
from ..probe import Probe
from .open_loop import Loop

UNDELAYED = 2.0**-20  # what is left of a connection's own signal, so that it can be read behind the delay
PERIODS = 5  # that a kick is followed
LOOKED_AT = 2  # periods in each of the two windows at the end whose amplitudes are compared
FIRST = 0.1  # of the model's margin: where the first two trials are on either side of it
WIDER = 1.6  # by how much the next one is further away where both grow, or both die out
FARTHEST = 4.0  # times the model's margin
CLOSE = 0.02  # of the model's margin: between a delay that dies out and one that grows
TRIALS = 12  # at most


@dataclass(frozen=True)
class Trial:
    """A delay [s] that was put in, and by how much a kick grew in a period (its logarithm; inf: the run ended)."""

    delay: float
    growth: float


@dataclass(frozen=True)
class InTime:
    """The delay margin that the linear model says [s], and the trials on runs, by rising delay, until `until` [s]."""

    model: float
    trials: tuple[Trial, ...]
    until: float

    @property
    def dies_out(self) -> float:
        """The longest delay [s] with which a kick dies out, below any with which it grows; 0 if there is none."""
        return max((t.delay for t in self.trials if t.growth < 0.0 and t.delay < self.grows), default=0.0)

    @property
    def grows(self) -> float:
        """The shortest delay [s] with which a kick grows; infinite if it grew with none."""
        return min((t.delay for t in self.trials if t.growth >= 0.0), default=np.inf)

    @property
    def longest(self) -> float:
        """The longest delay [s] that was tried."""
        return max(t.delay for t in self.trials)

    @property
    def delay(self) -> float:
        """Between the two, where a kick would neither grow nor die out [s]; nan where one of them was not found."""
        by = {t.delay: t.growth for t in self.trials}
        low, high = self.dies_out, self.grows
        if low not in by or high not in by:
            return np.nan
        return low - by[low] * (high - low) / (by[high] - by[low]) if np.isfinite(by[high]) else 0.5 * (low + high)

    @property
    def difference(self) -> float:
        """By how much the model's margin is above that of the runs, relative to it."""
        return self.model / self.delay - 1.0

    def content(self) -> dict[str, object]:
        """Ready for JSON: times in seconds."""
        return {
            "model": self.model, "time_domain": self.delay, "difference": self.difference, "dies_out": self.dies_out,
            "grows": self.grows, "until": self.until, "trials": [[t.delay, t.growth] for t in self.trials],
        }  # fmt: skip


def longest_run(loop: Loop) -> float:
    """How long [s] a trial may go on."""
    omega, delay = loop.delay_crossing
    return FARTHEST * delay + (PERIODS + 1) * 2.0 * pi / omega


class DelayedLoop:
    """The loop that is broken at a probe's channels, with a delay put in there."""

    def __init__(self, probe: Probe, sums: bool, sizes: list[float]) -> None:
        """`sums`: broken at outputs to which free inputs are added, the probe's signals, and not at connections."""
        self.probe, self.sums, self.sizes = probe, sums, np.array(sizes)
        # What a connection sends is known at an instant where its target answers at once, else behind the step.
        self.behind = 0.0 if not sums and all(probe.at_once.values()) else 1.0
        self.shortest = 0.0 if sums else self.behind * probe.dt

    def growth(self, here: Snapshot, delay: float, omega: float) -> tuple[float, float]:
        """Of a kick in a period of `omega` [rad/s], with a delay [s] put in; and the time [s] until which the run went.

        Raises RunError where it ends before the delay begins.
        """
        period = max(round(2.0 * pi / omega / self.probe.dt), 4)
        self.probe.back(here)
        past = [self._now()] if self.sums else []
        for _ in range(ceil(delay / self.probe.dt) + 3):
            past.append(self._step(np.zeros(len(self.sizes)), 1.0))
        with self.probe.keep() as begun:
            try:
                plus, minus = (self._kicked(begun, list(past), delay, sign, period) for sign in (1.0, -1.0))
            except RunError:
                return np.inf, self.probe.session.time
        return _growth((plus - minus) / (2.0 * self.sizes), period), self.probe.session.time

    def _now(self) -> np.ndarray:
        return self.probe.read()[: len(self.sizes)]

    def _step(self, added: np.ndarray, own: float) -> np.ndarray:
        """Go on by a sample, `own` times its signal and something more at each channel; what was there without that."""
        for channel, value in zip(self.probe.channels, added.tolist(), strict=True):
            if self.sums or own == 1.0:
                self.probe.add(channel, value)
            else:
                self.probe.bend(channel, own, value)
                self.probe.answer(channel)
        self.probe.sample()
        found = self._now()
        without: np.ndarray = found if self.sums else (found - added) / own
        return without

    def _kicked(self, begun: Snapshot, past: list[np.ndarray], delay: float, sign: float, period: int) -> np.ndarray:
        """The signals (samples, q) of the break from a state on, kicked there."""
        self.probe.back(begun)
        first = len(past)
        kick = max(period // 4, 1)
        for k in range(PERIODS * period):
            added = sign * self.sizes if k < kick else np.zeros(len(self.sizes))
            if self.sums:  # what is added is held over a sample: the middle of it counts
                ahead = 1.5 * past[-1] - 0.5 * past[-2]
                past.append(self._step(added + _before(past, delay / self.probe.dt - 0.5) - ahead, 1.0))
            else:
                past.append(self._step(added + _before(past, delay / self.probe.dt - self.behind), UNDELAYED))
        return np.array(past[first:])


def _before(past: list[np.ndarray], samples: float) -> np.ndarray:
    """What was so many samples before the last one, between two of them on a straight line."""
    if samples < 0.0:
        ahead: np.ndarray = past[-1] - samples * (past[-1] - past[-2])
        return ahead
    whole = int(samples)
    share = samples - whole
    found: np.ndarray = (1.0 - share) * past[-1 - whole] + share * past[-2 - whole]
    return found


def _growth(response: np.ndarray, period: int) -> float:
    """Of the amplitude in a period (its logarithm): from one window to the next at the end, by what they hold of the
    period's frequency."""
    span = LOOKED_AT * period
    k = np.arange(span)
    hann = 0.5 - 0.5 * np.cos(2.0 * pi * (k + 0.5) / span)
    wave = hann * np.exp(-2j * pi * k / period)
    line = np.vander(k / span, 2)
    sizes = []
    for part in (response[-2 * span : -span], response[-span:]):
        flat: np.ndarray = part - line @ np.linalg.lstsq(line, part, rcond=None)[0]
        sizes.append(float(np.linalg.norm(wave @ flat)))
    if not np.isfinite(sizes[1]):
        return np.inf
    return log(max(sizes[1], 1e-300) / max(sizes[0], 1e-300)) / LOOKED_AT


def in_time(
    loop: DelayedLoop, here: Snapshot, model: float, omega: float,
    progress: Callable[[float], None] = lambda _share: None,
) -> InTime:  # fmt: skip
    """The delay margin on runs, looked for around the model's [s], at the frequency [rad/s] that the model says.

    It tries TRIALS delays at most, each on two runs of PERIODS periods. Raises RunError.
    """
    trials: list[Trial] = []
    until = 0.0
    down, up = model * (1.0 - FIRST), model * (1.0 + FIRST)
    while len(trials) < TRIALS:
        found = InTime(model, tuple(trials), until)
        low, high = found.dies_out, found.grows
        if not trials or not np.isfinite(high):
            delay = down if not trials else up
            up *= WIDER if trials else 1.0
            if delay > FARTHEST * model:
                break
        elif not any(t.delay == low for t in trials):
            if high <= loop.shortest:
                break
            delay = down if down < high else high / WIDER
            down = delay / WIDER
        elif high - low <= CLOSE * model:
            break
        else:
            edge = 0.5 * CLOSE * model
            delay = min(max(found.delay, low + edge), high - edge)
        delay = max(delay, loop.shortest)
        growth, end = loop.growth(here, delay, omega)
        until = max(until, end)
        trials = sorted([*trials, Trial(delay, growth)], key=lambda t: t.delay)
        progress(len(trials) / TRIALS)
    progress(1.0)
    return InTime(model, tuple(trials), until)
