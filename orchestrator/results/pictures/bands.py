"""A ripple that is too fast to be seen at the width of a picture: its mean, in a band from least to largest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

COLUMNS, SAMPLES = 700, 4  # of a figure: places side by side, and samples in each that can still be told apart
READABLE = 8  # columns that one swing up and down needs
VISIBLE = 0.02  # of the whole range: a swing that makes a line thick
DENSE = 3  # blocks of READABLE columns with more swings than can be read make a band
SMOOTHED = 3  # swings over which the mean is taken, twice


@dataclass(frozen=True)
class Band:
    """At the middle of each column: time [s], mean over time, least and largest value, (columns,) each."""

    time: np.ndarray
    mean: np.ndarray
    least: np.ndarray
    largest: np.ndarray


@dataclass(frozen=True)
class Ripple:
    """Swings that are too fast for the width: how long one takes [s], and the blocks of the picture that have them."""

    period: float
    dense: np.ndarray  # (blocks,)
    swing: np.ndarray  # (blocks,), from least to largest value of a swing, on average


def ripple(time: np.ndarray, values: np.ndarray, columns: int = COLUMNS) -> Ripple | None:
    """The ripple of a signal that cannot be read as a line over `columns`; None where it can."""
    if len(time) < 4 or time[-1] <= time[0]:
        return None
    blocks = columns // READABLE
    rises = np.sign(np.diff(values))
    kept = np.flatnonzero(rises)
    turns = time[kept[1:][rises[kept[1:]] != rises[kept[:-1]]]]
    edges = np.linspace(time[0], time[-1], blocks + 1)
    counts = np.histogram(turns, edges)[0]
    travelled = np.diff(np.interp(edges, time, np.concatenate([[0.0], np.cumsum(np.abs(np.diff(values)))])))
    net = np.abs(np.diff(np.interp(edges, time, values)))  # a slow change is no swing
    swing = np.maximum(travelled - net, 0.0) / np.maximum(counts, 1)
    dense = (counts > 2) & (swing > VISIBLE * (np.max(values) - np.min(values)))
    if np.count_nonzero(dense) < DENSE:
        return None
    width = (edges[1] - edges[0]) * np.count_nonzero(dense)
    return Ripple(float(2.0 * width / np.sum(counts[dense])), dense, swing)


def columns_of(time: np.ndarray, values: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Integral over time, least and largest value between neighbouring edges, (edges - 1,) each."""
    at_edges = np.interp(edges, time, values)
    places = np.searchsorted(time, edges, side="left")
    times, all_values = np.insert(time, places, edges), np.insert(values, places, at_edges)
    firsts = places + np.arange(len(edges))
    steps = np.diff(times) * (all_values[1:] + all_values[:-1]) / 2.0
    integral = np.diff(np.concatenate([[0.0], np.cumsum(steps)])[firsts])
    least = np.minimum(np.minimum.reduceat(all_values, firsts[:-1]), at_edges[1:])
    return integral, least, np.maximum(np.maximum.reduceat(all_values, firsts[:-1]), at_edges[1:])


def band(time: np.ndarray, values: np.ndarray, columns: int = COLUMNS) -> Band | None:
    """The band of a signal of finite numbers; None for one that can be read as a line over `columns`."""
    found = ripple(time, values, columns)
    if found is None and (len(time) < SAMPLES * columns or time[-1] <= time[0]):
        return None
    edges = np.linspace(time[0], time[-1], columns + 1)
    width = edges[1] - edges[0]
    integral, least, largest = columns_of(time, values, edges)
    if found is None:
        return Band((edges[1:] + edges[:-1]) / 2.0, np.clip(integral / width, least, largest), least, largest)
    reach = int(np.ceil(found.period / width / 2.0))  # columns to each side, which hold a whole swing
    least, largest = _extreme(least, reach, np.min), _extreme(largest, reach, np.max)
    fine = np.linspace(time[0], time[-1], 4 * columns + 1)
    wide = max(2.0 * width, SMOOTHED * found.period)
    smooth = sliding_mean(time, values, fine, wide)
    middle = (edges[1:] + edges[:-1]) / 2.0
    return Band(middle, np.clip(sliding_mean(fine, smooth, middle, wide), least, largest), least, largest)


def sliding_mean(time: np.ndarray, values: np.ndarray, at: np.ndarray, width: float) -> np.ndarray:
    """The mean over `width` [s] about each instant of `at`, of the piecewise linear signal; narrower at the ends."""
    steps = np.diff(time) * (values[1:] + values[:-1]) / 2.0
    integral = np.concatenate([[0.0], np.cumsum(steps)])

    def until(t: np.ndarray) -> np.ndarray:
        """The integral from the first instant."""
        k = np.clip(np.searchsorted(time, t, side="right") - 1, 0, len(time) - 2)
        left = t - time[k]
        found: np.ndarray = integral[k] + left * (values[k] + np.interp(t, time, values)) / 2.0
        return found

    half = np.minimum(width / 2.0, np.minimum(at - time[0], time[-1] - at))
    half = np.maximum(half, 1e-9 * (time[-1] - time[0]))
    begin, end = np.maximum(at - half, time[0]), np.minimum(at + half, time[-1])
    mean: np.ndarray = (until(end) - until(begin)) / (end - begin)
    return mean


def _extreme(values: np.ndarray, reach: int, of: object) -> np.ndarray:
    """The extreme of each value and its neighbours to each side."""
    padded = np.pad(values, reach, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)
    found: np.ndarray = of(windows, axis=1)  # type: ignore[operator]
    return found
