"""The energy that the coupling makes or loses at a power bond, and the balance of a whole system.

A bond is a pair effort and flow that cross between two components in opposite directions. Each side computes its
power with what it knows: its own output, and the other's signal as it received it (held over the step). What the two
differ by is made or lost by the coupling; it vanishes as the periods shrink.

A flow that the side of the effort is not told of (a torque against a housing that turns) carries power on one side
only: all of it is made by the coupling, whatever the periods.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from .signals import Signal, Signals
from .system import Bond


@dataclass(frozen=True)
class Ledger:
    """Energies [J] over the run at both sides of a bond, and what the coupling made of it."""

    name: str
    effort_side: float
    flow_side: float

    @property
    def made(self) -> float:
        return self.flow_side - self.effort_side

    @property
    def relative(self) -> float:
        """|made| over the larger of the two energies; 0 for a bond that carries nothing."""
        carried = max(abs(self.effort_side), abs(self.flow_side))
        return abs(self.made) / carried if carried else 0.0


def work(held: Signal, own: Signal, sign: float) -> np.ndarray:
    """Cumulative work of a held input times an output of the same component (trapezoidal in the output), (rows,)."""
    step = sign * held.values[1:] * 0.5 * (own.values[1:] + own.values[:-1]) * np.diff(own.time)
    return np.concatenate([[0.0], np.cumsum(step)])


def ledger(signals: Signals, bond: Bond) -> Ledger:
    """The books of one bond. Its four signals must be recorded."""
    effort = float(work(signals[bond.flow[1]], signals[bond.effort[0]], bond.sign)[-1]) if bond.flow[1] else 0.0
    flow = work(signals[bond.effort[1]], signals[bond.flow[0]], bond.sign)
    return Ledger(bond.name, effort, float(flow[-1]))


@dataclass(frozen=True)
class Balance:
    """Energies [J] of a whole run: what came in, what was lost, what is stored more than at the start."""

    supplied: float
    lost: float
    stored: float
    coupling: float  # made at the bonds: by their ledgers

    @property
    def residual(self) -> float:
        return self.supplied + self.coupling - self.lost - self.stored

    @property
    def relative(self) -> float:
        return abs(self.residual) / abs(self.supplied) if self.supplied else 0.0


def balance(signals: Signals, entry: Mapping[str, Iterable[str]], ledgers: Iterable[Ledger]) -> Balance:
    """The balance that a system file asks for: `supplied`, `lost` and `stored` name energies that components count."""

    def rise(key: str) -> float:
        values = [signals[name].values for name in entry.get(key, ())]
        return float(sum(v[-1] - v[0] for v in values))

    return Balance(rise("supplied"), rise("lost"), rise("stored"), sum(x.made for x in ledgers))
