"""Whoever looks on while a run goes: what is recorded, a progress bar, a function of the user's, checkpoints.

All have one interface: they say at which instant they must be called next, and see the rows that are new since.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ...loop.cells import NEVER as NEVER


@dataclass(frozen=True)
class Piece:
    """What a run has recorded since an observer looked last."""

    time: float  # s, reached: all components are complete until then
    tick: int
    first: list[int]  # per table: how many rows, counted from time 0, were there before
    tables: list[np.ndarray]  # per table: the new rows, (rows, columns); views that the next step may overwrite


class Observer(Protocol):
    """Sees a run as it goes. What it raises ends the run; an RovbrushError keeps what was computed."""

    def due(self, tick: int) -> int:
        """The first instant behind `tick` at which `see` must be called; NEVER: it need not, but may be at any."""

    def see(self, piece: Piece) -> None:
        """Called at the instants that are due, and every tenth of a second or so in between.

        The row of an instant at which something is done by hand comes a second time, as it is then."""


class Progress:
    """Tells a function the time reached [s], now and then."""

    def __init__(self, report: Callable[[float], object]) -> None:
        self.report = report

    def due(self, tick: int) -> int:
        return NEVER

    def see(self, piece: Piece) -> None:
        self.report(piece.time)


class Every:
    """Calls a function at instants that are due and at no other, with the time reached [s].

    A run whose steps vary reaches an instant only nearly: the first step that ends behind it counts.
    """

    def __init__(self, call: Callable[[float], object], instants: Iterable[int]) -> None:
        self.call = call
        self._coming = iter(instants)
        self._next = next(self._coming, NEVER)

    def due(self, tick: int) -> int:
        return self._next

    def see(self, piece: Piece) -> None:
        if piece.tick < self._next:
            return
        while self._next <= piece.tick:
            self._next = next(self._coming, NEVER)
        self.call(piece.time)
