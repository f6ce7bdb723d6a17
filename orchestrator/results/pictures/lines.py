"""Signals as they are drawn over time: lines, and bands where a line would be a solid bar."""

from __future__ import annotations

from typing import Any

import numpy as np

COLUMNS, SAMPLES = 700, 4  # of a figure: places side by side, and samples in each that can still be told apart
STYLES = ("-", "--", "-.", ":")  # of signals in one axis: one does not hide the other


def draw(axis: Any, time: np.ndarray, values: np.ndarray, name: str, style: str) -> None:
    """A signal as a line; one of more samples than a figure can show as its mean in a band from least to largest."""
    if len(time) < SAMPLES * COLUMNS or values.dtype.kind not in "fiu":
        axis.plot(time, values, style, linewidth=0.9, label=name)
        return
    firsts = np.linspace(0, len(time), COLUMNS, endpoint=False, dtype=int)
    counts = np.diff([*firsts, len(time)])
    middle = np.add.reduceat(time, firsts) / counts
    (line,) = axis.plot(middle, np.add.reduceat(values, firsts) / counts, style, linewidth=0.9, label=name)
    least, largest = np.minimum.reduceat(values, firsts), np.maximum.reduceat(values, firsts)
    axis.fill_between(middle, least, largest, color=line.get_color(), alpha=0.25, linewidth=0.0)
