"""The observations of an episode over time, as an array of pixels."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..results.pictures.written import as_written
from .signals import Signal


def picture(signals: Sequence[Signal], trace: Sequence[tuple[float, list[float]]]) -> np.ndarray:
    """One axis for each signal; (height, width, 3) of uint8."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 1.2 + 1.2 * len(signals)), layout="constrained")
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots(len(signals), 1, sharex=True, squeeze=False)[:, 0]
    times = [time for time, _ in trace]
    for k, (signal, axis) in enumerate(zip(signals, axes, strict=True)):
        axis.plot(times, [values[k] for _, values in trace])
        axis.set_ylabel(f"{signal.name} [{signal.unit}]")
    axes[-1].set_xlabel("time [s]")
    with as_written(figure):
        canvas.draw()  # type: ignore[no-untyped-call]
    return np.asarray(canvas.buffer_rgba())[:, :, :3].copy()  # type: ignore[no-untyped-call]
