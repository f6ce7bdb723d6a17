"""Signals as they are drawn over time: lines, steps of what is no real number, bands where a line would be a bar."""

from __future__ import annotations

from typing import Any

import numpy as np

from .bands import band

STYLES = ("-", "--", "-.", ":")  # of signals in one axis: one does not hide the other
ITEMS = 12  # different texts that an axis can name


def draw(
    axis: Any, time: np.ndarray, values: np.ndarray, name: str, style: str, factor: float = 1.0, color: str = ""
) -> None:
    """A signal times `factor` as a line; one that swings faster than can be seen as its mean in a band.

    Whole numbers, truth values and texts are steps; texts are named on the axis.
    """
    if values.dtype.kind not in "fiub":
        _draw_texts(axis, time, values, name, style)
        return
    paint = {"color": color} if color else {}
    numbers = factor * values.astype(float)
    finite = np.isfinite(numbers)
    found = band(time[finite], numbers[finite]) if len(time[finite]) > 1 else None
    if found is None:
        steps = {} if values.dtype.kind == "f" else {"drawstyle": "steps-post"}
        alone = {"marker": "o", "markersize": 4} if np.count_nonzero(finite) == 1 else {}
        axis.plot(time, numbers, style, linewidth=0.9, label=name, **paint, **steps, **alone)
    else:
        (line,) = axis.plot(found.time, found.mean, style, linewidth=1.0, label=name, **paint)
        about = {"color": line.get_color(), "alpha": 0.25, "linewidth": 0.0}
        axis.fill_between(found.time, found.least, found.largest, **about)
    if values.dtype.kind == "b":
        axis.set_yticks([0, 1], ["false", "true"])


def _draw_texts(axis: Any, time: np.ndarray, values: np.ndarray, name: str, style: str) -> None:
    """Each different text has a height of its own."""
    texts = [value.hex() if isinstance(value, bytes) else str(value) for value in values.tolist()]
    known = {text: k for k, text in enumerate(dict.fromkeys(texts))}
    axis.plot(time, [known[text] for text in texts], style, drawstyle="steps-post", linewidth=0.9, label=name)
    named = list(known.items())[:ITEMS]
    axis.set_yticks([k for _, k in named], [text if len(text) < 24 else f"{text[:21]}..." for text, _ in named])
