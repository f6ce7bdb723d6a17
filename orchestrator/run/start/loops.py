"""Algebraic loops at the start, torn: a few inputs are found, the others follow from them one after the other.

A ring of a thousand FMUs is one equation for one unknown. Source: Elmqvist and Otter, Methods for tearing systems of
equations in object-oriented modeling, 1994.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ...extras import needed
from ...plan.start import LOOPED
from ...system.connection import Connection

TOLERANCE = 1e-9  # of a loop's inputs, relative to their size or 1
NUDGE = 1e-7  # of an input, relative to its size or 1, to see what it does
SINGULAR = (
    1e-6  # smallest singular value of the loop's matrix against the largest or 1, below which it has more solutions
)
GOLDEN = 0.6180339887498949  # by whose multiples nudges differ, so that what they do does not cancel


class StartLoop:
    """The inputs of a loop: `torn` are the unknowns, `behind` follow from them; `put` sets an input, `received` gives
    what the source of one sends."""

    def __init__(
        self, torn: Sequence[Connection], behind: Sequence[Connection],
        put: Callable[[Connection, float], None], received: Callable[[Connection], float],
    ) -> None:  # fmt: skip
        self.torn, self.behind, self.put, self.received = torn, behind, put, received

    def sent(self, inputs: np.ndarray) -> np.ndarray:
        """What the unknowns are sent where they have these values."""
        for c, value in zip(self.torn, inputs.tolist(), strict=True):
            self.put(c, value)
        for c in self.behind:
            self.put(c, self.received(c))
        found: np.ndarray = np.array([self.received(c) for c in self.torn])
        return found

    def solve(self, guess: np.ndarray, wanted: float) -> tuple[float, bool]:
        """Set the inputs so that they are what they are sent: what is left of the difference, relative to the inputs or
        1, and whether there is no other solution nearby (asked only where the guess is one)."""
        sent = self.sent(guess)
        found = _size(sent, guess)
        nudges = NUDGE * np.maximum(np.abs(guess), 1.0)
        fixed = np.array_equal(self.sent(guess + nudges * (1.0 + np.arange(len(guess)) * GOLDEN % 1.0)), sent)
        if found <= wanted:
            unique = fixed or not self._singular(guess, sent, nudges)
            self.sent(guess)
            return found, unique
        if fixed:  # so these are the solution, if that holds there too; else they may be where an FMU fails
            found = _size(self.sent(sent), sent)
            if found <= wanted:
                return found, True
        root = needed("scipy.optimize", LOOPED).root
        solution = root(lambda x: self.sent(x) - x, guess, method="hybr", options={"xtol": 1e-14}).x
        return _size(self.sent(solution), solution), True

    def _singular(self, inputs: np.ndarray, sent: np.ndarray, nudges: np.ndarray) -> bool:
        """Whether other inputs nearby are solutions, too."""
        rows = [(self.sent(inputs + row) - sent) / size for row, size in zip(np.diag(nudges), nudges, strict=True)]
        values = np.linalg.svd(np.array(rows).T - np.eye(len(inputs)), compute_uv=False)
        return bool(values[-1] <= SINGULAR * max(values[0], 1.0))


def _size(sent: np.ndarray, inputs: np.ndarray) -> float:
    return float(np.max(np.abs(sent - inputs) / np.maximum(np.abs(inputs), 1.0)))
