"""Which signals share an axis: of one component and one unit, and of a size at which each can be read."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from ..signals import Signal
from .lines import STYLES
from .shown import Shown, shown

TOGETHER = 20.0  # times: what varies less than the largest by this gets an axis of its own
LINES = 10  # signals in an axis


class Row:
    """The signals of one axis, and the unit in which they are read."""

    def __init__(self, signals: Sequence[Signal]) -> None:
        self.signals = list(signals)
        self.read: Shown = shown(signals[0].unit, [s.values for s in signals])

    @property
    def label(self) -> str:
        """Of the axis: `name [unit]` of one signal; of several their component and unit."""
        if len(self.signals) == 1:
            return self.read.label(self.signals[0].name)
        owners = list(dict.fromkeys(s.name.partition(".")[0] for s in self.signals))
        return self.read.label(owners[0] if len(owners) == 1 else "")

    def short(self, signal: Signal) -> str:
        """What a signal is called in the legend: without its component where the axis names that."""
        owners = {s.name.partition(".")[0] for s in self.signals}
        return signal.name.partition(".")[2] or signal.name if len(owners) == 1 else signal.name

    def styles(self) -> list[str]:
        """Of each signal."""
        return [STYLES[k % len(STYLES)] for k in range(len(self.signals))]


def rows(signals: Iterable[Signal]) -> list[Row]:
    """The signals in rows, in the order in which a row's first one comes."""
    groups: dict[tuple[str, ...], list[Signal]] = {}
    for signal in signals:
        kind = signal.values.dtype.kind
        alone = signal.name if kind not in "fiu" else (kind == "f" and "real") or "whole"
        groups.setdefault((signal.name.partition(".")[0], signal.unit, alone), []).append(signal)
    return [Row(part) for group in groups.values() for part in _parts(group)]


def extent(signal: Signal) -> float:
    """From the least to the largest finite value."""
    if signal.values.dtype.kind not in "fiub":
        return 1.0
    values = signal.values.astype(float)
    values = values[np.isfinite(values)]
    return float(np.max(values) - np.min(values)) if len(values) else 0.0


def is_constant(signal: Signal) -> bool:
    """Whether a signal has one value only."""
    return len(signal.values) < 2 or bool(np.all(signal.values == signal.values[0]))


def _parts(group: list[Signal]) -> list[list[Signal]]:
    """Signals of like extent together, and no more than an axis bears."""
    order = sorted(group, key=extent, reverse=True)
    parts: list[list[Signal]] = []
    for signal in order:
        if not parts or extent(signal) * TOGETHER < extent(parts[-1][0]) or len(parts[-1]) == LINES:
            parts.append([])
        parts[-1].append(signal)
    place = {signal.name: k for k, signal in enumerate(group)}
    return [sorted(part, key=lambda s: place[s.name]) for part in parts]
