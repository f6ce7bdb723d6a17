"""What goes between components: connections, and the bonds that two of them are. Data only."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Connection:
    """One scalar output that drives one scalar input: `target = gain * source + offset` (unit conversion)."""

    source: tuple[str, str]
    target: tuple[str, str]
    transfer: str = ""  # empty: the plan chooses
    gain: float = 1.0
    offset: float = 0.0
    where: str = ""
    rounded: bool = False  # "round": the nearest value of the input's type
    counter: str = ""  # an output of the source's component whose rise is the time integral of the source exactly
    per_second: float = 1.0  # of the source, where the counter rises by 1 in a second

    @property
    def label(self) -> str:
        return f"{'.'.join(self.source)} -> {'.'.join(self.target)}"

    @property
    def counted(self) -> tuple[str, str] | None:
        """The counter that gives the mean, with its component; None where the mean is none of a counter."""
        return (self.source[0], self.counter) if self.counter and self.transfer == "mean" else None


@dataclass(frozen=True)
class Bond:
    """A power bond: effort and flow, each crossing one connection, in opposite directions."""

    name: str
    effort: tuple[str, str]  # output and input, as "component.variable"
    flow: tuple[str, str]  # the input is empty where the other side is not told of the flow
    sign: float
    impulse: str = ""  # an output that counts the time integral of the effort exactly
    displacement: str = ""  # and of the flow
    limit: float = math.inf  # J that the coupling may make or lose over the run
    limit_relative: float = math.inf  # of the energy that the bond carries
