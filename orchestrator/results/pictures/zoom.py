"""Which part of a run is worth a closer look: what happened, a few swings of its ripple, or where most changes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..signals import Signal
from .bands import Ripple, ripple

SWINGS = 8  # of a ripple, in a closer look
PART = 0.1  # of the run, where there is neither ripple nor event
WORTH = 0.5  # of the run; a longer look is none
STRONG = 0.5  # of its strongest swings: a ripple that is at least so strong


def zoom(signals: Sequence[Signal], events: Sequence[float] = ()) -> tuple[float, float] | None:
    """From when to when [s] to look closer at these signals; None where the whole says as much."""
    moving = [s for s in signals if s.values.dtype.kind == "f" and len(s.time) > 3 and np.all(np.isfinite(s.values))]
    if not moving:
        return None
    begin, end = min(s.time[0] for s in moving), max(s.time[-1] for s in moving)
    found = _swings(moving) or _events(events, begin, end) or _steepest(moving, begin, end)
    low, high = max(found[0], begin), min(found[1], end)
    return (low, high) if 0.0 < high - low < WORTH * (end - begin) else None


def _swings(signals: Sequence[Signal]) -> tuple[float, float] | None:
    """A few swings of the ripple that fills most of the picture, at the last place where most ripples are strong."""
    found = [(s, r) for s in signals if (r := ripple(s.time, s.values)) is not None]
    if not found:
        return None
    signal, chosen = max(found, key=lambda pair: np.count_nonzero(pair[1].dense))
    width = (signal.time[-1] - signal.time[0]) / len(chosen.swing)
    middles = signal.time[0] + (np.arange(len(chosen.swing)) + 0.5) * width
    together = np.sum([_strong(one, its, middles) for one, its in found], axis=0)
    middle = middles[int(np.flatnonzero(together == np.max(together))[-1])]
    half = SWINGS * chosen.period / 2.0
    late = min(middle + half, float(signal.time[-1]))
    return late - 2.0 * half, late


def _strong(signal: Signal, found: Ripple, at: np.ndarray) -> np.ndarray:
    """Where a ripple is strong, at instants `at` (instants,)."""
    swing = np.where(found.dense, found.swing, 0.0)
    strong = swing >= STRONG * np.quantile(swing[found.dense], 0.9)
    width = (signal.time[-1] - signal.time[0]) / len(swing)
    blocks = np.floor((at - signal.time[0]) / width).astype(int)
    inside = (blocks >= 0) & (blocks < len(swing))
    there: np.ndarray = inside & strong[np.clip(blocks, 0, len(swing) - 1)]
    return there


def _events(events: Sequence[float], begin: float, end: float) -> tuple[float, float] | None:
    """Around the first event, with those that follow it closely."""
    inside = sorted(t for t in events if begin < t < end)
    if not inside:
        return None
    margin = PART * (end - begin) / 2.0
    return inside[0] - margin, inside[0] + margin


def _steepest(signals: Sequence[Signal], begin: float, end: float) -> tuple[float, float]:
    """The part in which the signals together travel furthest, each measured by all of its own way."""
    count = round(1.0 / PART)
    edges = np.linspace(begin, end, 4 * count + 1)
    way = np.zeros(len(edges))
    for signal in signals:
        travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(signal.values)))])
        if travelled[-1] > 0.0:
            way += np.interp(edges, signal.time, travelled) / travelled[-1]
    k = int(np.argmax(way[4:] - way[:-4]))
    return float(edges[k]), float(edges[k + 4])
