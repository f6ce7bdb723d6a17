"""A signal in small: a line, or the band between its extremes where it goes up and down within a pixel."""

from __future__ import annotations

import numpy as np

from ..markup import element

WIDTH, HEIGHT = 160, 28  # px


def spark(time: np.ndarray, values: np.ndarray) -> str:
    """SVG of values over their time, from their lowest to their highest; empty where there is nothing to draw."""
    if values.dtype.kind not in "fiub" or len(values) < 2 or not time[-1] > time[0]:
        return ""
    numbers = values.astype(float)
    finite = np.isfinite(numbers)
    if not finite.any():
        return ""
    low, high = float(numbers[finite].min()), float(numbers[finite].max())
    column = ((time - time[0]) / (time[-1] - time[0]) * (WIDTH - 1)).astype(int)
    with np.errstate(over="ignore"):
        middle = 0.5 if not 0.0 < high - low < np.inf else None
        height = np.full(len(numbers), middle) if middle is not None else (numbers - low) / (high - low)
    y = 1.5 + (HEIGHT - 3) * (1.0 - height)
    tops, bottoms, places = [], [], []
    for x in np.unique(column[finite]).tolist():
        inside = y[finite & (column == x)]
        tops.append(float(inside.min()))
        bottoms.append(float(inside.max()))
        places.append(x + 0.5)
    band = [*zip(places, tops, strict=True), *zip(reversed(places), reversed(bottoms), strict=True)]
    points = " ".join(f"{x:g},{at:.1f}" for x, at in band)
    line = element("polygon", points=points, fill="#2f7ebc", fill_opacity=0.35, stroke="#2f7ebc", stroke_width=1.0)
    return element("svg", line, width=WIDTH, height=HEIGHT, viewBox=f"0 0 {WIDTH} {HEIGHT}", role="img")
