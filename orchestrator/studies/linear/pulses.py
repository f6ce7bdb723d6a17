"""Markov parameters of a run: what follows from one sample of something added, by central differences.

From a saved state the run is gone through twice for each channel, once with `+size` and once with `-size` added during
the first sample; half the difference over `size` is the response. Of an operating point that is periodic this is done
from several instants of whole periods, and the mean is taken: the response of the averaged system.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ...run.stepping.snapshot import Snapshot
from .channels import Channel
from .probe import Probe

SIZE = 1e-3  # of a channel's value, or of its nominal size where that is more
LOOK = 100  # samples between two looks at whether a response has died out
DECAYED = 1e-5  # of the largest: what is left of one that has
GROWN = 1e4  # times what it was in its first samples: one that is followed no further
FIRST = 20  # samples


@dataclass(frozen=True)
class Pulses:
    """Responses (samples, p, m) and how they were found: the size of what was added to each channel, and how much of
    them was the same for both signs, relative to the response (0 where all is linear)."""

    values: np.ndarray
    sizes: tuple[float, ...]
    even: float


def size_of(channel: Channel, value: float, stated: float | None) -> float:
    """How much is added to a channel that has a value now."""
    return stated if stated is not None else SIZE * max(abs(value), channel.nominal)


def pulses_from(
    probe: Probe, starts: Sequence[Snapshot], sizes: Sequence[float], samples: int | None, most: int, count: int,
    over_the_step: bool = False, progress: Callable[[float], None] = lambda _share: None,
) -> Pulses:  # fmt: skip
    """The mean responses of the first `count` signals to all channels over the starts.

    `samples`: how many; None: until they have died out, `most` at most. `over_the_step`: signals are read as they were
    during a sample, the first one that of the pulse, and not as they are at its instants.
    """
    reader = _Reader(probe, count, over_the_step)
    if samples is None:
        samples = max(_enough(reader, starts[0], c, s, most) for c, s in zip(probe.channels, sizes, strict=True))
    values = np.zeros((samples, count, len(sizes)))
    even, odd, done = 0.0, 0.0, 0
    for kept in starts:
        middles: dict[str | None, np.ndarray] = {}
        for k, (channel, size) in enumerate(zip(probe.channels, sizes, strict=True)):
            plus, minus = (reader.one(kept, channel, sign * size, samples) for sign in (1.0, -1.0))
            answers = probe.answers(channel)  # what answers is asked without a pulse too, so that all else is the same
            if answers not in middles:
                middles[answers] = reader.one(kept, channel, 0.0, samples)
            middle = middles[answers]
            response = (plus - minus) / (2.0 * size)
            values[:, :, k] += response / len(starts)
            even += float(np.sum(np.square((plus + minus - 2.0 * middle) / (2.0 * size))))
            odd += float(np.sum(np.square(response)))
            done += 1
            progress(done / (len(starts) * len(sizes)))
    return Pulses(values, tuple(sizes), float(np.sqrt(even / odd)) if odd else 0.0)


def _enough(reader: _Reader, kept: Snapshot, channel: Channel, size: float, most: int) -> int:
    """After how many samples the response to a channel has died out, or has grown too large; `most` at most."""
    count = min(LOOK, most)
    while True:  # the runs are short against what is made of them: they are begun anew, longer
        plus, minus = (reader.one(kept, channel, sign * size, count) for sign in (1.0, -1.0))
        response = np.abs(plus - minus)
        largest = np.max(response, axis=0)
        left = np.max(response[-count // 5 :], axis=0)
        early = np.max(response[:FIRST], axis=0)
        grown = bool(np.any((left > GROWN * early) & (early > 0.0)))
        if count >= most or grown or np.all(left <= DECAYED * largest):
            return count
        count = min(2 * count, most)


class _Reader:
    """The first `count` signals of a probe, sample by sample."""

    def __init__(self, probe: Probe, count: int, over_the_step: bool) -> None:
        self.probe, self.count, self.over = probe, count, over_the_step

    def now(self) -> np.ndarray:
        return self.probe.read()[: self.count]

    def one(self, kept: Snapshot, channel: Channel, size: float, samples: int) -> np.ndarray:
        """The signals (samples, p) from a kept state on, with something added during the first sample."""
        probe = self.probe
        probe.back(kept)
        probe.add(channel, size)
        rows = [] if self.over else [self.now()]
        probe.sample()
        if self.over:
            rows.append(self.now())
        probe.add(channel, 0.0)
        if not self.over:
            rows.append(self.now())
        return self.go_on(rows, samples)

    def go_on(self, rows: list[np.ndarray], samples: int) -> np.ndarray:
        """These rows and those that follow where nothing is added."""
        while len(rows) < samples:
            self.probe.sample()
            rows.append(self.now())
        return np.array(rows[:samples])
