"""Extrapolated inputs that left the range in which their sources stayed: values that no FMU ever gave."""

from __future__ import annotations

import numpy as np

from ..signals import Signals
from ..tables import Run

EXTRAPOLATED = ("linear", "quadratic")
ROUNDING = 1e-9  # of the range: by so much the arithmetic may leave it


def left_range(run: Run, signals: Signals) -> list[str]:
    """Each such input by name, with both ranges; only where it and its source are recorded."""
    lines = []
    for c, choice in run.plan.choices.items():
        source, target = ".".join(c.source), ".".join(c.target)
        if choice.transfer not in EXTRAPOLATED or not {source, target} <= signals.places.keys():
            continue
        taken, given = signals[target], c.gain * signals[source].values + c.offset
        if not len(given) or not len(taken.values):
            continue
        (low, high), (least, most) = _range(given), _range(taken.values)
        beyond = max(low - least, most - high)
        if beyond > ROUNDING * max(high - low, abs(low), abs(high)):
            share = f" ({100.0 * beyond / (high - low):.3g} % of that range beyond it)" if high > low else ""
            unit = f" {taken.unit}" if taken.unit not in ("", "1") else ""
            lines.append(
                f"{target} was extrapolated to {least:.6g} to {most:.6g}{unit}, its source {source} stayed within "
                f"{low:.6g} to {high:.6g}{unit}{share}; (hold) or (interpolate) stays within"
            )
    return lines


def _range(values: np.ndarray) -> tuple[float, float]:
    return float(np.min(values)), float(np.max(values))
