"""Units in which people read: degrees for angles, millimetres for short lengths. For display only, results stay SI."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

SHORT = 0.1  # m; lengths that stay below it are read in millimetres


class Shown(NamedTuple):
    """A unit on an axis, and the factor that brings a value there."""

    unit: str
    factor: float = 1.0

    def label(self, name: str) -> str:
        """`name [unit]`; of what can have no unit its name alone."""
        return f"{name} [{self.unit}]" if self.unit else name


def shown(unit: str, values: Iterable[np.ndarray] = ()) -> Shown:
    """The unit in which the values of one axis are read."""
    if unit == "rad":
        return Shown("deg", 180.0 / math.pi)
    if unit == "m":
        largest = max((largest_of(one) for one in values), default=0.0)
        return Shown("mm", 1e3) if 0.0 < largest < SHORT else Shown(unit)
    return Shown(unit)


def largest_of(values: np.ndarray) -> float:
    """The largest magnitude among finite values; 0 where there is none."""
    if values.dtype.kind not in "fiub" or not len(values):
        return 0.0
    magnitudes = np.abs(values.astype(float))
    return float(np.max(magnitudes, where=np.isfinite(magnitudes), initial=0.0))
