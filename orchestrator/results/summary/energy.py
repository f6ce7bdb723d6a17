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

from ...errors import RunError
from ...plan.schedule.bond_energy import slug
from ...system.connection import Bond
from ..signals import Signals
from ..tables import Run


@dataclass(frozen=True)
class Ledger:
    """Energies [J] over the run at both sides of a bond, and what the coupling made of it."""

    name: str
    effort_side: float
    flow_side: float
    carried: float  # the largest magnitude of either so far: energy may come back

    @property
    def made(self) -> float:
        return self.flow_side - self.effort_side

    @property
    def relative(self) -> float:
        """|made| over what the bond carried; 0 for a bond that carries nothing."""
        return abs(self.made) / self.carried if self.carried else 0.0


def ledger(signals: Signals, bond: Bond) -> Ledger:
    """The books of one bond at the end of a run; the coupling's own signals are always recorded."""
    name = slug(bond)
    effort, flow = (signals[f"coupling.{name}_{side}_side"].values for side in ("effort", "flow"))
    carried = max(float(np.max(np.abs(side))) for side in (effort, flow))
    return Ledger(bond.name, float(effort[-1]), float(flow[-1]), carried)


def over_limits(ledgers: Iterable[Ledger], bonds: Iterable[Bond]) -> list[str]:
    """What to tell of bonds at which the coupling made or lost more than the system file allows."""
    found = []
    for entry, bond in zip(ledgers, bonds, strict=True):
        if abs(entry.made) > bond.limit:
            found.append(f"power bond {bond.name}: the coupling made {entry.made:.4g} J, allowed are {bond.limit:g} J")
        elif entry.relative > bond.limit_relative:
            found.append(
                f"power bond {bond.name}: the coupling made {entry.relative:.3g} of the energy that the bond carried "
                f"({entry.made:.4g} J), allowed is {bond.limit_relative:g}"
            )
    return found


def require_energy(run: Run) -> Run:
    """The run itself, or RunError if the coupling made or lost more than the bonds of the system allow."""
    signals, bonds = Signals(run), run.plan.system.bonds
    excess = over_limits([ledger(signals, bond) for bond in bonds], bonds)
    if excess:
        raise RunError("; ".join(excess) + "; take smaller periods, another transfer or another algorithm")
    return run


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
